## The library reloaded while plants exist in the tree, as when it is compiled with an open editor.
##
## The engine reloads libraries in the editor only. An editor without a window runs the checks of
## hot_reload/plugin.gd in a project of its own.
extends "res://tests/engine/harness.gd"

const FOLDER := "user://hot_reload_project"
const PLUGIN := "res://tests/engine/hot_reload/"
const SHADERS := "addons/undergrowth/shaders"
const PROJECT := """config_version=5

[editor_plugins]

enabled=PackedStringArray("res://addons/hot_reload/plugin.cfg")
"""
## Frames after which the editor ends in any case.
const PATIENCE := "20000"

var _output := ""


func test_plants_and_resources_survive_reloads_of_the_library() -> void:
	if not _make_project():
		return
	var words: PackedStringArray = ["--headless", "--editor", "--quit-after", PATIENCE]
	words.append_array(["--path", ProjectSettings.globalize_path(FOLDER)])
	var lines: Array = []
	var status := OS.execute(engine_path(), words, lines, true)
	_output = "\n".join(lines)
	check_equal(status, 0, "exit status of the editor")
	_check_results()
	_check_complaints()
	_remove(ProjectSettings.globalize_path(FOLDER))


func _check_results() -> void:
	var results: PackedStringArray = []
	for line in _output.split("\n"):
		if line.begins_with("result "):
			results.append(line.trim_prefix("result ").strip_edges())
	for result in results:
		check(not result.ends_with("does not hold"), result)
	var last := results[-1] if results.size() > 0 else "nothing"
	check_equal(last, "end", "last result of " + _output.right(2000))


func _check_complaints() -> void:
	for line in _output.split("\n"):
		for word: String in ["ERROR:", "WARNING:", "leaked", "still in use"]:
			check(not line.contains(word), line.strip_edges())


## Returns a project with a copy of the library, so that a reload affects no other test.
func _make_project() -> bool:
	var folder := ProjectSettings.globalize_path(FOLDER)
	_remove(folder)
	DirAccess.make_dir_recursive_absolute(folder.path_join("addons/hot_reload"))
	DirAccess.make_dir_recursive_absolute(folder.path_join(".godot"))
	for file: String in ["plugin.cfg", "plugin.gd"]:
		var target := folder.path_join("addons/hot_reload").path_join(file)
		check_equal(DirAccess.copy_absolute(PLUGIN + file, target), OK, "copying " + file)
	_copy_shaders(folder)
	var library := _find_library()
	check(not library.is_empty(), "the extension names a library for this machine")
	if library.is_empty():
		return false
	var copy := "res://" + library.get_file()
	check_equal(DirAccess.copy_absolute(library, folder.path_join(library.get_file())), OK, "copy")
	_write(folder.path_join("project.godot"), PROJECT)
	_write(
		folder.path_join("undergrowth.gdextension"),
		(
			'[configuration]\nentry_symbol = "undergrowth_init"\ncompatibility_minimum = "4.5"\n'
			+ 'reloadable = true\n[libraries]\n%s = "%s"\n' % [OS.get_name().to_lower(), copy]
		)
	)
	_write(folder.path_join(".godot/extension_list.cfg"), "res://undergrowth.gdextension\n")
	return true


func _copy_shaders(folder: String) -> void:
	DirAccess.make_dir_recursive_absolute(folder.path_join(SHADERS))
	for file in DirAccess.get_files_at("res://" + SHADERS):
		var target := folder.path_join(SHADERS).path_join(file)
		check_equal(DirAccess.copy_absolute("res://" + SHADERS.path_join(file), target), OK, file)


## Returns the library file that the running engine has loaded.
func _find_library() -> String:
	for extension in GDExtensionManager.get_loaded_extensions():
		var settings := ConfigFile.new()
		settings.load(extension)
		if settings.get_value("configuration", "entry_symbol", "") != "undergrowth_init":
			continue
		for features in settings.get_section_keys("libraries"):
			if _fits(features):
				var path: String = settings.get_value("libraries", features)
				var whole := (
					path if path.is_absolute_path() else extension.get_base_dir().path_join(path)
				)
				return ProjectSettings.globalize_path(whole)
	return ""


func _fits(features: String) -> bool:
	for feature in features.split("."):
		if not OS.has_feature(feature):
			return false
	return true


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	check(file != null, "writing " + path)
	if file:
		file.store_string(text)
		file.close()


func _remove(folder: String) -> void:
	var directory := DirAccess.open(folder)
	if directory == null:
		return
	directory.include_hidden = true
	for file in directory.get_files():
		directory.remove(file)
	for inner in directory.get_directories():
		_remove(folder.path_join(inner))
	DirAccess.remove_absolute(folder)
