## Fields: their contents, saving and loading.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = _make_field()


func test_the_number_of_plants_is_density_times_area() -> void:
	await _fill()
	check_near(field.get_plant_count(), 2000, 100.0)


func test_a_field_without_area_or_density_is_empty() -> void:
	field.density = 0.0
	await _fill()
	check_equal(field.get_plant_count(), 0)
	await frames(3)


func test_one_plant() -> void:
	field.density = 0.0
	root.add_child(field)
	var transforms := [Transform3D(Basis.IDENTITY, Vector3(1, 2, 3))]
	var ids := field.add_plants(transforms, TulipFunction.new())
	check_equal(ids.size(), 1, "ids")
	check_equal(field.get_plant_count(), 1)
	await frames(3)
	check_equal(field.get_plant_ids(), ids, "ids of the plants")
	check_equal(field.get_plant_transform(ids[0]).origin, Vector3(1, 2, 3))
	var height := field.get_plant_height(ids[0])
	check_near(field.get_tip_position(ids[0]).distance_to(Vector3(1, 2, 3)), height, 1e-4)


func test_a_hundred_thousand_plants() -> void:
	field.free()
	field = (PlantField3D.from_species(
		[
			GrassFunction.new(),
			ReedFunction.new(),
			CattailFunction.new(),
			TulipFunction.new(),
			BellflowerFunction.new()
		]
	))
	field.size = Vector2(100, 100)
	field.density = 10.0
	for entry in field.species:
		entry.variants = 8
	await _fill()
	check_near(field.get_plant_count(), 100000, 1000.0)
	await frames(5)
	var reported := field.get_statistics()
	check_equal(reported["simulated"], field.get_plant_count())
	check(
		reported["bytes_per_plant"] <= 96.0,
		"at most 96 bytes a plant: %s" % reported["bytes_per_plant"]
	)


## Queries and results use world positions. The wind's direction and the outline are set in other
## axes.
func test_a_field_under_a_parent_equals_one_at_the_same_place() -> void:
	var parent := Node3D.new()
	parent.transform = Transform3D(Basis(Vector3.UP, 0.7), Vector3(30.0, 2.0, -7.0))
	field.transform = Transform3D(Basis(Vector3.UP, -1.9), Vector3(5.0, 0.0, 3.0))
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_CONSTANT
	field.exclusions = [add_path("Pond", [Vector3(-2, 0, -2), Vector3(1, 0, -2), Vector3(1, 0, 3)])]
	var alone := await start_with_twin({transform = parent.transform * field.transform})
	field.reparent(parent, false)
	root.add_child(parent)
	check(
		field.global_transform.is_equal_approx(alone.global_transform), "they have the same place"
	)
	field.rebuild()
	await filled(field)
	check_equal(sorted_ids().size(), alone.get_plant_count(), "plants")
	var center := field.to_global(Vector3(-3.0, 0.0, 1.0))
	var near := field.find_plants_in_sphere(center, 1.5)
	check(near.size() > 10, "%d are near" % near.size())
	check_equal(near.size(), alone.find_plants_in_sphere(center, 1.5).size(), "near a place")
	for i in 60:
		step_both(alone)
	for id in near:
		var apart := field.get_tip_position(id).distance_to(alone.get_tip_position(id))
		check_near(apart, 0.0, 1e-4, "tips apart")
	check(relative_tip(near[0]).angle_to(Vector3.UP) > 0.05, "they bend")
	alone.free()
	field.reparent(root)
	parent.free()


func test_the_same_seed_gives_the_same_field() -> void:
	await _fill()
	var other := _make_field()
	root.add_child(other)
	await filled(other)
	check_equal(_described(other), _described(field), "the other field")
	other.seed = 5
	await filled(other)
	check(_described(other) != _described(field), "another seed gives another field")
	other.free()


