## PlantSimulation: all simulated plants of the running scene, stepped together frame by frame.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const TIP_TOLERANCE := 1e-5
## m/s. The tips of these tests are slower.
const LARGEST_SPEED := 2.0

var _plant: Plant3D
var _usual_step := PlantSimulation.step_length


func before_each() -> void:
	_plant = _add_plant(TulipFunction.new())
	_plant.wind = _make_wind()


func after_each() -> void:
	paused = false
	Engine.time_scale = 1.0
	PlantSimulation.step_length = _usual_step
	for child in root.get_children():
		if child is Plant3D:
			child.free()
	_plant = null
	check_equal(PlantSimulation.get_plant_count(), 0, "plants left in the simulation")


func test_the_wind_swings_plants_its_way() -> void:
	_plant.species.damping_ratio = 1.0
	for degrees: float in [0.0, 90.0, 225.0]:
		_plant.reset_motion()
		_plant.wind.direction = deg_to_rad(degrees)
		var way := Vector3(sin(deg_to_rad(degrees)), 0, cos(deg_to_rad(degrees)))
		await _pass(0.2)
		var tip := _plant.get_tip_position()
		check(tip.dot(way) > 0.01, "it leans to %s: %s" % [str(way), str(tip)])
		check_near(tip.slide(way).x, 0.0, 1e-3, "and not aside")
		_check_bone_near_the_tip()


func test_it_moves_plants_as_driving_by_hand_does() -> void:
	var other := _add_plant(_plant.species)
	other.simulation_enabled = false
	other.wind = _make_wind()
	await _pass(0.5)
	var steps := roundi(_plant.wind.get_time() / STEP)
	check(steps >= 29, "steps, %d" % steps)
	for i in steps:
		other.advance(STEP)
	check_near(_plant.get_tip_position(), other.get_tip_position(), TIP_TOLERANCE, "tip")


func test_a_shared_wind_goes_on_once_a_step() -> void:
	var shared := _make_wind()
	for i in 20:
		var plant := _add_plant(GrassFunction.new() if i % 2 == 0 else ReedFunction.new())
		plant.species.law = (i % 2) as PlantFunction.MotionLaw
		plant.rotation_degrees.x = 15.0 * i
		plant.wind = shared
	await _pass(0.3)
	check(shared.get_time() > 0.25, "it goes on, %f" % shared.get_time())
	check_near(shared.get_time(), _plant.wind.get_time(), STEP + 1e-6, "as one plant's own")


func test_a_wind_without_plants_does_not_advance() -> void:
	var wind := _make_wind()
	await _pass(0.1)
	check_equal(wind.get_time(), 0.0)


func test_it_counts_plants_and_measures_its_time() -> void:
	_add_plant(GrassFunction.new())
	check_equal(PlantSimulation.get_plant_count(), 2)
	await _pass(0.1)
	check(PlantSimulation.get_step_time_usec() >= 0.0, "step time")
	check(PlantSimulation.get_pose_time_usec() > 0.0, "pose time")


func test_a_pause_stops_plants_and_goes_on_without_a_jump() -> void:
	var awake := _add_plant(TulipFunction.new())
	awake.process_mode = Node.PROCESS_MODE_ALWAYS
	awake.wind = _make_wind()
	await _pass(0.2)
	paused = true
	var tip := _plant.get_tip_position()
	var awake_tip := awake.get_tip_position()
	await _pass(0.2)
	check_equal(_plant.get_tip_position(), tip, "tip of the paused plant")
	check(awake.get_tip_position() != awake_tip, "the other goes on")
	paused = false
	check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, "tip as it goes on")
	await frames(1)
	_check_moved_smoothly(tip, "a frame later")
	await _pass(0.1)
	check(_plant.get_tip_position() != tip, "it moves")


func test_a_plant_for_pauses_moves_in_them_only() -> void:
	_plant.process_mode = Node.PROCESS_MODE_WHEN_PAUSED
	var tip := _plant.get_tip_position()
	await _pass(0.1)
	check_equal(_plant.get_tip_position(), tip, "tip")
	paused = true
	await _pass(0.1)
	check(_plant.get_tip_position() != tip, "it moves")


func test_a_disabled_plant_stops_and_goes_on() -> void:
	await _pass(0.1)
	_plant.process_mode = Node.PROCESS_MODE_DISABLED
	var tip := _plant.get_tip_position()
	await _pass(0.1)
	check_equal(_plant.get_tip_position(), tip, "tip")
	check_equal(PlantSimulation.get_plant_count(), 0)
	_plant.process_mode = Node.PROCESS_MODE_INHERIT
	await _pass(0.1)
	check(_plant.get_tip_position() != tip, "it moves")


func test_a_plant_stops_simulating_when_it_is_disabled() -> void:
	await _pass(0.1)
	_plant.simulation_enabled = false
	var tip := _plant.get_tip_position()
	await _pass(0.1)
	check_equal(_plant.get_tip_position(), tip, "tip")
	_plant.simulation_enabled = true
	await _pass(0.1)
	check(_plant.get_tip_position() != tip, "it moves")


