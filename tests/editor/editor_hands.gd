@tool
extends "editor_checks.gd"
## Simulated input of a user: mouse, pen and keyboard.
##
## Events enter where those of the operating system do ([method Input.parse_input_event]). Focus,
## shortcuts and popups behave as they do for a user.

## Number of steps of a drag.
const DRAG_STEPS := 8

## Keys that are pressed during mouse actions.
var holds_ctrl := false
var holds_shift := false
## Pressure of a pen that replaces the mouse.
var pen_pressure := 0.0


## Clicks into [param control], in the middle or at [param at] (its own coordinates).
func click(control: Control, at := Vector2.INF, button := MOUSE_BUTTON_LEFT) -> void:
	var where := _in_window(control, at)
	await _point(control, where)
	_press(control, where, button, true)
	await frames(1)
	_press(control, where, button, false)
	await frames(2)


## Double-clicks into [param control] at [param at].
func double_click(control: Control, at: Vector2) -> void:
	await click(control, at)
	_press(control, _in_window(control, at), MOUSE_BUTTON_LEFT, true, true)
	_press(control, _in_window(control, at), MOUSE_BUTTON_LEFT, false)
	await frames(2)


## Presses at [param from], moves to [param to] and releases (the control's own coordinates).
func drag(control: Control, from: Vector2, to: Vector2, button := MOUSE_BUTTON_LEFT) -> void:
	var start := _in_window(control, from)
	var goal := _in_window(control, to)
	await _point(control, start)
	_press(control, start, button, true)
	await frames(1)
	var before := start
	for i in DRAG_STEPS:
		var now := start.lerp(goal, float(i + 1) / DRAG_STEPS)
		_move(control, before, now, 1 << (button - 1))
		before = now
		await frames(1)
	_press(control, goal, button, false)
	await frames(2)


## Turns the wheel over [param control], up for positive [param clicks].
func wheel(control: Control, clicks: int) -> void:
	var where := _in_window(control, Vector2.INF)
	var button := MOUSE_BUTTON_WHEEL_UP if clicks > 0 else MOUSE_BUTTON_WHEEL_DOWN
	await _point(control, where)
	for i in absi(clicks):
		_press(control, where, button, true)
		_press(control, where, button, false)
		await frames(1)


## Types [param text] into the focused control of the control's window, faster than it is drawn.
func type(control: Control, text: String) -> void:
	for i in text.length():
		_strike(control, KEY_NONE, text.unicode_at(i))
	await frames(2)


## Presses and releases one key: `await press_key(dock(), KEY_ENTER)`, optionally with Ctrl or
## Shift.
func press_key(control: Control, key: Key, unicode := 0, ctrl := false, shift := false) -> void:
	_strike(control, key, unicode, ctrl, shift)
	await frames(1)


func _strike(control: Control, key: Key, unicode: int, ctrl := false, shift := false) -> void:
	for pressed: bool in [true, false]:
		var event := InputEventKey.new()
		event.window_id = control.get_window().get_window_id()
		event.keycode = key
		event.physical_keycode = key
		event.unicode = unicode
		event.ctrl_pressed = ctrl
		event.shift_pressed = shift
		event.pressed = pressed
		_send(event)


## Undoes the newest step, as Ctrl+Z over the scene does.
func undo() -> void:
	await press_key(EditorInterface.get_base_control(), KEY_Z, 0, true)
	await frames(2)


func redo() -> void:
	await press_key(EditorInterface.get_base_control(), KEY_Z, 0, true, true)
	await frames(2)


func _in_window(control: Control, at: Vector2) -> Vector2:
	var own := control.size * 0.5 if at == Vector2.INF else at
	return control.get_global_transform_with_canvas() * own


# A button accepts a click only if the pointer is over it for the engine. Do not drag an
# EditorSpinSlider: it captures the system's pointer, and Xvfb's pointer never returns into the
# window.
func _point(control: Control, where: Vector2) -> void:
	var viewport := control.get_viewport()
	var is_under := func() -> bool:
		_move(control, where, where, 0)
		return viewport.gui_get_hovered_control() != null
	if not await until(is_under):
		problems.append("nothing is under the pointer at %s of %s" % [where, control])


func _press(
	control: Control, where: Vector2, button: MouseButton, pressed: bool, double := false
) -> void:
	var event := InputEventMouseButton.new()
	event.window_id = control.get_window().get_window_id()
	event.button_index = button
	event.button_mask = 1 << (button - 1) if pressed else 0
	event.pressed = pressed
	event.double_click = double
	event.ctrl_pressed = holds_ctrl
	event.shift_pressed = holds_shift
	event.position = where
	event.global_position = where
	_send(event)


func _move(control: Control, before: Vector2, now: Vector2, mask: int) -> void:
	var event := InputEventMouseMotion.new()
	event.window_id = control.get_window().get_window_id()
	event.position = now
	event.global_position = now
	event.relative = now - before
	event.button_mask = mask
	event.ctrl_pressed = holds_ctrl
	event.shift_pressed = holds_shift
	if pen_pressure > 0.0:
		event.tilt = Vector2(0.1, 0.2)
		event.pressure = pen_pressure if mask else 0.0
	_send(event)


func _send(event: InputEvent) -> void:
	Input.parse_input_event(event)
	Input.flush_buffered_events()
