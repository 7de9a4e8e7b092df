## Builds of fields in a paused tree.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 4.0
	field.wind = PlantWind.new()


func test_a_field_grows_behind_a_paused_loading_screen() -> void:
	paused = true
	root.add_child(field)
	await _grown()
	check_near(field.get_plant_count(), 1600, 60.0, "plants")
	var rest := all_tips()
	await frames(10)
	check_equal(all_tips(), rest, "tips while paused")
	field.density = 2.0
	await _grown()
	check_near(field.get_plant_count(), 800, 60.0, "plants of another density")
	paused = false
	await step(10)
	check(all_tips() != rest, "it moves then")


func test_a_field_grows_on_colliders_while_paused() -> void:
	var ground := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(30, 2, 30)
	ground.add_child(shape)
	ground.position.y = 2.0
	root.add_child(ground)
	await physics_frames(2)
	paused = true
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	root.add_child(field)
	await _grown()
	check_near(field.get_plant_count(), 1600, 60.0, "plants")
	check_near(field.get_plant_transform(field.get_plant_ids()[0]).origin.y, 3.0, 1e-3, "height")
	ground.free()


func test_a_disabled_field_grows() -> void:
	field.process_mode = Node.PROCESS_MODE_DISABLED
	root.add_child(field)
	await _grown()
	check_near(field.get_plant_count(), 1600, 60.0, "plants")


func test_levels_and_styles_change_while_paused() -> void:
	await start()
	paused = true
	field.levels = [PlantFieldLevel.of(5)]
	field.species[0].species.color_deviation = 0.5
	await frames(1)
	await until(
		func() -> bool: return not field.get_statistics()["is_rebuilding_meshes"],
		"its meshes are built"
	)
	check_equal(field.get_statistics()["drawn_by_level"].size(), 1, "levels")


func _grown() -> void:
	await frames(1)
	await until(func() -> bool: return not field.is_building(), "it is filled")
