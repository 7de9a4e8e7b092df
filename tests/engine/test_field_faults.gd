## Fields with invalid settings report one error, and the previous field stays.
extends "res://tests/engine/field_harness.gd"


## A species whose plants cannot be sampled.
class FaultySpecies:
	extends PlantFunction

	func _generate_height(_rng: RandomNumberGenerator) -> float:
		return NAN

	func _calculate_curve_point(offset: float) -> float:
		return 0.01 * (1.0 - offset)


func before_each() -> void:
	field = _make_field()


func test_a_new_field_grows_grass_that_covers_the_ground() -> void:
	field.free()
	field = PlantField3D.new()
	await _fill()
	check_near(field.get_plant_count(), 40 * 20 * 20, 300.0)
	for id in field.get_plant_ids().slice(0, 10):
		var grows := field.get_plant_species(id).resource_path.get_file()
		check_equal(grows, "meadow_grass.tres", "plant %d" % id)


func test_an_empty_entry_is_one_error_and_the_other_species_grow() -> void:
	await _fill()
	var grass := field.species[0]
	var tulips := field.species[1]
	var grass_places := _places_of(grass.species)
	var emptied := PlantFieldSpecies.new()
	field.species = [grass, emptied]
	await rested()
	check_error_count("species[1] is empty, and does not grow. Set a PlantFieldSpecies", 1)
	check_equal(_places_of(grass.species), grass_places, "the other species' places")
	check_equal(field.get_plant_count(), grass_places.size(), "plants")
	field.density = 6.0
	await rested()
	check(field.get_plant_count() > grass_places.size(), "the field follows its properties")
	field.density = 5.0
	field.species = [grass, null]
	await rested()
	check(
		field.get_plant_count() > grass_places.size(),
		"grass takes the room of an entry that is null"
	)
	field.species = [grass, tulips]
	await rested()
	check_equal(_places_of(grass.species), grass_places, "the other species' places")
	check(field.get_plant_count() > grass_places.size(), "tulips are back")


func test_a_list_of_empty_entries_is_one_error_and_the_field_stays() -> void:
	await _fill()
	var before := _described(field)
	field.species = [null, PlantFieldSpecies.new()]
	await rested()
	check_error_count("species[0] is empty", 1)
	check_equal(_described(field), before, "the field")


func test_a_scene_with_a_deleted_species_names_its_file_and_grows_the_rest() -> void:
	var species_path := "user://own_fern.tres"
	var scene_path := "user://field_with_fern.tscn"
	ResourceSaver.save(TulipFunction.new(), species_path)
	var fern := ResourceLoader.load(species_path, "", ResourceLoader.CACHE_MODE_IGNORE)
	fern.take_over_path(species_path)
	field.species[1].species = fern
	var scene := PackedScene.new()
	scene.pack(field)
	check_equal(ResourceSaver.save(scene, scene_path), OK, "saving")
	fern = null
	field.free()
	DirAccess.remove_absolute(species_path)
	ResourceLoader.set_abort_on_missing_resources(false)
	scene = ResourceLoader.load(scene_path, "", ResourceLoader.CACHE_MODE_IGNORE)
	ResourceLoader.set_abort_on_missing_resources(true)
	check(scene != null, "the scene loads")
	field = scene.instantiate()
	await _fill()
	check_error("Cannot open file 'user://own_fern.tres'")
	check_error("Failed loading resource: user://own_fern.tres")
	check_error_count(
		"'user://own_fern.tres', which 'user://field_with_fern.tscn' uses, is missing", 1
	)
	check_near(field.get_plant_count(), 0.5 * 5 * 20 * 20, 100.0, "plants of the other species")


func test_a_species_with_errors_is_named_once_and_the_rest_grows() -> void:
	field.species[1].species = FaultySpecies.new()
	root.add_child(field)
	await rested()
	check_error("species[1] does not grow. ")
	check_near(field.get_plant_count(), 0.5 * 5 * 20 * 20, 100.0, "plants of the other species")
	field.rebuild()
	await rested()
	check_near(field.get_plant_count(), 0.5 * 5 * 20 * 20, 100.0, "plants of the other species")
	field.species[1].species = TulipFunction.new()
	await rested()
	check_near(field.get_plant_count(), 5 * 20 * 20, 100.0, "plants of both")


func test_ends_of_a_range_push_each_other() -> void:
	field.slope_limits = Vector2(0.1, 0.5)
	field.slope_limits = Vector2(0.7, 0.5)
	check_equal(field.slope_limits, Vector2(0.7, 0.7), "the smaller end pushes the larger")
	field.slope_limits = Vector2(0.7, 0.2)
	check_equal(field.slope_limits, Vector2(0.2, 0.2), "the larger end pushes the smaller")
	field.slope_limits = Vector2(0.7, 0.4)
	check_error(
		"slope_limits goes from 0.7 down to 0.4, it keeps its value. Set the smaller number"
	)
	check_equal(field.slope_limits, Vector2(0.2, 0.2), "both ends at once, in the wrong order")
	field.height_limits = Vector2(5.0, 1000.0)
	field.height_limits = Vector2(5.0, -3.0)
	check_equal(field.height_limits, Vector2(-3.0, -3.0), "heights")
	field.species[0].scale_range = Vector2(2.0, 1.2)
	check_equal(field.species[0].scale_range, Vector2(2.0, 2.0), "scales")
	var arrangement := PlantArrangement.new()
	arrangement.count = Vector2i(7, 9)
	arrangement.count = Vector2i(12, 9)
	check_equal(arrangement.count, Vector2i(12, 12), "count")
	arrangement.count = Vector2i(12, 3)
	check_equal(arrangement.count, Vector2i(3, 3), "count")
	var blade := PlantBlade.new()
	blade.length = Vector2(0.2, 0.3)
	blade.length = Vector2(0.4, 0.3)
	check_near(blade.length, Vector2(0.4, 0.4), 1e-6, "length")


