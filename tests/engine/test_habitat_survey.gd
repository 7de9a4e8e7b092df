## PlantHabitat: moisture, light and values of the ground, and competition.
extends "res://tests/engine/field_harness.gd"

const HALF := 12.0  # Metres, half of the field's side.
const STEEPNESS := 0.4

var _habitat: PlantHabitat
var _ground: Ground


## A valley along z, a roof with its ridge along x, and two kinds of ground. It counts queries.
class Ground:
	extends Node3D
	var is_roof := false
	var answer: Variant = null
	var heights := 0
	var kinds := 0

	func get_height(place: Vector3) -> float:
		heights += 1
		return -STEEPNESS * absf(place.z) if is_roof else STEEPNESS * absf(place.x)

	func get_kind(place: Vector3) -> Variant:
		kinds += 1
		return answer if answer != null else (3 if place.x > 0.0 else 1)

	func get_tint(place: Vector3) -> Color:
		return Color(0.0, 0.0, 1.0 if place.z > 4.0 else 0.0)


func before_each() -> void:
	_habitat = PlantHabitat.new()
	_ground = Ground.new()
	_ground.name = "Ground"
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2.ONE * 2.0 * HALF
	field.density = 12.0
	field.species[0].habitat = _habitat
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = ^"Ground"
	field.add_child(_ground)


func test_wet_plants_grow_in_the_valley() -> void:
	_habitat.moisture_curve = _step_at(0.7)
	await start()
	var left := places_of(0)
	check(left.size() > 50, "%d plants" % left.size())
	for id in left:
		check(absf(left[id].x) < 3.0, "at %v" % left[id])
	_habitat.moisture_curve = PlantHabitat.make_curve([Vector2(0.68, 1.0), Vector2(0.7, 0.0)])
	await rested()
	var dry := places_of(0)
	check(dry.size() > 1000, "%d dry plants" % dry.size())
	for id in dry:
		check(absf(dry[id].x) > 0.3, "at %v" % dry[id])


func test_light_falls_on_the_slope_towards_the_sun() -> void:
	_ground.is_roof = true
	_habitat.light_curve = _step_at(0.51)
	await start()
	var left := places_of(0)
	check(left.size() > 500, "%d plants" % left.size())
	for id in left:
		check(left[id].z > -1.0, "at %v" % left[id])
	field.sun_latitude = deg_to_rad(-40.0)
	await rested()
	left = places_of(0)
	check(left.size() > 500, "%d plants in the south" % left.size())
	for id in left:
		check(left[id].z < 1.0, "at %v" % left[id])


func test_values_of_the_ground_have_kinds_and_channels() -> void:
	_habitat.value_method = &"get_kind"
	_habitat.value_curve = PlantHabitat.make_curve(
		[Vector2(0, 0), Vector2(2, 0), Vector2(3, 1), Vector2(4, 0)]
	)
	await start()
	_check_from(0.0, Vector3.RIGHT)
	_ground.add_to_group(&"soil")
	_habitat.value_group = &"soil"
	_habitat.value_method = &"get_tint"
	_habitat.value_channel = PlantHabitat.CHANNEL_BLUE
	_habitat.value_curve = _step_at(0.5)
	await rested()
	_check_from(4.0, Vector3.BACK)


func test_a_curve_changes_without_another_survey() -> void:
	_habitat.value_method = &"get_kind"
	_habitat.value_curve = _step_at(2.0)
	await start()
	var before := _ground.kinds
	check(before > 500, "%d queries" % before)
	_habitat.value_curve.set_point_value(1, 0.5)
	await rested()
	check_equal(_ground.kinds, before, "queries after a change of the curve")
	field.rebuild()
	await filled(field)
	check_equal(_ground.kinds, 2 * before, "queries after rebuild()")


func test_a_faulty_source_of_values_is_an_error_with_a_remedy() -> void:
	_habitat.value_method = &"get_soil"
	_habitat.value_curve = _step_at(0.5)
	root.add_child(field)
	await rested()
	check_error("species[0] has the value_method 'get_soil', but ground_object has no such method")
	_habitat.value_group = &"soils"
	await rested()
	check_error("but no node of the group 'soils' has it")
	_habitat.value_group = &""
	_habitat.value_method = &"get_kind"
	_ground.answer = "clay"
	await rested()
	check_error("get_kind() of ")
	_ground.answer = 0.75
	field.rebuild()
	await filled(field)
	check(places_of(0).size() > 500, "%d plants" % places_of(0).size())
	_ground.answer = NAN
	field.rebuild()
	await filled(field)
	check_equal(places_of(0).size(), 0, "plants where the ground has holes")


