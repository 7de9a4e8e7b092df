## Bodies that push single plants.
extends "res://tests/engine/plant_harness.gd"

const RADIUS := 0.3  # m, of the balls.
## m. A plant is pushed once per step, and pulls back during a step.
const CLEAR := 0.01

const MAX_DIFFERENCE := 0.001  # m, between a tip of a field and that of a single plant.

const BOTH_LAWS: Array[PlantFunction.MotionLaw] = [
	PlantFunction.LAW_SPRING, PlantFunction.LAW_ELASTICITY
]


func test_a_ball_holds_the_tip_at_its_surface_and_the_tip_is_a_sphere() -> void:
	for law in BOTH_LAWS:
		for thick: float in [0.0, 0.05, 0.2]:
			var plant := add_plant(make_species(law, thick))
			var ball := add_ball(Vector3(-0.1, 1.2, 0.05), RADIUS)
			await pass_time(0.5)
			var away := tip_of(plant).distance_to(ball.position)
			check_near(away, RADIUS + thick, CLEAR, "tip to ball, law %d" % law)
			check(tip_of(plant).x > 0.05, "it leaves by the near side: %s" % tip_of(plant))
			plant.free()
			ball.free()


func test_a_capsule_pushes_up_to_its_round_end() -> void:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 0.2
	capsule.height = 1.0
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING))
	var body := add_body(capsule, Vector3(-0.05, 1.2 + 0.05 + 0.1 + 0.5, 0))
	await pass_time(0.5)
	check_near(plant.get_deflection(), 0.0, 1e-6, "deflection 10 cm below the capsule")
	body.position.y -= 0.2
	await pass_time(0.5)
	check(plant.get_deflection() > 0.02, "a lower one pushes: %f" % plant.get_deflection())


func test_a_fast_body_pushes_from_its_place_in_the_same_frame() -> void:
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING, 0.0))
	var ball := add_ball(Vector3(-0.8, 1.2, 0), RADIUS)
	await frames(2)
	var nearest := 1.0
	for i in 16:
		ball.position.x += 0.05
		await process_frame
		nearest = minf(nearest, tip_of(plant).distance_to(ball.position))
	check_near(nearest, RADIUS, CLEAR, "tip to ball")
	check(tip_of(plant).x > 0.2, "it is pushed along: %s" % tip_of(plant))


func test_plants_that_are_moved_scaled_or_turned_are_pushed_in_the_world() -> void:
	var spring := make_species(PlantFunction.LAW_SPRING)
	var elastic := make_species(PlantFunction.LAW_ELASTICITY)
	var moved := Transform3D(Basis(), Vector3(40, -7, 12))
	await _check_surface(spring, moved)
	await _check_surface(elastic, moved)
	var scaled := Transform3D(Basis.from_scale(Vector3.ONE * 2.0), Vector3(3, 1, 0))
	await _check_surface(spring, scaled)
	await _check_surface(elastic, scaled.rotated(Vector3.UP, 2.0))
	for axis: Vector3 in [Vector3.RIGHT, Vector3.FORWARD, Vector3(1, 0, 1).normalized()]:
		for angle: float in [0.4, 0.5 * PI, 0.8 * PI, PI, 1.5 * PI]:
			await _check_surface(spring, Transform3D(Basis(axis, angle), Vector3(1, 9, 2)))


func test_a_plant_and_that_of_a_field_are_pushed_alike() -> void:
	for law in BOTH_LAWS:
		var species := make_species(law, 0.08)
		var near := Transform3D(Basis.from_scale(Vector3.ONE * 1.5), Vector3(0, 0, 4))
		await _check_like_field(species, Transform3D(), SphereShape3D.new(), Vector3(0.2, 0.1, 0.1))
		await _check_like_field(species, near, CapsuleShape3D.new(), Vector3(-0.2, -0.4, 0.3))
		await _check_like_field(species, near, CylinderShape3D.new(), Vector3(0.3, -0.6, 0.1))
		await _check_like_field(species, Transform3D(), BoxShape3D.new(), Vector3(0.1, 0.2, 0.4))


