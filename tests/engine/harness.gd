## Base class of the engine tests. A test script extends this file and has methods named test_*.
##
## Run one with `godot --headless --path build/test/project --script res://tests/engine/test_x.gd`.
## Each method prints `ok NAME` or `not ok NAME: why`. The first line is `start`, the last one `done
## COUNT`. Options follow `--`. `--rounds=N` runs all tests N times in one process, on the same
## object, so that leftovers of one test affect all other tests. `--seed=N` runs them in a random
## order, which `round K seed N` prints. Each round adds one to the seed. A test fails by an error
## or warning of the engine that it does not claim with [method check_error], and by the absence of
## any check.
extends SceneTree


## Collects the engine's errors and warnings from all threads.
class Listener:
	extends Logger
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
		_mutex.lock()
		_messages.append("%s (%s:%d)" % [text, file.get_file(), line])
		_mutex.unlock()

	func take() -> PackedStringArray:
		_mutex.lock()
		var taken := _messages
		_messages = []
		_mutex.unlock()
		return taken


## Maximum number of characters of a value in a failed check.
const SHOWN_LENGTH := 160

var _listener := Listener.new()
var _problems: PackedStringArray = []
var _errors: PackedStringArray = []
var _check_count := 0


func _initialize() -> void:
	OS.add_logger(_listener)
	print("start")
	_run_all()


## Called before each test. Override it to create the objects that all tests of the script need.
func before_each() -> void:
	pass


## Called after each test. Override it to free them.
func after_each() -> void:
	pass


## Fails the test unless [param condition] is true. [param what] describes the expected result.
func check(condition: bool, what: String) -> void:
	_check_count += 1
	if not condition:
		_problems.append(what)


## Fails the test unless both are equal and of one type.
func check_equal(actual: Variant, expected: Variant, what := "value") -> void:
	var same: bool = typeof(actual) == typeof(expected) and actual == expected
	check(same, "%s is %s, not %s" % [what, _shown(actual), _shown(expected)])


## Fails the test unless [param actual], a number or a vector, is within [param tolerance] of
## [param expected].
func check_near(actual: Variant, expected: Variant, tolerance: float, what := "value") -> void:
	var distance: float = NAN
	if actual is float or actual is int:
		distance = absf(float(actual) - float(expected))
	elif actual is Vector3 or actual is Vector2:
		distance = actual.distance_to(expected)
	elif actual is Color:
		distance = _color_distance(actual, expected)
	elif actual is Quaternion:
		distance = (actual as Quaternion).angle_to(expected)
	check(
		distance <= tolerance,
		"%s is %s, not %s within %s" % [what, str(actual), str(expected), str(tolerance)]
	)


## Claims one error or warning. Fails the test unless exactly one that was reported since the start
## of the test (or since its last claim) contains [param text].
func check_error(text: String) -> void:
	check_error_count(text, 1)


## Claims [param count] errors or warnings that contain [param text].
func check_error_count(text: String, count: int) -> void:
	_errors.append_array(_listener.take())
	var others: PackedStringArray = []
	for message in _errors:
		if not message.contains(text):
			others.append(message)
	var found := _errors.size() - others.size()
	check(found == count, '%d errors contain "%s", not %d' % [found, text, count])
	_errors = others


## True if the inspector shows the property [param title] of [param object].
func is_shown(object: Object, title: String) -> bool:
	for property in object.get_property_list():
		if property["name"] == title:
			return property["usage"] & PROPERTY_USAGE_EDITOR != 0
	return false


## Waits for [param count] frames: `await frames(2)`.
func frames(count: int) -> void:
	for i in count:
		await process_frame


## Waits for [param count] physics frames: `await physics_frames(2)`.
func physics_frames(count: int) -> void:
	for i in count:
		await physics_frame


## Waits for worker threads until [param holds] is true, at most two minutes. Frames do not wait for
## the clock, so it leaves the processor to the workers.
func until(holds: Callable, what: String) -> void:
	var deadline := Time.get_ticks_msec() + 120000
	while not holds.call() and Time.get_ticks_msec() < deadline:
		OS.delay_usec(1000)
		await process_frame
	check(holds.call(), what)


