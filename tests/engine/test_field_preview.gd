## Fields moved by a tool: in the editor, or without simulation.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
## Difference between a preview and a simulated field, m: the same steps in the same wind.
const SAME := 1e-5

var _field: PlantField3D
var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.strength = 2.0
	_field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	_field.density = 4.0
	_field.size = Vector2(6, 6)
	_field.simulation_enabled = false


func after_each() -> void:
	_field.free()


func test_preview_moves_plants_and_changes_no_property() -> void:
	await _start()
	var before := _tips()
	_preview(30)
	check(_tips()[3].distance_to(before[3]) > 0.001, "plant 3 moved")
	check(_field.wind == null, "the field has no wind of its own")


func test_reset_motion_puts_plants_back() -> void:
	await _start()
	var before := _tips()
	_preview(30)
	_field.reset_motion()
	check_equal(_tips(), before, "tips after the reset")
	_wind.strength = 0.0
	_preview(10)
	check_equal(_tips(), before, "tips after ten steps in still air")


func test_reset_motion_puts_followers_back_and_keeps_the_plants() -> void:
	_field.prototypes = 8
	await _start()
	var ids := _field.get_plant_ids()
	var before := _tips()
	_preview(60)
	check(_tips()[3].distance_to(before[3]) > 0.001, "plant 3 moved")
	_field.reset_motion()
	await frames(1)
	while _field.get_statistics()["is_rebuilding_meshes"]:
		await process_frame
	check_equal(_field.get_plant_count(), ids.size(), "plants")
	check_equal(_field.get_tip_positions(ids), before, "tips after the reset")


func test_still_air_moves_nothing() -> void:
	await _start()
	var before := _tips()
	_field._preview(STEP, null)
	check_equal(_tips(), before, "tips")


func test_nonsense_is_ignored() -> void:
	await _start()
	var before := _tips()
	for delta: float in [NAN, INF, -1.0, 1e9]:
		_field._preview(delta, _wind)
	check_equal(_tips(), before, "tips")


func test_a_field_without_plants_bears_it() -> void:
	_field._preview(STEP, _wind)
	_field.reset_motion()
	check_equal(_field.get_plant_count(), 0, "plants")


func test_a_field_that_moves_by_itself_is_left_alone() -> void:
	_field.simulation_enabled = true
	await _start()
	var before := _tips()
	_field._preview(1.0, _wind)
	check_equal(_tips(), before, "tips")


func test_preview_moves_as_the_simulation_does() -> void:
	await _start()
	var other: PlantField3D = _field.duplicate()
	other.simulation_enabled = true
	other.wind = _wind.duplicate()
	root.add_child(other)
	await other.build_finished
	await frames(40)
	var steps := roundi(other.get_motion_time() / STEP)
	check(steps > 10, "%d steps" % steps)
	_preview(steps)
	other.simulation_enabled = false
	var tips := _tips()
	var others := other.get_tip_positions(other.get_plant_ids())
	for i in tips.size():
		check_near(tips[i].distance_to(others[i]), 0.0, SAME)
	other.free()


func _start() -> void:
	root.add_child(_field)
	await _field.build_finished
	await frames(1)


func _preview(steps: int) -> void:
	for i in steps:
		_wind.advance(STEP)
		_field._preview(STEP, _wind)


func _tips() -> PackedVector3Array:
	return _field.get_tip_positions(_field.get_plant_ids())
