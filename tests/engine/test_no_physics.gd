## Fields on colliders without physics, by the suite's project settings.
extends "res://tests/engine/field_harness.gd"


func test_a_field_on_colliders_fails_with_one_error_and_plants_nothing() -> void:
	field = PlantField3D.from_species([GrassFunction.new()])
	field.density = 4.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	root.add_child(field)
	await frames(1)
	await until(func() -> bool: return not field.is_building(), "it does not go on for ever")
	check_equal(field.get_plant_count(), 0, "plants")
	check_error("needs 3D physics, which is disabled")
	field.ground_mode = PlantField3D.GROUND_NONE
	await filled(field)
	check(field.get_plant_count() > 0, "plants on flat ground")


func test_shapes_push_plants_where_there_is_no_physics() -> void:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.bodies_group = &"walkers"
	root.add_child(plant)
	var walker := add_walker()
	walker.position = Vector3(-0.2, plant.get_plant_height(), 0)
	await frames(30)
	check(plant.get_deflection() > 0.1, "pushed by %f rad" % plant.get_deflection())
	walker.free()
	plant.free()
