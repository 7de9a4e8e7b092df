## Changes of settings while a plant moves, and invalid steps: no pose jumps.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const TIP_TOLERANCE := 1e-5
## Limit of the tip's speed: the gain by its law in one step, far below a jump.
const LARGEST_MOVE := 0.2

var _plant: Plant3D
var _function: PlantFunction


func before_each() -> void:
	_function = TulipFunction.new()
	_plant = Plant3D.new()
	_plant.species = _function
	_plant.height = 1.5
	_plant.simulation_enabled = false
	_plant.wind = PlantWind.new()
	_plant.wind.strength = 1.0
	root.add_child(_plant)


func after_each() -> void:
	_plant.free()
	_function = null


func test_changes_of_the_function_keep_the_tip_where_it_is() -> void:
	var changes := {
		"natural_frequency": 3.0,
		"damping_ratio": 0.5,
		"mass": 2.0,
		"wind_weight": 0.1,
		"law": PlantFunction.LAW_ELASTICITY,
		"elasticity": 2.0,
		"inner_friction": 1.0,
		"shading": PlantFunction.SHADING_FLAT,
	}
	for property: String in changes:
		await _check_no_jump(func() -> void: _function.set(property, changes[property]), property)


func test_changes_of_the_wind_keep_the_tip_where_it_is() -> void:
	var changes := {
		"strength": 3.0,
		"direction": 2.0,
		"kind": PlantWind.KIND_WAVES,
		"frequency": 3.0,
		"gust_duration": 3.0,
	}
	for property: String in changes:
		var change := func() -> void: _plant.wind.set(property, changes[property])
		await _check_no_jump(change, property)
	await _check_no_jump(func() -> void: _plant.wind = null, "no wind")
	await _check_no_jump(func() -> void: _plant.wind = PlantWind.new(), "another wind")


func test_changes_of_the_plant_keep_the_direction_of_the_tip() -> void:
	await _check_no_jump(func() -> void: _plant.segments = 5, "segments")
	await _check_no_jump(func() -> void: _plant.seed = 5, "seed")
	await _check_no_jump(func() -> void: _plant.height = 2.0, "height")
	await _check_no_jump(func() -> void: _plant.species = ReedFunction.new(), "species")
	await _check_no_jump(func() -> void: _plant.rebuild(), "rebuild")


func test_changes_keep_the_velocity() -> void:
	_plant.wind = null
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	_run(0.1)
	var before := _plant.get_tip_position()
	_plant.advance(STEP)
	var velocity := (_plant.get_tip_position() - before) / STEP
	_function.law = PlantFunction.LAW_ELASTICITY
	before = _plant.get_tip_position()
	_plant.advance(STEP)
	check_near((_plant.get_tip_position() - before) / STEP, velocity, 0.15, "velocity")


func test_driving_by_hand_and_simulating_hand_over_the_motion() -> void:
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	_run(0.2)
	var tip := _plant.get_tip_position()
	_plant.simulation_enabled = true
	check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, "tip as it begins")
	await frames(3)
	tip = _plant.get_tip_position()
	_plant.simulation_enabled = false
	check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, "tip as it ends")
	_plant.advance(STEP)
	check(_plant.get_tip_position() != tip, "it goes on by hand")


func test_a_long_step_is_bounded() -> void:
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	for delta: float in [10.0, 1e6]:
		_plant.advance(delta)
		check(_plant.get_tip_position().is_finite(), "tip after %f s" % delta)
		check_near(_plant.get_tip_position().length(), 1.5, TIP_TOLERANCE, "distance")


func test_impossible_steps_give_one_error_and_move_nothing() -> void:
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	_run(0.2)
	var tip := _plant.get_tip_position()
	for delta: float in [-1.0, -1e-9, NAN, INF, -INF]:
		_plant.advance(delta)
		check_error("is impossible; nothing moved")
		check_equal(_plant.get_tip_position(), tip, "tip")


