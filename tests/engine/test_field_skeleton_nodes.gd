## The nodes of a field's skeletons are reused.
extends "res://tests/engine/field_harness.gd"

const MAX_WAIT_MSEC := 5000  # For a tile. Frames of a headless engine are too short to count.


func test_a_camera_that_goes_to_and_fro_leaves_no_heap_of_skeletons() -> void:
	var camera := _watch(GrassFunction.new(), Vector2(60, 6), 30)
	await start()
	var counts: Array[int] = []
	for round in 8:
		camera.position = Vector3(-20 if round % 2 == 0 else 20, 1, 0)
		await frames(30)
		check_equal(field.get_skeletons().size(), 30, "skeletons")
		counts.append(field.get_node("FieldSkeletons").get_child_count())
	check_equal(counts[7], counts[1], "nodes, after %s" % [counts])
	check(counts[7] <= 60, "%d nodes" % counts[7])
	camera.position.y = 100.0
	await frames(30)
	for node: Node3D in field.get_node("FieldSkeletons").get_children():
		check(not node.visible, "%s is seen, and the camera is far away" % node.name)
	camera.free()


func test_what_was_hung_on_a_plant_goes_with_its_skeleton_to_no_other_plant() -> void:
	var camera := _watch(GrassFunction.new(), Vector2(60, 6), 10)
	camera.position = Vector3(-20, 1, 0)
	await start()
	await frames(30)
	var lanterns: Array[Node3D] = []
	for skeleton in field.get_skeletons():
		lanterns.append(Node3D.new())
		skeleton.add_child(lanterns[-1])
	check_equal(lanterns.size(), 10, "lanterns")
	camera.position.x = 20.0
	await frames(30)
	for skeleton in field.get_skeletons():
		check_equal(skeleton.get_child_count(), 0, "what hangs on %s" % skeleton.name)
	for lantern in lanterns:
		check(not is_instance_valid(lantern), "a lantern is gone with its skeleton")
	camera.free()


func test_mown_plants_have_no_skeleton() -> void:
	var camera := _watch(GrassFunction.new(), Vector2(6, 6), 10)
	await start()
	await frames(30)
	check_equal(field.get_skeletons().size(), 10, "skeletons of whole plants")
	check(field.set_height_in_sphere(Vector3.ZERO, 20.0, 0.05) > 100, "all are mown")
	await frames(30)
	check_equal(field.get_skeletons().size(), 0, "skeletons of mown plants")
	camera.free()


func test_parts_of_a_turned_plant_swing_as_those_of_another() -> void:
	var species: PlantFunction = (
		load("res://addons/undergrowth/species/garden_tulip.tres").duplicate()
	)
	species.frequency_deviation = 0.0
	var camera := _watch(species, Vector2(4, 4), 2)
	field.density = 0.0
	field.species[0].variants = 1
	await start()
	var turn := Basis(Vector3.UP, 0.5 * PI)
	var places: Array[Transform3D] = [
		Transform3D(Basis(), Vector3(-1, 0, 0)), Transform3D(turn, Vector3(1, 0, 0))
	]
	var ids := field.add_plants(places, species)
	await frames(20)
	var push := Vector3(0.05, 0, 0)
	field.apply_impulse_in_sphere(places[0].origin, 0.1, push)
	field.apply_impulse_in_sphere(places[1].origin, 0.1, turn * push)
	await frames(8)
	var one := field.get_skeleton(ids[0])
	var other := field.get_skeleton(ids[1])
	check(one.get_bone_count() > 3, "%d bones" % one.get_bone_count())
	var bend := 0.0
	for bone: int in one.get_bone_count():
		var turned := one.get_bone_pose_rotation(bone)
		bend = maxf(bend, turned.angle_to(Quaternion.IDENTITY))
		var away := turned.angle_to(other.get_bone_pose_rotation(bone))
		check_near(away, 0.0, 2e-3, "turn of bone %d" % bone)
	check(bend > 0.02, "largest turn of a bone: %f rad" % bend)
	camera.free()


func test_a_bent_plant_that_is_a_skeleton_has_room_for_its_tip_where_it_is_culled() -> void:
	var species := GrassFunction.new()
	species.law = PlantFunction.LAW_SPRING
	species.lean = deg_to_rad(75.0)
	var camera := _watch(species, Vector2(6, 6), 10)
	await start()
	await frames(30)
	check_equal(field.get_skeletons().size(), 10, "skeletons")
	for skeleton in field.get_skeletons():
		var drawn := skeleton.get_child(0, true) as MeshInstance3D
		var tip := field.get_tip_position(field.get_skeleton_plant(skeleton))
		var own := skeleton.global_transform.affine_inverse() * field.to_global(tip)
		var room := drawn.custom_aabb if drawn.custom_aabb.has_volume() else drawn.get_aabb()
		check(room.grow(1e-3).has_point(own), "%s is in %s" % [own, room])
	camera.free()


func test_skeletons_belong_to_plants_when_a_stroke_meets_a_tile_that_arrives() -> void:
	var camera := _watch(GrassFunction.new(), Vector2(200, 40), 20)
	for i in 11:
		field.species.append(PlantFieldSpecies.of(GrassFunction.new()))
	field.map = PlantMap.new()
	field.map.fill_polygon(field.get_outline_points(), "Grass")
	field.tile_size = 32.0
	field.view_distance = 8.0
	field.build_budget_msec = 0.1
	await start()
	var arrived := 0
	for x: float in [64.0, -64.0, 32.0, -32.0]:
		camera.position = Vector3(x, 1, 0)
		var deadline := Time.get_ticks_msec() + MAX_WAIT_MSEC
		while Time.get_ticks_msec() < deadline:
			await process_frame
			if field.get_skeletons().size() > 0:
				arrived += 1
				field.map.erase(Vector3(x, 0, 0), 0.5, "Grass")
				for frame in 4:
					await process_frame
					for skeleton in field.get_skeletons():
						check(field.get_skeleton_plant(skeleton) >= 0, "a plant of %s" % skeleton)
				break
	check(arrived > 0, "%d tiles arrive" % arrived)
	camera.free()


## Returns a field of one species and a camera at its middle. Plants near the camera become
## skeletons.
func _watch(species: PlantFunction, size: Vector2, maximum: int) -> Camera3D:
	field = PlantField3D.from_species([species])
	field.size = size
	field.density = 4.0
	field.skeleton_distance = 4.0
	field.max_skeletons = maximum
	var camera := Camera3D.new()
	root.add_child(camera)
	return camera
