## Fields: what they are made of, saved and loaded.
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
	field.species = [] as Array[PlantFunction]
	root.add_child(field)
	field.add_plants([Transform3D(Basis.IDENTITY, Vector3(1, 2, 3))], TulipFunction.new())
	check_equal(field.get_plant_count(), 1)
	await frames(3)
	check_equal(field.get_plant_transform(0).origin, Vector3(1, 2, 3))
	var height := field.get_plant_height(0)
	check_near(field.get_tip_position(0).distance_to(Vector3(1, 2, 3)), height, 1e-4)


func test_a_hundred_thousand_plants() -> void:
	field.size = Vector2(100, 100)
	field.density = 10.0
	field.species = [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new()
	]
	field.variants = 8
	await _fill()
	check_near(field.get_plant_count(), 100000, 1000.0)
	await frames(5)
	var told := field.get_statistics()
	check_equal(told["simulated"], field.get_plant_count())
	check(told["bytes_per_plant"] <= 96.0, "at most 96 bytes a plant: %s" % told["bytes_per_plant"])


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
	field.shares = PackedFloat32Array([3, 1])
	field.seed = 7
	field.area = make_curve([Vector3(-5, 0, -5), Vector3(5, 0, -5), Vector3(0, 0, 6)])
	field.exclusions = [make_curve([Vector3(-1, 0, -1), Vector3(1, 0, -1), Vector3(0, 0, 1)])]
	field.wind = PlantWind.new()
	field.levels = PackedInt32Array([8, 2])
	field.level_distances = PackedFloat32Array([9.0])
	field.bodies_group = &"walkers"
	await _fill()
	var scene := PackedScene.new()
	check_equal(scene.pack(field), OK, "packing")
	var path := "user://field.tscn"
	check_equal(ResourceSaver.save(scene, path), OK, "saving")
	var text := FileAccess.get_file_as_string(path)
	check(text.length() < 4000 and not text.contains("Mesh"), "parameters are saved, no meshes")
	var loaded: PlantField3D = (
		(ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene)
		. instantiate()
	)
	root.add_child(loaded)
	await filled(loaded)
	check_equal(_described(loaded), _described(field), "the loaded field")
	check_equal(loaded.bodies_group, &"walkers")
	check_equal(loaded.levels, PackedInt32Array([8, 2]))
	loaded.free()
	DirAccess.remove_absolute(path)


func test_shares_decide_between_species() -> void:
	field.shares = PackedFloat32Array([0.0, 1.0])
	await _fill()
	for i: int in range(0, field.get_plant_count(), 97):
		check_equal(field.get_plant_function(i), field.species[1], "species of plant %d" % i)


func test_plants_stand_inside_the_area_and_outside_exclusions() -> void:
	field.area = make_curve(
		[Vector3(0, 0, 0), Vector3(10, 0, 0), Vector3(10, 0, 10), Vector3(0, 0, 10)]
	)
	field.exclusions = [
		make_curve([Vector3(4, 0, 4), Vector3(6, 0, 4), Vector3(6, 0, 6), Vector3(4, 0, 6)])
	]
	var path := _make_field()
	path.size = Vector2(2, 2)
	path.position = Vector3(1, 0, 1)
	root.add_child(path)
	path.name = "Path"
	root.add_child(field)
	field.excluded_fields = [NodePath("../Path")]
	await filled(field)
	check_near(field.get_plant_count(), 5 * (100 - 4 - 4), 40.0)
	for i in field.get_plant_count():
		var place := field.get_plant_transform(i).origin
		var at := Vector2(place.x, place.z)
		check(Rect2(0, 0, 10, 10).has_point(at), "%s is inside the area" % at)
		check(not Rect2(4, 4, 2, 2).has_point(at), "%s is outside the exclusion" % at)
		check(not Rect2(0, 0, 2, 2).has_point(at), "%s is outside the other field" % at)
	path.free()


func test_filling_tells_how_far_it_is() -> void:
	var told: Array[float] = []
	field.filling_progressed.connect(func(share: float) -> void: told.append(share))
	field.size = Vector2(60, 60)
	await _fill()
	check(not told.is_empty() and told[-1] == 1.0, "it ends with 1: %s" % [told])
	var sorted := told.duplicate()
	sorted.sort()
	check_equal(told, sorted, "progress")


func test_the_old_field_stays_until_the_new_one_stands() -> void:
	await _fill()
	var count := field.get_plant_count()
	field.density = 1.0
	check_equal(field.get_plant_count(), count, "plants at once")
	check(field.is_filling(), "it fills")
	await filled(field)
	check_near(field.get_plant_count(), 400, 50.0, "plants then")


func _fill() -> void:
	root.add_child(field)
	await filled(field)


func _make_field() -> PlantField3D:
	var field := PlantField3D.new()
	field.species = [GrassFunction.new(), TulipFunction.new()]
	field.density = 5.0
	return field


func _described(field: PlantField3D) -> Array:
	var told := [field.get_plant_count()]
	for i: int in range(0, field.get_plant_count(), 13):
		told.append_array(
			[field.get_plant_transform(i), field.get_plant_height(i), field.get_plant_seed(i)]
		)
	return told
