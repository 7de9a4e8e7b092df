## Fields on colliders where physics has a thread of its own: the suite's project says so.
extends "res://tests/engine/field_harness.gd"


func test_plants_stand_on_colliders() -> void:
	check(
		ProjectSettings.get_setting("physics/3d/run_on_separate_thread"),
		"physics has its own thread"
	)
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(8, 2, 8)
	body.add_child(shape)
	body.position.y = 4.5
	root.add_child(body)
	await physics_frames(3)
	field = PlantField3D.from_species([GrassFunction.new()])
	field.density = 20.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	await start()
	check_near(field.get_plant_count(), 20 * 8 * 8, 60.0, "plants")
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		check_near(transform.origin.y, 5.5, 1e-3, "height")
	field.fill()
	await filled(field)
	check_near(field.get_plant_count(), 20 * 8 * 8, 60.0, "plants after another fill")
	body.free()


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
	var most := 0.0
	while ball.position.x < 1.0:
		await physics_frame
		most = maxf(most, plant.get_deflection())
	check(most > 0.2, "pushed by %f rad" % most)
	ball.free()
	plant.free()
