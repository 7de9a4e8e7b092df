## Signals of single plants for bodies among them, and warnings for bodies that cannot push.
extends "res://tests/engine/plant_harness.gd"

const RADIUS := 0.3  # m, of the balls.


func test_bodies_are_signalled_by_each_plant() -> void:
	var near := add_plant(make_species(PlantFunction.LAW_SPRING, 0.0))
	var far := add_plant(near.species, Transform3D(Basis(), Vector3(3, 0, 0)))
	var ball := add_ball(Vector3(-0.45, 1.2, 0), RADIUS)
	var reported: Array[String] = []
	for plant: Plant3D in [near, far]:
		var title := "near" if plant == near else "far"
		plant.body_entered_plants.connect(
			func(_body: Node3D) -> void: reported.append(title + " in")
		)
		plant.body_exited_plants.connect(
			func(_body: Node3D) -> void: reported.append(title + " out")
		)
	await pass_time(0.2)
	check_equal(reported, [] as Array[String], "signals farther than the margin")
	near.touch_margin = 0.2
	await pass_time(0.2)
	check_equal(reported, ["near in"] as Array[String], "signals within the margin")
	check_near(near.get_deflection(), 0.0, 1e-6, "a margin pushes nothing")
	paused = true
	await frames(3)
	paused = false
	ball.position = Vector3(2.65, 1.2, 0)
	await pass_time(0.2)
	check_equal(
		reported, ["near in", "far in", "near out"] as Array[String], "signals at the other"
	)
	ball.remove_from_group(GROUP)
	await pass_time(0.2)
	check_equal(reported.back(), "far out", "signal of one that left the group")
	ball.add_to_group(GROUP)
	await pass_time(0.2)
	far.bodies_group = &""
	await pass_time(0.2)
	check_equal(
		reported.slice(4), ["far in", "far out"] as Array[String], "signals without a group"
	)
	near.touch_margin = -1.0
	check_error("touch_margin")
	check_equal(near.touch_margin, 0.2, "margin")


func test_a_point_is_in_a_plant_within_its_margin() -> void:
	var placed := Transform3D(Basis.from_euler(Vector3(0.3, 0, 1.2)) * 2.0, Vector3(5, 1, 0))
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING, 0.05), placed)
	plant.touch_margin = 0.15
	var middle := plant.to_global(Vector3(0, 0.6, 0))
	var aside := placed.basis.x.normalized()
	check(plant.is_point_in_plants(middle + 0.19 * aside), "within margin and radius")
	check(not plant.is_point_in_plants(middle + 0.21 * aside), "beyond them")
	check(not plant.is_point_in_plants(Vector3(NAN, 0, 0)), "nowhere")


func test_a_body_that_is_freed_among_plants_is_forgotten() -> void:
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING))
	var reported: Array[Node3D] = []
	plant.body_exited_plants.connect(func(body: Node3D) -> void: reported.append(body))
	var ball := add_ball(Vector3(-0.1, 1.2, 0), RADIUS)
	await pass_time(0.2)
	ball.free()
	await pass_time(3.0)
	check(plant.get_deflection() < 0.1, "it swings freely")
	check_equal(reported, [] as Array[Node3D], "signals")
	ball = add_ball(Vector3(-0.1, 1.2, 0), RADIUS)
	await pass_time(0.2)
	plant.queue_free()
	ball.queue_free()
	await pass_time(0.2)
	add_plant(make_species(PlantFunction.LAW_SPRING))
	await pass_time(0.2)


func test_bodies_that_cannot_push_are_reported_once_for_many_plants() -> void:
	var species := make_species(PlantFunction.LAW_SPRING)
	for i in 50:
		add_plant(species, Transform3D(Basis(), Vector3(i, 0, 0))).touch_margin = 0.01 * i
	var walker := add_body(CapsuleShape3D.new())
	var wall := add_body(WorldBoundaryShape3D.new())
	wall.name = "Wall"
	Engine.time_scale = 8.0
	await pass_time(4.0)
	paused = true
	await frames(3)
	paused = false
	await pass_time(4.0)
	check_error("Wall' is in the group 'walkers' but pushes no plants")
	walker.free()


func test_an_empty_group_is_reported_once() -> void:
	var group := "wlakers%d" % Time.get_ticks_usec()  # One warning per group and process.
	for i in 3:
		add_plant(make_species(PlantFunction.LAW_SPRING, 0.01 * i)).bodies_group = group
	Engine.time_scale = 8.0
	await pass_time(20.0)
	check_error("no body of its world is in the group '%s'" % group)
