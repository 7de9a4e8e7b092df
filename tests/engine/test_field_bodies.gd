## Bodies and blows that push the plants of a field.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(30, 30)
	field.density = 3.0
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES
	field.wind.strength = 2.0


func test_impulses_move_plants_in_reach_only() -> void:
	field.wind = null
	await start()
	var before := all_tips()
	var count := field.apply_impulse_in_sphere(Vector3(3, 0, 3), 2.0, Vector3(1, 0, 0))
	check(count > 10, "%d plants are hit" % count)
	await step(4)
	var after := all_tips()
	var places := field.get_plant_transforms(field.get_plant_ids())
	for i in places.size():
		var is_near := places[i].origin.distance_to(Vector3(3, 0, 3)) <= 2.0
		var has_moved := after[i].distance_to(before[i]) > 1e-5
		check(is_near == has_moved, "plant %d moves where it was hit" % i)
	field.apply_impulse_in_sphere(Vector3.ZERO, 1.0, Vector3(NAN, 0, 0))
	check_error("apply_impulse_in_sphere")


func test_bodies_push_plants_and_are_told_of() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var walker := add_walker()
	walker.position = Vector3(0, 0.5, 50)
	var told: Array[String] = []
	field.body_entered_plants.connect(
		func(body: Node3D) -> void: told.append("in" if body == walker else "?")
	)
	field.body_exited_plants.connect(
		func(body: Node3D) -> void: told.append("out" if body == walker else "?")
	)
	await step(3)
	check_equal(told, [] as Array[String], "told outside")
	var rest := all_tips()
	walker.position = Vector3(0, 0.5, 0)
	await step(5)
	check_equal(told, ["in"] as Array[String], "told inside")
	check(count_moved(rest, 0.05) > 0, "plants are pushed")
	walker.position = Vector3(0, 0.5, 50)
	await step(3)
	check_equal(told, ["in", "out"] as Array[String], "told outside again")
	walker.position = Vector3(0, 0.5, 0)
	await step(3)
	walker.remove_from_group(&"walkers")
	await step(3)
	check_equal(
		told, ["in", "out", "in", "out"] as Array[String], "told of one that left the group"
	)
	await step(1500)
	check_equal(count_moved(rest, 0.02), 0, "plants that have not come back")
	walker.free()


func test_bodies_push_plants_that_follow_prototypes_for_a_while() -> void:
	field.prototypes = 8
	field.wind = null
	field.bodies_group = &"walkers"
	var walker := add_walker()
	await start()
	var rest := all_tips()
	walker.position = Vector3(0, 0.5, 0)
	await step(5)
	var pushed := count_moved(rest, 0.05)
	check(pushed > 0, "plants are pushed")
	check(pushed < rest.size(), "not all of them")
	var simulated: int = field.get_statistics()["simulated"]
	check(simulated > 8, "they swing by themselves")
	walker.position = Vector3(0, 0.5, 50)
	await step(400)
	check_equal(count_moved(rest, 0.02), 0, "plants that have not come back")
	check_equal(field.get_statistics()["simulated"], 8 * field.species.size(), "they follow again")
	walker.free()


func test_a_body_that_is_freed_among_plants_is_forgotten() -> void:
	field.bodies_group = &"walkers"
	await start()
	var walker := add_walker()
	await step(3)
	walker.free()
	await step(3)
	check(field.get_plant_count() > 0, "all goes on")
