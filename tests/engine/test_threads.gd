## Meshes and plants created on threads.
extends "res://tests/engine/harness.gd"

const TASKS := 64
const LOD := 9

var _functions: Array[PlantFunction] = []
var _meshes: Array[ArrayMesh] = []
var _plants: Array[Plant3D] = []
var _mutex := Mutex.new()


func before_each() -> void:
	_functions = [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new(),
		CurvePlantFunction.new(),
		_make_script_function(),
	]
	for function in _functions:
		function.shape_deviation = 0.5
		function.color_deviation = 0.5
	_meshes = []
	_meshes.resize(TASKS)
	_plants = []


func after_each() -> void:
	for plant in _plants:
		plant.free()
	_plants = []
	_meshes = []
	_functions = []


func test_meshes_of_threads_equal_those_of_the_main_thread() -> void:
	var group := WorkerThreadPool.add_group_task(_generate, TASKS)
	WorkerThreadPool.wait_for_group_task_completion(group)
	for index in TASKS:
		_check_mesh(index, _make_mesh(index))


func test_the_main_thread_may_generate_meshes_at_the_same_time() -> void:
	var group := WorkerThreadPool.add_group_task(_generate, TASKS)
	var own: Array[ArrayMesh] = []
	for index in TASKS:
		own.append(_make_mesh(index))
	WorkerThreadPool.wait_for_group_task_completion(group)
	for index in TASKS:
		_check_mesh(index, own[index])


func test_errors_on_threads_are_reported_and_harm_nothing() -> void:
	var tulip := TulipFunction.new()
	var group := WorkerThreadPool.add_group_task(
		func(_index: int) -> void: tulip.generate_mesh(-1.0, 12), 16
	)
	WorkerThreadPool.wait_for_group_task_completion(group)
	check_error_count("cannot be built", 16)


func test_plants_made_on_threads_grow_in_the_tree() -> void:
	var group := WorkerThreadPool.add_group_task(_make_plant, 20)
	WorkerThreadPool.wait_for_group_task_completion(group)
	await frames(3)
	check_equal(_plants.size(), 20, "plants")
	check_equal(PlantSimulation.get_plant_count(), 20, "plants in the simulation")
	for plant in _plants:
		check(plant.get_parent() == root, "it is in the tree")
		var is_stem := plant.species.law == PlantFunction.LAW_STEM
		check_equal(plant.get_skeleton().get_bone_count(), 6 if is_stem else 2, "bones")


func test_plants_built_on_threads_are_shown_in_the_tree() -> void:
	var group := WorkerThreadPool.add_group_task(_make_built_plant, 20)
	WorkerThreadPool.wait_for_group_task_completion(group)
	await frames(3)
	check_equal(_plants.size(), 20, "plants")
	for plant in _plants:
		var instance: MeshInstance3D = plant.get_skeleton().get_child(0, true)
		check(instance.mesh == plant.get_mesh(), "its mesh is shown")


func _generate(index: int) -> void:
	var mesh := _make_mesh(index)
	_mutex.lock()
	_meshes[index] = mesh
	_mutex.unlock()


func _make_mesh(index: int) -> ArrayMesh:
	return _functions[index % _functions.size()].generate_mesh(0.0, LOD, index)


## The arrays are read here, because a thread that requests them waits for the main thread.
func _check_mesh(index: int, expected: ArrayMesh) -> void:
	var arrays := var_to_bytes(expected.surface_get_arrays(0))
	check_equal(var_to_bytes(_meshes[index].surface_get_arrays(0)), arrays, "mesh %d" % index)


func _make_plant(index: int) -> void:
	var plant := Plant3D.new()
	plant.species = _functions[index % _functions.size()].duplicate()
	plant.seed = index
	plant.height = 1.0
	_hand_over(plant)


func _make_built_plant(index: int) -> void:
	var plant := Plant3D.new()
	plant.species = _functions[index % _functions.size()].duplicate()
	plant.get_mesh()
	_hand_over(plant)


func _hand_over(plant: Plant3D) -> void:
	_mutex.lock()
	_plants.append(plant)
	_mutex.unlock()
	root.add_child.call_deferred(plant)


func _make_script_function() -> PlantFunction:
	var script := GDScript.new()
	script.source_code = (
		"extends PlantFunction\nfunc _calculate_curve_point(offset: float) -> float:\n"
		+ "\treturn 0.5 + 0.5 * offset\n"
	)
	check_equal(script.reload(), OK, "compiling")
	return script.new()
