## Rotated, scaled and moved fields: queries in world axes, and drawing.
extends "res://tests/engine/field_harness.gd"

const TURNED := Vector3(0.3, 1.1, 0.2)

var _stage: SubViewport


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 4.0
	field.simulation_enabled = false


func after_each() -> void:
	super()
	if is_instance_valid(_stage):
		_stage.free()


func test_a_world_box_contains_the_plants_in_it() -> void:
	_place_askew()
	await start()
	var box := AABB(Vector3(27, 0, -22), Vector3(6, 20, 7))
	var expected := PackedInt64Array()
	for id in sorted_ids():
		if box.has_point(field.to_global(field.get_plant_transform(id).origin)):
			expected.append(id)
	var found := field.find_plants_in_box(box)
	found.sort()
	check(found.size() > 5 and found.size() < field.get_plant_count(), "%d found" % found.size())
	check_equal(found, expected, "plants in the box")


func test_a_world_sphere_contains_the_plants_in_it() -> void:
	_place_askew()
	await start()
	var center := Vector3(30, 5, -20)
	var expected := PackedInt64Array()
	for id in sorted_ids():
		if center.distance_to(field.to_global(field.get_plant_transform(id).origin)) <= 5.0:
			expected.append(id)
	var found := field.find_plants_in_sphere(center, 5.0)
	found.sort()
	check(found.size() > 20 and found.size() < field.get_plant_count(), "%d found" % found.size())
	check_equal(found, expected, "plants in the sphere")
	check_equal(field.remove_in_sphere(center, 5.0), found.size(), "mown")
	check_equal(field.apply_impulse_in_sphere(center, 5.0, Vector3.ONE), 0, "hit then")


func test_a_sphere_of_the_world_is_one_in_an_unevenly_scaled_field() -> void:
	field.rotation = TURNED
	field.scale = Vector3(1.8, 1.0, 0.6)
	await start()
	var center := field.to_global(Vector3(1.0, 0.0, -2.0))
	var expected := PackedInt64Array()
	for id in sorted_ids():
		if center.distance_to(field.to_global(field.get_plant_transform(id).origin)) <= 5.0:
			expected.append(id)
	var found := field.find_plants_in_sphere(center, 5.0)
	found.sort()
	check(found.size() > 20 and found.size() < field.get_plant_count(), "%d found" % found.size())
	check_equal(found, expected, "plants in the sphere")


func test_an_impulse_bends_plants_along_it_in_a_turned_field() -> void:
	field.density = 0.0
	field.simulation_enabled = true
	field.transform = Transform3D(Basis(Vector3.UP, 1.9).scaled(Vector3.ONE * 2), Vector3(9, 0, 4))
	root.add_child(field)
	var tulip := TulipFunction.new()
	tulip.law = PlantFunction.LAW_SPRING
	tulip.lean = 0.0
	var id := field.add_plants([Transform3D.IDENTITY], tulip)[0]
	await frames(3)
	var before := field.to_global(field.get_tip_position(id))
	field.apply_impulse_in_sphere(field.position, 1.0, Vector3(tulip.mass * 3.0, 0, 0))
	await frames(10)
	var way := field.to_global(field.get_tip_position(id)) - before
	check(way.x > 0.02, "the tip goes to +x: %s" % way)
	check_near(way.z, 0.0, 0.1 * way.x, "z")


func test_a_blast_bends_plants_away_from_it_in_a_turned_field() -> void:
	field.density = 0.0
	field.simulation_enabled = true
	field.transform = Transform3D(Basis(Vector3.UP, 1.9).scaled(Vector3.ONE * 2), Vector3(9, 0, 4))
	root.add_child(field)
	var tulip := TulipFunction.new()
	tulip.law = PlantFunction.LAW_SPRING
	tulip.lean = 0.0
	var id := field.add_plants([Transform3D.IDENTITY], tulip)[0]
	await frames(3)
	var before := field.to_global(field.get_tip_position(id))
	check_equal(field.apply_blast(field.position + Vector3.LEFT, 2.0, tulip.mass * 6.0), 1, "hit")
	await frames(10)
	var way := field.to_global(field.get_tip_position(id)) - before
	check(way.x > 0.02, "the tip goes to +x: %s" % way)
	check_near(way.z, 0.0, 0.1 * way.x, "z")


func test_a_field_that_moves_takes_its_plants_and_their_motion_along() -> void:
	field.wind = PlantWind.new()
	field.simulation_enabled = true
	await start()
	await step(30)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.get_plant_ids()
	var tips := field.get_tip_positions(ids)
	_place_askew()
	await frames(12)
	check(not field.is_building(), "nothing is rebuilt")
	check_equal(field.get_plant_ids(), ids, "plants")
	check_equal(field.get_tip_positions(ids), tips, "tips in the field's axes")


