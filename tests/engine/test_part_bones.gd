## The bones of plants of parts, in a Plant3D and in a field near cameras.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const SPECIES := ["garden_tulip", "meadow_grass", "oxeye_daisy"]

var _plant: Plant3D


func before_each() -> void:
	_plant = Plant3D.new()
	_plant.species = _load("garden_tulip")
	_plant.seed = 5
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_CONSTANT
	_plant.wind.strength = 6.0
	_plant.simulation_enabled = false
	root.add_child(_plant)


func after_each() -> void:
	_plant.free()


func test_root_and_tip_have_fixed_names_and_parts_have_up_to_30_bones() -> void:
	for species: String in SPECIES:
		_plant.species = _load(species)
		var skeleton := _plant.get_skeleton()
		var first := 2 + _plant.get_joint_count()
		check_equal(skeleton.get_bone_name(0), "root", species)
		check_equal(skeleton.get_bone_name(1), "tip", species)
		check(skeleton.get_bone_count() > first, species + " has bones of its parts")
		check(skeleton.get_bone_count() <= first + 30, species + " has 30 bones of parts at most")
		check_equal(skeleton.get_bone_name(first - 1), "stem_4", species)
		for bone in range(first, skeleton.get_bone_count()):
			check(
				skeleton.get_bone_parent(bone) >= 2,
				"%s bone %d hangs on the stem" % [species, bone]
			)


func test_a_tulip_has_bones_for_its_leaves_and_one_for_its_head() -> void:
	var skeleton := _plant.get_skeleton()
	var head := skeleton.get_bone_global_rest(skeleton.find_bone("head")).origin
	check_near(
		head.y, _plant.get_plant_height(), 0.15 * _plant.get_plant_height(), "the head's height"
	)
	var leaf := skeleton.get_bone_global_rest(skeleton.find_bone("leaf_1")).origin
	check(leaf.y > 0.0 and leaf.y < 0.3 * _plant.get_plant_height(), "a leaf is attached low")
	check_equal(skeleton.find_bone("stem_1"), 2, "bones of the stem")


func test_weights_of_a_vertex_are_of_bones_that_there_are() -> void:
	for species: String in SPECIES:
		_plant.species = _load(species)
		var count := _plant.get_skeleton().get_bone_count()
		var arrays := _plant.get_mesh().surface_get_arrays(0)
		var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
		var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
		var maximum := 0
		var worst := 0.0
		for i in range(0, weights.size(), 4):
			worst = maxf(
				worst, absf(weights[i] + weights[i + 1] + weights[i + 2] + weights[i + 3] - 1.0)
			)
			for k in range(i, i + 4):
				maximum = maxi(maximum, bones[k])
		check_equal(maximum, count - 1, species + ": the last bone")
		check_near(worst, 0.0, 1e-4, species + ": sums of weights")


## Shaders and bones move each vertex in calm air to the same position.
func test_the_calm_plant_of_a_mesh_is_that_of_its_bones() -> void:
	var leaning := _load("garden_tulip").duplicate() as PlantFunction
	leaning.lean = deg_to_rad(25.0)
	_plant.species = leaning
	_plant.wind.strength = 0.0
	_plant.reset_motion()
	await frames(2)
	var skeleton := _plant.get_skeleton()
	var arrays := _plant.get_mesh().surface_get_arrays(0)
	var places: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
	var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
	var calm: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM3]
	var farthest := 0.0
	var leant := 0.0
	for i in places.size():
		var place := Vector3.ZERO
		for k in range(4 * i, 4 * i + 4):
			var bone := bones[k]
			var from_rest := skeleton.get_bone_global_rest(bone).affine_inverse()
			place += weights[k] * (skeleton.get_bone_global_pose(bone) * from_rest * places[i])
		var reported := Vector2(calm[4 * i + 2], calm[4 * i + 3])
		farthest = maxf(farthest, reported.distance_to(Vector2(place.x, place.z)))
		leant = maxf(leant, reported.distance_to(Vector2(places[i].x, places[i].z)))
	check(leant > 0.05, "it leans by %f m" % leant)
	check_near(farthest, 0.0, 2e-3, "m between the two")


