## Stems that bend along their length: their bones, swings and invariants.
extends "res://tests/engine/stem_harness.gd"

## Tolerance of the length of the chain of bones, as a fraction.
const CHAIN_TOLERANCE := 1e-5
const FREQUENCY_TOLERANCE := 0.005
const DAMPING_TOLERANCE := 0.003
const TIP_TOLERANCE := 1e-5


func test_a_stem_has_a_bone_for_each_joint() -> void:
	for joints: int in [1, 4, 8]:
		reed.species.stem.joints = joints
		await frames(1)
		var skeleton := reed.get_skeleton()
		var expected: PackedStringArray = ["root", "tip"]
		for joint in joints:
			expected.append("stem_%d" % (joint + 1))
		var names: PackedStringArray = []
		for bone in skeleton.get_bone_count():
			names.append(skeleton.get_bone_name(bone))
		check_equal(names, expected, "bones")
		check_equal(reed.get_joint_count(), joints, "joints")


func test_other_laws_have_one_joint() -> void:
	reed.species.law = PlantFunction.LAW_SPRING
	await frames(1)
	check_equal(reed.get_joint_count(), 1, "joints")
	check_equal(reed.get_skeleton().get_bone_count(), 2, "bones")
	check_near(reed.get_joint_position(1), reed.get_tip_position(), TIP_TOLERANCE, "tip")


func test_leaning_stems_nod_under_their_weight_if_they_are_to() -> void:
	reed.species.lean = deg_to_rad(15.0)
	var bends: Array[float] = []
	for nods: bool in [false, true]:
		reed.species.stem.nods = nods
		await frames(1)
		reed.reset_motion()
		reed.advance(0.001)
		bends.append(reed.get_deflection())
	check_near(bends[0], 0.0, 1e-3, "bend of a stem that does not")
	check(bends[1] > 0.03, "bend of one that does: %.3f" % bends[1])
	for i in 600:
		reed.advance(1.0 / 60.0)
	check_near(reed.get_deflection(), bends[1], 0.002, "bend after ten seconds")
	reed.species.lean = 0.0
	reed.species.stem.nods = false


func test_a_plant_without_simulation_has_the_bend_of_its_weight() -> void:
	reed.species.stem.nods = true
	var bends: Array[float] = []
	for lean: float in [0.0, 10.0, 20.0]:
		reed.species.lean = deg_to_rad(lean)
		reed.reset_motion()
		await frames(2)
		var unmoved := reed.get_deflection()
		bends.append(unmoved)
		for i in 600:
			reed.advance(1.0 / 60.0)
		check_near(reed.get_deflection(), unmoved, 1e-3, "bend at once, lean %d" % lean)
	check_near(bends[0], 0.0, 1e-4, "bend of an upright stem")
	check(bends[1] > 0.02 and bends[2] > 1.5 * bends[1], "bends of leaning stems: %s" % [bends])
	reed.reset_motion()
	reed.species.stem.nods = false
	await frames(2)
	check_near(reed.get_deflection(), 0.0, 1e-3, "bend without its weight")
	reed.species.stem.nods = true
	await frames(2)
	check_near(reed.get_deflection(), bends[2], 1e-3, "bend with its weight again")
	var parent := reed.get_parent()
	parent.remove_child(reed)
	parent.add_child(reed)
	await frames(2)
	check_near(reed.get_deflection(), bends[2], 1e-3, "bend in the tree again")
	reed.species.lean = 0.0
	reed.species.stem.nods = false


func test_the_chain_of_bones_keeps_its_length() -> void:
	for joints: int in [1, 2, 4, 8]:
		reed.species.stem.joints = joints
		await frames(1)
		for push: float in [0.001, 0.1, 10.0]:
			reed.reset_motion()
			reed.apply_impulse(Vector3(push, 0, -0.3 * push))
			swing(reed, 12)
			var skeleton := reed.get_skeleton()
			var from := Vector3.ZERO
			var length := 0.0
			for bone: String in _chain(joints):
				var pose := skeleton.get_bone_global_pose(skeleton.find_bone(bone))
				length += from.distance_to(pose.origin)
				from = pose.origin
			var height := reed.get_plant_height()
			check_near(
				length, height, CHAIN_TOLERANCE * height, "%d joints, %s N s" % [joints, push]
			)


