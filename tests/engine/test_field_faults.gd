## Fields that are told what cannot be: one error, and the old field stays.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = _make_field()


func test_a_new_field_without_species_is_no_error() -> void:
	field.species = [] as Array[PlantFunction]
	root.add_child(field)
	await frames(3)
	check_equal(field.get_plant_count(), 0)


func test_an_empty_species_is_one_error_and_the_field_stays() -> void:
	await _fill()
	var before := _described(field)
	field.species = [GrassFunction.new(), null]
	await frames(3)
	check_error("species[1] is empty")
	check_equal(_described(field), before, "the field")
	field.species = [] as Array[PlantFunction]
	await frames(3)
	check_error("has no species")
	check_equal(_described(field), before, "the field")


func test_shares_of_0_are_one_error() -> void:
	await _fill()
	field.shares = PackedFloat32Array([0, 0])
	await frames(3)
	check_error("share")
	check(field.get_plant_count() > 0, "the field stays")


func test_an_area_of_nothing_is_one_error() -> void:
	await _fill()
	field.area = make_curve([Vector3.ZERO, Vector3.RIGHT])
	await frames(3)
	check_error("PlantField3D")
	check(field.get_plant_count() > 0, "the field stays")
	field.area = null
	field.size = Vector2.ZERO
	await frames(3)
	check_error("PlantField3D")


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
	await frames(3)
	check_error("plants")
	check_near(field.get_plant_count(), 2000, 100.0, "plants that stay")


func test_wrong_numbers_keep_the_old_value() -> void:
	var wrong := {
		"variants": 0,
		"update_interval": 0,
		"prototypes": 65,
		"threads": -1,
		"chunk_size": 0.0,
		"clumping": 1.5,
		"height_deviation": NAN,
		"wind_speed": -1.0,
		"scale_range": Vector2(2, 1),
		"levels": PackedInt32Array([0]),
		"level_distances": PackedFloat32Array([5, 5]),
		"fade_margin": INF,
		"ground": 9,
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