func test_leaves_lag_behind_their_stem_and_each_in_its_own_way() -> void:
	var skeleton := _plant.get_skeleton()
	for i in 12:
		_plant.advance(STEP)
	var turns: Array[float] = []
	for bone in ["leaf_1", "leaf_2", "leaf_3"]:
		turns.append(_turn_of(skeleton, bone))
	check(turns.max() > 0.02, "leaves turn on their stem: %s" % [turns])
	check(absf(turns[0] - turns[1]) > 1e-3 and absf(turns[1] - turns[2]) > 1e-3, "%s" % [turns])


func test_twigs_of_a_hazel_have_bones_on_those_of_its_branches() -> void:
	_plant.species = _load("hazel")
	var skeleton := _plant.get_skeleton()
	var twigs := 0
	for bone in skeleton.get_bone_count():
		if skeleton.get_bone_name(bone).begins_with("twig_"):
			twigs += 1
			var branch := skeleton.get_bone_name(skeleton.get_bone_parent(bone))
			check(branch.begins_with("leaf_"), "a twig on %s" % branch)
	check(twigs > 10 and twigs <= 32, "%d bones of twigs" % twigs)


func test_twigs_turn_on_their_branches_and_each_in_its_own_way() -> void:
	_plant.species = _load("hazel")
	var skeleton := _plant.get_skeleton()
	var turns: Array[float] = []
	for bone in ["twig_1", "twig_2", "twig_3"]:
		check_near(_turn_of(skeleton, bone), 0.0, 1e-5, bone + " at rest")
	for i in 12:
		_plant.advance(STEP)
	for bone in ["twig_1", "twig_2", "twig_3"]:
		turns.append(_turn_of(skeleton, bone))
	check(turns.max() > 0.01, "twigs turn on their branch: %s" % [turns])
	check(absf(turns[0] - turns[1]) > 1e-3 and absf(turns[1] - turns[2]) > 1e-3, "%s" % [turns])


func test_the_second_mode_of_a_leaning_stem_bends_it_as_that_of_an_upright_one() -> void:
	var ways: Array[float] = []
	for lean: float in [0.0, 0.8]:
		var species := _load("garden_tulip").duplicate(true) as PlantFunction
		species.lean = lean
		species.stem.modes = 2
		_plant.species = species
		_plant.wind.strength = 0.0
		_plant.reset_motion()
		var skeleton := _plant.get_skeleton()
		var joint := skeleton.find_bone("stem_3")
		var before := skeleton.get_bone_global_pose(joint).origin
		var rest := _plant.get_tip_position().normalized()
		var way := Vector3(rest.x, 0, rest.z).normalized() if lean > 0.0 else Vector3.RIGHT
		var bend := Quaternion(Vector3.UP, rest) * (0.3 * way)
		var state := PackedFloat32Array(
			[rest.x, rest.y, rest.z, 0, 0, 0, bend.x, bend.y, bend.z, 0, 0, 0]
		)
		_plant.set_motion_state(state)
		_plant.advance(1e-3)
		ways.append(skeleton.get_bone_global_pose(joint).origin.distance_to(before))
	check(ways[0] > 0.005, "the upright stem is bent by %f m" % ways[0])
	check_near(ways[1], ways[0], 0.1 * ways[0], "way of the leaning one")


func test_a_plant_at_rest_has_still_leaves_and_comes_back_to_rest() -> void:
	_plant.wind.strength = 0.0
	var skeleton := _plant.get_skeleton()
	_plant.advance(0.5)
	check_near(_turn_of(skeleton, "leaf_1"), 0.0, 1e-5, "without wind")
	_plant.apply_impulse(Vector3(0.08, 0.0, 0.04))
	var maximum := 0.0
	for i in 12:
		_plant.advance(STEP)
		maximum = maxf(maximum, _turn_of(skeleton, "leaf_1"))
	check(maximum > 0.05, "after a blow")
	_plant.species.damping_ratio = 1.0
	for i in 300:
		_plant.advance(STEP)
	check_near(_turn_of(skeleton, "leaf_1"), 0.0, 1e-4, "later")