func test_a_stem_swings_as_it_is_declared() -> void:
	for declared: Vector2 in [Vector2(0.7, 0.05), Vector2(1.9, 0.02), Vector2(1.0, 0.15)]:
		reed.species.natural_frequency = declared.x
		reed.species.damping_ratio = declared.y
		for height: float in [0.3, 1.5]:
			reed.height = height
			await frames(1)
			var seen := _ring_down(reed)
			var what := "of %.1f Hz, %.2f, %.1f m" % [declared.x, declared.y, height]
			check_near(seen.x / declared.x, 1.0, FREQUENCY_TOLERANCE, "frequency " + what)
			check_near(seen.y, declared.y, DAMPING_TOLERANCE, "damping " + what)


func test_joints_show_the_motion_and_do_not_change_it() -> void:
	var twin := add_stem(make_reed())
	twin.species.stem.joints = 8
	await frames(1)
	for plant: Plant3D in [reed, twin]:
		plant.apply_impulse(Vector3(0.002, 0, 0))
		swing(plant, 20)
	check(reed.get_deflection() > 0.02, "it swings, %f" % reed.get_deflection())
	check_near(twin.get_deflection(), reed.get_deflection(), 1e-5, "bend")


func test_other_joints_rebuild_the_mesh_and_preserve_the_motion() -> void:
	reed.apply_impulse(Vector3(0.002, 0, 0))
	swing(reed, 20)
	var mesh := reed.get_mesh()
	var tip := reed.get_tip_position()
	reed.species.stem.joints = 6
	await frames(1)
	check(reed.get_mesh() != mesh, "the mesh is another one")
	check_equal(reed.get_joint_count(), 6, "joints")
	check_near(reed.get_tip_position(), tip, 1e-4, "tip")


func test_what_a_stem_is_made_of_leaves_its_mesh() -> void:
	var mesh := reed.get_mesh()
	var signals := [0]
	reed.mesh_changed.connect(func() -> void: signals[0] += 1)
	reed.species.natural_frequency = 2.0
	reed.species.damping_ratio = 0.2
	reed.species.stem.youngs_modulus = 4e9
	reed.species.stem.diameter = 0.006
	reed.species.stem.wind_weights = PackedFloat32Array([0, 0, 0, 1])
	await frames(2)
	check(reed.get_mesh() == mesh, "the mesh stays")
	check_equal(signals[0], 0, "changes signalled")


func test_an_impulse_on_a_lower_joint_moves_the_tip_less() -> void:
	var before := 0.0
	for joint: int in [1, 2, 3, 4]:
		reed.reset_motion()
		reed.apply_impulse(Vector3(0.0005, 0, 0), joint)
		swing(reed, 10)
		var way := reed.get_tip_position().x
		check(way > 1.5 * before, "joint %d moves it %f m, the one below %f" % [joint, way, before])
		before = way
	reed.reset_motion()
	reed.apply_impulse(Vector3(0.0005, 0, 0))
	swing(reed, 10)
	check_near(reed.get_tip_position().x, before, TIP_TOLERANCE, "the tip is meant by default")


func test_tall_stems_of_one_material_are_slow() -> void:
	reed.species.damping_ratio = 0.05
	reed.species.stem.diameter = 0.006
	reed.species.stem.taper = 0.3
	reed.species.stem.head_mass = 0.0
	reed.species.stem.youngs_modulus = 4e9
	var before := INF
	for height: float in [0.5, 0.9, 1.5]:
		reed.height = height
		await frames(1)
		var seen := _ring_down(reed).x
		check(seen < 0.5 * before, "%.1f m swing at %.2f Hz" % [height, seen])
		before = seen
	reed.species.stem.head_mass = 0.002
	await frames(1)
	check(_ring_down(reed).x < 0.9 * before, "a head slows it")


func test_a_scene_with_a_stem_is_saved() -> void:
	var stem := reed.species.stem
	stem.joints = 7
	stem.youngs_modulus = 3e9
	stem.wind_weights = PackedFloat32Array([0, 0, 0, 0, 0, 0, 1])
	var scene := PackedScene.new()
	scene.pack(reed)
	check_equal(ResourceSaver.save(scene, PATH), OK, "saving")
	var loaded: PackedScene = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	var twin: Plant3D = loaded.instantiate()
	root.add_child(twin)
	check_equal(twin.species.law, PlantFunction.LAW_STEM, "law")
	for property: String in ["joints", "youngs_modulus", "wind_weights", "taper", "density"]:
		check_equal(twin.species.stem.get(property), stem.get(property), property)
	check_equal(twin.get_joint_count(), 7, "joints")


func test_a_stem_goes_on_from_the_state_of_another() -> void:
	reed.apply_impulse(Vector3(0.003, 0, 0.001))
	swing(reed, 20)
	var twin := add_stem(reed.species)
	twin.set_motion_state(reed.get_motion_state())
	check_near(twin.get_tip_position(), reed.get_tip_position(), TIP_TOLERANCE, "tip")
	swing(reed, 50)
	swing(twin, 50)
	check_near(twin.get_tip_position(), reed.get_tip_position(), 10 * TIP_TOLERANCE, "later")


