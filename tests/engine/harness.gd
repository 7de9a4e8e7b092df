## Base of the engine tests: a test script extends this file and has methods named test_*.
##
## Run one with `godot --headless --path build/test/project --script res://tests/engine/test_x.gd`.
## Each method prints `ok NAME` or `not ok NAME: why`; first comes `start`, last `done COUNT`.
## After `--` one may say `--rounds=N`: all tests run N times in one process, on the same object, so
## that what one test leaves behind meets every other. `--seed=N` has them run in a random order,
## which `round K seed N` names; each round more takes the next number as its seed.
## An error or warning of the engine that the test does not claim with [method check_error] fails
## the test, and so does a test that checks nothing.
extends SceneTree


## Collects what the engine reports, from whichever thread.
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


## Characters of a value that a failed check shows.
const SHOWN_LENGTH := 160

var _listener := Listener.new()
var _problems: PackedStringArray = []
var _errors: PackedStringArray = []
var _check_count := 0


func _initialize() -> void:
	OS.add_logger(_listener)
	print("start")
	_run_all()


## Called before each test; override to build what all tests of the script need.
func before_each() -> void:
	pass


## Called after each test; override to free it again.
func after_each() -> void:
	pass


## Fails the test unless [param condition] holds; [param what] says what was expected.
func check(condition: bool, what: String) -> void:
	_check_count += 1
	if not condition:
		_problems.append(what)


## Fails the test unless both are of one type and equal.
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


## Claims one error or warning: fails the test unless exactly one that was reported since the test
## began (or since the last claim of it) contains [param text].
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


## Whether the inspector shows the property [param title] of [param object].
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


## Waits for what worker threads do: until [param holds], a minute at most.
func until(holds: Callable, what: String) -> void:
	var deadline := Time.get_ticks_msec() + 60000
	while not holds.call() and Time.get_ticks_msec() < deadline:
		await process_frame
	check(holds.call(), what)


## What starts this engine once more. A script may have started it by its loader, which has no other
## name for itself.
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


## The names of all tests, as they stand in the script or shuffled.
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


## [param names] in an order that [param seed_value] alone decides.
func shuffled(names: PackedStringArray, seed_value: int) -> PackedStringArray:
	var random := RandomNumberGenerator.new()
	random.seed = hash(seed_value)  # Seeds in a row would begin alike.
	for last in range(names.size() - 1, 0, -1):
		var other := random.randi_range(0, last)
		var name := names[last]
		names[last] = names[other]
		names[other] = name
	return names


## What the command line says after `--` as `--NAME=VALUE`, or [param otherwise].
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
	return _problems.is_empty()


## At its exit the engine waits for ever where tasks of low priority, like the compilation of
## pipelines, stand in a queue while another one runs: a worker that saw that queue goes back to
## sleep, and nobody wakes it when another has emptied it (Godot 4.6.3, each time). They begin in
## the order in which they came: where the last of them has ended, none waits.
func _let_queued_tasks_begin() -> void:
	await frames(10)  # The last pictures may still ask for some.
	var last := WorkerThreadPool.add_task(OS.delay_usec.bind(0), false, "The last in the queue")
	WorkerThreadPool.wait_for_task_completion(last)


## A body of this shape in the group "walkers".
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


## A value as text, cut where it would fill the screen.
func _shown(value: Variant) -> String:
	var text := var_to_str(value)
	return text if text.length() <= SHOWN_LENGTH else text.left(SHOWN_LENGTH) + "…"


func _color_distance(a: Color, b: Color) -> float:
	return Vector4(a.r, a.g, a.b, a.a).distance_to(Vector4(b.r, b.g, b.b, b.a))