func test_the_same_impossible_step_is_reported_once_until_one_was_possible() -> void:
	for i in 3:
		_plant.advance(NAN)
	check_error("is impossible; nothing moved")
	_plant.advance(STEP)
	_plant.advance(NAN)
	check_error("is impossible; nothing moved")


func test_a_step_of_nothing_moves_nothing() -> void:
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	_run(0.2)
	var tip := _plant.get_tip_position()
	for i in 100:
		_plant.advance(0.0)
	check_equal(_plant.get_tip_position(), tip, "tip")


func test_short_steps_add_up() -> void:
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	for i in 1000:
		_plant.advance(STEP / 10.0)
	var tip := _plant.get_tip_position()
	_plant.reset_motion()
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	for i in 100:
		_plant.advance(STEP)
	check_equal(_plant.get_tip_position(), tip, "tip")


func test_a_simulating_plant_cannot_be_stepped() -> void:
	_plant.simulation_enabled = true
	var tip := _plant.get_tip_position()
	for i in 3:
		_plant.advance(1.0)
	check_error("while the plant simulates")
	check_equal(_plant.get_tip_position(), tip, "tip")


func test_impulses_that_are_not_finite_give_one_error_and_move_nothing() -> void:
	for impulse: Vector3 in [Vector3(NAN, 0, 0), Vector3(0, INF, 0), Vector3(0, 0, -INF)]:
		_plant.apply_impulse(impulse)
		check_error("finite impulse")
	_plant.wind = null
	_run(0.5)
	check_near(_plant.get_deflection(), 0.0, 1e-5, "deflection")


func test_huge_impulses_and_storms_stay_finite() -> void:
	_plant.wind.strength = 1e6
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		_function.law = law
		_plant.apply_impulse(Vector3(1e30, -1e30, 1e30))
		for i in 60:
			_plant.advance(STEP)
			check_near(_plant.get_tip_position().length(), 1.5, 1e-4, "distance")


func test_extreme_functions_stay_finite() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		for extreme: Dictionary in _extremes():
			_function = PlantFunction.new()
			_function.law = law
			for property: String in extreme:
				_function.set(property, extreme[property])
			_plant.species = _function
			_plant.apply_impulse(Vector3(1, 0, 0))
			_run(1.0)
			check(_plant.get_tip_position().is_finite(), "tip with " + str(extreme))
			check_near(_plant.get_tip_position().length(), 1.5, 1e-4, "distance")


func _extremes() -> Array[Dictionary]:
	return [
		{"mass": 1e-6},
		{"mass": 1e6},
		{"elasticity": -0.99},
		{"elasticity": 1e4, "mass": 1e-6},
		{"inner_friction": 1e6},
		{"natural_frequency": 1000.0},
		{"natural_frequency": 0.01},
		{"damping_ratio": 100.0},
		{"damping_ratio": 0.0},
		{"wind_weight": 1000.0},
		{"lean": deg_to_rad(80.0)},
	]


func _run(seconds: float) -> void:
	for i in roundi(seconds / STEP):
		_plant.advance(STEP)


## Checks that the tip's direction stays the same during [param change] and the frames of the
## rebuild, and moves smoothly in the steps afterwards.
func _check_no_jump(change: Callable, label: String) -> void:
	_plant.apply_impulse(Vector3(0.1, 0, 0.1))
	_run(0.3)
	var tip := _plant.get_tip_position().normalized()
	change.call()
	check_near(_plant.get_tip_position().normalized(), tip, TIP_TOLERANCE, label)
	await frames(2)
	check_near(_plant.get_tip_position().normalized(), tip, TIP_TOLERANCE, label + " a frame later")
	for i in 3:
		_plant.advance(STEP)
		var moved := _plant.get_tip_position().normalized().distance_to(tip)
		check(moved < LARGEST_MOVE, "%s: moved by %f in a step" % [label, moved])
		tip = _plant.get_tip_position().normalized()
