@tool
extends "editor_test.gd"
## Species with errors: the dock shows the solution, the last valid plant, and stays responsive.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const FILE := "res://faulty_species.gd"
const OTHER_FILE := "res://renamed_species.gd"
const HEAD := "extends PlantFunction\n@export var breadth := 0.4\n\n"
const METHOD := "func _calculate_curve_point(_offset: float) -> float:\n\treturn "
const GOOD := "@tool\n" + HEAD + METHOD + "breadth\n"
const NOT_TOOL := HEAD + METHOD + "breadth\n"
const SYNTAX_ERROR := "@tool\n" + HEAD + METHOD + "breadth +\n"
const WRONG_VALUE := "@tool\n" + HEAD + METHOD + "-3.0\n"

# Time of a script's last change, in whole seconds.
var _written := 0


func test_script_without_tool_is_explained() -> void:
	await choose_tile("Tulip")
	await _write(FILE, NOT_TOOL)
	await _choose(FILE)
	_check_status("@tool")
	check(not _state().function.get_script(), "the species before stays chosen")
	await _remove(FILE)


func test_syntax_error_is_explained() -> void:
	await _write(FILE, SYNTAX_ERROR)
	await _choose(FILE)
	_check_status("mend it")
	check_error("arse")
	await _remove(FILE)


func test_wrong_value_is_explained() -> void:
	await _write(FILE, WRONG_VALUE)
	await _choose(FILE)
	_check_status("_calculate_curve_point(")
	await double_click(tiles(), place_of_tile(find_key(FILE)))
	await open_inspector()
	var hint := preview_part("Hint") as Label
	check(hint.is_visible_in_tree(), "the preview says why it is empty")
	await take_picture("fault")
	await _remove(FILE)


func test_script_that_breaks_while_chosen() -> void:
	await _write(FILE, GOOD)
	await _choose(FILE)
	check_equal(_state().path, FILE, "path")
	var function := _state().function
	function.set("breadth", 0.7)
	await _write(FILE, SYNTAX_ERROR)
	_check_status("mend it")
	check_error("arse")
	await _write(FILE, GOOD)
	check_equal((part("Status/Text") as Label).text, "", "status")
	check(_state().function == function, "the plant is the same object")
	check_equal(function.get("breadth"), 0.7, "its property")
	await _remove(FILE)
	_check_status(FILE)


func test_script_that_is_renamed_while_chosen() -> void:
	await _write(FILE, GOOD)
	await _choose(FILE)
	var folder := ProjectSettings.globalize_path("res://")
	DirAccess.rename_absolute(folder + FILE.get_file(), folder + OTHER_FILE.get_file())
	DirAccess.rename_absolute(
		folder + FILE.get_file() + ".uid", folder + OTHER_FILE.get_file() + ".uid"
	)
	await _scan()
	check(_state().function != null, "the plant stays")
	await _choose(OTHER_FILE)
	check_equal(_state().path, OTHER_FILE, "path")
	await _remove(OTHER_FILE)


func _state() -> EditorState:
	return dock().get("state")


func _check_status(text: String) -> void:
	var shown := (part("Status/Text") as Label).text
	check(shown.contains(text), 'the status line has "%s": %s' % [text, shown])


func _write(path: String, text: String) -> void:
	# The editor compares file times in whole seconds. Its cache is one scan behind and may still
	# contain a removed file, so that it would miss the .uid of its successor.
	while Time.get_unix_time_from_system() < _written + 1.1:
		await frames(1)
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
	_written = FileAccess.get_modified_time(path)
	await _scan()


func _remove(path: String) -> void:
	for file: String in [path, path + ".uid"]:
		DirAccess.remove_absolute(ProjectSettings.globalize_path(file))
	await _scan()


func _scan() -> void:
	await files_are_known()
	EditorInterface.get_resource_filesystem().scan()
	await files_are_known()
	await frames(20)


func _choose(path: String) -> void:
	await open_panel()
	check(find_key(path) >= 0, path + " is in the list")
	if find_key(path) >= 0:
		await click_tile(find_key(path))