func test_degrees_as_slope_limits_are_one_error_that_names_radians() -> void:
	var before := field.slope_limits
	field.slope_limits = Vector2(0, 90)
	check_error("in radians: deg_to_rad(90.0) is 90.0°")
	check_equal(field.slope_limits, before, "slope_limits")


func test_shares_of_0_are_one_error() -> void:
	await _fill()
	for entry in field.species:
		entry.weight = 0.0
	await rested()
	check_error("weight")
	check(field.get_plant_count() > 0, "the field stays")


func test_an_area_of_nothing_is_one_error() -> void:
	await _fill()
	field.outline = add_path("Area", [Vector3.ZERO, Vector3.RIGHT])
	await rested()
	check_error("PlantField3D")
	check(field.get_plant_count() > 0, "the field stays")
	field.outline = NodePath()
	field.size = Vector2.ZERO
	await rested()
	check_error("PlantField3D")


func test_an_outline_that_is_no_path_is_one_error() -> void:
	await _fill()
	for path: NodePath in [NodePath("../Nobody"), NodePath("..")]:
		field.outline = path
		await rested()
		check_error("outline")
		check(field.get_plant_count() > 0, "the field stays")
		field.outline = NodePath()
		await rested()
	field.exclusions = [NodePath("../Nobody")]
	await rested()
	check_error("exclusions[0]")


func test_levels_that_do_not_go_outwards_are_one_error() -> void:
	await _fill()
	var ids := sorted_ids()
	var usual := (field.get_statistics()["drawn_by_level"] as PackedInt32Array).size()
	field.levels = [PlantFieldLevel.of(8, 20.0), PlantFieldLevel.of(4, 10.0), PlantFieldLevel.of(2)]
	await rested()
	check_error("levels[1] ends at 10.0 m")
	field.levels = [PlantFieldLevel.of(8, 20.0), PlantFieldLevel.of(4, 9.0)]
	await rested()
	check_error("levels[1] ends at 9.0 m")
	field.levels = [null, PlantFieldLevel.of(3)]
	await rested()
	check_error("levels[0] is empty")
	var drawn := (field.get_statistics()["drawn_by_level"] as PackedInt32Array).size()
	check_equal(drawn, usual, "levels that are drawn")
	check_equal(sorted_ids(), ids, "plants stay")
	field.levels = [PlantFieldLevel.of(8, 20.0), PlantFieldLevel.of(4)]
	await rested()
	drawn = (field.get_statistics()["drawn_by_level"] as PackedInt32Array).size()
	check_equal(drawn, 2, "levels that are drawn")


func test_absurd_densities_are_refused() -> void:
	await _fill()
	field.density = NAN
	check_error("density")
	field.density = -1.0
	check_error("density")
	field.density = 1e9
	check_error("density")
	check_equal(field.density, 5.0)
	field.size = Vector2(1000, 1000)
	await rested()
	check_error("plants")
	check_near(field.get_plant_count(), 2000, 100.0, "plants that stay")


func test_wrong_numbers_keep_the_old_value() -> void:
	var wrong := {
		"update_interval": 0,
		"prototypes": 65,
		"max_threads": -1,
		"tile_size": 0.0,
		"clumping": 1.5,
		"height_limits": Vector2(2, 1),
		"slope_limits": Vector2(0.5, 0.25),
		"fade_ratio": 1.5,
		"pixel_error": INF,
		"ground_mode": 9,
	}
	for property: String in wrong:
		var before: Variant = field.get(property)
		field.set(property, wrong[property])
		check_error(property)
		check_equal(field.get(property), before, property)


func _fill() -> void:
	root.add_child(field)
	await filled(field)


func _make_field() -> PlantField3D:
	var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	field.density = 5.0
	return field


func _places_of(function: PlantFunction) -> Array:
	var places := []
	for id in field.get_plant_ids():
		if field.get_plant_species(id) == function:
			places.append(field.get_plant_transform(id).origin)
	places.sort()
	return places


func _described(field: PlantField3D) -> Array:
	var reported := [field.get_plant_count()]
	var ids := field.get_plant_ids()
	for i: int in range(0, ids.size(), 13):
		var id := ids[i]
		reported.append_array(
			[field.get_plant_transform(id), field.get_plant_height(id), field.get_plant_seed(id)]
		)
	return reported
