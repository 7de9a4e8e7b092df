@tool
extends RefCounted
## Draws the path of a climber on its wall in the 3D view: a drag, or clicks and Enter. Escape
## discards it.

const DrawnPath := preload("../brush/drawn_path.gd")
const ClimberSteps := preload("climber_steps.gd")
const COLOR := Color(0.65, 0.95, 0.4)

## True while the tool takes the mouse.
var is_on := false:
	set(on):
		is_on = on
		if not on:
			_drawn = DrawnPath.new()
			_end = null

var _undo: EditorUndoRedoManager
var _plugin: EditorPlugin
var _climber: PlantClimber3D
var _drawn := DrawnPath.new()
# Of the pointer, in the climber's axes, or null.
var _end: Variant
var _is_down := false


func setup(plugin: EditorPlugin) -> void:
	_plugin = plugin
	_undo = plugin.get_undo_redo()


## Draws for [param object], if it is a climber.
func edit(object: Object) -> void:
	if object != _climber:
		is_on = false
		_climber = object as PlantClimber3D


## Returns the edited climber, or null.
func get_climber() -> PlantClimber3D:
	return _climber if is_instance_valid(_climber) and _climber.is_inside_tree() else null


## Handles input of a 3D view. Returns true if it was for the tool.
func handle(camera: Camera3D, event: InputEvent) -> bool:
	if not is_on or not get_climber():
		return false
	var is_used := false
	if event is InputEventMouseButton:
		is_used = _handle_button(camera, event as InputEventMouseButton)
	elif event is InputEventMouseMotion:
		_end = _find_place(camera, (event as InputEventMouseMotion).position, false)
		if _is_down and _end is Vector3:
			_drawn.drag(_end)
		is_used = _is_down
	elif event is InputEventKey and event.is_pressed():
		is_used = _handle_key((event as InputEventKey).keycode)
	_plugin.update_overlays()
	return is_used


## Draws the path on [param overlay].
func draw_over(overlay: Control) -> void:
	if not is_on or not get_climber() or _drawn.is_empty():
		return
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	_drawn.draw(overlay, camera, _climber, _end, COLOR)


## Adds the path to the climber, unless it is too short.
func finish() -> void:
	var points := _drawn.points
	var is_complete := _drawn.is_complete()
	is_on = false
	if is_complete and get_climber():
		ClimberSteps.change_path(_undo, _climber, points)


func _handle_button(camera: Camera3D, event: InputEventMouseButton) -> bool:
	if event.button_index != MOUSE_BUTTON_LEFT:
		return false
	if not event.pressed:
		var was_down := _is_down
		_is_down = false
		if was_down and _drawn.is_dragged():
			finish()
		return was_down
	var place: Variant = _find_place(camera, event.position, true)
	if place is Vector3:
		_is_down = true
		_drawn.press(place)
		if event.double_click and _drawn.is_complete():
			finish()
	return true


func _handle_key(key: Key) -> bool:
	if key in [KEY_ENTER, KEY_KP_ENTER] and not _drawn.is_empty():
		finish()
	elif key == KEY_ESCAPE:
		is_on = false
	else:
		return false
	return true


func _find_place(camera: Camera3D, pixel: Vector2, is_first: bool) -> Variant:
	var place: Variant = _climber._pick(
		camera.project_ray_origin(pixel), camera.project_ray_normal(pixel), is_first
	)
	return _climber.to_local(place) if place is Vector3 else null
