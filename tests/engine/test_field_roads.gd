## Paths with a width: roads without plants, and beds with plants.
extends "res://tests/engine/field_harness.gd"

const POLLING_FRAMES := 10  # Frames between two polls of movement without a signal.
const WIDTH := 2.4
const RING: Array[Vector3] = [
	Vector3(-8, 0, -8), Vector3(8, 0, -8), Vector3(8, 0, 8), Vector3(-8, 0, 8), Vector3(-8, 0, -8)
]


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2(30, 30)
	field.density = 10.0


func test_nothing_grows_on_a_road_of_two_points() -> void:
	var from := Vector3(-20, 0, -3)
	var to := Vector3(20, 1, 5)
	field.exclusions = [add_path("Road", [from, to])]
	field.exclusion_widths = [WIDTH]
	await start()
	var beside := 0
	for place in _places():
		var away := _away(place, [from, to])
		check(away > 0.5 * WIDTH - 1e-3, "%s is on the road" % place)
		beside += 1 if away < 0.5 * WIDTH + 0.5 else 0
	# Along slightly more than 30 m, half a metre on each side.
	check_near(beside, 10.0 * 30.6, 70.0, "plants beside it")


func test_a_road_that_crosses_itself_is_free_at_the_crossing() -> void:
	var points: Array[Vector3] = [
		Vector3(-19, 0, -16), Vector3(8, 0, 8), Vector3(8, 0, -8), Vector3(-19, 0, 16)
	]
	field.exclusions = [add_path("Road", points)]
	field.exclusion_widths = [WIDTH]
	await start()
	for place in _places():
		check(_away(place, points) > 0.5 * WIDTH - 1e-3, "%s is on the road" % place)
	check(_count_near(Vector3(4, 0, 0), 1.0) > 10, "plants in its loop")


func test_a_road_around_a_place_leaves_that_place_to_plants() -> void:
	field.exclusions = [add_path("Ring", RING)]
	field.exclusion_widths = [WIDTH]
	await start()
	for place in _places():
		check(_away(place, RING) > 0.5 * WIDTH - 1e-3, "%s is on the road" % place)
	check_near(_count_near(Vector3.ZERO, 5.0), PI * 25.0 * 10.0, 100.0, "plants within it")
	check(_count_near(Vector3(12, 0, 12), 2.0) > 80, "plants outside of it")


func test_a_bed_grows_along_its_path() -> void:
	var points: Array[Vector3] = [Vector3(-30, 0, 2), Vector3(0, 0, -4), Vector3(30, 0, 2)]
	field.outline = add_path("Bed", points)
	root.add_child(field)
	field.outline_width = WIDTH
	await filled(field)
	check_near(field.get_plant_count(), 61.2 * WIDTH * 10.0, 120.0, "plants")
	for place in _places():
		check(_away(place, points) < 0.51 * WIDTH, "%s is in the bed" % place)
	check(field.get_outline_points().size() >= 6, "its border")
	var bed := field.get_node("Bed") as Path3D
	bed.curve.set_point_position(1, Vector3(0, 0, 8))
	await rested()
	for place in _places():
		var away := _away(place, [points[0], Vector3(0, 0, 8), points[2]])
		check(away < 0.52 * WIDTH, "%s is in the bed that was bent" % place)
	field.outline_width = 0.0
	await rested()
	check_near(field.get_plant_count(), 0.5 * 60.0 * 6.0 * 10.0, 150.0, "what it goes around")


func test_a_bed_around_a_place_is_a_ring() -> void:
	field.outline = add_path("Bed", RING)
	field.outline_width = 2.0
	await start()
	check_near(field.get_plant_count(), (18.0 * 18.0 - 14.0 * 14.0) * 10.0, 120.0, "plants")
	check_equal(_count_near(Vector3.ZERO, 6.9), 0, "plants within it")


