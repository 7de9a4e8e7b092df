## The nodes of a field's skeletons: they are used again and again.
extends "res://tests/engine/field_harness.gd"


func test_a_camera_that_goes_to_and_fro_leaves_no_heap_of_skeletons() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	field = PlantField3D.from_species([GrassFunction.new()])
	field.size = Vector2(60, 6)
	field.density = 4.0
	field.skeleton_distance = 4.0
	field.max_skeletons = 30
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
