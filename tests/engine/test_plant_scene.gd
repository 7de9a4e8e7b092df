## Plant3D in scenes: saving, duplicating, moving in the tree, undo, freeing. No ghosts.
extends "res://tests/engine/harness.gd"

const PATH := "user://saved_meadow.tscn"
const TIP_TOLERANCE := 1e-5

var _stage: Node3D


func before_each() -> void:
	_stage = Node3D.new()
	root.add_child(_stage)


func after_each() -> void:
	if is_instance_valid(_stage):
		_stage.free()
	_stage = null
	DirAccess.remove_absolute(PATH)
	check_equal(PlantSimulation.get_plant_count(), 0, "plants left in the simulation")


func test_a_packed_scene_holds_no_children_of_plants() -> void:
	for i in 3:
		_add_plant("Plant%d" % i)
	await frames(3)
	var state := _pack().get_state()
	check_equal(state.get_node_count(), 4, "nodes")
	for i in range(1, 4):
		check_equal(String(state.get_node_type(i)), "Plant3D")


func test_a_saved_scene_loads_equal() -> void:
	var plant := _add_plant("Rose")
	plant.segments = 7
	plant.height = 1.25
	plant.seed = 77
	plant.simulation_enabled = false
	plant.wind = PlantWind.new()
	plant.wind.strength = 3.5
	plant.species.mass = 0.7
	plant.position = Vector3(1, 2, 3)
	await frames(2)
	check_equal(ResourceSaver.save(_pack(), PATH), OK, "saving")
	var text := FileAccess.get_file_as_string(PATH)
	for word: String in ["Skeleton", "Mesh", "bones", "AABB"]:
		check(not text.contains(word), "the file holds no %s: %s" % [word, text])
	var loaded := _load()
	root.add_child(loaded)
	var twin: Plant3D = loaded.get_node("Rose")
	_check_equal_plants(twin, plant)
	loaded.free()


func test_defaults_are_not_saved() -> void:
	_add_plant("Rose", null)
	check_equal(ResourceSaver.save(_pack(), PATH), OK, "saving")
	var text := FileAccess.get_file_as_string(PATH)
	for property: String in ["segments", "height", "seed", "simulation_enabled", "species", "wind"]:
		check(not text.contains(property + " ="), "%s is not saved" % property)


func test_a_duplicate_has_one_skeleton_of_its_own() -> void:
	var plant := _add_plant("Rose")
	await frames(2)
	var twin: Plant3D = plant.duplicate()
	_stage.add_child(twin)
	await frames(2)
	_check_one_skeleton(plant)
	_check_one_skeleton(twin)
	check(twin.get_skeleton() != plant.get_skeleton(), "each has its own")
	_check_equal_plants(twin, plant)


func test_a_duplicate_of_a_parent_has_one_skeleton_for_each_plant() -> void:
	_add_plant("Rose")
	_add_plant("Violet")
	await frames(2)
	var twin: Node3D = _stage.duplicate()
	root.add_child(twin)
	await frames(2)
	for child in twin.get_children():
		_check_one_skeleton(child)
	twin.free()


func test_a_duplicate_of_a_packed_duplicate_has_one_skeleton() -> void:
	_add_plant("Rose")
	await frames(2)
	check_equal(ResourceSaver.save(_pack(), PATH), OK, "saving")
	var loaded := _load()
	var twin: Node3D = loaded.duplicate()
	root.add_child(loaded)
	root.add_child(twin)
	await frames(2)
	_check_one_skeleton(loaded.get_node("Rose"))
	_check_one_skeleton(twin.get_node("Rose"))
	loaded.free()
	twin.free()


func test_removed_and_added_again_it_keeps_its_state() -> void:
	var plant := _add_plant("Rose")
	plant.apply_impulse(Vector3(0.2, 0, 0))
	await frames(10)
	var tip := plant.get_tip_position()
	_stage.remove_child(plant)
	check_near(plant.get_tip_position(), tip, TIP_TOLERANCE, "tip outside of the tree")
	check_equal(PlantSimulation.get_plant_count(), 0, "plants in the simulation")
	await frames(3)
	_stage.add_child(plant)
	check_near(plant.get_tip_position(), tip, TIP_TOLERANCE, "tip back in the tree")
	_check_one_skeleton(plant)
	check_equal(PlantSimulation.get_plant_count(), 1, "plants in the simulation")


func test_reparented_it_keeps_its_state() -> void:
	var plant := _add_plant("Rose")
	var other := Node3D.new()
	_stage.add_child(other)
	plant.apply_impulse(Vector3(0.2, 0, 0))
	await frames(10)
	var tip := plant.get_tip_position()
	plant.reparent(other)
	check_near(plant.get_tip_position(), tip, TIP_TOLERANCE, "tip")
	_check_one_skeleton(plant)
	check_equal(PlantSimulation.get_plant_count(), 1, "plants in the simulation")