## Returns the command that starts this engine again. If a loader started it, the command includes
## the loader.
func engine_path() -> String:
	var named := OS.get_environment("GODOT")
	return OS.get_executable_path() if named.is_empty() else named


func _run_all() -> void:
	await process_frame
	var failed := 0
	var count := 0
	for number in _word("rounds", "1").to_int():
		for test in _tests_of_round(number):
			count += 1
			failed += 0 if await _run_one(test) else 1
	OS.remove_logger(_listener)
	print("done %d" % count)
	await _let_queued_tasks_begin()
	quit(1 if failed > 0 else 0)


## Returns the names of all tests, in the order of the script or shuffled.
func _tests_of_round(number: int) -> PackedStringArray:
	var tests: PackedStringArray = []
	for method: Dictionary in get_script().get_script_method_list():
		if method["name"].begins_with("test_"):
			tests.append(method["name"])
	var word := _word("seed", "")
	if not word.is_empty():
		tests = shuffled(tests, word.to_int() + number)
		print("round %d seed %d" % [number + 1, word.to_int() + number])
	return tests


## Returns [param names] in an order that depends only on [param seed_value].
func shuffled(names: PackedStringArray, seed_value: int) -> PackedStringArray:
	var random := RandomNumberGenerator.new()
	random.seed = hash(seed_value)  # Consecutive seeds would give similar first numbers.
	for last in range(names.size() - 1, 0, -1):
		var other := random.randi_range(0, last)
		var name := names[last]
		names[last] = names[other]
		names[other] = name
	return names


## Returns the value of `--NAME=VALUE` after `--` in the command line, or [param otherwise].
func _word(name: String, otherwise: String) -> String:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("--%s=" % name):
			return word.get_slice("=", 1)
	return otherwise


func _run_one(test: String) -> bool:
	_problems = []
	_errors = []
	_check_count = 0
	_listener.take()
	var begin := Time.get_ticks_msec()
	await before_each()
	await call(test)
	await after_each()
	_errors.append_array(_listener.take())
	for message in _errors:
		_problems.append("unexpected: " + message)
	if _check_count == 0:
		_problems.append("nothing was checked")
	if _problems.is_empty():
		print("ok " + test)
	else:
		print("not ok %s: %s" % [test, "; ".join(_problems).replace("\n", " ")])
	print("took %.1f s" % ((Time.get_ticks_msec() - begin) * 0.001))
	return _problems.is_empty()


## At its exit the engine can wait forever if tasks of low priority, such as the compilation of
## pipelines, are queued while another one runs. A worker that finds that queue full sleeps, and
## nothing wakes it after the queue is empty (Godot 4.6.3, reproducible). Tasks start in the order
## of their arrival, so none waits after the end of the last one.
func _let_queued_tasks_begin() -> void:
	await frames(10)  # The last pictures may still start some.
	var last := WorkerThreadPool.add_task(OS.delay_usec.bind(0), false, "The last in the queue")
	WorkerThreadPool.wait_for_task_completion(last)


## Returns a body of this shape in the group "walkers".
func add_body(shape: Shape3D, at := Vector3.ZERO) -> StaticBody3D:
	var body := StaticBody3D.new()
	add_shape(body, shape)
	body.position = at
	body.add_to_group(&"walkers")
	root.add_child(body)
	return body


func add_shape(to: Node3D, shape: Shape3D) -> void:
	var holder := CollisionShape3D.new()
	holder.shape = shape
	to.add_child(holder)


## Returns a value as text, truncated to a readable length.
func _shown(value: Variant) -> String:
	var text := var_to_str(value)
	return text if text.length() <= SHOWN_LENGTH else text.left(SHOWN_LENGTH) + "…"


func _color_distance(a: Color, b: Color) -> float:
	return Vector4(a.r, a.g, a.b, a.a).distance_to(Vector4(b.r, b.g, b.b, b.a))
