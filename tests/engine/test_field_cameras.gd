## Fields seen by several cameras, each in a viewport of its own.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(300, 20)
	field.density = 1.0
	for x: float in [-140.0, 140.0]:
		_add_camera(x)


func after_each() -> void:
	super()
	for viewport in root.get_children():
		if viewport is SubViewport:
			viewport.free()


func test_plants_near_every_camera_are_skeletons() -> void:
	field.skeleton_distance = 8.0
	field.max_skeletons = 64
	await start()
	await frames(60)
	var sides := [0, 0]
	for skeleton in field.get_skeletons():
		check(absf(skeleton.global_position.x) > 100.0, "%s is near one" % skeleton.global_position)
		sides[0 if skeleton.global_position.x < 0 else 1] += 1
	check(sides[0] > 10 and sides[1] > 10, "skeletons near each camera: %s" % [sides])


func test_plants_near_every_camera_are_stepped_in_full() -> void:
	field.far_distance = 20.0
	field.wind = PlantWind.new()
	await start()
	await step(40)
	# Over several steps: each stepped plant moves in every step.
	var ids := [_ids_near(-140.0), _ids_near(140.0), _ids_near(0.0)]
	var moves := [0, 0, 0]
	for i in 16:
		var before := []
		for place in 3:
			before.append(field.get_motion_state(ids[place]))
		await step(1)
		for place in 3:
			var now := field.get_motion_state(ids[place])
			moves[place] += 1 if now != before[place] else 0
	check(moves[0] >= 15 and moves[1] >= 15, "steps near the cameras of 16: %s" % [moves])
	check(moves[2] < 10, "steps far from both of 16: %s" % [moves])


func test_cameras_of_other_worlds_see_no_plants() -> void:
	var elsewhere := _add_camera(0.0)
	elsewhere.own_world_3d = true
	field.skeleton_distance = 8.0
	await start()
	await frames(60)
	for skeleton in field.get_skeletons():
		check(absf(skeleton.global_position.x) > 100.0, "%s is near one" % skeleton.global_position)
	check(field.get_skeletons().size() > 10, "skeletons near cameras of its own world")


func test_cameras_that_draw_none_of_its_layers_see_no_plants() -> void:
	var blind := _add_camera(0.0).get_camera_3d()
	blind.cull_mask = 1 << 19  # As the picking camera of a terrain.
	field.view_distance = 40.0
	await start()
	check(
		field.find_plants_in_sphere(Vector3(140, 0, 0), 3.0).size() > 5, "plants near another one"
	)
	check_equal(field.find_plants_in_sphere(Vector3.ZERO, 3.0).size(), 0, "plants near it")
	field.layers = blind.cull_mask
	for viewport: SubViewport in root.get_children().filter(_is_viewport):
		if viewport.get_camera_3d() != blind:
			viewport.get_camera_3d().cull_mask = 1
	var moved := func() -> bool:
		return (
			field.find_plants_in_sphere(Vector3.ZERO, 3.0).size() > 5
			and field.find_plants_in_sphere(Vector3(140, 0, 0), 3.0).is_empty()
		)
	await until(moved, "it is the only one for a field in its layer")


func test_plants_near_a_camera_above_the_field_are_stepped_fully() -> void:
	field.far_distance = 12.0
	field.wind = PlantWind.new()
	for viewport in root.get_children():
		if viewport is SubViewport:
			viewport.get_child(0).position.y = 3.5
	await start()
	await step(40)
	var ids := field.find_plants_in_sphere(Vector3(-140, 0, 0), 4.0)
	check(ids.size() > 20, "%d plants near it" % ids.size())
	var moves := PackedInt32Array()
	moves.resize(ids.size())
	for i in 16:
		var before := field.get_motion_state(ids)
		await step(1)
		var now := field.get_motion_state(ids)
		var floats := now.size() / ids.size()
		for plant in ids.size():
			var own := plant * floats
			moves[plant] += (
				1 if now.slice(own, own + floats) != before.slice(own, own + floats) else 0
			)
	var minimum := moves[0]
	for steps in moves:
		minimum = mini(minimum, steps)
	check(minimum >= 15, "a plant is stepped in %d of 16" % minimum)


func test_a_body_far_from_all_cameras_pushes_all_plants_in_its_way() -> void:
	field.wind = null
	field.bodies_group = &"walkers"
	for viewport in root.get_children():
		if viewport is SubViewport:
			viewport.get_child(0).position = Vector3(0, 1, 200)
	var walker := add_walker()
	walker.position = Vector3(-60, 0.8, 0)
	check(field.far_distance > 0.0, "far plants are stepped less often by default")
	await start()
	await step(20)
	var rest := all_tips()
	var moved := {}
	while walker.position.x < -37.0:
		walker.position.x += 6.0 * root.get_process_delta_time()
		await process_frame
		var now := all_tips()
		for plant in rest.size():
			if now[plant].distance_to(rest[plant]) > 0.02:
				moved[plant] = true
	var places := field.get_plant_transforms(field.get_plant_ids())
	var in_way := 0
	for plant in places.size():
		var at := places[plant].origin
		if at.x > -58 and at.x < -38 and absf(at.z) < 0.3:
			in_way += 1
			check(moved.has(plant), "the plant at %s is pushed" % at)
	check(in_way > 5, "%d plants in the way" % in_way)
	walker.free()


func _is_viewport(node: Node) -> bool:
	return node is SubViewport


func _ids_near(x: float) -> PackedInt64Array:
	return field.find_plants_in_sphere(Vector3(x, 0, 0), 3.0)


func _add_camera(x: float) -> SubViewport:
	var viewport := SubViewport.new()
	var camera := Camera3D.new()
	camera.position = Vector3(x, 1, 0)
	viewport.add_child(camera)
	root.add_child(viewport)
	camera.make_current()
	return viewport
