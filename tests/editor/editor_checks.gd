@tool
extends RefCounted
## Base of all editor tests: checks, waits, and pictures. An error or warning of the engine fails
## the test unless the test claims it.


## Collects the engine's errors and warnings from all threads.
class Listener:
	extends Logger
	## The suite runs the engine without an input method, because its input-method thread crashes.
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


## Minimum frames and seconds of [method until].
const PATIENCE := 600
const PATIENCE_SECONDS := 15.0
## Microseconds of sleep in each frame of [method until].
const WAITING_SLEEP := 5000
## Frames without a scan after which the editor has applied the results of the scan thread.
const CALM_FRAMES := 3
## Minimum number of colours of a picture that is not empty.
const MIN_COLORS := 40

## Number of pictures that tests wait for. The driver then draws all of each frame.
static var awaited_pictures := 0

## Folder for [method take_picture]. Empty: it saves nothing.
var pictures_folder := ""

## Error of the last test, or an empty text.
var problems: PackedStringArray = []
## Emitted when the test ended or was aborted.
var is_done := true

var _listener := Listener.new()
var _errors: PackedStringArray = []
var _check_count := 0


## Runs the method called [param test], and emits [member is_done] at its end.
func run(test: String) -> void:
	is_done = false
	problems = []
	_errors = []
	_check_count = 0
	OS.add_logger(_listener)
	await files_are_known()
	if is_done:
		return  # It was aborted.
	await call(test)
	if is_done:
		return  # It was aborted.
	if _check_count == 0:
		problems.append("nothing was checked")
	await _end(test)


## Aborts a test that hangs. [param why] is its error.
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


## Fails the test unless [param condition] is true. [param what] describes the expected result.
func check(condition: bool, what: String) -> void:
	_check_count += 1
	if not condition:
		problems.append(what)


## Fails the test unless both are equal and of one type.
func check_equal(actual: Variant, expected: Variant, what := "value") -> void:
	var same: bool = typeof(actual) == typeof(expected) and actual == expected
	check(same, "%s is %s, not %s" % [what, var_to_str(actual), var_to_str(expected)])


## Claims all errors and warnings since the start of the test that contain [param text], at least
## one.
func check_error(text: String) -> void:
	_errors.append_array(_listener.take())
	var others: PackedStringArray = []
	for message in _errors:
		if not message.contains(text):
			others.append(message)
	check(others.size() < _errors.size(), 'no error contains "%s"' % text)
	_errors = others


## Waits for [param count] frames, of which not all are drawn.
func frames(count: int) -> void:
	for i in count:
		await (Engine.get_main_loop() as SceneTree).process_frame


## Waits until [param condition] is true, and leaves the processor to worker threads and other
## programs. Returns false at the time limit.
func until(condition: Callable) -> bool:
	var begin := Time.get_ticks_msec()
	var count := 0
	while count < PATIENCE or Time.get_ticks_msec() - begin < PATIENCE_SECONDS * 1000.0:
		if condition.call():
			return true
		OS.delay_usec(WAITING_SLEEP)
		await frames(1)
		count += 1
	return false


## Waits for the end of the editor's scan, also one from the previous test. During a scan the editor
## has no ids of saved files and starts no other scan.
func files_are_known() -> void:
	var files := EditorInterface.get_resource_filesystem()
	var calm := 0
	while calm < CALM_FRAMES:
		await frames(1)
		calm = 0 if files.is_scanning() else calm + 1


## Saves the editor's window as dock_[param name].png and checks that it is not empty. [param of]
## limits the picture to one control.
func take_picture(name: String, of: Control = null) -> void:
	await frames(3)
	var picture := await _photograph("dock_" + name, of)
	var colors: Dictionary[Color, bool] = {}
	for x in range(0, picture.get_width(), 7):
		for y in range(0, picture.get_height(), 7):
			colors[picture.get_pixel(x, y)] = true
	check(colors.size() >= MIN_COLORS, "dock_%s.png has %d colours" % [name, colors.size()])


## Waits for a frame that is drawn with all views.
func drawn() -> void:
	await frames(1)  # At its start, so that only one frame is drawn.
	awaited_pictures += 1
	EditorInterface.get_base_control().queue_redraw()  # Without any movement no frame is drawn.
	await RenderingServer.frame_post_draw
	awaited_pictures -= 1


func _photograph(name: String, of: Control = null) -> Image:
	await drawn()
	var window := EditorInterface.get_base_control().get_window()
	var picture := window.get_texture().get_image()
	if of:
		picture = picture.get_region(Rect2i(of.get_global_rect()))
	if not pictures_folder.is_empty():
		picture.save_png(pictures_folder.path_join(name + ".png"))
	return picture
