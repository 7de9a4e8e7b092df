## Plant3D: its meshes, its rebuilds, and the errors of invalid settings.
extends "res://tests/engine/harness.gd"

var _plant: Plant3D


func before_each() -> void:
	_plant = Plant3D.new()
	_plant.species = TulipFunction.new()
	_plant.simulation_enabled = false
	root.add_child(_plant)


func after_each() -> void:
	if is_instance_valid(_plant):
		_plant.free()


func test_it_has_two_bones_at_the_root() -> void:
	var skeleton := _plant.get_skeleton()
	check_equal(skeleton.get_bone_count(), 2)
	check_equal(skeleton.get_bone_parent(0), -1, "parent of the root")
	check_equal(skeleton.get_bone_parent(1), 0, "parent of the tip")
	for bone in 2:
		check_equal(skeleton.get_bone_global_pose(bone), Transform3D.IDENTITY, "pose")


func test_its_mesh_hangs_below_the_skeleton() -> void:
	var skeleton := _plant.get_skeleton()
	var instance := _instance()
	check(instance.get_parent() == skeleton, "the mesh is a child of the skeleton")
	check(instance.mesh == _plant.get_mesh(), "which shows the plant's mesh")
	check(instance.get_node(instance.skeleton) == skeleton, "and is bent by the skeleton")
	check_equal(instance.skin.get_bind_count(), 2, "binds")
	for bone in 2:
		check_equal(instance.skin.get_bind_bone(bone), bone, "bone of a bind")
		check_equal(instance.skin.get_bind_pose(bone), Transform3D.IDENTITY, "pose of a bind")


func test_its_children_are_internal() -> void:
	check_equal(_plant.get_child_count(), 0, "children to see")
	check_equal(_plant.get_child_count(true), 1, "children with the skeleton")


func test_plants_share_their_skin() -> void:
	var other := Plant3D.new()
	other.species = GrassFunction.new()
	root.add_child(other)
	check(other.get_skeleton().get_child(0, true).skin == _instance().skin, "one skin")
	other.free()


func test_mesh_height_and_seed_are_the_functions() -> void:
	_plant.seed = 7
	_plant.segments = 9
	var expected := _plant.species.generate_mesh(0.0, 9, 7)
	var arrays := _plant.get_mesh().surface_get_arrays(0)
	check_equal(arrays, expected.surface_get_arrays(0), "mesh")
	check_near(_plant.get_plant_height(), expected.get_aabb().size.y, 1e-6, "height")
	_plant.height = 0.75
	check_near(_plant.get_mesh().get_aabb().size.y, 0.75, 1e-6, "set height")


func test_queries_work_before_it_enters_the_tree() -> void:
	var plant := Plant3D.new()
	plant.species = ReedFunction.new()
	plant.height = 2.0
	check(plant.get_mesh() != null, "a mesh")
	check_equal(plant.get_skeleton().get_bone_count(), 2, "bones")
	check_near(plant.get_tip_position().length(), 2.0, 1e-6, "distance of the tip")
	plant.free()


func test_changes_of_one_frame_are_built_once_at_its_end() -> void:
	await frames(2)
	var counter := _counting_function()
	_plant.species = counter
	await frames(2)
	check_equal(counter.get("builds"), 1, "builds after the function was set")
	var before := _plant.get_mesh()
	_plant.height = 0.5
	_plant.segments = 5
	_plant.seed = 3
	counter.shape_deviation = 0.5
	check_equal(counter.get("builds"), 1, "builds before the frame ends")
	await frames(2)
	check(_plant.get_mesh() != before, "a new mesh in the next")
	check_equal(counter.get("builds"), 2, "builds")
	await frames(5)
	check_equal(counter.get("builds"), 2, "builds after more frames")


func test_a_change_that_leaves_the_mesh_alone_builds_nothing() -> void:
	var counter := _counting_function()
	_plant.species = counter
	await frames(2)
	counter.mass = 3.0
	counter.natural_frequency = 0.5
	counter.law = PlantFunction.LAW_ELASTICITY
	counter.wind_weight = 0.5
	await frames(2)
	check_equal(counter.get("builds"), 1, "builds")


func test_rebuild_builds_at_once() -> void:
	var before := _plant.get_mesh()
	check_equal(_plant.rebuild(), true)
	check(_plant.get_mesh() != before, "a new mesh")


