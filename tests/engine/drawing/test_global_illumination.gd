## What the instances of a field add to global illumination.
extends "res://tests/engine/drawing/drawing_harness.gd"

const BAKED := 1
const DYNAMIC := 2


func test_plants_follow_the_mode_of_their_field() -> void:
	field = PlantField3D.from_species([load("res://addons/undergrowth/species/meadow_grass.tres")])
	field.size = Vector2(12, 12)
	field.density = 4.0
	check_equal(field.gi_mode, GeometryInstance3D.GI_MODE_DISABLED, "mode of a new field")
	await start()
	_check_flags(0)
	field.gi_mode = GeometryInstance3D.GI_MODE_STATIC
	await frames(12)
	_check_flags(BAKED)
	field.gi_mode = GeometryInstance3D.GI_MODE_DYNAMIC
	await frames(12)
	_check_flags(DYNAMIC)
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	field.rebuild()
	await filled(field)
	_check_flags(DYNAMIC)


## Their levels cast shadows themselves.
func test_plants_without_parts_follow_the_mode_of_their_field() -> void:
	field = make_field(12.0, 2.0)
	await start()
	_check_flags(0)


func _check_flags(wanted: int) -> void:
	var instances := DrawingRecord.get_instances()
	check(instances.size() > 0, "%d instances" % instances.size())
	for instance: Dictionary in instances:
		check_equal(instance["gi_flags"], wanted, "flags")
