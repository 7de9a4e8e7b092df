## A field with a map, and the plants that a change of the map does not affect.
extends "res://tests/engine/field_map_harness.gd"


func test_a_field_that_is_painted_all_over_is_the_one_without_a_map() -> void:
	await start()
	var plain := all_plants()
	for title: String in [TULIP, GRASS]:
		map.fill_polygon(field.get_outline_points(), title)
	field.map = map
	await filled(field)
	check_equal(all_plants(), plain, "its plants")
	field.map = null
	await filled(field)
	check_equal(all_plants(), plain, "its plants without a map")


func test_an_empty_map_grows_nothing_and_its_strokes_do() -> void:
	field.map = map
	root.add_child(field)
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	map.paint(Vector3(30, 0, 4), 4.0, TULIP, 1.0, 0.0)
	await rested()
	# Half of 10 plants/m², with four standard deviations of a count.
	check_near(field.get_plant_count(), 5.0 * PI * 16.0, 64.0, "plants")
	for id in field.get_plant_ids():
		check(field.get_plant_species(id) is TulipFunction, "it is a tulip")
		var root_at := field.get_plant_transform(id).origin
		check(root_at.distance_to(Vector3(30, 0, 4)) < 4.4, "it is in the circle")


func test_painted_heights_are_those_of_plants() -> void:
	for title: String in [TULIP, GRASS]:
		map.fill_polygon(field.get_outline_points(), title)
	field.map = map
	await start()
	var before := {}
	for id in field.get_plant_ids():
		before[id] = field.get_plant_height(id)
	map.paint_height(Vector3.ZERO, 5.0, TULIP, 1.5, 1.0, 0.0)
	await rested()
	var higher := 0
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id).origin
		var factor := map.get_height_factor(place, TULIP)
		factor = factor if field.get_plant_species(id) is TulipFunction else 1.0
		check_near(field.get_plant_height(id), before[id] * factor, 1e-3, "height")
		higher += 1 if factor > 1.0 else 0
	check(higher > 200, "%d are higher" % higher)


func test_the_order_of_species_and_other_entries_change_nothing() -> void:
	map.paint(Vector3.ZERO, 5.0, TULIP, 1.0, 0.0)
	field.map = map
	await start()
	field.species = [field.species[1], field.species[0]]
	await filled(field)
	check(field.get_plant_count() > 200, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		check(field.get_plant_species(id) is TulipFunction, "it is a tulip")


func test_another_species_grows_where_its_layer_is_painted() -> void:
	map.paint(Vector3.ZERO, 5.0, TULIP, 1.0, 0.0)
	field.species = [PlantFieldSpecies.of(ReedFunction.new())]
	field.map = map
	await start()
	check_equal(field.get_plant_count(), 0, "plants")
	check_error("'Tulip' is no species of the fields with this map")
	field.species[0].layer = TULIP
	await filled(field)
	check(field.get_plant_count() > 500, "%d plants" % field.get_plant_count())


func test_a_scene_brings_back_what_was_painted() -> void:
	field.map = map
	map.paint(Vector3(8, 0, 1), 5.0, TULIP, 0.7)
	map.paint(Vector3(6, 0, 1), 5.0, GRASS, 0.7)
	await start()
	var scene := PackedScene.new()
	scene.pack(field)
	check_equal(ResourceSaver.save(scene, "user://painted.tscn"), OK, "saving")
	var loaded: PackedScene = ResourceLoader.load(
		"user://painted.tscn", "", ResourceLoader.CACHE_MODE_IGNORE
	)
	var plants := all_plants()
	check(plants.size() > 300, "%d plants" % plants.size())
	field.free()
	field = loaded.instantiate()
	await start()
	check_equal(all_plants(), plants, "its plants")


func test_plants_follow_the_data_of_another_map() -> void:
	map.paint(Vector3(-6, 0, 0), 3.0, TULIP, 1.0, 0.0)
	field.map = map
	await start()
	check(field.get_plant_count() > 50, "%d plants" % field.get_plant_count())
	var other := PlantMap.new()
	other.paint(Vector3(6, 0, 0), 3.0, TULIP, 1.0, 0.0)
	map.data = other.data
	await rested()
	check_equal(field.find_plants_in_sphere(Vector3(-6, 0, 0), 4.0).size(), 0, "plants before")
	check(field.find_plants_in_sphere(Vector3(6, 0, 0), 4.0).size() > 50, "plants now")


func test_plants_of_a_species_that_leaves_the_map_are_gone() -> void:
	map.fill_polygon(field.get_outline_points(), TULIP)
	field.map = map
	await start()
	check(field.get_plant_count() > 0, "plants")
	map.remove_species(TULIP)
	await rested()
	check_equal(field.get_plant_count(), 0, "plants without a layer")


func test_exclusions_count_on_a_map() -> void:
	var square: Array[Vector3] = [
		Vector3(-3, 0, -3), Vector3(3, 0, -3), Vector3(3, 0, 3), Vector3(-3, 0, 3)
	]
	field.exclusions = [add_path("Pond", square)]
	field.map = map
	map.paint(Vector3.ZERO, 8.0, GRASS, 1.0, 0.0)
	await start()
	check(field.get_plant_count() > 300, "%d plants" % field.get_plant_count())
	check_equal(field.find_plants_in_sphere(Vector3.ZERO, 3.0).size(), 0, "plants in the pond")


func test_an_unreadable_map_is_reported_and_the_plants_stay() -> void:
	await start()
	var plants := all_plants()
	map.data = PackedByteArray([1, 2, 3])
	check_error("no map")
	field.map = map
	await rested()
	check_error("its map cannot be used")
	check_equal(all_plants(), plants, "its plants")


func test_fields_that_share_a_map_both_grow_by_it() -> void:
	field.map = map
	await start()
	var other := PlantField3D.from_species([GrassFunction.new()])
	other.map = map
	root.add_child(other)
	await filled(other)
	map.paint(Vector3.ZERO, 5.0, GRASS, 1.0, 0.0)
	await rested()
	while other.is_building():
		await process_frame
	check(field.get_plant_count() > 300, "%d plants" % field.get_plant_count())
	check(other.get_plant_count() > 1500, "%d plants of the other" % other.get_plant_count())
	other.free()


func test_an_unused_layer_name_is_reported_once() -> void:
	field.map = map
	var other := PlantField3D.from_species([ReedFunction.new()])
	other.map = map
	root.add_child(other)
	root.add_child(field)
	await settled(field)
	await settled(other)
	for title: String in [GRASS, TULIP, "Reed"]:
		map.paint(Vector3.ZERO, 2.0, title, 1.0)
	map.erase(Vector3.ZERO, 2.0, "", 1.0)
	check_error_count("is no species", 0)
	map.erase(Vector3.ZERO, 2.0, "Tulpe", 1.0)
	check_error("'Tulpe' is no species of the fields with this map")
	map.paint(Vector3.ZERO, 2.0, "Tulpe", 1.0)
	check_error_count("Tulpe", 0)
	map.set_from_image(Image.create_empty(4, 4, false, Image.FORMAT_L8), Rect2(0, 0, 4, 4), "Gras")
	check_error("'Gras' is no species of the fields with this map")
	other.free()


func test_a_map_of_other_species_is_reported_when_it_is_used() -> void:
	map.paint(Vector3.ZERO, 2.0, "Tulpe", 1.0)
	map.paint(Vector3.ZERO, 2.0, TULIP, 1.0)
	field.map = map
	root.add_child(field)
	await settled(field)
	check_error("'Tulpe' is no species of the fields with this map")
	field.rebuild()
	await filled(field)
	check_error_count("Tulpe", 0)