func test_what_walks_by_moves_both_alike_at_every_frame_rate() -> void:
	for moved: String in ["physics", "drawn"]:
		for rate: int in [30, 60, 144, 240]:
			var ways := _ways_of(rate, moved)
			var how := " at %d frames, %s" % [rate, moved]
			check(ways[0] > 0.3, "tips of the field go %f m" % ways[0])
			check_near(ways[1], ways[0], 0.05 * ways[0], "way" + how)
			check_near(ways[2], 0.0, MAX_DIFFERENCE, "most between two tips" + how)


## Returns the output of tests/engine/driven/walk_by_plants.gd in a process of its own (m): the
## movement of tips of a field and of single plants, and the maximum distance between them.


func _ways_of(rate: int, moved: String) -> PackedFloat64Array:
	var script := "res://tests/engine/driven/walk_by_plants.gd"
	var words := [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", script
	]
	words += ["--fixed-fps", str(rate), "--", moved]
	var output := []
	OS.execute(OS.get_environment("GODOT"), words, output, true)
	var said := (output[0] as String).get_slice("ways ", 1).get_slice("\n", 0)
	return said.split_floats(" ")


func test_it_rings_down_once_the_body_is_gone() -> void:
	for law in BOTH_LAWS:
		var plant := add_plant(make_species(law))
		var ball := add_ball(Vector3(-0.1, 1.2, 0), RADIUS)
		await pass_time(0.3)
		check(plant.get_deflection() > 0.1, "pushed by %f rad" % plant.get_deflection())
		ball.position.x = 500.0
		var crossed := false
		for i in 600:
			await process_frame
			crossed = crossed or tip_of(plant).x < -0.02
		check(crossed, "it swings to the other side, law %d" % law)
		Engine.time_scale = 8.0
		await pass_time(60.0)
		Engine.time_scale = 1.0
		check_near(plant.get_deflection(), 0.0, 0.01, "deflection in the end, law %d" % law)
		plant.free()
		ball.free()


func test_plants_that_name_no_group_or_do_not_simulate_are_not_pushed() -> void:
	var species := make_species(PlantFunction.LAW_SPRING)
	var nameless := add_plant(species)
	nameless.bodies_group = &""
	var other := add_plant(species)
	other.bodies_group = &"others"
	var parked := add_plant(species)
	parked.simulation_enabled = false
	var driven := add_plant(species)
	driven.simulation_enabled = false
	var pushed := add_plant(species)
	add_ball(Vector3(-0.1, 1.2, 0), RADIUS)
	for i in 10:
		await process_frame
		driven.advance(0.02)
	for plant: Plant3D in [nameless, other, parked, driven]:
		check_near(plant.get_deflection(), 0.0, 1e-6, "deflection")
	check(pushed.get_deflection() > 0.1, "the one that names it is pushed")
	parked.simulation_enabled = true
	other.bodies_group = GROUP
	pushed.bodies_group = &""
	await pass_time(3.0)
	check(parked.get_deflection() > 0.1, "and once it simulates")
	check(other.get_deflection() > 0.1, "and once it names the group")
	check(pushed.get_deflection() < 0.1, "and not once it names none")


func test_in_a_paused_tree_only_active_nodes_are_pushed() -> void:
	var stands := add_plant(make_species(PlantFunction.LAW_SPRING))
	var goes_on := add_plant(stands.species)
	goes_on.process_mode = Node.PROCESS_MODE_ALWAYS
	await frames(2)
	paused = true
	add_ball(Vector3(-0.1, 1.2, 0), RADIUS)
	await frames(20)
	check_near(stands.get_deflection(), 0.0, 1e-6, "deflection of the one that is fixed")
	check(goes_on.get_deflection() > 0.1, "the other is pushed")
	paused = false
	await pass_time(0.2)
	check(stands.get_deflection() > 0.1, "and the first one after the pause")


func test_shapes_deep_below_a_body_push_but_not_those_of_areas() -> void:
	var near := add_plant(make_species(PlantFunction.LAW_SPRING))
	var far := add_plant(near.species, Transform3D(Basis(), Vector3(4, 0, 0)))
	var hero := Node3D.new()
	var pivot := Node3D.new()
	var area := Area3D.new()
	var sight := SphereShape3D.new()
	sight.radius = 12.0
	add_shape(area, sight)
	pivot.add_child(area)
	var ball := SphereShape3D.new()
	ball.radius = RADIUS
	add_shape(pivot, ball)
	hero.add_child(pivot)
	hero.position = Vector3(-0.1, 1.2, 0)
	hero.add_to_group(GROUP)
	root.add_child(hero)
	await pass_time(0.2)
	check(near.get_deflection() > 0.1, "a grandchild pushes")
	check_near(far.get_deflection(), 0.0, 1e-6, "what feels does not")


