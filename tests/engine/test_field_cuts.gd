## Cuts and air blasts on many plants in one call.
extends "res://tests/engine/field_harness.gd"

const TURN := 0.4


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 10.0
	field.wind = PlantWind.new()
	field.wind.strength = 0.0
	field.position = Vector3(5, 1, -3)
	field.rotation.y = TURN


func test_a_box_is_cut() -> void:
	await start()
	var box := AABB(Vector3(3, 0, -5), Vector3(4, 2, 3))
	var inside := _inside(func(place: Vector3) -> bool: return box.has_point(place))
	check_equal(field.remove_in_box(box), inside, "cut")
	check(inside > 80, "%d were there" % inside)
	check_equal(field.find_plants_in_box(box).size(), 0, "left")
	check_equal(field.remove_in_box(box), 0, "cut again")


func test_a_polygon_is_cut_however_high() -> void:
	await start()
	var points := PackedVector3Array([Vector3(2, 50, -6), Vector3(8, -9, -5), Vector3(4, 0, 2)])
	var flat := PackedVector2Array()
	for point in points:
		flat.append(Vector2(point.x, point.z))
	var is_inside := func(place: Vector3) -> bool:
		return Geometry2D.is_point_in_polygon(Vector2(place.x, place.z), flat)
	var inside := _inside(is_inside)
	check(inside > 100, "%d are there" % inside)
	check(absi(field.remove_in_polygon(points) - inside) <= 1, "cut")
	check(_inside(is_inside) <= 1, "left")


func test_a_way_is_cut_once_where_it_bends_however_high() -> void:
	await start()
	var way := PackedVector3Array([Vector3(0, 1, -3), Vector3(6, 9, -3), Vector3(6, -5, 3)])
	var is_near := func(place: Vector3) -> bool:
		var seen := Vector2(place.x, place.z)
		for i in 2:
			var ends := [Vector2(way[i].x, way[i].z), Vector2(way[i + 1].x, way[i + 1].z)]
			var near := Geometry2D.get_closest_point_to_segment(seen, ends[0], ends[1])
			if near.distance_to(seen) <= 0.75:
				return true
		return false
	var inside := _inside(is_near)
	var count := field.get_plant_count()
	var cut := field.remove_along(way, 1.5)
	check(inside > 150, "%d were there" % inside)
	check(absi(cut - inside) <= 1, "%d are cut, not %d" % [cut, inside])
	check_equal(field.get_plant_count(), count - cut, "left in all")


func test_cut_plants_are_neither_found_nor_pushed() -> void:
	await start()
	await step(3)
	var id := field.find_plants_in_sphere(field.global_position, 1.0)[0]
	var tip := field.to_global(field.get_tip_position(id))
	field.touch_margin = 0.02
	check(field.is_point_in_plants(tip), "there is a plant")
	field.remove_in_sphere(field.global_position, 3.0)
	check(not field.has_plant(id), "it is gone")
	check(not field.is_point_in_plants(tip), "no plant is there")
	check_equal(field.apply_blast(field.global_position, 2.5, 1.0), 0, "plants that are blown at")
	await step(3)
	check(not field.is_point_in_plants(tip), "nor later")


func test_cutting_in_a_paused_tree_and_while_it_does_not_move() -> void:
	await start()
	field.simulation_enabled = false
	check(field.remove_in_sphere(field.global_position, 2.0) > 50, "cut")
	await frames(2)
	paused = true
	check(field.remove_in_sphere(field.global_position, 3.0) > 50, "cut in a pause")
	await frames(2)
	paused = false
	field.simulation_enabled = true
	await step(3)
	check(field.remove_in_sphere(field.global_position, 4.0) > 50, "cut then")


func test_a_blast_pushes_away_from_its_centre_and_falls_off() -> void:
	await start()
	await step(3)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.find_plants_in_sphere(field.global_position, 3.0)
	check_equal(field.apply_blast(field.global_position, 3.0, 0.05), ids.size(), "plants")
	var state := field.get_motion_state(ids)
	var outward := 0
	var near := 0.0
	var far := 0.0
	for i in ids.size():
		var place := field.get_plant_transform(ids[i]).origin
		var rate := Vector3(state[12 * i + 3], state[12 * i + 4], state[12 * i + 5])
		outward += 1 if rate.dot(place) > 0.0 else 0
		var speed := rate.length() * field.get_plant_height(ids[i])
		if place.length() < 1.0:
			near = maxf(near, speed)
		elif place.length() > 2.5:
			far = maxf(far, speed)
	check(outward > ids.size() * 0.98, "%d of %d go outward" % [outward, ids.size()])
	check(near > 2.0 * far, "near ones are as fast as %f, far ones as %f" % [near, far])


func test_bad_positions_are_one_error_each_and_cut_nothing() -> void:
	await start()
	var count := field.get_plant_count()
	field.remove_in_box(AABB(Vector3(NAN, 0, 0), Vector3.ONE))
	check_error("remove_in_box() needs a finite box")
	field.remove_in_polygon(PackedVector3Array([Vector3.ZERO, Vector3.ONE]))
	check_error("remove_in_polygon(): The area has fewer than three points")
	field.remove_along(PackedVector3Array(), 1.0)
	check_error("remove_along() needs finite points")
	field.remove_along(PackedVector3Array([Vector3.ZERO]), -1.0)
	check_error("remove_along() needs finite points")
	field.apply_blast(Vector3.ZERO, 0.0, 1.0)
	check_error("apply_blast() needs a radius above 0")
	field.apply_blast(Vector3(INF, 0, 0), 1.0, 1.0)
	check_error("apply_blast() needs a finite centre")
	check_equal(field.get_plant_count(), count, "plants")


func _inside(holds: Callable) -> int:
	var count := 0
	for id in field.get_plant_ids():
		count += 1 if holds.call(field.to_global(field.get_plant_transform(id).origin)) else 0
	return count
