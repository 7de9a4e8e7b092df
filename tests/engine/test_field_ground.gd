## Plants of fields on meshes, colliders and slopes.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = _make_field()


func test_the_ground_follows_a_mesh() -> void:
	var hill := MeshInstance3D.new()
	var plane := PlaneMesh.new()
	plane.size = Vector2(10, 10)
	hill.mesh = plane
	hill.rotation.z = 0.3
	hill.position.y = 2.0
	hill.name = "Hill"
	root.add_child(hill)
	root.add_child(field)
	field.ground_mode = PlantField3D.GROUND_MESH
	field.ground_mesh = NodePath("../Hill")
	await filled(field)
	check_near(field.get_plant_count(), 5 * 10 * 10 * cos(0.3), 40.0)
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id).origin
		check_near(place.y, 2.0 + place.x * tan(0.3), 1e-3, "height at %s" % place)
	field.slope_limits = Vector2(0, deg_to_rad(10))
	await filled(field)
	check_equal(field.get_plant_count(), 0, "plants on too steep a slope")
	hill.free()


func test_plants_lean_with_the_ground() -> void:
	var hill := MeshInstance3D.new()
	hill.mesh = PlaneMesh.new()
	(hill.mesh as PlaneMesh).size = Vector2(10, 10)
	hill.rotation.z = 0.4
	hill.name = "Hill"
	root.add_child(hill)
	field.ground_mesh = NodePath("../Hill")
	field.ground_mode = PlantField3D.GROUND_MESH
	field.simulation_enabled = false
	for entry in field.species:
		entry.species.law = PlantFunction.LAW_SPRING
		entry.species.lean = 0.0
	await _fill()
	check_near(_field_axis(_fifth()), Vector3.UP, 1e-3, "a plant without alignment")
	field.slope_alignment = 1.0
	await filled(field)
	for id in field.get_plant_ids():
		check_near(_field_axis(id), hill.basis.y, 2e-3, "axis of plant %d" % id)
	field.slope_alignment = 0.5
	await filled(field)
	check_near(
		_field_axis(_fifth()), Vector3.UP.rotated(Vector3.BACK, 0.2), 5e-3, "half an alignment"
	)
	hill.free()


func test_plants_of_an_uneven_field_lean_with_colliders() -> void:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(30, 2, 30)
	body.add_child(shape)
	body.rotation.z = 0.4
	root.add_child(body)
	await physics_frames(2)
	field.scale = Vector3(1, 2, 1)
	field.simulation_enabled = false
	for entry in field.species:
		entry.species.law = PlantFunction.LAW_SPRING
		entry.species.lean = 0.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.slope_alignment = 1.0
	await _fill()
	# In the field's axes the same slope is half as steep.
	var normal := Vector3(-sin(0.4), 2.0 * cos(0.4), 0).normalized()
	check_near(_field_axis(_fifth()), normal, 5e-3, "axis")
	body.free()


func test_added_plants_keep_their_turn_and_their_tilt() -> void:
	field.density = 0.0
	field.simulation_enabled = false
	root.add_child(field)
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean = 0.0
	var tilt := Basis(Vector3(1, 0, 2).normalized(), 0.6)
	var place := Transform3D(tilt * Basis(Vector3.UP, 1.3), Vector3(1, 2, 3))
	var id := field.add_plants([place], function)[0]
	await frames(2)
	check_near(_field_axis(id), tilt.y, 1e-3, "axis")
	check_near(field.get_plant_transform(id).basis.z, Basis(Vector3.UP, 1.3).z, 1e-3, "front")


func test_ground_is_what_rays_hit() -> void:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	var box := BoxShape3D.new()
	box.size = Vector3(8, 2, 8)
	shape.shape = box
	body.add_child(shape)
	body.position.y = 0.5
	root.add_child(body)
	await physics_frames(2)
	root.add_child(field)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	await filled(field)
	check_near(field.get_plant_count(), 5 * 8 * 8, 30.0)
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		check_near(transform.origin.y, 1.5, 1e-3, "height")
	field.height_limits = Vector2(2, 5)
	await filled(field)
	check_equal(field.get_plant_count(), 0, "plants below the limit")
	body.free()


func test_on_colliders_heights_are_interpolated_on_a_grid() -> void:
	var hill := StaticBody3D.new()
	var ball := SphereShape3D.new()
	ball.radius = 30.0
	add_shape(hill, ball)
	root.add_child(hill)
	await physics_frames(2)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.ground_sample_spacing = 1.0
	await _fill()
	var coarse := _max_above_ball(ball.radius)
	check(coarse > 0.003 and coarse < 0.01, "plants are off by at most %f m" % coarse)
	field.ground_sample_spacing = 0.0
	await filled(field)
	var exact := _max_above_ball(ball.radius)
	check(exact < 0.001, "plants with a ray each are off by at most %f m" % exact)
	hill.free()


