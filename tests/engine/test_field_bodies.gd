## Bodies and impulses that push the plants of a field.
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


func test_bodies_push_plants_and_are_signalled() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var walker := add_walker()
	walker.position = Vector3(0, 0.5, 50)
	var reported: Array[String] = []
	field.body_entered_plants.connect(
		func(body: Node3D) -> void: reported.append("in" if body == walker else "?")
	)
	field.body_exited_plants.connect(
		func(body: Node3D) -> void: reported.append("out" if body == walker else "?")
	)
	await step(3)
	check_equal(reported, [] as Array[String], "signals outside")
	var rest := all_tips()
	walker.position = Vector3(0, 0.5, 0)
	await step(5)
	check_equal(reported, ["in"] as Array[String], "signals inside")
	check(count_moved(rest, 0.05) > 0, "plants are pushed")
	walker.position = Vector3(0, 0.5, 50)
	await step(3)
	check_equal(reported, ["in", "out"] as Array[String], "signals outside again")
	walker.position = Vector3(0, 0.5, 0)
	await step(3)
	walker.remove_from_group(&"walkers")
	await step(3)
	check_equal(
		reported, ["in", "out", "in", "out"] as Array[String], "signal of one that left the group"
	)
	await step(1500)
	check_equal(count_moved(rest, 0.02), 0, "plants that have not come back")
	walker.free()


func test_each_of_several_bodies_is_signalled_by_its_own_position() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var walkers: Array[Node3D] = []
	for i in 3:
		walkers.append(add_walker())
		walkers[i].position = Vector3(0, 0.5, 50 + 5 * i)
	var reported: PackedStringArray = []
	var tell := func(body: Node3D, what: String) -> void:
		reported.append("%d %s" % [walkers.find(body), what])
	field.body_entered_plants.connect(tell.bind("in"))
	field.body_exited_plants.connect(tell.bind("out"))
	for walker: Node3D in [walkers[2], walkers[0], walkers[1]]:
		walker.position.z -= 50
		await step(3)
		walker.position.z += 50
		await step(3)
	walkers[2].position.z -= 50
	await step(3)
	walkers[2].remove_from_group(&"walkers")
	await step(3)
	var expected: PackedStringArray = [
		"2 in", "2 out", "0 in", "0 out", "1 in", "1 out", "2 in", "2 out"
	]
	check_equal(reported, expected, "signals")
	for walker in walkers:
		walker.free()


func test_a_body_below_another_of_the_group_is_signalled_alone() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var rider := add_walker()
	var horse := Node3D.new()
	horse.position = Vector3(0, 0.5, 50)
	add_shape(horse, CapsuleShape3D.new())
	horse.add_to_group(&"walkers")
	root.add_child(horse)
	rider.reparent(horse)
	rider.position = Vector3(0, 0, -50)
	var reported: Array[Node3D] = []
	field.body_entered_plants.connect(func(body: Node3D) -> void: reported.append(body))
	await step(30)  # Longer than the shapes of a body are valid.
	check_equal(reported, [rider] as Array[Node3D], "bodies")
	horse.free()


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


func test_a_walker_moves_plants_alike_at_every_frame_rate() -> void:
	for moved: String in ["physics", "drawn"]:
		var expected := _way_of_tips(60, moved)
		check(expected > 0.3, "tips go %f m" % expected)
		for rate: int in [30, 144, 240]:
			var way := _way_of_tips(rate, moved)
			check_near(way, expected, 0.05 * expected, "way at %d frames, %s" % [rate, moved])


## Returns the movement (m) of tips in tests/engine/driven/walk_through_field.gd, in a process of
## its own.
func _way_of_tips(rate: int, moved: String) -> float:
	var script := "res://tests/engine/driven/walk_through_field.gd"
	var words := [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", script
	]
	words += ["--fixed-fps", str(rate), "--", moved]
	var output := []
	OS.execute(engine_path(), words, output, true)
	var said := (output[0] as String).get_slice("way ", 1)
	return said.to_float()


