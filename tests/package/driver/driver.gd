## Does in a headless editor what somebody does who installs the add-on, as `--scenario=NAME` says
## after `--`, and prints `ok` and `not ok` as the engine tests do. `--from=DIR` has the add-on.
@tool
extends EditorPlugin

const ADDON := "res://addons/undergrowth"
const PLUGIN := "undergrowth"
const A_CLASS := &"PlantField3D"
const MINUTE := 60000


func _enter_tree() -> void:
	_run.call_deferred()


func _run() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	await _wait(60)
	print("start")
	var scenario := _word("scenario")
	var fault: String = await call("_" + scenario)
	print("ok " + scenario if fault.is_empty() else "not ok %s: %s" % [scenario, fault])
	print("done 1")
	await _wait(60)
	get_tree().quit()


func _wait(frames: int) -> void:
	for _frame in frames:
		await get_tree().process_frame


func _word(name: String) -> String:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("--%s=" % name):
			return word.get_slice("=", 1)
	return ""


func _has_dock() -> bool:
	var base := EditorInterface.get_base_control()
	return not base.find_children("Undergrowth", "EditorDock", true, false).is_empty()


## The plugin stays off: classes are there, the dock is not.
func _off() -> String:
	var is_there := ClassDB.class_exists(A_CLASS)
	return "" if is_there and not _has_dock() else "class %s, dock %s" % [is_there, _has_dock()]


## The project file of a fresh clone says that the plugin is on.
func _on() -> String:
	var is_there := ClassDB.class_exists(A_CLASS)
	return "" if is_there and _has_dock() else "class %s, dock %s" % [is_there, _has_dock()]


func _switched() -> String:
	for is_on: bool in [true, false, true]:
		EditorInterface.set_plugin_enabled(PLUGIN, is_on)
		await _wait(30)
		if _has_dock() != is_on:
			return "switched to %s, the dock is %s" % [is_on, _has_dock()]
	return ""


## A newcomer copies the folder while the project is open, and switches the plugin on.
func _copied() -> String:
	_copy(_word("from"), ADDON)
	EditorInterface.get_resource_filesystem().scan()
	var deadline := Time.get_ticks_msec() + MINUTE
	while not ClassDB.class_exists(A_CLASS) and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame
	if not ClassDB.class_exists(A_CLASS):
		return "its classes are not there after a minute"
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	await _wait(60)
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	await _wait(60)
	return "" if _has_dock() else "there is no dock"


## The library is missing: only what is said matters, which the log tells.
func _missing() -> String:
	await _wait(60)
	return "" if not ClassDB.class_exists(A_CLASS) else "the library is there"


func _copy(from: String, to: String) -> void:
	DirAccess.make_dir_recursive_absolute(to)
	for file in DirAccess.get_files_at(from):
		DirAccess.copy_absolute(from.path_join(file), to.path_join(file))
	for folder in DirAccess.get_directories_at(from):
		_copy(from.path_join(folder), to.path_join(folder))
