## What somebody does first with the add-on, in an empty project: a field in wind, saved, loaded.
extends "res://tests/engine/field_harness.gd"

const SCENE := "user://first_scene.tscn"
const DENSITY := 40.0


func before_each() -> void:
	field = PlantField3D.new()
	field.size = Vector2(4, 4)
	field.density = DENSITY
	field.wind = PlantWind.new()


func test_a_field_grows_grass_at_once() -> void:
	await start()
	check(field.get_plant_count() > DENSITY * 8, "%d plants exist" % field.get_plant_count())


func test_wind_bends_it() -> void:
	await start()
	var before := all_tips()
	await step(120)
	check(count_moved(before, 0.01) > before.size() / 2.0, "most plants moved")


func test_ready_species_winds_and_mixes_load() -> void:
	var species: PlantFunction = load("res://addons/undergrowth/species/poppy.tres")
	field.species = [PlantFieldSpecies.new()]
	field.species[0].species = species
	field.wind = load("res://addons/undergrowth/winds/fresh.tres")
	await start()
	var mix: Node = load("res://addons/undergrowth/mixes/meadow.tscn").instantiate()
	check(field.get_plant_count() > 0 and mix is PlantField3D, "species, wind and mix are there")
	mix.free()


func test_an_isolated_plant_sways() -> void:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.wind = field.wind
	root.add_child(plant)
	await frames(30)
	check(plant.get_child_count(true) > 0, "it is built")
	plant.free()
	await start()


func test_a_scene_is_saved_and_loaded() -> void:
	await start()
	var ids := sorted_ids()
	var scene := PackedScene.new()
	check_equal(scene.pack(field), OK, "packing")
	check_equal(ResourceSaver.save(scene, SCENE), OK, "saving")
	field.free()
	field = (load(SCENE) as PackedScene).instantiate()
	await start()
	check_equal(sorted_ids(), ids, "what grows")