func test_steps_of_one_frame_push_at_places_of_their_own() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	field.density = 0.0
	await start()
	var places: Array[Transform3D] = []
	for i in 40:
		places.append(Transform3D(Basis.IDENTITY, Vector3(0.1 * i, 0, 0)))
	var ids := field.add_plants(places, TulipFunction.new())
	var shape := CapsuleShape3D.new()
	shape.radius = 0.12
	shape.height = 1.2
	var ball := add_body(shape, Vector3(-2.0, 0.6, 0.06))
	Engine.time_scale = 6.0  # Frames of six steps.
	var maximum: Array[float] = []
	maximum.resize(ids.size())
	for i in 12:
		ball.position.x += 0.6
		await frames(1)
		for k in ids.size():
			maximum[k] = maxf(maximum[k], absf(relative_tip(ids[k]).normalized().z))
	await frames(2)
	for k in ids.size():
		check(maximum[k] > 0.02, "plant %d is pushed aside: %f" % [k, maximum[k]])
	ball.free()


func test_a_body_that_a_field_carries_along_does_not_shove_its_plants() -> void:
	field.wind = null
	field.apparent_wind = 0.0
	field.bodies_group = &"walkers"
	await start()
	var shape := SphereShape3D.new()
	shape.radius = 0.5
	var ball := add_body(shape, Vector3(0, 0.3, 0))
	ball.reparent(field)
	await step(300)
	var rest := all_tips()
	for i in 120:
		field.position.x += 0.05
		await frames(1)
	check_equal(count_moved(rest, 0.005), 0, "plants that the ride moved")
	ball.free()


func test_a_crate_pushes_by_its_own_size_and_turn() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	field.density = 20.0
	var crate := add_body(box_shape(Vector3(2, 4, 0.4)))
	crate.position = Vector3(0, 0.5, 0)
	crate.rotation.y = 0.6
	await start()
	await step(30)
	var inside := 0
	for each in all_tips():
		var tip := crate.to_local(each).abs()
		inside += 1 if tip.x < 0.9 and tip.y < 1.9 and tip.z < 0.15 else 0
	check_equal(inside, 0, "tips in the crate")
	var rest := Vector3.ZERO
	for id in field.get_plant_ids():
		var at := crate.to_local(field.get_plant_transform(id).origin).abs()
		var lean := relative_tip(id).normalized()
		if at.x < 0.7 and at.z < 0.1:
			rest = lean
		if at.x > 1.2 or at.z > 0.5:
			check(lean.y > 0.99, "plant %d beside it is upright" % id)
	check(rest.y < 0.995 and rest != Vector3.ZERO, "plants in its middle lean: %s" % rest)
	crate.free()


func test_shapes_deep_below_a_body_push_but_not_those_of_areas() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var before := all_tips()
	var hero := Node3D.new()
	var pivot := Node3D.new()
	var area := Area3D.new()
	var sight := SphereShape3D.new()
	sight.radius = 12.0
	add_shape(area, sight)
	pivot.add_child(area)
	add_shape(pivot, CapsuleShape3D.new())
	hero.add_child(pivot)
	hero.position.y = 1.0
	hero.add_to_group(&"walkers")
	root.add_child(hero)
	await step(10)
	var after := all_tips()
	var places := field.get_plant_transforms(field.get_plant_ids())
	for i in before.size():
		var away := places[i].origin.length()
		var moved := after[i].distance_to(before[i])
		check(away < 2.5 or moved < 1e-3, "plant %d is pushed from %f m" % [i, away])
	check(count_moved(before, 0.05) > 0, "plants are pushed")
	hero.free()


func test_bodies_that_cannot_push_are_reported_once() -> void:
	field.bodies_group = &"walkers"
	var walker := add_walker()
	var wall := add_body(WorldBoundaryShape3D.new())
	wall.name = "Wall"
	Engine.time_scale = 8.0
	await start()
	await step(240)
	check_error("Wall' is in the group 'walkers' but pushes no plants")
	walker.free()
	wall.free()


func test_an_empty_group_is_reported_once() -> void:
	field.bodies_group = &"wlakers"
	Engine.time_scale = 8.0
	await start()
	await step(900)
	check_error("no body of its world is in the group 'wlakers'")


