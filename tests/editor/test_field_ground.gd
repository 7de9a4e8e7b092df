@tool
extends "brush_test.gd"
## A field whose ground changes in the editor. It rebuilds once after a change by the user, and on
## request.

const PLACE := &"position"


func test_plants_follow_a_collider_that_was_moved() -> void:
	var ground := await _ground_of_a_field()
	await _move_to(ground, Vector3(0, 1.0, 0))
	await _check_height(1.0, "after the step")
	await undo()
	await _check_height(0.0, "after undo")
	await redo()
	await _check_height(1.0, "after redo")


func test_plants_fall_to_the_ground_below_what_was_moved_away() -> void:
	await _ground_of_a_field()
	var far := _field().get_parent().get_node("Far") as Node3D
	await _move_to(far, Vector3(0, 1.0, 0))
	await _check_height(1.0, "on what came")
	await _move_to(far, Vector3(50, 1.0, 0))
	await _check_height(0.0, "on what is left")


func test_painted_plants_follow_ground_anywhere_below_them() -> void:
	await _ground_of_a_field()
	var field := _field()
	field.size = Vector2(0.2, 0.2)
	field.map = PlantMap.new()
	field.map.paint(Vector3(5, 0, 5), 2.0, field.species[0].get_layer_name(), 1.0)
	await _rested(field)
	var far := field.get_parent().get_node("Far") as Node3D
	await _move_to(far, Vector3(15, 1.0, 15))
	var is_up := func(id: int) -> bool:
		return absf(field.get_plant_transform(id).origin.y - 1.0) < 0.01
	var is_any_up := func() -> bool:
		return not field.is_building() and Array(field.get_plant_ids()).any(is_up)
	check(await until(is_any_up), "plants are on what came")


func test_plants_follow_a_shape_that_was_changed() -> void:
	var ground := await _ground_of_a_field()
	var shape := (ground.get_child(0) as CollisionShape3D).shape as BoxShape3D
	await _step(shape, &"size", Vector3(20, 3, 20))
	await _check_height(1.0, "of a higher box")


func test_a_drag_rebuilds_once_at_its_end() -> void:
	var ground := await _ground_of_a_field()
	var field := _field()
	var count := [0]
	var listener := func() -> void: count[0] += 1
	field.build_finished.connect(listener)
	Input.parse_input_event(_left(true))
	Input.flush_buffered_events()
	for i in 5:
		await _move_to(ground, Vector3(0, 0.1 * (i + 1), 0))
	await frames(30)
	check_equal(count[0], 0, "times it was filled while the button is down")
	Input.parse_input_event(_left(false))
	Input.flush_buffered_events()
	await _check_height(0.5, "after the drag")
	check_equal(count[0], 1, "times it was filled")
	field.build_finished.disconnect(listener)


func test_what_is_no_ground_of_it_changes_nothing() -> void:
	var ground := await _ground_of_a_field()
	var field := _field()
	var count := [0]
	var listener := func() -> void: count[0] += 1
	field.build_finished.connect(listener)
	var root := field.get_parent()
	field.bodies_group = &"pushers"
	await _rested(field)
	count[0] = 0
	await _move_to(root.get_node("Far") as Node3D, Vector3(60, 1, 0))
	await _move_to(root.get_node("Pusher") as Node3D, Vector3(0, 9, 0))
	await _step(root.get_node("Far"), &"visible", false)
	await frames(60)
	check_equal(count[0], 0, "times it was filled")
	check(not field.is_building(), "it rests")
	check(ground != null, "its ground exists")
	field.build_finished.disconnect(listener)


func test_the_button_rebuilds() -> void:
	var ground := await _ground_of_a_field()
	ground.position.y = 2.0  # As by a script, without a signal.
	await frames(30)
	await _check_height(0.0, "before")
	await _choose_only(_field())
	await click(_bar().get_node("%Fill") as Control)
	await _check_height(2.0, "after the button")


func _field() -> PlantField3D:
	return EditorInterface.get_edited_scene_root().get_child(0) as PlantField3D


# Its upper side is at 0.
func _ground_of_a_field() -> Node3D:
	var root := Node3D.new()
	root.name = "Hill"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(2, 4)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	_put(root, field)
	for body: Array in [["Ground", Vector3.ZERO], ["Far", Vector3(50, 0, 0)]]:
		_put_body(root, body[0], body[1], Vector3(20, 1, 20), Vector3(0, -0.5, 0))
	_put_body(root, "Pusher", Vector3(0.5, 5, 0.5), Vector3(0.1, 1, 0.1), Vector3.ZERO)
	root.get_node("Pusher").add_to_group(&"pushers", true)
	await _open("res://field_ground.tscn", root)
	await _check_height(0.0, "at first")
	await frames(5)
	return _field().get_parent().get_node("Ground") as Node3D


func _put_body(root: Node3D, name: String, at: Vector3, size: Vector3, middle: Vector3) -> void:
	var body := StaticBody3D.new()
	body.name = name
	body.position = at
	_put(root, body)
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = size
	shape.position = middle
	body.add_child(shape)
	shape.owner = root


func _move_to(node: Node3D, at: Vector3) -> void:
	await _step(node, PLACE, at)


# As by the editor's own tools.
func _step(object: Object, property: StringName, value: Variant) -> void:
	var undo_manager := EditorInterface.get_editor_undo_redo()
	undo_manager.create_action(
		"Change", UndoRedo.MERGE_DISABLE, EditorInterface.get_edited_scene_root()
	)
	undo_manager.add_do_property(object, property, value)
	undo_manager.add_undo_property(object, property, object.get(property))
	undo_manager.commit_action()
	await frames(3)


func _check_height(height: float, what: String) -> void:
	var field := _field()
	var is_there := func() -> bool:
		return (
			not field.is_building()
			and field.get_plant_count() > 0
			and absf(_height_of(field) - height) < 0.01
		)
	check(await until(is_there), "%s it is at %f" % [what, _height_of(field)])


func _height_of(field: PlantField3D) -> float:
	var ids := field.get_plant_ids()
	return NAN if ids.is_empty() else field.get_plant_transform(ids[0]).origin.y


func _left(pressed: bool) -> InputEventMouseButton:
	var event := InputEventMouseButton.new()
	event.button_index = MOUSE_BUTTON_LEFT
	event.pressed = pressed
	event.position = Vector2(3, 3)
	event.global_position = event.position
	return event