func test_plants_show_their_own_motion_after_another_has_stopped() -> void:
	_plant.wind = null
	var still := _add_plant(_plant.species)
	var pushed := _add_plant(_plant.species)
	var skeletons: Array[Skeleton3D] = [still.get_skeleton(), pushed.get_skeleton()]
	await frames(2)
	_plant.simulation_enabled = false
	pushed.apply_impulse(2.0 * _plant.species.mass * Vector3.RIGHT)
	await _pass(0.1)
	var shown: Array[float] = []
	for skeleton in skeletons:
		shown.append((skeleton.get_bone_pose_rotation(1) * Vector3.UP).angle_to(Vector3.UP))
	check_near(shown[0], 0.0, 1e-3, "bend that the still one shows")
	check(shown[1] > 0.02, "the pushed one shows a bend of %f rad" % shown[1])


func test_time_scale_zero_stops_time() -> void:
	await _pass(0.2)
	Engine.time_scale = 0.0
	await frames(2)
	var tip := _plant.get_tip_position()
	await frames(20)
	check_equal(_plant.get_tip_position(), tip, "tip")
	Engine.time_scale = 1.0
	await frames(1)
	_check_moved_smoothly(tip, "as time goes on")


func test_time_scale_hundred_is_fast_and_finite() -> void:
	Engine.time_scale = 100.0
	_plant.wind.kind = PlantWind.KIND_BURSTS
	for i in 50:
		await frames(1)
		check_near(_plant.get_tip_position().length(), _plant.get_plant_height(), 1e-4, "distance")


func test_the_thesis_step_of_32_ms_works_and_moves_no_plant() -> void:
	await _pass(0.2)
	var tip := _plant.get_tip_position()
	PlantSimulation.step_length = 0.032
	check_near(PlantSimulation.step_length, 0.032, 1e-9, "step")
	check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, "tip")
	check_equal(PlantSimulation.get_plant_count(), 1)
	_plant.reset_motion()
	var before := _plant.wind.get_time()
	await _pass(0.3)
	var steps := (_plant.wind.get_time() - before) / 0.032
	check(steps >= 8.0, "it steps, %f times" % steps)
	check_near(steps, roundf(steps), 1e-6, "whole steps of 32 ms")
	var other := _add_plant(_plant.species)
	other.simulation_enabled = false
	other.wind = _make_wind()
	for i in roundi(steps):
		other.advance(0.032)
	check_near(_plant.get_tip_position(), other.get_tip_position(), TIP_TOLERANCE, "tip")


func test_a_step_of_another_length_moves_driven_plants_on() -> void:
	_plant.simulation_enabled = false
	_plant.advance(0.2)
	var tip := _plant.get_tip_position()
	PlantSimulation.step_length = 0.032
	_plant.advance(0.0)
	check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, "tip")
	_plant.advance(0.1)
	check(_plant.get_tip_position() != tip, "it moves")


func test_impossible_step_lengths_give_one_error_and_are_not_kept() -> void:
	for seconds: float in [0.0, -1.0, 1e-9, 0.2, NAN, INF]:
		PlantSimulation.step_length = seconds
		check_error("step_length cannot be ")
		check_equal(PlantSimulation.step_length, _usual_step)


func test_changes_while_running_keep_the_tip_where_it_is() -> void:
	await _pass(0.3)
	var changes := {
		"law": PlantFunction.LAW_ELASTICITY,
		"elasticity": 2.0,
		"mass": 0.6,
		"natural_frequency": 2.0,
		"shape_deviation": 0.5,
	}
	for property: String in changes:
		var tip := _plant.get_tip_position()
		_plant.species.set(property, changes[property])
		check_near(_plant.get_tip_position(), tip, TIP_TOLERANCE, property)
		await frames(1)
		_check_moved_smoothly(tip, property)
	check_equal(PlantSimulation.get_plant_count(), 1)


func test_functions_and_winds_changed_while_running_keep_the_direction() -> void:
	await _pass(0.3)
	for function: PlantFunction in [ReedFunction.new(), TulipFunction.new()]:
		var direction := _plant.get_tip_position().normalized()
		_plant.species = function
		_plant.wind = _make_wind()
		var now := _plant.get_tip_position().normalized()
		check_near(now, direction, TIP_TOLERANCE, function.get_class())
		await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 1)


func test_pushed_and_reset_while_running() -> void:
	_plant.wind = null
	_plant.apply_impulse(Vector3(0.3, 0, 0))
	await _pass(0.1)
	check(_plant.get_tip_position().x > 0.01, "it was pushed")
	_plant.reset_motion()
	check_equal(_plant.get_deflection(), 0.0, "deflection")
	await _pass(0.1)
	check_near(_plant.get_deflection(), 0.0, 1e-5, "deflection later")


func test_a_hidden_plant_goes_on_moving() -> void:
	_plant.hide()
	await _pass(0.2)
	check(_plant.get_deflection() > 0.01, "it moves")
	_plant.show()
	await frames(2)
	_check_bone_near_the_tip()


func _check_moved_smoothly(from: Vector3, label: String) -> void:
	var maximum := LARGEST_SPEED * (root.get_process_delta_time() + STEP)
	check_near(_plant.get_tip_position(), from, maximum, "tip " + label)


func _check_bone_near_the_tip() -> void:
	# The drawn bone is between the last two steps.
	var turned := _plant.get_skeleton().get_bone_pose_rotation(1) * Vector3.UP
	check(turned.angle_to(_plant.get_tip_position()) < 0.15, "the bone points to the tip")


func _add_plant(function: PlantFunction) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = function
	root.add_child(plant)
	return plant


func _make_wind() -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	wind.strength = 1.0
	return wind


## Waits for [param seconds] of the scene's time.
func _pass(seconds: float) -> void:
	var passed := 0.0
	while passed < seconds:
		await frames(1)
		passed += root.get_process_delta_time()