func test_what_is_set_down_among_plants_does_not_shove_them() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	var walker := add_walker()
	walker.position = Vector3(-500, 1, 0)
	await start()
	await step(10)
	var rest := all_tips()
	walker.position = Vector3(0, 1, 0)
	await step(3)
	walker.position = Vector3(500, 1, 0)
	var maximum := 0.0
	for i in 30:
		await step(1)
		var tips := all_tips()
		for plant in rest.size():
			maximum = maxf(maximum, tips[plant].distance_to(rest[plant]))
	check(maximum > 0.05 and maximum < 1.2, "tips went %f m" % maximum)
	var now := all_tips()
	var places := field.get_plant_transforms(field.get_plant_ids())
	for i in rest.size():
		if absf(places[i].origin.x) > 3.0:
			var moved := now[i].distance_to(rest[i])
			check(moved < 1e-3, "plant %d on the way is not swept" % i)
	walker.free()


func test_a_moving_field_is_not_pushed_by_a_body_at_rest() -> void:
	var still := await _max_lean_of(0.0, 0.0)
	check(still > 0.05, "plants are pushed to %f rad" % still)
	check_near(await _max_lean_of(0.02, 0.0), still, 0.005, "lean where the field moves")
	check_near(await _max_lean_of(-0.02, -0.02), still, 0.005, "lean where both move")
	check(await _max_lean_of(0.0, -0.02) > still + 0.02, "a ball that comes shoves")
	var slower := await _max_lean_of(0.02, -0.02)
	check_near(await _max_lean_of(0.02, -0.02, 2.0), slower, 0.005, "lean in a turned field")


func test_plants_of_a_turned_and_scaled_field_are_pushed_as_those_of_another() -> void:
	var usual := await _push_by_passing(Transform3D())
	check(usual.length() > 0.2, "tips are pushed by %s" % usual)
	var turned := Transform3D(Basis(Vector3.UP, 2.2).scaled(Vector3.ONE * 2.0), Vector3(30, 5, -20))
	var pushed := await _push_by_passing(turned)
	check_near(pushed, usual, 0.3 * usual.length(), "push")


## Returns the maximum lean of a plant beside a ball while its field and the ball move by metres in
## each frame. At the end both have the positions of a run without movement.
func _max_lean_of(field_way: float, ball_way: float, turn := 0.0) -> float:
	var own := _single_plant_field()
	own.rotation.y = turn
	root.add_child(own)
	await filled(own)
	var id := own.add_plants([Transform3D()], TulipFunction.new())[0]
	await frames(3)
	var ball := SphereShape3D.new()
	ball.radius = 0.4
	var body := add_body(ball)
	var maximum := 0.0
	for i in 60:
		var left := maxi(15 - i, 0)
		own.position.x = -field_way * left
		body.position = Vector3(0.45 - ball_way * left, own.get_plant_height(id), 0)
		await process_frame
		var tip := own.get_tip_position(id) - own.get_plant_transform(id).origin
		maximum = maxf(maximum, tip.angle_to(Vector3.UP))
	body.free()
	own.free()
	return maximum


## Returns the maximum movement of the tip, in the field's axes, after a hit by a ball of 2 m/s in
## these axes.
func _push_by_passing(placed: Transform3D) -> Vector3:
	var own := _single_plant_field()
	own.transform = placed
	root.add_child(own)
	await filled(own)
	var id := own.add_plants([Transform3D()], TulipFunction.new())[0]
	await frames(3)
	var rest := own.get_tip_position(id)
	var ball := SphereShape3D.new()
	ball.radius = 0.3 * placed.basis.get_scale().x
	var body := add_body(ball)
	var way := -1.0
	while way < -0.3:
		body.position = placed * Vector3(way, rest.y, 0.1)
		await process_frame
		way += 2.0 * root.get_process_delta_time()
	body.free()
	var maximum := Vector3.ZERO
	for i in 150:
		await process_frame
		var pushed := own.get_tip_position(id) - rest
		maximum = pushed if pushed.length() > maximum.length() else maximum
	own.free()
	return maximum


func _single_plant_field() -> PlantField3D:
	var own := PlantField3D.new()
	own.density = 0.0
	own.apparent_wind = 0.0
	own.bodies_group = &"walkers"
	return own
