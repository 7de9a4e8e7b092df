## Fields that a tool moves: in the editor, or where they do not simulate.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
## Of a preview beside a field that moves by itself, m: the same steps in the same wind.
const SAME := 1e-5

var _field: PlantField3D
var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.strength = 2.0
	_field = PlantField3D.new()
	_field.species = [TulipFunction.new(), GrassFunction.new()]
	_field.size = Vector2(6, 6)
	_field.simulating = false


func after_each() -> void:
	_field.free()


func test_preview_moves_plants_and_changes_no_property() -> void:
	await _start()
	var before := _tips()
	_preview(30)
	check(_tips()[3].distance_to(before[3]) > 0.001, "plant 3 moved")
	check(_field.wind == null, "the field has no wind of its own")


func test_reset_puts_plants_back() -> void:
	await _start()
	var before := _tips()
	_preview(30)
	_field.reset()
	check_equal(_tips(), before, "tips after the reset")
	_wind.strength = 0.0
	_preview(10)
	check_equal(_tips(), before, "tips after ten steps in still air")


func test_reset_of_followers_fills_the_field_anew() -> void:
	_field.prototypes = 8
	await _start()
	var before := _tips()
	_preview(60)
	check(_tips()[3].distance_to(before[3]) > 0.001, "plant 3 moved")
	_field.reset()
	await _field.filled
	await frames(1)
	check_equal(_tips(), before, "tips after the reset")


func test_still_air_moves_nothing() -> void:
	await _start()
	var before := _tips()
	_field.preview(STEP, null)
	check_equal(_tips(), before, "tips")


func test_nonsense_is_ignored() -> void:
	await _start()
	var before := _tips()
	for delta: float in [NAN, INF, -1.0, 1e9]:
		_field.preview(delta, _wind)
	check_equal(_tips(), before, "tips")


func test_a_field_without_plants_bears_it() -> void:
	_field.preview(STEP, _wind)
	_field.reset()
	check_equal(_field.get_plant_count(), 0, "plants")


func test_a_field_that_moves_by_itself_is_left_alone() -> void:
	_field.simulating = true
	await _start()
	var before := _tips()
	_field.preview(1.0, _wind)
	check_equal(_tips(), before, "tips")


func test_preview_moves_as_the_simulation_does() -> void:
	await _start()
	var other: PlantField3D = _field.duplicate()
	other.simulating = true
	other.wind = _wind.duplicate()
	root.add_child(other)
	await other.filled
	await frames(40)
	# In its first step a field finds the wind's clock as it is.
	var steps := roundi(other.wind.get_time() / STEP) + 1
	check(steps > 10, "%d steps" % steps)
	_preview(steps)
	other.simulating = false
	for i: int in range(0, _field.get_plant_count(), 7):
		check_near(_field.get_tip_position(i).distance_to(other.get_tip_position(i)), 0.0, SAME)
	other.free()


func _start() -> void:
	root.add_child(_field)
	await _field.filled
	await frames(1)


func _preview(steps: int) -> void:
	for i in steps:
		_wind.advance(STEP)
		_field.preview(STEP, _wind)


func _tips() -> PackedVector3Array:
	var tips: PackedVector3Array = []
	for i in _field.get_plant_count():
		tips.append(_field.get_tip_position(i))
	return tips