func test_a_changed_function_is_seen_by_all_its_plants() -> void:
	var other := Plant3D.new()
	other.species = _plant.species
	root.add_child(other)
	var tulip: TulipFunction = _plant.species
	tulip.shading = PlantFunction.SHADING_FLAT
	await frames(2)
	var count := tulip.generate_mesh(1.0, 12).surface_get_array_len(0)
	check_equal(_plant.get_mesh().surface_get_array_len(0), count, "flat vertices")
	check_equal(other.get_mesh().surface_get_array_len(0), count, "flat vertices of the other")
	other.free()


func test_a_function_that_was_replaced_is_no_longer_followed() -> void:
	var old := _plant.species
	_plant.species = GrassFunction.new()
	await frames(2)
	var mesh := _plant.get_mesh()
	old.shading = PlantFunction.SHADING_FLAT
	await frames(2)
	check(_plant.get_mesh() == mesh, "the mesh stays")


func test_without_a_species_the_last_plant_stays() -> void:
	var mesh := _plant.get_mesh()
	_plant.species = null
	await frames(10)
	check_error("has no species any more")
	check(_plant.get_mesh() == mesh, "the mesh stays")
	_plant.height = 0.5
	_plant.advance(0.1)
	_plant.apply_impulse(Vector3.RIGHT)
	_plant.reset_motion()
	await frames(10)
	check(_instance().mesh == mesh, "and is still shown")
	_plant.species = GrassFunction.new()
	check_near(_plant.get_plant_height(), 0.5, 1e-6, "the next plant's height")


func test_a_plant_without_a_species_is_no_plant_yet() -> void:
	var plant := Plant3D.new()
	root.add_child(plant)
	await frames(3)
	check(plant.get_mesh() == null, "no mesh")
	check(plant.get_skeleton() == null, "no skeleton")
	check_equal(plant.get_tip_position(), Vector3.ZERO, "tip")
	check_equal(plant.get_deflection(), 0.0, "deflection")
	check_equal(plant.get_reach(), AABB(), "reach")
	check_equal(plant.rebuild(), false, "rebuilt")
	check_error("cannot be built without a species")
	plant.free()


func test_pushing_a_plant_without_a_function_gives_one_error() -> void:
	var plant := Plant3D.new()
	root.add_child(plant)
	plant.apply_impulse(Vector3.RIGHT)
	plant.apply_impulse(Vector3.RIGHT)
	check_error("cannot move without a plant")
	plant.reset_motion()
	plant.free()


func test_stepping_a_plant_without_a_function_gives_one_error() -> void:
	var plant := Plant3D.new()
	plant.simulation_enabled = false
	root.add_child(plant)
	for i in 10:
		plant.advance(0.1)
	check_error("cannot move without a plant")
	plant.free()


func test_heights_out_of_range_give_one_error_and_are_not_kept() -> void:
	_plant.height = 1.5
	for height: float in [-1.0, -0.001, 1001.0, 1e30, NAN, INF, -INF]:
		_plant.height = height
		check_error("height cannot be ")
		check_equal(_plant.height, 1.5)


func test_segments_out_of_range_give_one_error_and_are_not_kept() -> void:
	for lod: int in [0, -1, 257, 1000000]:
		_plant.segments = lod
		check_error("segments cannot be ")
		check_equal(_plant.segments, 12)


func test_errors_name_the_plant() -> void:
	_plant.name = "Rose"
	_plant.height = NAN
	check_error("Plant3D '/root/Rose'")


func test_any_seed_is_good() -> void:
	for seed_value: int in [-1, 0, 1 << 62, -(1 << 62)]:
		_plant.seed = seed_value
		check_equal(_plant.seed, seed_value)
		check(_plant.get_mesh() != null, "a mesh")


func _instance() -> MeshInstance3D:
	return _plant.get_skeleton().get_child(0, true)


## A function that counts the requests for a whole mesh.
func _counting_function() -> PlantFunction:
	var script := GDScript.new()
	script.source_code = """extends PlantFunction
var builds := 0
func _get_base_shape(_lod: int) -> PackedVector3Array:
	builds += 1
	return PackedVector3Array([Vector3(-1, 0, 0), Vector3(0, 0, 1), Vector3(1, 0, 0)])
"""
	check_equal(script.reload(), OK, "compiling")
	var function: PlantFunction = script.new()
	function.law = PlantFunction.LAW_SPRING  # A stem requests one more plant.
	return function
