@tool
extends "brush_test.gd"
## The tools that draw trails, hedges and beds in the 3D view.

const DrawnPath := preload("res://addons/undergrowth/editor/brush/drawn_path.gd")
const LEFT := Vector3(-0.9, 0, 1)
const MIDDLE := Vector3(0, 0, 0.5)
const RIGHT := Vector3(0.9, 0, 1)


func test_a_drag_draws_a_trail() -> void:
	var field := await _edited_field()
	await _rested(field)
	var count := field.get_plant_count()
	await _choose_tool("Trail")
	_set_width(0.6)
	var version := _history().get_version()
	await drag(_view(), _place_of(field, LEFT), _place_of(field, RIGHT))
	await _rested(field)
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(field.exclusions.size(), 1, "trails")
	check(absf(field.exclusion_widths[0] - 0.6) < 1e-4, "width")
	var path := field.get_node(field.exclusions[0]) as Path3D
	check(path.get_parent() == field and path.owner == field.owner, "a child of the field")
	check(path.curve.point_count <= 4, "%d points of a straight drag" % path.curve.point_count)
	check(field.get_plant_count() < count, "plants are gone")
	await take_picture("trail")
	await undo()
	await _rested(field)
	check(field.exclusions.is_empty() and field.get_child_count() == 0, "undo takes it away")
	check_equal(field.get_plant_count(), count, "plants are back")
	await redo()
	check_equal(field.exclusions.size(), 1, "trails after redo")
	await _choose_tool("Trail")


func test_clicks_and_enter_draw_a_hedge() -> void:
	var field := await _edited_field()
	await _choose_tool("Path")
	_set_width(0.4)
	var version := _history().get_version()
	for place: Vector3 in [LEFT, MIDDLE, RIGHT]:
		await click(_view(), _place_of(field, place))
	check_equal(_history().get_version(), version, "nothing before Enter")
	await press_key(_view(), KEY_BRACKETRIGHT)
	var shown: float = (_settings().get_node("%PathWidth") as EditorSpinSlider).value
	check(shown > 0.41, "a key makes it wider: %f m are shown" % shown)
	_set_width(0.4)
	await press_key(_view(), KEY_ENTER)
	await _rested(field)
	check_equal(_history().get_version(), version + 1, "one step")
	var path := field.get_node(field.outline) as Path3D
	check_equal(path.curve.point_count, 3, "points")
	check(not path.curve.closed, "it is open")
	check(absf(field.outline_width - 0.4) < 1e-4, "width: %f" % field.outline_width)
	await take_picture("hedge")
	await undo()
	check(field.outline.is_empty() and field.outline_width == 0.0, "undo takes it away")
	await _choose_tool("Path")


func test_a_closed_drag_draws_a_bed() -> void:
	var field := await _edited_field()
	await _choose_tool("Path")
	_set_width(0.3)
	await _drag_around(field, 0.9)
	await _rested(field)
	var path := field.get_node(field.outline) as Path3D
	check(path and path.curve.closed, "it is closed")
	check_equal(field.outline_width, 0.0, "width")
	check(field.get_plant_count() > 10, "plants inside")
	await undo()
	await _choose_tool("Path")


func test_a_second_hedge_replaces_the_first() -> void:
	var field := await _edited_field()
	await _choose_tool("Path")
	_set_width(0.4)
	await drag(_view(), _place_of(field, LEFT), _place_of(field, RIGHT))
	var first := field.get_node(field.outline) as Path3D
	await drag(_view(), _place_of(field, LEFT), _place_of(field, MIDDLE))
	var second := field.get_node(field.outline) as Path3D
	check(second != first, "the second is the area")
	check_equal(field.get_child_count(), 1, "paths of the field")
	check_equal(second.name, &"Hedge", "its name")
	await undo()
	check(field.get_node(field.outline) == first, "undo brings the first back")
	check_equal(field.get_child_count(), 1, "paths after undo")
	check(first.owner == field.owner, "it is saved with the scene")
	await redo()
	check(field.get_node(field.outline) == second, "redo replaces it")
	await undo()
	await undo()
	await _choose_tool("Path")


func test_a_path_with_another_use_stays() -> void:
	var field := await _edited_field()
	await _choose_tool("Path")
	_set_width(0.4)
	await drag(_view(), _place_of(field, LEFT), _place_of(field, RIGHT))
	var first := field.get_node(field.outline) as Path3D
	field.exclusion_widths = [0.2]
	field.exclusions = [NodePath(first.name)]
	await drag(_view(), _place_of(field, LEFT), _place_of(field, MIDDLE))
	check_equal(first.get_parent(), field as Node, "parent of the first")
	check_equal(field.get_child_count(), 2, "paths of the field")
	field.exclusions = []
	field.exclusion_widths = []
	await undo()
	await undo()
	await _choose_tool("Path")


func test_escape_discards_what_is_drawn() -> void:
	var field := await _edited_field()
	await _choose_tool("Trail")
	var version := _history().get_version()
	await click(_view(), _place_of(field, LEFT))
	await click(_view(), _place_of(field, RIGHT))
	await press_key(_view(), KEY_ESCAPE)
	await press_key(_view(), KEY_ENTER)
	check_equal(_history().get_version(), version, "no step")
	check((_bar().get_node("%Trail") as Button).button_pressed, "the tool stays on")
	await press_key(_view(), KEY_ESCAPE)
	check(not (_bar().get_node("%Trail") as Button).button_pressed, "a second Escape ends it")


func test_a_painted_map_is_kept_when_a_hedge_is_drawn() -> void:
	var field := await _edited_field()
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 0.5, GRASS, 1.0)
	var map := field.map
	await _choose_tool("Path")
	_set_width(0.4)
	await drag(_view(), _place_of(field, LEFT), _place_of(field, RIGHT))
	check(field.map == null, "the path is the area")
	check(field.get_meta(&"_undergrowth_map") == map, "the map is kept")
	await undo()
	check(field.map == map, "undo brings it back")
	await _choose_tool("Path")


func test_a_curve_has_few_points() -> void:
	var drawn := DrawnPath.new()
	for i in 60:
		drawn.points.append(Vector3(i * 0.3, 0.0, sin(i * 0.1) * 3.0))
	var curve := drawn.make_curve()
	check(curve.point_count < 25, "%d points of 60" % curve.point_count)
	var worst := 0.0
	for point in drawn.points:
		worst = maxf(worst, curve.get_closest_point(point).distance_to(point))
	check(worst < 0.2, "%f m beside what was drawn" % worst)


func _set_width(metres: float) -> void:
	(_settings().get_node("%PathWidth") as EditorSpinSlider).value = metres


## Drags along a circle.
func _drag_around(field: PlantField3D, radius: float) -> void:
	var view := _view()
	var before := _in_window(view, _place_of(field, Vector3(radius, 0, 0)))
	await _point(view, before)
	_press(view, before, MOUSE_BUTTON_LEFT, true)
	await frames(2)
	for i in range(1, 17):
		var around := Vector3(radius, 0, 0).rotated(Vector3.UP, TAU * i / 16.0)
		var now := _in_window(view, _place_of(field, around))
		_move(view, before, now, MOUSE_BUTTON_MASK_LEFT)
		before = now
		await frames(2)
	_press(view, before, MOUSE_BUTTON_LEFT, false)
	await frames(3)
