@tool
extends RefCounted
## Draws trails, hedges and beds in the 3D view: a drag from end to end, or clicks and Enter.

const BrushOptions := preload("brush_options.gd")
const BrushReadout := preload("brush_readout.gd")
const DrawnPath := preload("drawn_path.gd")
const PathSteps := preload("path_steps.gd")
const Translations := preload("../translations/translations.gd")
const COLOR := Color(1.0, 0.85, 0.4)

var _undo: EditorUndoRedoManager
var _options: BrushOptions
var _field: PlantField3D
var _drawn := DrawnPath.new()
# Of the pointer, in the field's axes, or null.
var _end: Variant


## Draws with [param options].
func setup(undo: EditorUndoRedoManager, options: BrushOptions) -> void:
	_undo = undo
	_options = options


## Begins or continues a path of [param field] at [param place] in world axes.
func press(field: PlantField3D, place: Vector3, is_double: bool) -> void:
	_field = field
	_drawn.width = _options.width
	if is_double and _drawn.is_complete():
		finish()
	else:
		_drawn.press(field.to_local(place))


## Follows the pointer. [param is_down]: with the button pressed.
func move_to(field: PlantField3D, place: Vector3, is_down: bool) -> void:
	_end = field.to_local(place)
	if is_down and _field == field:
		_drawn.drag(_end)


## Ends a drag.
func release() -> void:
	if not _drawn.is_empty() and _drawn.release():
		finish()


## Adds the path to the field, unless it is too short.
func finish() -> void:
	var drawn := _drawn
	_drawn = DrawnPath.new()
	if not drawn.is_complete() or not is_instance_valid(_field):
		return
	drawn.width = _options.width
	if _options.tool == BrushOptions.Tool.TRAIL:
		PathSteps.add_trail(_undo, _field, drawn)
	else:
		PathSteps.set_area(_undo, _field, drawn)


## Handles Enter, which ends the path, and Escape, which discards it. Returns true if it did.
func handle_key(key: Key) -> bool:
	if _drawn.is_empty():
		return false
	if key in [KEY_ENTER, KEY_KP_ENTER]:
		finish()
	elif key == KEY_ESCAPE:
		cancel()
	else:
		return false
	return true


func cancel() -> void:
	_drawn = DrawnPath.new()
	_end = null


## Draws the path on [param overlay], and its length beside [param pointer].
func draw_over(overlay: Control, camera: Camera3D, pointer: Vector2) -> void:
	if _drawn.is_empty() or not is_instance_valid(_field):
		return
	_drawn.draw(overlay, camera, _field, _end, COLOR)
	BrushReadout.draw(overlay, pointer, _describe())


func _describe() -> String:
	var length := String.num(_drawn.get_length(), 1)
	if _drawn.is_closed():
		return Translations.text("%s m, closed") % length
	return Translations.text("%s m long, %s m wide") % [length, String.num(_options.width, 1)]