func test_leaves_flutter_on_in_a_steady_wind() -> void:
	for i in 1200:
		_plant.advance(STEP)
	var skeleton := _plant.get_skeleton()
	var tip := _plant.get_tip_position()
	var minimum := INF
	var maximum := 0.0
	for i in 90:
		_plant.advance(STEP)
		var turn := _turn_of(skeleton, "leaf_1")
		minimum = minf(minimum, turn)
		maximum = maxf(maximum, turn)
	check_near(_plant.get_tip_position(), tip, 1e-3, "the stem does not move")
	check(maximum - minimum > 0.01, "a leaf turns by %f rad" % (maximum - minimum))


func test_reset_motion_puts_leaves_into_their_rest() -> void:
	for i in 12:
		_plant.advance(STEP)
	check(_turn_of(_plant.get_skeleton(), "leaf_2") > 0.005, "it is bent")
	_plant.reset_motion()
	check_near(_turn_of(_plant.get_skeleton(), "leaf_2"), 0.0, 1e-5, "it rests")


func test_frequency_and_damping_of_a_leaf_matter() -> void:
	var turns: Array[float] = []
	for change: Array in [[2.5, 0.12], [8.0, 0.12], [2.5, 1.0]]:
		var leaf := PlantBlade.of(
			{
				length = Vector2(0.2, 0.2),
				width = 0.03,
				frequency = change[0],
				damping_ratio = change[1]
			}
		)
		var line := PlantArrangement.new()
		line.part = leaf
		line.count = Vector2i(1, 1)
		line.angle = Vector2(0.6, 0.6)
		line.from = 0.5
		var species := PlantFunction.new()
		species.arrangements = [line]
		_plant.species = species
		_plant.reset_motion()
		for i in 10:
			_plant.advance(STEP)
		turns.append(_turn_of(_plant.get_skeleton(), "leaf_1"))
	check(absf(turns[0] - turns[1]) > 1e-3, "frequency: %s" % [turns])
	check(absf(turns[0] - turns[2]) > 1e-3, "damping: %s" % [turns])


func test_a_plant_of_another_species_has_its_bones_only() -> void:
	check(_plant.get_skeleton().get_bone_count() > 2, "a tulip of parts")
	_plant.species = TulipFunction.new()
	check_equal(_plant.get_skeleton().get_bone_count(), 2, "bones of a lathe")
	_plant.species = _load("lawn_grass")
	check(_plant.get_skeleton().find_bone("tuft_1") >= 2, "grass")


func test_a_mesh_alone_is_bound_to_root_and_tip() -> void:
	var mesh := _plant.species.generate_mesh(0.4, 12, 5)
	var bones: PackedInt32Array = mesh.surface_get_arrays(0)[Mesh.ARRAY_BONES]
	check_equal(Array(bones).max(), 1, "the last bone")


func test_skeletons_of_a_field_have_the_same_bones_and_swing() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position = Vector3(0.5, 0.5, 1.0)
	var field := PlantField3D.new()
	field.density = 0.0
	field.wind = _plant.wind
	field.skeleton_distance = 10.0
	root.add_child(field)
	field.rebuild()
	while field.is_building():
		await process_frame
	var id := field.add_plants([Transform3D.IDENTITY], _plant.species)[0]
	var skeleton: Skeleton3D = null
	for i in 100:
		await frames(1)
		skeleton = field.get_skeleton(id)
		if skeleton:
			break
	check(skeleton != null, "a plant near the camera has a skeleton")
	if skeleton:
		check(skeleton.find_bone("leaf_1") >= 2, "it has bones of leaves")
		var maximum := 0.0
		for i in 30:
			await frames(1)
			maximum = maxf(maximum, _turn_of(skeleton, "leaf_1"))
		check(maximum > 0.01, "they swing")
	field.free()
	camera.free()


func _load(species: String) -> PlantFunction:
	return load("res://addons/undergrowth/species/%s.tres" % species).duplicate()


## Returns the rotation of a bone relative to its parent's share of the stem's bend, in radians.
func _turn_of(skeleton: Skeleton3D, bone: String) -> float:
	var index := skeleton.find_bone(bone)
	var turned := skeleton.get_bone_global_pose(index).basis.get_rotation_quaternion()
	var tip := skeleton.get_bone_global_pose(1).basis.get_rotation_quaternion()
	var share := skeleton.get_bone_global_rest(index).origin.y / _plant.get_plant_height()
	return turned.angle_to(Quaternion.IDENTITY.slerp(tip, clampf(share, 0.0, 1.0)))
