@tool
extends EditorPlugin
## Uses the add-on inside the real editor and closes the editor when done.
##
## Put this folder beside the add-on in a project (addons/editor_driver), switch both plugins on in
## project.godot and start the editor in a display, with the tests to run and the folder for
## pictures:
## [codeblock]
## godot --editor --path PROJECT -- --editor-tests=all --pictures=/absolute/path
## [/codeblock]
## Without `--editor-tests` nothing happens, so that the project can be opened by hand. Names of
## test scripts (test_plant_page,test_undo) instead of `all` run only these.
##
## Each script test_*.gd of this folder extends editor_test.gd. After `start`, each of its methods
## test_* prints `ok NAME` or `not ok NAME: why`. An error or warning in the log that the test does
## not claim fails it. The last line is `N passed, N failed`. The editor's exit status is 0 only if
## none failed.

const EditorTest := preload("editor_test.gd")
const TESTS_OPTION := "--editor-tests="
const PICTURES_OPTION := "--pictures="
## Frames without any action after the editor's first scan.
const SETTLING_FRAMES := 20
## A test hangs if it exceeds both limits. The next one then starts. A busy machine has few frames
## in that time, a fast one has many.
const LIMIT_SECONDS := 60.0
const LIMIT_FRAMES := 3000
## Seconds after which a line reports a running test.
const LIFE_SIGN_SECONDS := 10.0
## One of this many frames draws the windows, and those for pictures. Without a graphics card,
## drawing takes nearly all of the time. All frames draw viewports that ask for a single picture, as
## those of thumbnails do.
const DRAWN_FRAME := 256
## Microseconds of sleep in each frame. The editor would set 100,000 in a window without the focus.
const FRAME_SLEEP := 1
## One of this many pixels of the 3D viewports is drawn.
const DRAWN_PIXEL := 16

var _passed := 0
var _failed := 0
# Viewports of containers, which draw them in each frame, whether their window is drawn or not.
var _contained: Array[Viewport] = []


func _enter_tree() -> void:
	var wish := _option(TESTS_OPTION)
	if not wish.is_empty():
		_run(wish)


func _process(_delta: float) -> void:
	OS.low_processor_usage_mode_sleep_usec = FRAME_SLEEP
	var is_awaited := EditorTest.awaited_pictures > 0
	_draw(is_awaited or Engine.get_process_frames() % DRAWN_FRAME == 0)


func _draw(is_drawn: bool) -> void:
	var mode := RenderingServer.VIEWPORT_UPDATE_DISABLED
	if is_drawn:
		mode = RenderingServer.VIEWPORT_UPDATE_WHEN_VISIBLE
	for viewport in _windows() + _contained:
		RenderingServer.viewport_set_update_mode(viewport.get_viewport_rid(), mode)


func _windows() -> Array[Viewport]:
	var windows: Array[Viewport] = []
	for id in DisplayServer.get_window_list():
		var number := DisplayServer.window_get_attached_instance_id(id)
		if is_instance_id_valid(number):
			windows.append(instance_from_id(number))
	return windows


func _add_contained(node: Node) -> void:
	if node is SubViewport and node.get_parent() is SubViewportContainer:
		_contained.append(node)


func _remove_contained(node: Node) -> void:
	if node is SubViewport:
		_contained.erase(node)


func _run(wish: String) -> void:
	for i in 4:
		EditorInterface.get_editor_viewport_3d(i).scaling_3d_scale = sqrt(1.0 / DRAWN_PIXEL)
	for node: Node in get_tree().root.find_children("*", "SubViewport", true, false):
		_add_contained(node)
	get_tree().node_added.connect(_add_contained)
	get_tree().node_removed.connect(_remove_contained)
	await _wait_for_editor()
	print("start")
	for path in _scripts(wish):
		await _run_script(path)
	await _wait_for_editor()
	print("%d passed, %d failed" % [_passed, _failed])
	_let_queued_tasks_begin()
	get_tree().quit(0 if _failed == 0 and _passed > 0 else 1)


func _wait_for_editor() -> void:
	var files := EditorInterface.get_resource_filesystem()
	await get_tree().process_frame
	while files.is_scanning():
		await get_tree().process_frame
	for i in SETTLING_FRAMES:
		await get_tree().process_frame


# At its exit the engine can wait forever if tasks of low priority are queued while another one runs
# (see tests/engine/harness.gd).
func _let_queued_tasks_begin() -> void:
	var last := WorkerThreadPool.add_task(OS.delay_usec.bind(0), false, "The last in the queue")
	WorkerThreadPool.wait_for_task_completion(last)


func _scripts(wish: String) -> PackedStringArray:
	var folder := (get_script() as Script).resource_path.get_base_dir()
	var paths: PackedStringArray = []
	for file in DirAccess.get_files_at(folder):
		var listed := wish == "all" or file.get_basename() in wish.split(",")
		if file.begins_with("test_") and file.ends_with(".gd") and listed:
			paths.append(folder.path_join(file))
	return paths


func _run_script(path: String) -> void:
	var script: Script = load(path)
	if not script.can_instantiate():
		_failed += 1
		print("not ok %s: the script has an error" % path.get_file())
		return
	var test := _make_test(script)
	for method: Dictionary in script.get_script_method_list():
		var title: String = method["name"]
		if title.begins_with("test_") and not await _run_test(test, title):
			test = _make_test(script)


func _make_test(script: Script) -> EditorTest:
	var test: EditorTest = script.call(&"new")
	test.pictures_folder = _option(PICTURES_OPTION)
	return test


# False if the test was aborted.
func _run_test(test: EditorTest, title: String) -> bool:
	var begin := Time.get_ticks_msec()
	var reported := begin
	var first := Engine.get_process_frames()
	test.run(title)
	while not test.is_done and not _is_over(begin, first):
		if Time.get_ticks_msec() - reported > LIFE_SIGN_SECONDS * 1000.0:
			reported = Time.get_ticks_msec()
			print("%s goes on, frame %d" % [title, Engine.get_process_frames() - first])
		await get_tree().process_frame
	var is_done := test.is_done
	if not is_done:
		test.give_up("it hangs: not done after %d frames" % (Engine.get_process_frames() - first))
	_report(title, test.problems)
	var seconds := (Time.get_ticks_msec() - begin) * 0.001
	print("took %.1f s, %d frames" % [seconds, Engine.get_process_frames() - first])
	return is_done


func _is_over(begin: int, first_frame: int) -> bool:
	return (
		Time.get_ticks_msec() - begin > LIMIT_SECONDS * 1000.0
		and Engine.get_process_frames() - first_frame > LIMIT_FRAMES
	)


func _report(title: String, problems: PackedStringArray) -> void:
	if problems.is_empty():
		_passed += 1
		print("ok " + title)
	else:
		_failed += 1
		print("not ok %s: %s" % [title, "; ".join(problems).replace("\n", " ")])


func _option(name: String) -> String:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with(name):
			return argument.trim_prefix(name)
	return ""