func test_a_stem_continues_both_modes_when_its_simulation_restarts() -> void:
	reed.species.stem.modes = 2
	var twin := add_stem(reed.species)
	await frames(1)
	for plant: Plant3D in [reed, twin]:
		plant.simulation_enabled = true
		plant.apply_impulse(Vector3(0.004, 0, 0.002), 2)
	await frames(5)
	twin.simulation_enabled = false
	twin.simulation_enabled = true
	await frames(5)
	check(reed.get_deflection() > 1e-3, "it swings, %f" % reed.get_deflection())
	check_equal(twin.get_tip_position(), reed.get_tip_position(), "tip")
	check_equal(twin.get_joint_position(2), reed.get_joint_position(2), "joint")


func test_a_state_holds_both_modes() -> void:
	reed.species.stem.modes = 2
	await frames(1)
	reed.apply_impulse(Vector3(0.004, 0, 0.002), 2)
	swing(reed, 7)
	var state := reed.get_motion_state()
	check_equal(state.size(), 12, "numbers")
	check(Vector3(state[6], state[7], state[8]).length() > 1e-3, "the second mode is bent")
	check(Vector3(state[9], state[10], state[11]).length() > 0.1, "and moves")
	var twins: Array[Plant3D] = [add_stem(reed.species), add_stem(reed.species)]
	twins[0].set_motion_state(state)
	twins[1].set_motion_state(state.slice(0, 6))
	for i in 12:
		check_near(twins[0].get_motion_state()[i], state[i], 1e-4, "number %d" % i)
	for plant: Plant3D in [reed, twins[0], twins[1]]:
		swing(plant, 5)
	check_near(twins[0].get_joint_position(2), reed.get_joint_position(2), 2e-4, "joint")
	var away := twins[1].get_joint_position(2).distance_to(reed.get_joint_position(2))
	check(away > 1e-3, "the tip alone does not say it: %f m" % away)


func test_a_species_is_set_on_an_existing_plant() -> void:
	var plant := Plant3D.new()
	root.add_child(plant)
	await frames(1)
	var species := make_reed()
	species.stem.youngs_modulus = 4e9
	plant.species = species
	plant.apply_impulse(Vector3(0.002, 0, 0))
	await frames(3)
	check(plant.get_tip_position().is_finite(), "it has a tip")
	check_equal(plant.get_joint_count(), 4, "joints")


func test_a_point_is_in_a_stem_where_that_is_bent_to() -> void:
	reed.touch_margin = 0.0
	reed.species.collision_radius = 0.01
	reed.species.stem.joints = 8
	await frames(1)
	reed.apply_impulse(Vector3(0.05, 0, 0))
	swing(reed, 8)
	check(reed.get_deflection() > 0.3, "it is bent, %f" % reed.get_deflection())
	for joint in range(1, 9):
		var place := reed.get_joint_position(joint)
		check(reed.is_point_in_plants(place), "joint %d" % joint)
	var straight := 0.5 * reed.get_tip_position()
	check(not reed.is_point_in_plants(straight + Vector3(0.03, 0, 0)), "beside it")


## Returns the bones of the stem and of the tip, from the root up.
func _chain(joints: int) -> PackedStringArray:
	var names: PackedStringArray = []
	for joint in joints:
		names.append("stem_%d" % (joint + 1))
	names.append("tip")
	return names


## Returns the frequency (Hz) and damping ratio after a small blow, by the times at which the tip
## passes its rest and the amplitudes between.
func _ring_down(plant: Plant3D) -> Vector2:
	plant.reset_motion()
	plant.apply_impulse(Vector3(1e-5, 0, 0))
	var times: PackedFloat64Array = []
	var peaks: PackedFloat64Array = [0.0]
	var last := 0.0
	for i in range(1, 2000):
		plant.advance(STEP)
		var now := plant.get_tip_position().x
		if last > 0.0 and now <= 0.0:
			times.append(i - 1 + last / (last - now))
			peaks.append(0.0)
		peaks[-1] = maxf(peaks[-1], now)
		last = now
		if times.size() == 7:
			break
	if times.size() < 7:
		return Vector2.ZERO
	var damped := (times[6] - times[0]) / 6.0 * STEP
	var shrinks := log(peaks[1] / peaks[5]) / 4.0
	var ratio := shrinks / sqrt(TAU * TAU + shrinks * shrinks)
	return Vector2(1.0 / (damped * sqrt(1.0 - ratio * ratio)), ratio)