func test_fields_of_any_scale_draw_all_their_plants() -> void:
	_make_stage()
	field.free()
	for scale: float in [1.0, 5.0, 0.2]:
		for ratio: float in [0.0, 0.2]:
			field = PlantField3D.from_species([GrassFunction.new()])
			field.simulation_enabled = false
			field.size = Vector2(24, 24) / scale
			field.density = 2.0 * scale * scale
			field.fade_ratio = ratio
			field.tile_size = maxf(8.0 / scale, 1.0)
			field.scale = Vector3.ONE * scale
			_stage.add_child(field)
			await filled(field)
			await frames(3)
			# The ranges of all levels include every plant.
			var drawn := await _primitives()
			field.levels = [PlantFieldLevel.of(2)]
			await rested()
			await frames(3)
			var coarse := await _primitives()
			var fewest := _primitives_of(2) * field.get_plant_count()
			check_equal(coarse, fewest, "primitives of all plants at scale %f" % scale)
			check(drawn >= coarse, "%d primitives of levels, scale %f" % [drawn, scale])
			field.visibility_range_end = 15.0
			await frames(12)
			await rested()
			var within := _count_within(15.0)
			var seen := await _primitives()
			check(
				seen >= within * _primitives_of(2),
				"%d primitives for %d plants in range, scale %f" % [seen, within, scale]
			)
			check(seen > 0 and seen < fewest, "some are too far: %d of %d" % [seen, fewest])
			var reported: int = field.get_statistics()["drawn_by_level"][0]
			check_equal(seen, reported * _primitives_of(2), "the statistics, scale %f" % scale)
			field.free()


func test_a_built_field_that_is_scaled_draws_all_within_its_range() -> void:
	_make_stage()
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(24, 24)
	field.density = 2.0
	field.tile_size = 8.0
	field.levels = [PlantFieldLevel.of(2)]
	_stage.add_child(field)
	await filled(field)
	field.visibility_range_end = 15.0
	await frames(12)  # The field polls the engine's own properties at intervals.
	await rested()
	field.scale = Vector3.ONE * 5.0
	# At a corner of tiles, so that all middles are farther than their previous range.
	_stage.get_camera_3d().look_at_from_position(Vector3(2, 3, 2), Vector3.ZERO)
	await frames(2)
	var within := _count_within(15.0)
	check(within > 20, "%d plants in range" % within)
	var seen := await _primitives()
	check(seen >= within * _primitives_of(2), "%d primitives for %d plants" % [seen, within])


func test_no_part_of_a_deviating_plant_is_culled() -> void:
	_make_stage()
	var function := CurvePlantFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean = 0.0
	function.shape_deviation = 1.0
	function.radius = 0.6
	function.height_min = 0.1
	function.height_max = 0.1
	field.density = 0.0
	field.levels = [PlantFieldLevel.of(12)]
	_stage.add_child(field)
	var id := field.add_plants([Transform3D.IDENTITY], function)[0]
	var height := field.get_plant_height(id)
	var mesh := function.generate_mesh(height, 12, field.get_plant_seed(id))
	var farthest := Vector3.ZERO
	for vertex: Vector3 in mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]:
		farthest = vertex if vertex.length() > farthest.length() else farthest
	# Rotated so that it leaves a box through a side and not a corner.
	field.remove_plant(id)
	var turn := Basis(Vector3.UP, atan2(farthest.z, farthest.x))
	id = field.add_plants([Transform3D(turn, Vector3.ZERO)], function)[0]
	check_near(field.get_plant_height(id), height, 1e-6, "height of the same plant again")
	await frames(4)
	var at := turn * farthest
	check_near(at.z, 0.0, 1e-3, "z of its widest place")
	var camera := _stage.get_camera_3d()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 0.02
	camera.near = 0.05
	camera.far = 10.0
	var aside := at.cross(Vector3.UP).normalized()
	camera.look_at_from_position(at * 1.008 + 3.0 * aside, at * 1.008)
	check(await _primitives() > 0, "it is drawn where only its widest part is seen")


func _place_askew() -> void:
	field.transform = Transform3D(
		Basis.from_euler(TURNED).scaled(Vector3.ONE * 1.5), Vector3(30, 5, -20)
	)


func _count_within(distance: float) -> int:
	var camera_position := _stage.get_camera_3d().global_position
	var count := 0
	for transform in field.get_plant_transforms(field.get_plant_ids()):
		count += (
			1 if field.to_global(transform.origin).distance_to(camera_position) < distance else 0
		)
	return count


func _primitives_of(segments: int) -> int:
	var arrays := GrassFunction.new().generate_mesh(1.0, segments, 1).surface_get_arrays(0)
	return floori((arrays[Mesh.ARRAY_INDEX] as PackedInt32Array).size() / 3.0)


func _primitives() -> int:
	await frames(2)
	await RenderingServer.frame_post_draw
	return RenderingServer.viewport_get_render_info(
		_stage.get_viewport_rid(),
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME
	)


func _make_stage() -> void:
	field.species = []
	_stage = SubViewport.new()
	_stage.size = Vector2i(64, 64)
	_stage.own_world_3d = true
	_stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_stage)
	var camera := Camera3D.new()
	_stage.add_child(camera)
	camera.look_at_from_position(Vector3(0, 3, 16), Vector3.ZERO)
	camera.fov = 120
