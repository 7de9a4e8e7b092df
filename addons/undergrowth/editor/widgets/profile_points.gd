@tool
extends Control
## The points of a species' width curve, which the user drags on its outline: root left, tip right.

const TOOL_TIP := "Drag points. A double-click adds one, a right click removes it."
const GRAB_RADIUS := 9.0
const HANDLE_RADIUS := 4.0
const MIN_POINTS := 2
## The property with all points of a curve. One undo step restores all of them.
const POINTS := &"_data"
const CURVE := &"width_curve"

var _function: CurvePlantFunction
var _undo: EditorUndoRedoManager
var _grabbed := -1
# The curve of the dragged point, and its points before the drag.
var _dragged: Curve
var _before: Array = []


## Changes are steps of [param undo].
func setup(undo: EditorUndoRedoManager) -> void:
	_undo = undo
	tooltip_text = tr(TOOL_TIP)


## Shows the points of [param function]. Null shows none.
func edit(function: CurvePlantFunction) -> void:
	_release()
	_function = function
	visible = function != null
	queue_redraw()


# A disabled plugin ends the drag.
func _exit_tree() -> void:
	_release()


func _gui_input(event: InputEvent) -> void:
	var button := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if motion and _grabbed >= 0:
		_move(motion.position)
	elif button and button.button_index == MOUSE_BUTTON_LEFT:
		_on_left_button(button)
	elif button and button.pressed and button.button_index == MOUSE_BUTTON_RIGHT:
		_remove_point(_find_point(button.position))


func _draw() -> void:
	if not _curve():
		return
	var radius := HANDLE_RADIUS * EditorInterface.get_editor_scale()
	for i in _curve().point_count:
		var place := _to_place(_curve().get_point_position(i))
		draw_circle(
			place, radius, get_theme_color(&"contrast_color_2", &"Editor"), true, -1.0, true
		)
		var color := get_theme_color(&"accent_color" if i == _grabbed else &"mono_color", &"Editor")
		draw_circle(place, radius * 0.75, color, true, -1.0, true)


func _curve() -> Curve:
	return _function.width_curve if _function else null


func _on_left_button(button: InputEventMouseButton) -> void:
	if button.pressed and button.double_click:
		_add_point(button.position)
	elif button.pressed:
		_grabbed = _find_point(button.position)
		_dragged = _curve()
		_before = _dragged.get(POINTS) if _dragged else []
	else:
		_release()
	queue_redraw()


# A drag with any ending adds its changes as a step of undo.
func _release() -> void:
	if _grabbed >= 0 and _curve() == _dragged:
		_remember(tr("Move Width Point"), _before)
	_grabbed = -1


func _find_point(place: Vector2) -> int:
	var nearest := -1
	var distance := GRAB_RADIUS * EditorInterface.get_editor_scale()
	for i in _curve().point_count if _curve() else 0:
		var away := _to_place(_curve().get_point_position(i)).distance_to(place)
		if away < distance:
			nearest = i
			distance = away
	return nearest


func _move(place: Vector2) -> void:
	if _curve() != _dragged:  # Undo replaced the curve.
		_grabbed = -1
		return
	var point := _to_point(place)
	_grabbed = _curve().set_point_offset(_grabbed, point.x)
	_curve().set_point_value(_grabbed, point.y)
	queue_redraw()


func _add_point(place: Vector2) -> void:
	if not _curve():
		_make_curve(place)
		return
	if _find_point(place) >= 0:
		return
	var before: Array = _curve().get(POINTS)
	_curve().add_point(_to_point(place))
	_remember(tr("Add Width Point"), before)


func _make_curve(place: Vector2) -> void:
	var curve := Curve.new()
	curve.add_point(Vector2(0.0, 1.0))
	curve.add_point(_to_point(place))
	curve.add_point(Vector2(1.0, 0.0))
	_undo.create_action(tr("Add Width Curve"), UndoRedo.MERGE_DISABLE, _function)
	_undo.add_do_property(_function, CURVE, curve)
	_undo.add_undo_property(_function, CURVE, null)
	_undo.commit_action()


func _remove_point(index: int) -> void:
	if index < 0 or _curve().point_count <= MIN_POINTS:
		return
	var before: Array = _curve().get(POINTS)
	_curve().remove_point(index)
	_remember(tr("Remove Width Point"), before)


# The curve has already changed. Undo and redo set all of its points.
func _remember(action: String, before: Array) -> void:
	var after: Array = _curve().get(POINTS)
	queue_redraw()
	if after == before:
		return
	_undo.create_action(action, UndoRedo.MERGE_DISABLE, _function)
	_undo.add_do_property(_curve(), POINTS, after)
	_undo.add_undo_property(_curve(), POINTS, before)
	_undo.commit_action(false)


func _to_place(point: Vector2) -> Vector2:
	var share := point.y / maxf(_max_width(), 1e-6)
	return Vector2(point.x * size.x, (1.0 - share) * size.y * 0.5)


func _to_point(place: Vector2) -> Vector2:
	var share := clampf(1.0 - place.y / maxf(size.y * 0.5, 1.0), 0.0, 1.0)
	return Vector2(clampf(place.x / maxf(size.x, 1.0), 0.0, 1.0), share * _max_width())


func _max_width() -> float:
	return _curve().max_value if _curve() else 1.0