func test_changes_can_be_undone_and_redone() -> void:
	var plant := _add_plant("Rose")
	var tulip := plant.species
	var undo := UndoRedo.new()
	_change(undo, plant, "species", GrassFunction.new())
	_change(undo, plant, "height", 0.5)
	_change(undo, plant, "segments", 3)
	await frames(2)
	check_equal(plant.get_mesh().get_aabb().size.y, 0.5, "height of the grass")
	for i in 3:
		undo.undo()
	await frames(2)
	check(plant.species == tulip, "the tulip is back")
	_check_one_skeleton(plant)
	var expected := tulip.generate_mesh(0.0, 12).surface_get_arrays(0)
	check_equal(plant.get_mesh().surface_get_arrays(0), expected, "mesh of the tulip")
	for i in 3:
		undo.redo()
	await frames(2)
	check_equal(plant.segments, 3, "segments")
	check_equal(plant.get_mesh().get_aabb().size.y, 0.5, "height of the grass again")
	undo.free()


func test_freed_while_simulating_it_leaves_the_simulation() -> void:
	var first := _add_plant("Rose")
	var second := _add_plant("Violet")
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 2, "plants in the simulation")
	first.free()
	check_equal(PlantSimulation.get_plant_count(), 1, "after free()")
	await frames(2)
	second.queue_free()
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 0, "after queue_free()")


func test_freed_outside_of_the_tree_it_leaves_nothing() -> void:
	var plant := _add_plant("Rose")
	await frames(2)
	_stage.remove_child(plant)
	plant.free()
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 0)


func test_freed_with_a_build_due_it_is_built_no_more() -> void:
	var plant := _add_plant("Rose")
	plant.height = 0.5
	plant.free()
	await frames(3)
	check_equal(_stage.get_child_count(), 0)


func test_freed_by_the_skeletons_own_signal() -> void:
	var plant := _add_plant("Rose")
	var neighbour := _add_plant("Violet")
	await frames(2)
	plant.get_skeleton().pose_updated.connect(func() -> void: plant.queue_free())
	plant.apply_impulse(Vector3.RIGHT)
	for i in 200:
		await frames(1)
		if not is_instance_valid(plant):
			break
	check(not is_instance_valid(plant), "it is gone")
	_check_one_skeleton(neighbour)
	check_equal(PlantSimulation.get_plant_count(), 1, "plants in the simulation")


func test_a_skeleton_that_is_freed_grows_again() -> void:
	var plant := _add_plant("Rose")
	await frames(2)
	var tip := plant.get_tip_position()
	plant.get_skeleton().free()
	await frames(2)
	_check_one_skeleton(plant)
	check_near(plant.get_tip_position(), tip, 0.1, "tip")


func test_a_skeleton_that_is_taken_away_grows_again() -> void:
	var plant := _add_plant("Rose")
	var skeleton := plant.get_skeleton()
	plant.remove_child(skeleton)
	await frames(2)
	_check_one_skeleton(plant)
	check(plant.get_skeleton() != skeleton, "a new one")
	skeleton.free()


func test_a_mesh_instance_that_is_freed_comes_back_with_the_next_mesh() -> void:
	var plant := _add_plant("Rose")
	plant.get_skeleton().get_child(0, true).free()
	check(plant.get_reach().has_volume(), "its reach")
	plant.height = 0.5
	await frames(2)
	_check_one_skeleton(plant)


func test_a_shared_function_outlives_its_plants() -> void:
	var function := TulipFunction.new()
	for i in 10:
		_add_plant("Plant%d" % i, function)
	await frames(2)
	_stage.free()
	check_equal(function.get_signal_connection_list("changed").size(), 0, "connections")
	function.emit_changed()
	await frames(2)


func _add_plant(plant_name: String, function: PlantFunction = TulipFunction.new()) -> Plant3D:
	var plant := Plant3D.new()
	plant.name = plant_name
	plant.species = function
	_stage.add_child(plant)
	plant.owner = _stage
	return plant


func _pack() -> PackedScene:
	var scene := PackedScene.new()
	check_equal(scene.pack(_stage), OK, "packing")
	return scene


func _load() -> Node3D:
	var scene: PackedScene = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	return scene.instantiate()


func _change(undo: UndoRedo, plant: Plant3D, property: StringName, value: Variant) -> void:
	undo.create_action("change " + property)
	undo.add_do_property(plant, property, value)
	undo.add_undo_property(plant, property, plant.get(property))
	undo.commit_action()


func _check_one_skeleton(plant: Plant3D) -> void:
	check_equal(plant.get_child_count(true), 1, "children")
	check(plant.get_child(0, true) == plant.get_skeleton(), "the child is the skeleton")
	# The engine itself adds a PhysicalBoneSimulator3D to every skeleton.
	check_equal(plant.find_children("*", "Skeleton3D", true, false).size(), 1, "skeletons")
	check_equal(plant.find_children("*", "MeshInstance3D", true, false).size(), 1, "meshes")
	check(plant.get_skeleton().get_child(0, true).mesh == plant.get_mesh(), "the plant's mesh")


func _check_equal_plants(actual: Plant3D, expected: Plant3D) -> void:
	for property: String in ["segments", "height", "seed", "simulation_enabled", "transform"]:
		check_equal(actual.get(property), expected.get(property), property)
	check_equal(actual.species.get_class(), expected.species.get_class(), "species")
	check_equal(actual.species.mass, expected.species.mass, "mass")
	if expected.wind:
		check_equal(actual.wind.strength, expected.wind.strength, "strength of the wind")
	var arrays := expected.get_mesh().surface_get_arrays(0)
	check_equal(actual.get_mesh().surface_get_arrays(0), arrays, "mesh")
