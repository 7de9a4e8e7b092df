@tool
extends "brush_test.gd"
## The three areas of a field in the inspector, of which one is in use.

const AreaModes := preload("res://addons/undergrowth/editor/field/area_modes.gd")
const BAR := "res://addons/undergrowth/editor/inspector/area_bar.gd"
const RECTANGLE := AreaModes.Mode.RECTANGLE
const PATH := AreaModes.Mode.PATH
const PAINTED := AreaModes.Mode.PAINTED


func test_a_new_field_is_a_rectangle() -> void:
	await _shown_field()
	check(find_by_script(BAR).is_visible_in_tree(), "the buttons are visible at once")
	check_equal(_pressed(), [RECTANGLE], "pressed buttons")
	check(_is_shown(&"size") and not _is_shown(&"outline_width"), "properties of a rectangle")


func test_a_path_begins_as_the_rectangle() -> void:
	var field := await _shown_field()
	var corners := field.get_outline_points()
	var version := _history().get_version()
	await _press_mode(PATH)
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(_pressed(), [PATH], "pressed buttons")
	check(_is_shown(&"outline_width") and not _is_shown(&"size"), "properties of a path")
	var path := field.get_node(field.outline) as Path3D
	check(path != null and path.owner == field.owner, "a path of the scene")
	check_equal(path.curve.point_count, corners.size(), "its points")
	await _rested(field)
	await take_picture("area_modes")
	await undo()
	check(field.outline.is_empty() and field.get_child_count() == 0, "undo takes it away")
	await redo()
	check(field.get_node(field.outline) == path, "redo brings it back")


func test_a_change_of_mode_keeps_the_others() -> void:
	var field := await _shown_field()
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 0.5, GRASS, 1.0)
	var map := field.map
	await frames(3)
	check_equal(_pressed(), [PAINTED], "pressed buttons")
	await _press_mode(PATH)
	check(field.map == null, "no map on a path")
	var outline := field.outline
	await _press_mode(RECTANGLE)
	check(field.map == null and field.outline.is_empty(), "a rectangle has neither")
	check_equal(EditorInterface.save_scene(), OK, "saving")
	field = await _reload(FIELD_FILE) as PlantField3D
	await _choose_only(field)
	await open_inspector()
	await frames(20)
	await _press_mode(PAINTED)
	check(field.map != null, "the map is back")
	check(field.map and field.map.data == map.data, "as it was painted")
	await _press_mode(PATH)
	check_equal(field.outline, outline, "the path is back")
	for i in 2:
		await undo()
	check(field.map == null and field.outline.is_empty(), "two steps back")
	await _press_mode(PAINTED)
	check(field.map and field.map.data == map.data, "the map is back after undo")


func test_a_painted_area_begins_as_the_rectangle() -> void:
	var field := await _shown_field()
	await _press_mode(PAINTED)
	check(field.map != null, "it has a map")
	check_equal(field.map.get_density(Vector3(0.5, 0, 1), GRASS), 1.0, "density inside")
	check_equal(field.map.get_density(Vector3(3, 0, 0), GRASS), 0.0, "density outside")
	await undo()
	check(field.map == null, "undo takes it away")


func _shown_field() -> PlantField3D:
	var field := await _edited_field()
	await open_inspector()
	await frames(20)
	return field


func _press_mode(mode: AreaModes.Mode) -> void:
	await click(find_by_script(BAR).get_child(mode) as Control)
	await frames(5)


func _pressed() -> Array:
	var pressed := []
	for button: Button in find_by_script(BAR).get_children():
		if button.button_pressed:
			pressed.append(button.get_index())
	return pressed


func _is_shown(property: StringName) -> bool:
	var inspector := EditorInterface.get_inspector()
	for editor: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if editor.get_edited_property() == property:
			return true
	return false
