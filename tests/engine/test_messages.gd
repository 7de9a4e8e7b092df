## Errors identify objects by their file, script or short path.
extends "res://tests/engine/harness.gd"

const SCENE := "user://messages_scene.tscn"
const SCRIPT := "user://messages_spike.gd"

static var _files := 0

## Number of the file of each test. The resource cache returns a loaded file while it is referenced.
var _species := ""
var _world: Node


func before_each() -> void:
	_files += 1
	_species = "user://messages_species_%d.tres" % _files
	_world = Node.new()
	_world.name = "World"
	root.add_child(_world)


func after_each() -> void:
	edited_scene_root = null
	_world.free()
	for path: String in [SCENE, _species, SCRIPT]:
		DirAccess.remove_absolute(path)


func test_a_species_of_its_own_file_is_called_by_it() -> void:
	ResourceSaver.save(GrassFunction.new(), _species)
	var grass: PlantFunction = load(_species)
	grass.mass = NAN
	check_error("GrassFunction '%s': mass cannot be" % _species)


func test_a_species_without_a_name_is_named_by_its_class() -> void:
	PlantFunction.new().mass = NAN
	check_error("PlantFunction: mass cannot be")


func test_an_error_in_a_file_is_reported_once_with_that_file() -> void:
	_write_faulty_file()
	var tulip: TulipFunction = load(_species)
	await frames(2)
	check_error_count("TulipFunction '%s': natural_frequency cannot be -3.0" % _species, 1)
	check_equal(
		tulip.natural_frequency, TulipFunction.new().natural_frequency, "it keeps its value"
	)
	check_equal(tulip.mass, 2.0, "what follows is read")


func test_an_error_in_a_file_is_reported_even_if_the_resource_is_freed() -> void:
	await frames(2)  # Waits until the resources of the last test are freed.
	_write_faulty_file()
	load(_species)
	await frames(2)
	check_error_count("natural_frequency cannot be -3.0", 1)


func test_an_error_in_a_dependency_is_reported_with_its_file() -> void:
	_write_faulty_file()
	_write(
		SCENE,
		(
			(
				'[gd_scene load_steps=2 format=3]\n[ext_resource type="Resource" path="%s" id="1"]\n'
				% _species
			)
			+ '[node name="Rose" type="Plant3D"]\nspecies = ExtResource("1")\n'
		)
	)
	var rose := ResourceLoader.load(SCENE, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene
	await frames(2)
	check_error_count("TulipFunction '%s': natural_frequency cannot be -3.0" % _species, 1)
	check(rose != null, "the scene is there")


func test_a_scripts_own_error_is_reported_at_once() -> void:
	var tulip := TulipFunction.new()
	tulip.natural_frequency = -3.0
	check_error_count("TulipFunction: natural_frequency cannot be -3.0", 1)


func test_a_species_embedded_in_a_scene_is_called_by_its_script() -> void:
	var spike := _embedded(_scripted("extends PlantFunction\n"))
	spike.mass = NAN
	check_error("PlantFunction '%s' in '%s': mass cannot be" % [SCRIPT, SCENE])


func test_a_species_embedded_in_a_scene_is_called_by_its_name() -> void:
	var tulip := TulipFunction.new()
	tulip.resource_name = "Red"
	_embedded(tulip).mass = NAN
	check_error("TulipFunction 'Red' in '%s': mass cannot be" % SCENE)


func test_a_species_embedded_in_a_scene_is_named_by_the_scene() -> void:
	_embedded(TulipFunction.new()).mass = NAN
	check_error("TulipFunction in '%s': mass cannot be" % SCENE)


func test_a_running_games_nodes_are_called_by_their_whole_path() -> void:
	var plant := _plant_below(_world)
	plant.height = NAN
	check_error("Plant3D '/root/World/Rose': height cannot be")


func test_nodes_of_an_edited_scene_are_called_from_its_root() -> void:
	var scene := Node3D.new()
	scene.name = "Meadow"
	_world.add_child(scene)
	edited_scene_root = scene
	var bed := Node3D.new()
	bed.name = "Bed"
	scene.add_child(bed)
	_plant_below(bed).height = NAN
	check_error("Plant3D 'Meadow/Bed/Rose': height cannot be")


func test_an_edited_scenes_root_is_called_by_its_name() -> void:
	var plant := _plant_below(_world)
	edited_scene_root = plant
	plant.height = NAN
	check_error("Plant3D 'Rose': height cannot be")


func test_nodes_beside_an_edited_scene_are_called_from_their_own_root() -> void:
	var scene := Node3D.new()
	_world.add_child(scene)
	edited_scene_root = scene
	var plant := _plant_below(_world)
	plant.height = NAN
	check_error("Plant3D 'Rose': height cannot be")
	plant.owner = _world
	plant.height = INF
	check_error("Plant3D 'World/Rose': height cannot be")


func _plant_below(parent: Node) -> Plant3D:
	var plant := Plant3D.new()
	plant.name = "Rose"
	parent.add_child(plant)
	return plant


# As typed by a user.
func _write_faulty_file() -> void:
	_write(
		_species,
		(
			'[gd_resource type="TulipFunction" format=3]\n\n'
			+ "[resource]\nnatural_frequency = -3.0\nmass = 2.0\n"
		)
	)


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()


func _scripted(code: String) -> PlantFunction:
	_write(SCRIPT, code)
	return (load(SCRIPT) as GDScript).new()


## Returns [param species] from a saved and loaded scene.
func _embedded(species: PlantFunction) -> PlantFunction:
	var holder := Node.new()
	holder.set_meta("species", species)
	var scene := PackedScene.new()
	scene.pack(holder)
	holder.free()
	check_equal(ResourceSaver.save(scene, SCENE), OK, "saving")
	scene = ResourceLoader.load(SCENE, "", ResourceLoader.CACHE_MODE_IGNORE)
	holder = scene.instantiate()
	var loaded: PlantFunction = holder.get_meta("species")
	check(loaded.resource_path.begins_with(SCENE + "::"), "embedded as " + loaded.resource_path)
	holder.free()
	return loaded
