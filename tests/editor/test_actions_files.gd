@tool
extends "actions_test.gd"
## Species in files of the project: saved from the dock, and new scripts.

const FileNames := preload("res://addons/undergrowth/editor/actions/file_names.gd")
const SCENE := "res://actions_files_scene.tscn"
const SAVED := "res://my species/Ševar vlažni.tres"
const BLOCKER := "res://not_a_folder"
const READ_ONLY := "res://read_only"
const MAY_READ := FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_EXECUTE_OWNER
const NEW_TITLE := "Šaš uz rijeku"
const NEW_SCRIPT := "res://sas_uz_rijeku.gd"
const NEW_CLASS := "SasUzRijekuFunction"


func test_save_as_keeps_edits_and_is_listed() -> void:
	await _choose("Tulip")
	_state().function.natural_frequency = 1.25
	await _use("Save")
	var dialog := _dialog("EditorFileDialog") as EditorFileDialog
	check(dialog != null and dialog.visible, "the file dialog opens")
	check_equal(dialog.current_file, "tulip.tres", "suggested name")
	DirAccess.make_dir_recursive_absolute(SAVED.get_base_dir())
	await _type_into(dialog, dialog.get_line_edit(), SAVED)
	await click(dialog.get_ok_button())
	await frames(3)
	check(FileAccess.file_exists(SAVED), "the file is there: " + _message())
	check_equal(_state().path, SAVED, "it is chosen")
	var read := ResourceLoader.load(SAVED, "", ResourceLoader.CACHE_MODE_IGNORE) as TulipFunction
	check_equal(read.natural_frequency, 1.25, "its frequency")
	check(await until(func() -> bool: return find_key(SAVED) >= 0), "the list finds it")
	check(EditorInterface.get_inspector().get_edited_object() == load(SAVED), "it can be edited")


func test_saving_over_a_species_changes_it_where_it_is_used() -> void:
	var used := load(SAVED) as TulipFunction
	await _choose("Tulip")
	_state().function.natural_frequency = 2.5
	part("Browser/Actions").call(&"save_as", SAVED)
	check_equal(used.natural_frequency, 2.5, "frequency where it was in use")
	check(_state().function == used, "the same is chosen")
	var plant := Plant3D.new()
	plant.species = used
	check(plant.get_mesh() != null, "it can be drawn")
	plant.free()


func test_write_errors_are_reported_and_nothing_is_lost() -> void:
	_write(BLOCKER, "keep me")
	await _choose("Reed")
	var function := _state().function
	for path: String in [BLOCKER + "/reed.tres", "/proc/reed.tres", "user://reed.tres"]:
		part("Browser/Actions").call(&"save_as", path)
		check(
			_message().length() > 20 and not FileAccess.file_exists(path), path + ": " + _message()
		)
	check(_state().function == function, "the species is still chosen")
	check_equal(FileAccess.get_file_as_string(BLOCKER), "keep me", "the file in the way")
	await _check_read_only_folder()


func test_new_species_is_written_opened_and_chosen() -> void:
	await click(part("Browser/List/New") as Control)
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	check(dialog.get_ok_button().disabled, "nothing to create without a name")
	var title := dialog.get_node("%Title") as LineEdit
	await _type_into(dialog, title, "9 lives")
	check(dialog.get_ok_button().disabled, "a class does not begin with a digit")
	check(_hint(dialog).contains("letter"), "and the dialog says so: " + _hint(dialog))
	await _type_into(dialog, title, "Grass")
	check(dialog.get_ok_button().disabled and _hint(dialog).contains("GrassFunction"), "taken name")
	await _type_into(dialog, title, NEW_TITLE)
	await take_dialog_picture(dialog, "new_species")
	await click(dialog.get_ok_button())
	await frames(10)
	check(not dialog.visible, "the dialog closes: " + _hint(dialog))
	check(FileAccess.file_exists(NEW_SCRIPT), "the script is there")
	check_equal(_state().path, NEW_SCRIPT, "it is chosen")
	check_equal(_state().problem, "", "its problem")
	var open := EditorInterface.get_script_editor().get_current_script()
	check(open and open.resource_path == NEW_SCRIPT, "it is open in the script editor")
	var source := FileAccess.get_file_as_string(NEW_SCRIPT)
	check(source.contains("class_name " + NEW_CLASS), "its class")
	check(await until(func() -> bool: return find_key(NEW_SCRIPT) >= 0), "the list finds it")


func test_a_second_species_of_that_name_is_refused() -> void:
	await click(part("Browser/List/New") as Control)
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, NEW_TITLE)
	check(dialog.get_ok_button().disabled, "it cannot be created")
	check(_hint(dialog).contains("exists"), "the dialog says why: " + _hint(dialog))
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, "Other")
	var path := dialog.get_node("%Folder").get_node("%Path") as LineEdit
	await _type_into(dialog, path, BLOCKER)
	await click(dialog.get_ok_button())
	await frames(3)
	check(dialog.visible and _hint(dialog).contains(BLOCKER), "it stays open: " + _hint(dialog))
	check(_message().contains(BLOCKER), "the status line says it, too: " + _message())
	await click(dialog.get_cancel_button())


func test_a_species_of_one_s_own_goes_into_the_scene() -> void:
	var garden := Node3D.new()
	garden.name = "Garden"
	await _open_scene(SCENE, garden)
	var root := EditorInterface.get_edited_scene_root()
	_select([root])
	await open_panel()
	await click_tile(find_key(NEW_SCRIPT))
	check_equal(_state().path, NEW_SCRIPT, "chosen species")
	await _use("Add")
	var plant := root.get_child(-1) as Plant3D
	check(plant.species.get_script() == load(NEW_SCRIPT), "its script")
	check(plant.get_mesh() != null, "its mesh")
	await undo()


func test_names_become_files_and_classes() -> void:
	check_equal(FileNames.to_stem("  Šaš uz rijeku / no. 2 "), "sas_uz_rijeku_no_2", "stem")
	check_equal(FileNames.to_stem('a:b*c?"<>|'), "a_b_c", "stem without illegal characters")
	check_equal(FileNames.to_stem("..."), "", "stem of nothing")
	check_equal(FileNames.to_stem("Straße"), "strasse", "stem of a sharp s")
	check_equal(FileNames.to_stem("芦苇"), "芦苇", "stem of another script")
	check_equal(FileNames.to_class_title("marsh Sedge"), "MarshSedgeFunction", "class")
	check_equal(FileNames.to_class_title("FoxtailFunction"), "FoxtailFunction", "class as typed")
	check_equal(FileNames.to_node_name("a.b:c/d"), "ABCD", "node")
	check_equal(FileNames.to_node_name("meadow grass"), "MeadowGrass", "node of a species")


## A folder without write permission. With root permissions it is writable nevertheless.
func _check_read_only_folder() -> void:
	DirAccess.make_dir_recursive_absolute(READ_ONLY)
	var real := ProjectSettings.globalize_path(READ_ONLY)
	FileAccess.set_unix_permissions(real, MAY_READ)
	var path := READ_ONLY.path_join("reed.tres")
	var may_write := FileAccess.open(path, FileAccess.WRITE) != null
	DirAccess.remove_absolute(path)
	part("Browser/Actions").call(&"save_as", path)
	check(_message().begins_with("Saved" if may_write else "Cannot write"), _message())
	check(_message().contains(path), "the file is named: " + _message())
	FileAccess.set_unix_permissions(real, MAY_READ | FileAccess.UNIX_WRITE_OWNER)
