## Reading and writing a plant's motion, and the report of a changed mesh.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const TIP_TOLERANCE := 1e-5

var _plant: Plant3D
var _signals := 0
var _usual_step := PlantSimulation.step_length


func before_each() -> void:
	_signals = 0
	_plant = _add()


func after_each() -> void:
	PlantSimulation.step_length = _usual_step
	for child in root.get_children():
		if child is Plant3D:
			child.free()


func test_a_plant_goes_on_from_the_state_of_another() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		_plant.species.law = law
		_plant.apply_impulse(Vector3(0.3, 0, 0.1))
		_run(_plant, 20)
		var twin := _add()
		twin.species = _plant.species
		twin.set_motion_state(_plant.get_motion_state())
		check_near(twin.get_tip_position(), _plant.get_tip_position(), TIP_TOLERANCE, "tip")
		check_near(_bone_direction(twin), twin.get_tip_position().normalized(), 1e-4, "bone")
		_run(_plant, 50)
		_run(twin, 50)
		check_near(twin.get_tip_position(), _plant.get_tip_position(), 10 * TIP_TOLERANCE, "later")


func test_a_simulating_plant_takes_a_state() -> void:
	_plant.apply_impulse(Vector3(0.3, 0, 0.1))
	_run(_plant, 20)
	var twin := _add()
	twin.simulation_enabled = true
	twin.set_motion_state(_plant.get_motion_state())
	check_near(twin.get_tip_position(), _plant.get_tip_position(), TIP_TOLERANCE, "tip")


func test_a_state_is_in_the_plants_own_axes() -> void:
	_plant.apply_impulse(Vector3(0.3, 0, 0))
	_run(_plant, 10)
	var tip := _plant.get_tip_position()
	var state := _plant.get_motion_state()
	check_equal(state.size(), 12, "floats")
	var direction := Vector3(state[0], state[1], state[2])
	check_near(direction, tip.normalized(), TIP_TOLERANCE, "direction")
	var twin := _add()
	twin.rotation_degrees = Vector3(0, 90, 0)
	await frames(1)
	twin.set_motion_state(state)
	check_near(twin.get_tip_position(), tip, TIP_TOLERANCE, "tip")
	_run(_plant, 30)
	_run(twin, 30)
	check(tip.distance_to(twin.get_tip_position()) > 0.01, "it swings on")
	check_near(twin.get_tip_position(), _plant.get_tip_position(), 10 * TIP_TOLERANCE, "later")
	_plant.reset_motion()
	_plant.set_motion_state(twin.get_motion_state())
	_run(_plant, 30)
	_run(twin, 30)
	check_near(twin.get_tip_position(), _plant.get_tip_position(), 10 * TIP_TOLERANCE, "later")


func test_a_plant_that_goes_to_other_company_is_drawn_without_a_jump() -> void:
	await _check_other_company(Vector3(1.0, 0, 0))


func test_a_plant_that_hangs_goes_to_other_company_without_a_jump() -> void:
	# Plants with a rest far from upright are simulated in other axes than the world's.
	_plant.species.law = PlantFunction.LAW_SPRING
	_plant.rotation.z = -0.5 * PI
	await _check_other_company(Vector3(0, 1.0, 0))


func test_a_state_that_is_none_is_refused_with_one_error() -> void:
	_plant.apply_impulse(Vector3(0.3, 0, 0))
	_run(_plant, 10)
	var before := _plant.get_motion_state()
	for bad: Array in [
		[], [0, 1, 0], [0, 1, 0, 0, 0, NAN], [0, INF, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]
	]:
		_plant.set_motion_state(PackedFloat32Array(bad))
		check_error("set_motion_state() needs twelve finite numbers")
		check_equal(_plant.get_motion_state(), before, "state")


func test_a_changed_mesh_is_signalled() -> void:
	await frames(1)
	_plant.mesh_changed.connect(func() -> void: _signals += 1)
	_plant.height = 1.2
	_plant.seed = 4
	await frames(1)
	check_equal(_signals, 1, "signals for two changes of one frame")
	_plant.species.mass = 2.0
	_plant.height = 1.2
	_plant.segments = _plant.segments
	_plant.seed = 4
	await frames(1)
	check_equal(_signals, 1, "signals where the mesh stays")
	_plant.rebuild()
	check_equal(_signals, 2, "signals of a mesh that is built now")


func test_setting_what_is_set_already_builds_nothing() -> void:
	await frames(1)
	var mesh := _plant.get_mesh()
	for property: String in ["species", "segments", "height", "seed", "wind", "simulation_enabled"]:
		_plant.set(property, _plant.get(property))
	await frames(1)
	check(_plant.get_mesh() == mesh, "the mesh is the same")


func _add() -> Plant3D:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.height = 1.0
	plant.simulation_enabled = false
	root.add_child(plant)
	return plant


func _run(plant: Plant3D, steps: int) -> void:
	for i in steps:
		plant.advance(STEP)


func _bone_direction(plant: Plant3D) -> Vector3:
	return plant.get_skeleton().get_bone_pose_rotation(1) * Vector3.UP


func _check_other_company(impulse: Vector3) -> void:
	PlantSimulation.step_length = 0.1  # A pose without the last step would be visible.
	_plant.simulation_enabled = true
	_plant.get_skeleton()
	_plant.apply_impulse(impulse)
	for i in 2000:
		await frames(1)
		if _bone_direction(_plant).angle_to(Vector3.UP) > 0.3:
			break
	await frames(1)
	var shown := _bone_direction(_plant)
	check(shown.angle_to(Vector3.UP) > 0.2, "it is bent")
	_plant.species.mass *= 1.01
	for i in 8:  # More than a step.
		await frames(1)
		var now := _bone_direction(_plant)
		check(now.angle_to(shown) < 0.1, "the bone goes on in frame %d" % i)
		shown = now