func test_nothing_grows_on_bodies_that_push_plants() -> void:
	var ground := _add_ground(Vector3(8, 2, 8))
	var walker := add_walker()
	walker.position = Vector3(1, 2.5, 1)
	await physics_frames(2)
	field.bodies_group = &"walkers"
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.density = 60.0
	await _fill()
	check(field.get_plant_count() > 3000, "%d plants exist" % field.get_plant_count())
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		var height := transform.origin.y
		check(absf(height - 1.5) < 1e-3, "a plant stands on the ground, not at %f" % height)
	walker.free()
	ground.free()


func test_with_the_lowest_ground_plants_grow_below_roofs() -> void:
	var ground := add_plate(100.0, 0.5)
	var roof := add_plate(4.0, 5.0)
	var upper_roof := add_plate(2.0, 8.0)
	await physics_frames(2)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.density = 20.0
	await _fill()
	check_equal(_heights(), [0.5, 5.0, 8.0], "on the roofs")
	field.ground_choice = PlantField3D.GROUND_LOWEST
	await filled(field)
	check_equal(_heights(), [0.5], "below them")
	ground.position.y = -300.5
	await physics_frames(2)
	field.rebuild()
	await filled(field)
	check_equal(_heights(), [-300.0], "far below them")
	ground.free()
	await physics_frames(2)
	field.rebuild()
	await filled(field)
	check_equal(_heights(), [5.0], "there is nothing but roofs")
	roof.free()
	upper_roof.free()
	field.set("ground_choice", 2)
	check_error("ground_choice is GROUND_HIGHEST or GROUND_LOWEST")
	check_equal(field.ground_choice, PlantField3D.GROUND_LOWEST, "it stays")


func test_of_a_mesh_with_a_roof_the_lowest_ground_may_be_chosen() -> void:
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	for height: float in [1.0, 4.0]:
		for corner: Vector2 in [Vector2(-20, -20), Vector2(20, -20), Vector2(0, 30)]:
			surface.add_vertex(Vector3(corner.x, height, corner.y))
	var house := MeshInstance3D.new()
	house.name = "House"
	house.mesh = surface.commit()
	root.add_child(house)
	field.ground_mode = PlantField3D.GROUND_MESH
	field.ground_mesh = ^"../House"
	await _fill()
	check_equal(_heights(), [4.0], "on it")
	field.ground_choice = PlantField3D.GROUND_LOWEST
	await filled(field)
	check_equal(_heights(), [1.0], "below it")
	house.free()


func test_a_field_without_ground_reports_what_to_check() -> void:
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	await _fill()
	check_equal(field.get_plant_count(), 0, "plants without a ground")
	check_error("Check that ground_collision_mask has a layer of the ground")
	field.rebuild()
	await filled(field)
	check_error_count("ground_collision_mask", 0)
	var ground := _add_ground(Vector3(8, 2, 8))
	await physics_frames(2)
	field.rebuild()
	await filled(field)
	check(field.get_plant_count() > 200, "plants exist once the ground is there")
	field.ground_collision_mask = 2
	await filled(field)
	check_error("ground_collision_mask")
	ground.free()


## Returns the maximum distance (m) of plants from a ball around the origin.
func _max_above_ball(radius: float) -> float:
	var maximum := 0.0
	for id in field.get_plant_ids():
		maximum = maxf(maximum, absf(field.get_plant_transform(id).origin.length() - radius))
	return maximum


func _add_ground(size: Vector3) -> StaticBody3D:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	var box := BoxShape3D.new()
	box.size = size
	shape.shape = box
	body.add_child(shape)
	body.position.y = 0.5
	root.add_child(body)
	return body


func _fill() -> void:
	root.add_child(field)
	await filled(field)


func _make_field() -> PlantField3D:
	var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	field.density = 5.0
	return field


## Returns the direction from a plant's root to its tip.
func _field_axis(id: int) -> Vector3:
	return relative_tip(id).normalized()


## Returns the id of one of the plants.
func _fifth() -> int:
	return field.get_plant_ids()[5]


## Returns the heights of all roots, rounded to a millimetre, ascending.
func _heights() -> Array[float]:
	var found: Array[float] = []
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		var height := snappedf(transform.origin.y, 0.001)
		if height not in found:
			found.append(height)
	found.sort()
	return found
