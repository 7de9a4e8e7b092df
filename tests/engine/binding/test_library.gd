## The library as a whole: its registered classes, the view from C++, and reloading.
extends "res://tests/engine/harness.gd"

const FOLDER := "user://probe_reload"
const PROJECT := 'config_version=5\n\n[application]\n\nconfig/name="Reload"\n'
const RELOAD_SCRIPT := "res://tests/engine/binding/reload_in_editor.gd"


func test_classes_are_registered_by_their_kind() -> void:
	check(ClassDB.can_instantiate("ProbeResource"), "a plain class")
	check(not ClassDB.can_instantiate("ProbeAbstract"), "an abstract class")
	check(ClassDB.can_instantiate("ProbeRuntime"), "a class for running projects")
	check(not ClassDB.can_instantiate("ProbeInternal"), "an internal class, for scripts")
	check_equal(ClassDB.get_parent_class("ProbeDerived"), &"ProbeNode")


func test_a_runtime_class_is_real_in_a_running_project() -> void:
	var node := ProbeRuntime.new()
	check(node.is_real(), "its method was called")
	node.free()


func test_a_method_that_this_engine_lacks_is_named() -> void:
	check_equal(ProbeChecks.call_missing_method(), "")
	check_error("photosynthesize")
	if ProbeChecks.is_bundled_binding():
		check_error('"mb" is null')  # The engine's own error text names no object.


func test_a_singleton_answers() -> void:
	check(Engine.has_singleton("ProbeServer"), "registered")
	check_equal(Engine.get_singleton("ProbeServer").call("answer"), 42)


func test_strings_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_strings(), PackedStringArray())


func test_arrays_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_arrays(), PackedStringArray())


func test_math_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_math(), PackedStringArray())


func test_variants_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_variants(), PackedStringArray())


func test_objects_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_objects(), PackedStringArray())


func test_engine_classes_in_c_plus_plus() -> void:
	check_equal(ProbeChecks.new().check_engine(), PackedStringArray())


## Only an editor reloads libraries. So another engine does it in a project of its own, because an
## editor writes files into its project.
func test_objects_outlive_a_reload_of_the_library() -> void:
	var folder := ProjectSettings.globalize_path(FOLDER)
	DirAccess.make_dir_recursive_absolute(folder + "/.godot")
	for file: String in ["probe.gdextension", "libprobe.so"]:
		DirAccess.copy_absolute("res://probe/" + file, folder + "/" + file)
	DirAccess.copy_absolute(RELOAD_SCRIPT, folder + "/reload_in_editor.gd")
	_write(folder + "/project.godot", PROJECT)
	_write(folder + "/.godot/extension_list.cfg", "res://probe.gdextension\n")
	var output: Array = []
	var words := ["--headless", "--editor", "--path", folder, "--script", "reload_in_editor.gd"]
	var status := OS.execute(engine_path(), words, output, true)
	var text: String = output[0]
	check_equal(status, 0, "exit status")
	check(text.contains("3 reloads passed"), "the other engine said: " + text.right(2000))


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
