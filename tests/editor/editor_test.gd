@tool
extends RefCounted
## Base of the editor tests: checks, and the hands of a user (mouse and keyboard).
##
## Events go in where those of the operating system do ([method Input.parse_input_event]), so
## focus, shortcuts and popups behave as they do for a user.


## Collects what the engine reports, from whichever thread.
class Listener:
	extends Logger
	## The suite leaves the engine without an input method: it crashes in its thread for them.
	const EXPECTED := "XCreateIC couldn't create"
	var _mutex := Mutex.new()
	var _messages: PackedStringArray = []

	func _log_error(
		_function: String,
		file: String,
		line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		_error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		var text := code if rationale.is_empty() else rationale
		if text.begins_with(EXPECTED):
			return
		_mutex.lock()
		_messages.append("%s (%s:%d)" % [text, file.get_file(), line])
		_mutex.unlock()

	func take() -> PackedStringArray:
		_mutex.lock()
		var taken := _messages
		_messages = []
		_mutex.unlock()
		return taken


## The lists of the plant page, as they stand below one another.
const LISTS: Array[String] = ["ReadyList", "MixList", "SimpleList", "ProjectList"]
const DOCK_SCRIPT := "res://addons/undergrowth/editor/dock.gd"
## [method until] waits at least so many frames and so many seconds.
const PATIENCE := 600
const PATIENCE_SECONDS := 15.0
## Frames within which something is under the pointer.
const POINTING_FRAMES := 20
## Steps in which a drag goes from its beginning to its end.
const DRAG_STEPS := 8
## Colours that a picture must have at least to count as more than empty.
const LEAST_COLORS := 40

## Where [method take_picture] writes; nothing: nowhere.
var pictures_folder := ""

## What is wrong with the test that ran last, or nothing.
var problems: PackedStringArray = []
## The test came to its end, or was given up.
var is_done := true

var _listener := Listener.new()
var _errors: PackedStringArray = []
var _check_count := 0


## Runs the method called [param test], and tells the end with [member is_done].
func run(test: String) -> void:
	is_done = false
	problems = []
	_errors = []
	_check_count = 0
	OS.add_logger(_listener)
	await call(test)
	if is_done:
		return  # It was given up.
	if _check_count == 0:
		problems.append("nothing was checked")
	await _end(test)


## Lets a test that hangs go: [param why] is what is wrong with it.
func give_up(why: String) -> void:
	problems.append(why)
	_take_errors()
	is_done = true


func _end(test: String) -> void:
	_take_errors()
	if not problems.is_empty():
		await _photograph("failed_" + test)
	is_done = true


func _take_errors() -> void:
	OS.remove_logger(_listener)
	_errors.append_array(_listener.take())
	for message in _errors:
		problems.append("unexpected: " + message)


## Fails the test unless [param condition] holds; [param what] says what was expected.
func check(condition: bool, what: String) -> void:
	_check_count += 1
	if not condition:
		problems.append(what)


## Fails the test unless both are of one type and equal.
func check_equal(actual: Variant, expected: Variant, what := "value") -> void:
	var same: bool = typeof(actual) == typeof(expected) and actual == expected
	check(same, "%s is %s, not %s" % [what, var_to_str(actual), var_to_str(expected)])


## Claims all errors and warnings since the test began that contain [param text]; at least one.
func check_error(text: String) -> void:
	_errors.append_array(_listener.take())
	var others: PackedStringArray = []
	for message in _errors:
		if not message.contains(text):
			others.append(message)
	check(others.size() < _errors.size(), 'no error contains "%s"' % text)
	_errors = others


## The dock's content, or null where the plugin is off.
func dock() -> Control:
	var found: Array[Node] = []
	_collect(EditorInterface.get_base_control(), DOCK_SCRIPT, found)
	return found[0] if found else null


## The node of the dock with that unique name: `part("Plant/List/ReadyList")` goes through the
## scenes that stand inside one another.
func part(path: String) -> Node:
	var node: Node = dock()
	for name in path.split("/"):
		node = node.get_node("%" + name) if node else null
	return node


## Shows the dock and the page of that name (Plant or Wind).
func open_page(name: String) -> void:
	(dock().get_parent() as EditorDock).make_visible()
	await frames(2)
	var pages := part("Pages") as TabContainer
	var index := pages.get_tab_idx_from_control(part(name) as Control)
	var bar := pages.get_tab_bar()
	await click(bar, bar.get_tab_rect(index).get_center())


## Brings the editor's inspector before the dock, whose tab is beside its.
func open_inspector() -> void:
	var above: Node = EditorInterface.get_inspector()
	while above is not EditorDock:
		above = above.get_parent()
	(above as EditorDock).make_visible()
	await frames(2)


## Waits for [param count] frames; not each is drawn.
func frames(count: int) -> void:
	for i in count:
		await (Engine.get_main_loop() as SceneTree).process_frame


## Waits until [param condition] is true; false if it never is.
func until(condition: Callable) -> bool:
	var begin := Time.get_ticks_msec()
	var count := 0
	while count < PATIENCE or Time.get_ticks_msec() - begin < PATIENCE_SECONDS * 1000.0:
		if condition.call():
			return true
		await frames(1)
		count += 1
	return false


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


## Clicks an item of a list, wherever the list is scrolled to.
func click_item(list: ItemList, index: int) -> void:
	await reveal_item(list, index)
	await click(list, list.get_item_rect(index).get_center())


## Unfolds the group of a list and scrolls so that one of its items is in sight.
func reveal_item(list: ItemList, index: int) -> void:
	var above: Node = list.get_parent()
	while above is not ScrollContainer:
		if above is FoldableContainer:
			(above as FoldableContainer).folded = false
		above = above.get_parent()
	await frames(2)
	var scroll := above as ScrollContainer
	var at := list.get_global_rect().position.y + list.get_item_rect(index).position.y
	scroll.scroll_vertical += int(at - scroll.get_global_rect().position.y)
	await frames(2)


## What an item is called, in however many lines.
func item_title(list: ItemList, index: int) -> String:
	return list.get_item_text(index).replace("\n", " ")


## The list of the plant page that has an item called [param title], and which one it is; [null, -1]
## where none has.
func find_item(title: String) -> Array:
	for name: String in LISTS:
		var list := part("Plant/List/" + name) as ItemList
		for i in list.item_count:
			if item_title(list, i) == title:
				return [list, i]
	return [null, -1]


## Presses at [param from], moves to [param to] and lets go (the control's own coordinates).
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


## Types [param text] into whatever has the focus of the control's window, faster than it is drawn.
func type(control: Control, text: String) -> void:
	for i in text.length():
		_strike(control, KEY_NONE, text.unicode_at(i))
	await frames(2)


## Presses one key and lets it go: `await press_key(dock(), KEY_ENTER)`, with Ctrl or Shift held
## when asked for.
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


## Writes the editor's window as dock_[param name].png and checks that it is more than empty;
## [param of] cuts out one control.
func take_picture(name: String, of: Control = null) -> void:
	await frames(3)
	var picture := await _photograph("dock_" + name, of)
	var colors: Dictionary[Color, bool] = {}
	for x in range(0, picture.get_width(), 7):
		for y in range(0, picture.get_height(), 7):
			colors[picture.get_pixel(x, y)] = true
	check(colors.size() >= LEAST_COLORS, "dock_%s.png has %d colours" % [name, colors.size()])


func _photograph(name: String, of: Control = null) -> Image:
	EditorInterface.get_base_control().queue_redraw()  # Where nothing moves, no frame is drawn.
	await RenderingServer.frame_post_draw
	var window := EditorInterface.get_base_control().get_window()
	var picture := window.get_texture().get_image()
	if of:
		picture = picture.get_region(Rect2i(of.get_global_rect()))
	if not pictures_folder.is_empty():
		picture.save_png(pictures_folder.path_join(name + ".png"))
	return picture


func _collect(node: Node, script_path: String, found: Array[Node]) -> void:
	var script := node.get_script() as Script
	if script and script.resource_path == script_path:
		found.append(node)
		return
	for child in node.get_children(true):
		_collect(child, script_path, found)


func _in_window(control: Control, at: Vector2) -> Vector2:
	var own := control.size * 0.5 if at == Vector2.INF else at
	return control.get_global_transform_with_canvas() * own


# A button takes a click only where the engine knows the pointer over it. Beware of dragging an
# EditorSpinSlider: it captures the system's pointer, and Xvfb's never comes back into the window.
func _point(control: Control, where: Vector2) -> void:
	for i in POINTING_FRAMES:
		_move(control, where, where, 0)
		if control.get_viewport().gui_get_hovered_control():
			return
		await frames(1)
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
	_send(event)


func _send(event: InputEvent) -> void:
	Input.parse_input_event(event)
	Input.flush_buffered_events()
