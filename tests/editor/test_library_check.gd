@tool
extends "editor_test.gd"
## What an export reports of libraries that the add-on lacks.

const LibraryCheck := preload("res://addons/undergrowth/editor/export/library_check.gd")
const LIST := "res://addons/undergrowth/undergrowth.gdextension"
const FOLDER := "user://library_check"
const MACOS: PackedStringArray = ["macos", "release", "template_release"]


func test_a_missing_library_of_macs_is_reported_once() -> void:
	_make_folder()
	for architectures: PackedStringArray in [["universal"], ["x86_64"], ["arm64"]]:
		var faults := _faults(MACOS + architectures)
		check_equal(faults.size(), 1, "faults for " + architectures[0])
		if faults.size() == 1:
			check(faults[0].contains("macos.template_release.universal.dylib"), faults[0])
			check(faults[0].contains("arch=universal target=template_release."), faults[0])


func test_one_library_is_for_both_processors() -> void:
	_make_folder()
	_write("bin/libundergrowth.macos.template_release.universal.dylib", "")
	for architectures: PackedStringArray in [["universal"], ["x86_64"], ["arm64"]]:
		check_equal(_faults(MACOS + architectures), PackedStringArray(), architectures[0])


func test_the_library_of_the_processor_is_reported() -> void:
	_make_folder()
	var faults := _faults(["linux", "debug", "template_debug", "arm64"])
	check_equal(faults.size(), 1, "faults")
	check(faults[0].contains("arch=arm64 target=template_debug."), faults[0])
	faults = _faults(["linux", "debug", "template_debug", "rv64"])
	check(faults[0].begins_with("There is no library for this platform"), faults[0])


func _faults(features: PackedStringArray) -> PackedStringArray:
	var library_check := LibraryCheck.new()
	library_check.setup(FOLDER)
	return library_check.find_faults(features)


## A folder with the list of libraries, and without libraries.
func _make_folder() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER.path_join("bin"))
	for file in DirAccess.get_files_at(FOLDER.path_join("bin")):
		DirAccess.remove_absolute(FOLDER.path_join("bin").path_join(file))
	_write("undergrowth.gdextension", FileAccess.get_file_as_string(LIST))


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(FOLDER.path_join(path), FileAccess.WRITE)
	file.store_string(text)
