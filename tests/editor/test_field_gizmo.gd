@tool
extends "viewport_test.gd"
## Fields in the editor's viewport: their border, and the handles for their size.

const BAR_SCRIPT := "res://addons/undergrowth/editor/brush/brush_bar.gd"
## Of the transform gizmo of the first 3D view.
const TRANSFORM_LAYER := 1 << 27
const GIZMO_SCRIPT := "res://addons/undergrowth/editor/gizmo/field_gizmos.gd"


func test_click_into_its_area_selects_a_field() -> void:
	var field := await _open_field()
	for place: Vector3 in [Vector3(1, 0, 1.5), Vector3(0.4, 0, 0.6)]:
		await _click_at(field, place)
		check_equal(_selected(), PackedStringArray(["Field"]), "selection at %s" % place)
	await _click_at(field, Vector3(1.5, 0, 0))
	check_equal(_selected(), PackedStringArray(), "selection beside it")


func test_border_follows_the_size() -> void:
	var field := await _open_field()
	field.size = Vector2(4, 4)
	await frames(3)
	await _click_at(field, Vector3(1.5, 0, 0.2))
	check_equal(_selected(), PackedStringArray(["Field"]), "selection where it has grown to")


func test_a_side_is_dragged_in_one_step() -> void:
	var field := await _open_field()
	field.position = Vector3(0.5, 0, 0)
	await _choose_only(field)
	var version := _history().get_version()
	var from := _place_of(field, Vector3(1, 0, 0))
	await drag(_view(), from, _place_of(field, Vector3(2, 0, 0)))
	check(absf(field.size.x - 3.0) < 0.1, "size: %s" % field.size)
	check_equal(field.size.y, 4.0, "size along the other axis")
	var across := field.to_global(Vector3(-field.size.x * 0.5, 0, 0))
	check(absf(across.x + 0.5) < 0.02, "the side across stays: %s" % across)
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(_history().get_current_action_name(), tr("Change Field Size"), "its name")
	await undo()
	check_equal(field.size, Vector2(2, 4), "size after undo")
	check_equal(field.position, Vector3(0.5, 0, 0), "place after undo")
	await redo()
	check(field.size.x > 2.5 and field.position.x > 0.75, "size after redo: %s" % field.size)


func test_the_nearest_side_is_dragged_in_a_field_that_is_turned_and_scaled() -> void:
	var field := await _open_field()
	field.rotation.y = 0.5
	field.scale = Vector3.ONE * 0.5
	await _choose_only(field)
	var before := field.to_global(Vector3(0, 0, -2))
	await drag(_view(), _place_of(field, Vector3(0, 0, 2)), _place_of(field, Vector3(0, 0, 3)))
	check(absf(field.size.y - 5.0) < 0.15, "size: %s" % field.size)
	check_equal(field.size.x, 2.0, "size along the other axis")
	var after := field.to_global(Vector3(0, 0, -field.size.y * 0.5))
	check(after.distance_to(before) < 0.02, "the side across stays: %s, %s" % [before, after])


func test_an_outline_is_the_border() -> void:
	var field := await _open_field()
	var curve := Curve3D.new()
	for corner: Vector3 in [Vector3(-1, 0, -2), Vector3(1, 0, 2), Vector3(-1, 0, 2)]:
		curve.add_point(corner)
	var path := Path3D.new()
	path.curve = curve
	_put(EditorInterface.get_edited_scene_root(), path)
	field.outline = field.get_path_to(path)
	await frames(3)
	await _click_at(field, Vector3(0.6, 0, -0.6))
	check_equal(_selected(), PackedStringArray(), "selection beside the triangle")
	await _click_at(field, Vector3(-0.6, 0, 1))
	check_equal(_selected(), PackedStringArray(["Field"]), "selection in the triangle")
	var from := _place_of(field, Vector3(1, 0, 0))
	await drag(_view(), from, from + Vector2(60, 0))
	check_equal(field.size, Vector2(2, 4), "it has no handles")


func test_a_bed_is_as_wide_as_its_border() -> void:
	var field := await _open_field()
	var path := Path3D.new()
	path.curve = Curve3D.new()
	path.curve.add_point(Vector3(-1, 0, 0.5))
	path.curve.add_point(Vector3(1, 0, 0.5))
	_put(EditorInterface.get_edited_scene_root(), path)
	field.outline = field.get_path_to(path)
	field.outline_width = 0.4
	await frames(3)
	await _click_at(field, Vector3(0.5, 0, 1.4))
	check_equal(_selected(), PackedStringArray(), "selection beside the bed")
	await _click_at(field, Vector3(0.5, 0, 0.6))
	check_equal(_selected(), PackedStringArray(["Field"]), "selection in the bed")
	field.outline_width = 2.4
	await frames(3)
	await _click_at(field, Vector3(0.5, 0, 1.4))
	check_equal(_selected(), PackedStringArray(["Field"]), "selection in a wider one")