func test_what_is_set_down_by_a_plant_does_not_shove_it() -> void:
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING))
	var ball := add_ball(Vector3(-500, 1.2, 0), RADIUS)
	await pass_time(0.2)
	ball.position.x = -0.2
	var maximum := 0.0
	for i in 30:
		await process_frame
		maximum = maxf(maximum, plant.get_deflection())
	check(maximum > 0.05 and maximum < 0.35, "it leans by %f rad" % maximum)
	ball.position.x = 500
	plant.position.x = 1000
	await pass_time(3.0)
	plant.position.x = 500.2
	maximum = 0.0
	for i in 30:
		await process_frame
		maximum = maxf(maximum, plant.get_deflection())
	check(maximum > 0.05 and maximum < 0.35, "nor one that is set down itself, %f rad" % maximum)


func test_a_moving_plant_is_not_pushed_by_a_body_at_rest_or_beside_it() -> void:
	var still := await _max_lean_of(0.0, 0.0)
	check(still > 0.05, "it is pushed to %f rad" % still)
	check_near(await _max_lean_of(0.02, 0.0), still, 0.02, "lean where the plant moves")
	check_near(await _max_lean_of(-0.02, -0.02), still, 0.02, "lean where both move")
	check(await _max_lean_of(0.0, -0.02) > still + 0.15, "a ball that comes shoves")


## Returns the maximum lean of a plant beside a ball while the plant and the ball move by metres in
## each frame. At the end both have the positions of a run without movement.


func _max_lean_of(plant_way: float, ball_way: float) -> float:
	var plant := add_plant(make_species(PlantFunction.LAW_SPRING, 0.2))
	plant.apparent_wind = 0.0
	var ball: StaticBody3D
	var maximum := 0.0
	for i in 60:
		var left := maxi(15 - i, 0)
		plant.position.x = -plant_way * left
		var at := Vector3(0.4 - ball_way * left, 1.2, 0)
		if ball == null:
			await frames(3)
			ball = add_ball(at, RADIUS)
		ball.position = at
		await process_frame
		maximum = maxf(maximum, plant.get_deflection())
	plant.free()
	ball.free()
	return maximum


## Checks that a ball at the tip of a plant in this pose leaves the tip at its surface.


func _check_surface(species: PlantFunction, placed: Transform3D) -> void:
	var plant := add_plant(species, placed)
	var rest := tip_of(plant)
	var aside := (rest - placed.origin).normalized().cross(Vector3(0.3, 0.5, 0.8)).normalized()
	var ball := add_ball(rest - 0.1 * aside, RADIUS)
	await pass_time(0.4)
	var tip := tip_of(plant)
	check_near(tip.distance_to(ball.position), RADIUS + 0.05, CLEAR, "at %s" % placed)
	check((tip - rest).dot(aside) > 0.05, "it goes to its side at %s: %s" % [placed, tip - rest])
	plant.free()
	ball.free()


## Checks that a body at this distance moves the tip as it moves that of a field's plant.


func _check_like_field(
	species: PlantFunction, placed: Transform3D, shape: Shape3D, from_tip: Vector3
) -> void:
	var field := PlantField3D.new()
	field.density = 0.0
	field.bodies_group = GROUP
	root.add_child(field)
	await field.build_finished
	await process_frame
	var id := field.add_plants([placed], species)[0]
	var stands := field.get_plant_transform(id)
	var plant := add_plant(species, stands, field.get_plant_height(id) / stands.basis.y.length())
	var body := add_body(shape, tip_of(plant) + from_tip)
	await pass_time(1.5)
	var tip := tip_of(plant)
	check(plant.get_deflection() > 0.05, "%s pushes: %s" % [shape.get_class(), tip])
	check_near(tip, field.get_tip_position(id), 0.005, "tip beside a %s" % shape.get_class())
	plant.free()
	body.free()
	field.free()
