## A property that is set to its current value starts no build.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	field.density = 6.0
	field.size = Vector2(6, 6)


func test_no_property_set_to_its_own_value_starts_a_build() -> void:
	field.map = PlantMap.new()
	field.map.fill_polygon(
		PackedVector3Array([Vector3(-3, 0, -3), Vector3(3, 0, -3), Vector3(3, 0, 3)]), "Grass", 1.0
	)
	field.exclusions = [add_path("Hole", [Vector3.ZERO, Vector3.RIGHT, Vector3.BACK])]
	field.outline = add_path("Area", [Vector3.ZERO, Vector3(4, 0, 0), Vector3(0, 0, 4)])
	field.levels = [PlantFieldLevel.of(6, 9.0), PlantFieldLevel.of(2)]
	field.wind = PlantWind.new()
	await start()
	await frames(10)
	var tried := 0
	for property in field.get_property_list():
		if property["usage"] & PROPERTY_USAGE_STORAGE == 0 or property["name"] == "script":
			continue
		field.set(property["name"], field.get(property["name"]))
		_check_at_rest(property["name"])
		tried += 1
	check(tried > 40, "%d properties" % tried)


func test_arrays_with_equal_entries_start_no_build() -> void:
	field.exclusions = [add_path("Hole", [Vector3.ZERO, Vector3.RIGHT, Vector3.BACK])]
	await start()
	field.exclusions = field.exclusions.duplicate()
	_check_at_rest("exclusions")
	field.species = field.species.duplicate()
	_check_at_rest("species")


func test_an_array_that_was_changed_in_place_and_set_again_starts_a_build() -> void:
	await start()
	var entries := field.species
	entries.append(PlantFieldSpecies.of(ReedFunction.new()))
	field.species = entries
	check(field.is_building(), "another species grows")
	await field.build_finished
	var paths := field.exclusions
	paths.append(add_path("Hole", [Vector3.ZERO, Vector3.RIGHT, Vector3.BACK]))
	field.exclusions = paths
	check(field.is_building(), "a hole is cut")
	await field.build_finished
	await process_frame


func _check_at_rest(title: String) -> void:
	check(not field.is_building(), "%s does not build the field" % title)
	check(not field.get_statistics()["is_rebuilding_meshes"], "%s does not dress it" % title)
