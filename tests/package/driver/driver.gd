## Does in a headless editor what somebody does who installs the add-on, as `--scenario=NAME` says
## after `--`, and prints `ok` and `not ok` as the engine tests do. `--from=DIR` has the add-on.
##
## A scenario is a row of steps, and each begins when the editor has been at rest for some frames.
## Nothing waits in between: an editor that imports reloads scripts, and those that wait are lost.
@tool
extends EditorPlugin

const ADDON := "res://addons/undergrowth"
const PLUGIN := "undergrowth"
const A_CLASS := &"PlantField3D"
const FRAMES_OF_REST := 120
const SCENARIOS: Dictionary[String, Array] = {
	"off": [&"_look_for_classes", &"_look_for_no_dock"],
	# The project file of a fresh clone says that the plugin is on.
	"on": [&"_look_for_classes", &"_look_for_dock"],
	"switched":
	[
		&"_switch_on",
		&"_look_for_dock",
		&"_switch_off",
		&"_look_for_no_dock",
		&"_switch_on",
		&"_look_for_dock"
	],
	"copied": [&"_copy_addon", &"_look_for_classes", &"_switch_on", &"_look_for_dock"],
	# What is said then, the log tells.
	"missing": [&"_look_for_no_classes"],
}

var _rested := 0
var _step := 0


func _process(_delta: float) -> void:
	_rested = 0 if EditorInterface.get_resource_filesystem().is_scanning() else _rested + 1
	if _rested < FRAMES_OF_REST:
		return
	_rested = 0
	var scenario := _word("scenario")
	var steps := SCENARIOS[scenario]
	if _step == steps.size():
		get_tree().quit()
		return
	if _step == 0:
		print("start")
	var fault: String = call(steps[_step])
	_step += 1
	if not fault.is_empty():
		print("not ok %s: step %d: %s" % [scenario, _step, fault])
		_step = steps.size()
	elif _step == steps.size():
		print("ok " + scenario)
	if _step == steps.size():
		print("done 1")


func _word(name: String) -> String:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("--%s=" % name):
			return word.get_slice("=", 1)
	return ""


func _look_for_classes() -> String:
	return "" if ClassDB.class_exists(A_CLASS) else "there is no " + A_CLASS


func _look_for_no_classes() -> String:
	return "the library is there" if ClassDB.class_exists(A_CLASS) else ""


func _has_dock() -> bool:
	var base := EditorInterface.get_base_control()
	return not base.find_children("Undergrowth", "EditorDock", true, false).is_empty()


func _look_for_dock() -> String:
	return "" if _has_dock() else "there is no dock"


func _look_for_no_dock() -> String:
	return "there is a dock" if _has_dock() else ""


func _switch_on() -> String:
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	return ""


func _switch_off() -> String:
	EditorInterface.set_plugin_enabled(PLUGIN, false)
	return ""


## A newcomer copies the folder while the project is open.
func _copy_addon() -> String:
	_copy(_word("from"), ADDON)
	EditorInterface.get_resource_filesystem().scan()
	return ""


func _copy(from: String, to: String) -> void:
	DirAccess.make_dir_recursive_absolute(to)
	for file in DirAccess.get_files_at(from):
		DirAccess.copy_absolute(from.path_join(file), to.path_join(file))
	for folder in DirAccess.get_directories_at(from):
		_copy(from.path_join(folder), to.path_join(folder))