## A dragged path changes only the plants near it.
func test_a_road_that_is_dragged_is_followed_where_it_goes() -> void:
	field.size = Vector2(60, 60)
	var points: Array[Vector3] = [Vector3(-40, 0, 20), Vector3(0, 0, 20), Vector3(40, 0, 20)]
	field.exclusions = [add_path("Road", points)]
	field.exclusion_widths = [WIDTH]
	await start()
	var reported := [0, 0]
	field.build_progressed.connect(func(_ratio: float) -> void: reported[0] += 1)
	field.build_finished.connect(func() -> void: reported[1] += 1)
	var road := field.get_node("Road") as Path3D
	for i in 12:
		points[1].z -= 1.0
		road.curve.set_point_position(1, points[1])
		await frames(i % 4)
	await rested()
	check_equal(reported[0], 0, "it was never filled as a whole")
	check(reported[1] > 0, "it reports that all exists")
	road.position.x = 1.5
	field.exclusion_widths = [WIDTH + 1.0]
	await frames(POLLING_FRAMES)
	await rested()
	for place in _places():
		var away := _away(place - Vector3(1.5, 0, 0), points)
		check(away > 0.5 * (WIDTH + 1.0) - 1e-3, "%s is on the road" % place)
	var edited := _described()
	field.rebuild()
	await filled(field)
	check(reported[0] > 0, "it is filled as a whole then")
	check_equal(_described(), edited, "and the same as before")


func test_a_road_on_a_painted_field_and_where_it_streams_is_followed() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	var points: Array[Vector3] = [Vector3(-20, 0, 4), Vector3(0, 0, 4), Vector3(20, 0, 4)]
	field.exclusions = [add_path("Road", points)]
	field.exclusion_widths = [WIDTH]
	for distance: float in [0.0, 60.0]:
		field.view_distance = distance
		field.map = PlantMap.new() if distance == 0.0 else null
		if field.map:
			field.map.fill_polygon(field.get_outline_points(), "Grass")
		if not field.is_inside_tree():
			root.add_child(field)
		await rested()
		points[1].z -= 3.0
		(field.get_node("Road") as Path3D).curve.set_point_position(1, points[1])
		await rested()
		check(field.get_plant_count() > 1000, "%d plants" % field.get_plant_count())
		for place in _places():
			check(_away(place, points) > 0.5 * WIDTH - 1e-3, "%s is on the road" % place)
	camera.free()


func test_a_change_without_effect_emits_build_finished() -> void:
	field.exclusions = [add_path("Road", [Vector3(-40, 0, 3), Vector3(40, 0, 3)])]
	field.exclusion_widths = [WIDTH]
	await start()
	var described := _described()
	field.outline_width = 3.0  # It has no outline.
	await filled(field)
	check_equal(_described(), described, "plants")
	check(not field.is_building(), "it is done")


func test_widths_that_are_none_are_refused() -> void:
	field.exclusion_widths = [1.0, -2.0]
	check_error("exclusion_widths cannot be -2")
	check_equal(field.exclusion_widths, PackedFloat32Array(), "they stay")
	field.outline_width = NAN
	check_error("outline_width cannot be nan")
	field.exclusions = [add_path("Spot", [Vector3.ONE])]
	field.exclusion_widths = [1.0]
	root.add_child(field)
	await rested()
	check_error("exclusions[0] has a curve of fewer than two points")
	field.exclusions = []
	field.outline = ^"Spot"
	await rested()
	check_error("outline 'Spot' has a curve of fewer than three points")
	field.outline_width = 2.0
	await rested()
	check_error("outline 'Spot' has a curve of fewer than two points")


func _places() -> PackedVector3Array:
	var places := PackedVector3Array()
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		places.append(Vector3(transform.origin.x, 0, transform.origin.z))
	return places


func _described() -> Array:
	var ids := sorted_ids()
	return [ids, field.get_plant_transforms(ids), field.get_plant_heights(ids)]


func _count_near(place: Vector3, radius: float) -> int:
	return field.find_plants_in_sphere(place, radius).size()


## Returns the distance, seen from above, from a line through points.
func _away(place: Vector3, points: Array[Vector3]) -> float:
	var flat := Vector2(place.x, place.z)
	var nearest := INF
	for i in points.size() - 1:
		var from := Vector2(points[i].x, points[i].z)
		var to := Vector2(points[i + 1].x, points[i + 1].z)
		var at := Geometry2D.get_closest_point_to_segment(flat, from, to)
		nearest = minf(nearest, flat.distance_to(at))
	return nearest
