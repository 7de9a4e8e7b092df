@tool
extends "viewport_test.gd"
## The buttons of a climber's inspector, and its path drawn in the 3D view.

const CLIMBER_FILE := "res://viewport_climber.tscn"


func test_a_drag_over_the_wall_draws_a_path() -> void:
	var climber := await _open_climber()
	await click(_button("DrawPath"))
	var version := _history().get_version()
	await drag(_view(), _place_of(climber, Vector3.ZERO), _place_of(climber, Vector3(0.9, 0.5, 0)))
	check_equal(_history().get_version(), version + 1, "one step")
	check(climber.path.size() >= 2, "%d points" % climber.path.size())
	for point in climber.path:
		check(absf(point.z) < 0.01, "a point is on the wall: %s" % point)
	check(not _button("DrawPath").button_pressed, "the tool ends")
	await _grown(climber)
	check(climber.get_reach().end.x > 0.8, "it grows along the path")
	await take_picture("climber")
	await undo()
	check(climber.path.is_empty(), "undo takes it away")
	await redo()
	check(climber.path.size() >= 2, "redo")
	await click(_button("ClearPath"))
	check(climber.path.is_empty(), "it is cleared")
	await undo()
	check(climber.path.size() >= 2, "undo of that")
	check(_selected() == climber, "it stays selected")


func test_clicks_and_enter_draw_a_path_and_escape_discards_it() -> void:
	var climber := await _open_climber()
	await click(_button("DrawPath"))
	for place: Vector3 in [Vector3(-0.6, 0, 0), Vector3(0.2, 0.4, 0), Vector3(0.8, 0.3, 0)]:
		await click(_view(), _place_of(climber, place))
	check(climber.path.is_empty(), "nothing before Enter")
	await press_key(_view(), KEY_ENTER)
	check_equal(climber.path.size(), 3, "points")
	await click(_button("DrawPath"))
	await click(_view(), _place_of(climber, Vector3(-0.6, 0, 0)))
	await press_key(_view(), KEY_ESCAPE)
	check_equal(climber.path.size(), 3, "points after Escape")
	check(not _button("DrawPath").button_pressed, "Escape ends the tool")


func test_another_changes_the_seed_in_one_step() -> void:
	var climber := await _open_climber()
	await _grown(climber)
	var first := climber.get_leaf_transform(10)
	await click(_button("Another"))
	await _grown(climber)
	check(climber.get_leaf_transform(10) != first, "another plant grows")
	await undo()
	await _grown(climber)
	check_equal(climber.get_leaf_transform(10), first, "leaf after undo")


func test_it_grows_again_where_it_is_moved() -> void:
	var climber := await _open_climber()
	await _grown(climber)
	climber.position.x += 0.5
	await _grown(climber)
	var low := 1e9
	for i in climber.get_leaf_count():
		low = minf(low, climber.get_leaf_transform(i).origin.distance_to(climber.global_position))
	check(low < 0.2, "a leaf is %.2f m from the root" % low)
	var wall := climber.get_parent_node_3d()
	var first := wall.to_local(climber.get_leaf_transform(10).origin)
	wall.position.x += 0.5
	await frames(4)
	check(not climber.is_growing(), "it does not grow when the wall is moved")
	var now := wall.to_local(climber.get_leaf_transform(10).origin)
	check(now.distance_to(first) < 1e-3, "it follows the wall")


func test_grow_follows_a_changed_wall() -> void:
	var climber := await _open_climber()
	await _grown(climber)
	var wall := climber.get_parent() as MeshInstance3D
	(wall.mesh as BoxMesh).size.z = 0.6
	await click(_button("Grow"))
	await _grown(climber)
	for i in climber.get_leaf_count():
		check(climber.get_leaf_transform(i).origin.z > 0.2, "leaf %d is outside of the wall" % i)


func _open_climber() -> PlantClimber3D:
	var root := Node3D.new()
	root.name = "Yard"
	var wall := MeshInstance3D.new()
	wall.name = "Wall"
	wall.mesh = BoxMesh.new()
	(wall.mesh as BoxMesh).size = Vector3(4, 2, 0.3)
	_put(root, wall)
	var climber := PlantClimber3D.new()
	climber.name = "Ivy"
	climber.position = Vector3(0, 0, 0.15)
	climber.length = 1.2
	wall.add_child(climber)
	climber.owner = root
	var opened := (await _open(CLIMBER_FILE, root)).get_child(0) as PlantClimber3D
	await open_inspector()
	await _choose_only(opened)
	EditorInterface.edit_node(opened)
	await frames(5)
	return opened


func _button(id: String) -> Button:
	return find_by_script(CLIMBER_BAR_SCRIPT).get_node(id) as Button


func _grown(climber: PlantClimber3D) -> void:
	await frames(3)
	check(await until(func() -> bool: return not climber.is_growing()), "it has grown")


func _selected() -> Node:
	return EditorInterface.get_selection().get_selected_nodes()[0]