func test_a_streamed_field_has_one_survey() -> void:
	_habitat.moisture_curve = _step_at(0.6)
	await start()
	var whole := places_of(0)
	field.free()
	before_each()
	_habitat.moisture_curve = _step_at(0.6)
	field.tile_size = 6.0
	field.view_distance = 40.0
	field.add_child(Camera3D.new())
	await start()
	await rested()
	check_equal(places_of(0).size(), whole.size(), "plants of tiles")
	for id in places_of(0):
		check(id in whole, "plant %d" % id)


func test_a_field_without_an_area_ignores_the_survey() -> void:
	_habitat.moisture_curve = PlantHabitat.make_curve([Vector2(0.0, 0.0), Vector2(1.0, 0.0)])
	_habitat.height_curve = _step_at(1.0)
	field.endless = true
	field.view_distance = 10.0
	field.add_child(Camera3D.new())
	await start()
	await rested()
	var left := places_of(0)
	check(left.size() > 500, "%d plants" % left.size())
	for id in left:
		check(left[id].y > 0.97, "at %v" % left[id])


func test_competition_has_the_same_plants_in_tiles_of_any_order() -> void:
	_compete(0.0)
	await start()
	var all := places_of(1)
	field.competition = 1.0
	await rested()
	var left := places_of(1)
	check(left.size() < 0.7 * all.size(), "%d of %d low plants" % [left.size(), all.size()])
	for id in left:
		check_equal(left[id], all.get(id), "place of a plant that stays")
	var whole := sorted_ids()
	for side: float in [3.0, 7.0]:
		field.free()
		before_each()
		_compete(1.0)
		field.tile_size = side
		field.view_distance = 50.0
		var camera := Camera3D.new()
		camera.position = Vector3(side, 1, -2 * side)
		field.add_child(camera)
		await start()
		await rested()
		check_equal(sorted_ids(), whole, "ids with tiles of %.0f m" % side)


func test_removed_plants_still_compete_after_a_rebuild() -> void:
	_compete(1.0)
	await start()
	var before := sorted_ids()
	var removed := field.find_plants_in_sphere(Vector3.ZERO, 3.0)
	field.remove_plants(removed)
	field.rebuild()
	await filled(field)
	var expected := Array(before).filter(func(id: int) -> bool: return id not in removed)
	check_equal(Array(sorted_ids()), expected, "ids")


func test_strokes_have_the_plants_of_a_whole_build() -> void:
	_compete(1.0)
	var map := PlantMap.new()
	for entry in field.species:
		map.paint(Vector3.ZERO, 9.0, entry.get_layer_name(), 0.6)
	field.map = map
	await start()
	map.erase(Vector3(2, 0, 1), 3.0, field.species[0].get_layer_name())
	await rested()
	map.paint(Vector3(-4, 0, 2), 2.0, field.species[0].get_layer_name(), 1.0)
	await rested()
	var strokes := sorted_ids()
	field.rebuild()
	await filled(field)
	check_equal(sorted_ids(), strokes, "ids")


func test_bad_values_are_errors_and_are_not_kept() -> void:
	var entry := field.species[0]
	for bad: Array in [
		[entry, "vigor", 0.0],
		[entry, "vigor", NAN],
		[entry, "shade_radius", 5.0],
		[entry, "shade_tolerance", 1.5],
		[field, "competition", -0.1],
		[field, "sun_latitude", 50.0],
		[_habitat, "value_channel", 9],
	]:
		var before: Variant = bad[0].get(bad[1])
		bad[0].set(bad[1], bad[2])
		check_error("%s cannot be " % bad[1])
		check_equal(bad[0].get(bad[1]), before, bad[1])


func _compete(strength: float) -> void:
	field.species[0].vigor = 3.0
	field.species[0].shade_radius = 0.5
	field.species[0].shade_tolerance = 1.0
	field.species[1].shade_tolerance = 0.0
	field.competition = strength


# Suitability 0 below `x`, 1 above it.
func _step_at(x: float) -> Curve:
	return PlantHabitat.make_curve([Vector2(x - 0.02, 0.0), Vector2(x, 1.0)])


# Between two samples of the survey suitability changes over 1 m.
func _check_from(place: float, axis: Vector3) -> void:
	var left := places_of(0)
	check(left.size() > 400, "%d plants" % left.size())
	var full := 0
	for id in left:
		check(left[id].dot(axis) > place - 1.1, "at %v" % left[id])
		full += 1 if left[id].dot(axis) > place + 1.1 else 0
	var area := (HALF - place - 1.1) * 2.0 * HALF
	check_near(full / area, 6.0, 0.8, "plants/m²")
