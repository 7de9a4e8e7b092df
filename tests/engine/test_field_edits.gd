## Edits of lists and paths by scripts and tools in a built field.
extends "res://tests/engine/field_harness.gd"

const POLLING_FRAMES := 10  # Frames between two polls of objects without a change signal.


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 4.0


func test_a_species_that_is_appended_grows() -> void:
	await start()
	var grass := PlantFieldSpecies.of(GrassFunction.new(), 5.0)
	field.species.append(grass)
	await frames(POLLING_FRAMES)
	await rested()
	var count := 0
	for id in field.get_plant_ids():
		count += 1 if field.get_plant_species(id) == grass.species else 0
	check(count > field.get_plant_count() / 2.0, "%d of its plants exist" % count)
	grass.weight = 0.0
	await filled(field)
	for id in field.get_plant_ids():
		check(field.get_plant_species(id) != grass.species, "plant %d is another" % id)


func test_a_level_that_is_appended_is_drawn() -> void:
	field.levels = [PlantFieldLevel.of(12, 4.0)]
	await start()
	field.levels.append(PlantFieldLevel.of(3))
	await frames(POLLING_FRAMES)
	await rested()
	check_equal(field.get_statistics()["drawn_by_level"].size(), 2, "levels")
	check(not field.is_building(), "nothing is rebuilt")


func test_an_exclusion_that_is_appended_is_kept_free() -> void:
	await start()
	field.exclusions.append(_add_square("Pond"))
	await frames(POLLING_FRAMES)
	await rested()
	check_equal(_count_near(Vector2.ZERO, 2.0), 0, "plants in the pond")


func test_dragged_points_and_moves_of_an_exclusion_are_applied() -> void:
	field.exclusions = [_add_square("Pond")]
	await start()
	var pond := field.get_node("Pond") as Path3D
	check_equal(_count_near(Vector2.ZERO, 2.0), 0, "plants in the pond")
	pond.position = Vector3(6, 0, 0)
	await frames(POLLING_FRAMES)
	await rested()
	check(_count_near(Vector2.ZERO, 2.0) > 20, "plants where the pond was")
	check_equal(_count_near(Vector2(6, 0), 2.0), 0, "plants where it is")
	for i in 4:
		pond.curve.set_point_position(i, pond.curve.get_point_position(i) * 2.0)
	await rested()
	check_equal(_count_near(Vector2(6, 0), 4.0), 0, "plants in the larger pond")


func test_dragged_points_and_moves_of_an_outline_are_applied() -> void:
	field.outline = _add_square("Lawn")
	await start()
	check_near(field.get_plant_count(), 4 * 36, 30.0, "plants")
	var lawn := field.get_node("Lawn") as Path3D
	lawn.rotation.y = PI / 4.0
	lawn.position.z = 20.0
	await frames(POLLING_FRAMES)
	await rested()
	check_near(field.get_plant_count(), 4 * 36, 30.0, "plants of the turned outline")
	check_equal(_count_near(Vector2(0, 20), 8.0), field.get_plant_count(), "plants around it")
	lawn.curve.set_point_position(0, Vector3(-9, 0, -9))
	await rested()
	check(field.get_plant_count() > 4 * 45, "%d plants then" % field.get_plant_count())


func test_an_outline_that_was_replaced_is_no_longer_followed() -> void:
	field.outline = _add_square("Lawn")
	await start()
	field.outline = _add_square("Meadow")
	await filled(field)
	await frames(2 * POLLING_FRAMES)
	var lawn := field.get_node("Lawn") as Path3D
	lawn.curve.set_point_position(0, Vector3(-9, 0, -9))
	await frames(1)
	check(not field.is_building(), "it is not filled for the old outline")
	var meadow := field.get_node("Meadow") as Path3D
	meadow.curve.set_point_position(0, Vector3(-9, 0, -9))
	check(field.is_building(), "it is filled for the new one")
	await rested()


func test_another_field_that_is_excluded_is_followed() -> void:
	var path := PlantField3D.from_species([GrassFunction.new()])
	path.name = "Path"
	path.size = Vector2(4, 4)
	root.add_child(path)
	root.add_child(field)
	field.exclusions = [NodePath("../Path")]
	await filled(field)
	check_equal(_count_near(Vector2.ZERO, 2.0), 0, "plants in the other field")
	path.size = Vector2(12, 12)
	await frames(POLLING_FRAMES)
	await rested()
	check_equal(_count_near(Vector2.ZERO, 5.5), 0, "plants in the larger field")
	path.position.x = 30.0
	await frames(POLLING_FRAMES)
	await rested()
	check(_count_near(Vector2.ZERO, 5.5) > 100, "plants where the other field was")
	path.free()


func test_the_outline_of_another_field_that_is_excluded_is_followed() -> void:
	var other := PlantField3D.from_species([GrassFunction.new()])
	other.name = "Other"
	root.add_child(other)
	var corners := [Vector3(-3, 0, -3), Vector3(3, 0, -3), Vector3(3, 0, 3), Vector3(-3, 0, 3)]
	var outline := Path3D.new()
	outline.curve = Curve3D.new()
	for corner: Vector3 in corners:
		outline.curve.add_point(corner)
	other.add_child(outline)
	other.outline = other.get_path_to(outline)
	root.add_child(field)
	field.exclusions = [NodePath("../Other")]
	await filled(field)
	check_equal(_count_near(Vector2.ZERO, 2.5), 0, "plants within the outline")
	for i in 4:
		outline.curve.set_point_position(i, corners[i] * 2.0)
	await frames(POLLING_FRAMES)
	await rested()
	check_equal(_count_near(Vector2.ZERO, 5.5), 0, "plants within the larger outline")
	other.free()


func test_an_exclusion_of_two_points_is_reported_with_advice() -> void:
	field.exclusions = [add_path("Line", [Vector3(-5, 0, 0), Vector3(5, 0, 0)])]
	root.add_child(field)
	await rested()
	check_error("curve of fewer than three points, which encloses no area. Add points")
	check_equal(field.get_plant_count(), 0, "plants")
	(field.get_node("Line") as Path3D).curve.add_point(Vector3(0, 0, 5))
	await rested()
	check(field.get_plant_count() > 1000, "it grows when the point is there")


func test_a_field_that_a_tool_adds_grows_grass_at_once() -> void:
	var new_field := PlantField3D.new()
	root.add_child(new_field)
	await filled(new_field)
	check(new_field.get_plant_count() >= 10000, "%d plants" % new_field.get_plant_count())
	var id := new_field.get_plant_ids()[0]
	var grows := new_field.get_plant_species(id).resource_path.get_file()
	check_equal(grows, "meadow_grass.tres", "what grows")
	check_equal(new_field.species.size(), 0, "species of the list")
	new_field.free()


func _add_square(title: String) -> NodePath:
	return add_path(
		title, [Vector3(-3, 0, -3), Vector3(3, 0, -3), Vector3(3, 0, 3), Vector3(-3, 0, 3)]
	)


func _count_near(place: Vector2, radius: float) -> int:
	return field.find_plants_in_sphere(Vector3(place.x, 0, place.y), radius).size()