func test_a_saved_field_is_the_same_when_it_is_loaded() -> void:
	field.species[0].weight = 3.0
	field.seed = 7
	field.outline = add_path("Area", [Vector3(-5, 0, -5), Vector3(5, 0, -5), Vector3(0, 0, 6)])
	var pond := add_path("Pond", [Vector3(-1, 0, -1), Vector3(1, 0, -1), Vector3(0, 0, 1)])
	field.exclusions = [pond]
	field.wind = PlantWind.new()
	field.levels = [PlantFieldLevel.of(8, 9.0), PlantFieldLevel.of(2)]
	field.bodies_group = &"walkers"
	var walker := add_walker()
	await _fill()
	var scene := PackedScene.new()
	check_equal(scene.pack(field), OK, "packing")
	var path := "user://field.tscn"
	check_equal(ResourceSaver.save(scene, path), OK, "saving")
	var text := FileAccess.get_file_as_string(path)
	check(text.length() < 6000 and not text.contains("Mesh"), "parameters are saved, no meshes")
	var loaded: PlantField3D = (
		(ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene)
		. instantiate()
	)
	root.add_child(loaded)
	await filled(loaded)
	check_equal(_described(loaded), _described(field), "the loaded field")
	check_equal(loaded.bodies_group, &"walkers")
	check_equal(loaded.levels.size(), 2, "levels")
	check_equal(loaded.levels[0].end, 9.0, "end of the first level")
	loaded.free()
	walker.free()
	DirAccess.remove_absolute(path)


func test_shares_decide_between_species() -> void:
	field.species[0].weight = 0.0
	await _fill()
	check_near(field.get_plant_count(), 2000, 100.0)
	for id in field.get_plant_ids():
		check_equal(field.get_plant_species(id), field.species[1].species, "species of %d" % id)


func test_plants_are_inside_the_area_and_outside_exclusions() -> void:
	field.outline = add_path(
		"Area", [Vector3(0, 0, 0), Vector3(10, 0, 0), Vector3(10, 0, 10), Vector3(0, 0, 10)]
	)
	var pond := add_path(
		"Pond", [Vector3(4, 0, 4), Vector3(6, 0, 4), Vector3(6, 0, 6), Vector3(4, 0, 6)]
	)
	var path := _make_field()
	path.size = Vector2(2, 2)
	path.position = Vector3(1, 0, 1)
	root.add_child(path)
	path.name = "Path"
	root.add_child(field)
	field.exclusions = [pond, NodePath("../Path")]
	await filled(field)
	check_near(field.get_plant_count(), 5 * (100 - 4 - 4), 40.0)
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		var place := transform.origin
		var at := Vector2(place.x, place.z)
		check(Rect2(0, 0, 10, 10).has_point(at), "%s is inside the area" % at)
		check(not Rect2(4, 4, 2, 2).has_point(at), "%s is outside the exclusion" % at)
		check(not Rect2(0, 0, 2, 2).has_point(at), "%s is outside the other field" % at)
	path.free()


func test_a_build_continues_when_its_field_returns_to_the_tree() -> void:
	root.add_child(field)
	while not field.is_building():
		await process_frame
	field.rebuild()  # The build is in progress from here on, on any machine.
	root.remove_child(field)
	await frames(3)
	root.add_child(field)
	await until(func() -> bool: return not field.is_building(), "it exists")
	check(field.get_plant_count() > 100, "%d plants" % field.get_plant_count())


func test_a_build_reports_its_progress() -> void:
	var reported: Array[float] = []
	field.build_progressed.connect(func(ratio: float) -> void: reported.append(ratio))
	field.size = Vector2(60, 60)
	await _fill()
	check(not reported.is_empty() and reported[-1] == 1.0, "it ends with 1: %s" % [reported])
	var sorted := reported.duplicate()
	sorted.sort()
	check_equal(reported, sorted, "progress")


func test_the_old_field_stays_until_the_new_one_is_ready() -> void:
	await _fill()
	var count := field.get_plant_count()
	field.density = 1.0
	check_equal(field.get_plant_count(), count, "plants at once")
	check(field.is_building(), "it fills")
	await filled(field)
	check_near(field.get_plant_count(), 400, 50.0, "plants then")


func _fill() -> void:
	root.add_child(field)
	await filled(field)


func _make_field() -> PlantField3D:
	var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	field.density = 5.0
	return field


func _described(field: PlantField3D) -> Array:
	var reported := [field.get_plant_count()]
	var ids := field.get_plant_ids()
	for i: int in range(0, ids.size(), 13):
		var id := ids[i]
		reported.append_array(
			[field.get_plant_transform(id), field.get_plant_height(id), field.get_plant_seed(id)]
		)
	return reported