func test_f_frames_a_field() -> void:
	var field := await _open_field()
	field.position = Vector3(30, 0, 0)
	await _choose_only(field)
	await click(_view(), Vector2(20, 20), MOUSE_BUTTON_MIDDLE)
	await press_key(_view(), KEY_F)
	var middle := _view().size * 0.5
	var framed := func() -> bool:
		return _place_of(field, Vector3.ZERO).distance_to(middle) < _view().size.y * 0.25
	check(await until(framed), "it is in the middle: %s" % _place_of(field, Vector3.ZERO))
	field.position = Vector3.ZERO
	await press_key(_view(), KEY_F)
	check(await until(framed), "and the camera comes back")


func _click_at(field: PlantField3D, place: Vector3) -> void:
	EditorInterface.get_selection().clear()
	await frames(5)
	await click(_view(), _place_of(field, place))
	await frames(3)


func _selected() -> PackedStringArray:
	var names: PackedStringArray = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		names.append(node.name)
	return names


func test_a_painted_field_has_no_handles_for_its_size() -> void:
	var field := await _open_field()
	field.size = Vector2(5, 4)  # Its sides are outside the editor's own gizmo.
	await _choose_only(field)
	field.map = PlantMap.new()
	field.map.fill_polygon(field.get_outline_points(), "Grass")
	await frames(5)
	var from := _place_of(field, Vector3(-2.5, 0, 0))
	await drag(_view(), from, _place_of(field, Vector3(-3.5, 0, 0)))
	check_equal(field.size, Vector2(5, 4), "size after a drag")
	field.position = Vector3.ZERO  # The editor's own tool drags whole nodes.
	await _choose_only(field)
	field.map = null
	await frames(5)
	await drag(_view(), from, _place_of(field, Vector3(-3.5, 0, 0)))
	check(field.size.x > 5.5, "size after a drag without a map: %s" % field.size)


func test_a_field_has_no_handles_while_a_tool_of_the_brush_is_on() -> void:
	var field := await _open_field()
	field.size = Vector2(5, 4)
	await _choose_only(field)
	var tool := find_by_script(BAR_SCRIPT).get_node("%Pick") as Button
	await click(tool)
	await frames(5)
	var gizmo := _gizmo_of(field)
	var from := _place_of(field, Vector3(-2.5, 0, 0))
	await drag(_view(), from, _place_of(field, Vector3(-3.5, 0, 0)))
	await drag(_view(), _place_of(field, Vector3.ZERO), _place_of(field, Vector3(1, 0, 0)))
	check_equal(field.size, Vector2(5, 4), "size after drags with the brush")
	check_equal(field.position, Vector3.ZERO, "position after drags with the brush")
	check(not gizmo.get_plugin().call(&"_has_handles", field), "it has no handles")
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var shown := camera.cull_mask
	await click(tool)
	check_equal(camera.cull_mask, shown | TRANSFORM_LAYER, "layers of the view without the brush")
	check(shown & TRANSFORM_LAYER == 0, "the transform gizmo is hidden with the brush")
	await frames(5)
	await drag(_view(), from, _place_of(field, Vector3(-3.5, 0, 0)))
	check(field.size.x > 5.5, "size after a drag without the brush: %s" % field.size)


func test_the_size_is_shown_in_metres() -> void:
	var field := await _open_field()
	field.size = Vector2(19, 16.25)
	await _choose_only(field)
	var gizmo := _gizmo_of(field)
	var plugin := gizmo.get_plugin()
	var title: String = plugin.call(&"_get_handle_name", gizmo, 0, false)
	var value: String = plugin.call(&"_get_handle_value", gizmo, 0, false)
	check_equal("%s: %s" % [title, value], tr("Size") + ": 19.0 × 16.25 m", "what the view shows")


func _gizmo_of(field: PlantField3D) -> EditorNode3DGizmo:
	for gizmo in field.get_gizmos():
		var own := gizmo as EditorNode3DGizmo
		var plugin := own.get_plugin() if own else null
		var script := plugin.get_script() as Script if plugin else null
		if script and script.resource_path == GIZMO_SCRIPT:
			return own
	return null
