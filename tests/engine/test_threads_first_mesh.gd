## The first mesh of a ready species, generated on threads while the main thread waits for it. Each
## engine has one first mesh, so this script has one test, and nothing before it makes a mesh.
extends "res://tests/engine/harness.gd"

const SPECIES := "res://addons/undergrowth/species/"
const PATIENCE := 30000  # ms.
const LOD := 9

var _species: Array[PlantFunction] = []
var _meshes: Array[ArrayMesh] = []
var _mutex := Mutex.new()


func test_the_first_mesh_of_a_ready_species_may_be_a_threads() -> void:
	for file in ResourceLoader.list_directory(SPECIES):
		_species.append(load(SPECIES + file))
	_meshes.resize(_species.size())
	var group := WorkerThreadPool.add_group_task(_generate, _species.size())
	# The main thread only waits, without a frame, up to a time limit.
	var deadline := Time.get_ticks_msec() + PATIENCE
	while not WorkerThreadPool.is_group_task_completed(group) and Time.get_ticks_msec() < deadline:
		OS.delay_msec(1)
	check(WorkerThreadPool.is_group_task_completed(group), "all meshes are generated")
	await until(func() -> bool: return WorkerThreadPool.is_group_task_completed(group), "tasks end")
	WorkerThreadPool.wait_for_group_task_completion(group)
	await frames(2)
	for i in _species.size():
		var title := _species[i].resource_path.get_file()
		var expected := _species[i].generate_mesh(0.0, LOD, i)
		var arrays := var_to_bytes(expected.surface_get_arrays(0))
		check_equal(var_to_bytes(_meshes[i].surface_get_arrays(0)), arrays, "mesh of " + title)
		var material := _meshes[i].surface_get_material(0) as ShaderMaterial
		check(material.shader != null, "the material of %s has a shader" % title)
		check(material == expected.surface_get_material(0), "%s shares its material" % title)


func _generate(index: int) -> void:
	var mesh := _species[index].generate_mesh(0.0, LOD, index)
	_mutex.lock()
	_meshes[index] = mesh
	_mutex.unlock()
