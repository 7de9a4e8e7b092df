## Fields that are told what cannot be: one error, and the old field stays.
extends "res://tests/engine/field_harness.gd"


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


func test_an_empty_species_is_one_error_and_the_field_stays() -> void:
	await _fill()
	var before := _described(field)
	field.species = [PlantFieldSpecies.of(GrassFunction.new()), null]
	await rested()
	check_error("species[1]")
	check_equal(_described(field), before, "the field")
	field.species = [PlantFieldSpecies.new(), PlantFieldSpecies.of(GrassFunction.new())]
	await rested()
	check_error("species[0]")
	check_equal(_described(field), before, "the field")


func test_shares_of_0_are_one_error() -> void:
	await _fill()
	for entry in field.species:
		entry.share = 0.0
	await rested()
	check_error("share")
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
		"fade_margin": INF,
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


func _described(field: PlantField3D) -> Array:
	var told := [field.get_plant_count()]
	var ids := field.get_plant_ids()
	for i: int in range(0, ids.size(), 13):
		var id := ids[i]
		told.append_array(
			[field.get_plant_transform(id), field.get_plant_height(id), field.get_plant_seed(id)]
		)
	return told
