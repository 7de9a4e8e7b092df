## Fields with physics in its own thread, by the suite's project settings.
extends "res://tests/engine/field_harness.gd"

const RATES: Array[int] = [30, 60, 144, 240]

var _ground: StaticBody3D


func before_each() -> void:
	Engine.max_physics_steps_per_frame = 100
	_ground = StaticBody3D.new()
	add_shape(_ground, box_shape(Vector3(8, 2, 8)))
	_ground.position.y = 4.5
	root.add_child(_ground)
	field = PlantField3D.from_species([GrassFunction.new()])
	field.density = 20.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS


func after_each() -> void:
	Engine.physics_ticks_per_second = 60
	Engine.max_physics_steps_per_frame = 8
	_ground.free()
	await super()


func test_physics_has_its_own_thread() -> void:
	check(ProjectSettings.get_setting("physics/3d/run_on_separate_thread"), "the project says so")


func test_plants_follow_colliders_at_every_rate() -> void:
	for rate in RATES:
		Engine.physics_ticks_per_second = rate
		await physics_frames(3)
		if field.is_inside_tree():
			field.rebuild()
			await filled(field)
		else:
			await start()
		check_near(field.get_plant_count(), 20 * 8 * 8, 60.0, "plants at %d Hz" % rate)
		for transform in field.get_plant_transforms(field.get_plant_ids()):
			check_near(transform.origin.y, 5.5, 1e-3, "height at %d Hz" % rate)


func test_what_physics_moves_pushes_plants_that_touch_at_every_rate() -> void:
	field.species = [PlantFieldSpecies.of(TulipFunction.new())]
	field.contact_enabled = true
	field.bodies_group = &"walkers"
	await physics_frames(3)
	await start()
	for rate in RATES:
		Engine.physics_ticks_per_second = rate
		field.reset_motion()
		await frames(3)
		await _roll_through(rate)


func test_a_field_is_rebuilt_repeatedly_while_bodies_move_among_its_plants() -> void:
	field.bodies_group = &"walkers"
	field.contact_enabled = true
	await physics_frames(3)
	await start()
	var ball := _add_ball(-3.0)
	for rate in RATES:
		Engine.physics_ticks_per_second = rate
		for round in 3:
			ball.position = Vector3(-3, 7.1, 0)
			ball.linear_velocity = Vector3(6, 0, 0)
			field.rebuild()
			await filled(field)
			check_near(field.get_plant_count(), 20 * 8 * 8, 60.0, "plants at %d Hz" % rate)
			check(not is_nan(all_tips()[0].x), "tips at %d Hz" % rate)
	ball.free()


func test_a_walker_moves_plants_alike_at_every_rate() -> void:
	for contact: String in ["", "contact"]:
		var expected := _way_of_tips(60, contact)
		check(expected > 0.3, "tips go %f m" % expected)
		for rate in RATES:
			var way := _way_of_tips(rate, contact)
			# With fewer physics frames than steps, a body moves in jumps. Slow frames of a busy
			# machine drop steps, which affects tips in contact most.
			var share := 0.15 if rate < 60 or not contact.is_empty() else 0.05
			check_near(way, expected, share * expected, "way at %d Hz %s" % [rate, contact])


func test_bodies_that_physics_moves_push_plants() -> void:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.bodies_group = &"walkers"
	root.add_child(plant)
	var ball := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	ball.add_child(shape)
	ball.gravity_scale = 0.0
	ball.position = Vector3(-1.5, plant.get_plant_height(), 0)
	ball.linear_velocity.x = 1.5
	ball.add_to_group(&"walkers")
	root.add_child(ball)
	var maximum := 0.0
	while ball.position.x < 1.0:
		await physics_frame
		maximum = maxf(maximum, plant.get_deflection())
	check(maximum > 0.2, "pushed by %f rad" % maximum)
	ball.free()
	plant.free()


## Returns the movement (m) of tips in tests/engine/driven/walk_through_field.gd, in a process of
## its own with a walker that moves in physics frames.
func _way_of_tips(rate: int, contact: String) -> float:
	var script := "res://tests/engine/driven/walk_through_field.gd"
	var words := [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", script
	]
	words += ["--fixed-fps", "60", "--", "physics", "ticks=%d" % rate, contact]
	var output := []
	OS.execute(engine_path(), words, output, true)
	var said := (output[0] as String).get_slice("way ", 1)
	return said.to_float()


## Returns a ball that only physics moves, along the middle of the field.
func _roll_through(rate: int) -> void:
	var reported: Array[String] = []
	var enter := func(_body: Node3D) -> void: reported.append("in")
	var leave := func(_body: Node3D) -> void: reported.append("out")
	field.body_entered_plants.connect(enter)
	field.body_exited_plants.connect(leave)
	var rest := all_tips()
	var places := field.get_plant_transforms(field.get_plant_ids())
	var ball := _add_ball(-8.0)
	var pushed := {}
	while ball.position.x < 8.0:
		await process_frame
		var tips := all_tips()
		for i in tips.size():
			check(tips[i].is_finite(), "tip %d at %d Hz" % [i, rate])
			if tips[i].distance_to(rest[i]) > 0.05:
				pushed[i] = true
	check_equal(reported, ["in", "out"] as Array[String], "signals at %d Hz" % rate)
	var in_its_way := 0
	var missed := 0
	for i in places.size():
		var aside := absf(places[i].origin.z)
		in_its_way += 1 if aside < 0.3 else 0
		missed += 1 if aside < 0.3 and not pushed.has(i) else 0
		check(not pushed.has(i) or aside < 3.0, "plant %d exists at %d Hz" % [i, rate])
	check(in_its_way > 50, "%d plants are in its way" % in_its_way)
	# A slow frame of a busy machine drops steps.
	check(missed < 0.2 * in_its_way, "%d of %d are missed at %d Hz" % [missed, in_its_way, rate])
	field.body_entered_plants.disconnect(enter)
	field.body_exited_plants.disconnect(leave)
	ball.free()


func _add_ball(x: float) -> RigidBody3D:
	var ball := RigidBody3D.new()
	var shape := SphereShape3D.new()
	shape.radius = 0.5
	add_shape(ball, shape)
	ball.gravity_scale = 0.0
	ball.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	ball.add_to_group(&"walkers")
	ball.position = Vector3(x, 7.1, 0)
	ball.linear_velocity = Vector3(8, 0, 0)
	root.add_child(ball)
	return ball
