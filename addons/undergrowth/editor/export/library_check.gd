@tool
extends EditorExportPlugin
## Reports at the start of an export that the add-on has no library for the game. The engine omits a
## missing library without a message.

const EXTENSION := "undergrowth.gdextension"
const SECTION := "libraries"
const UNIVERSAL := "universal"
const ARCHITECTURES: Array[String] = ["x86_64", "arm64", "x86_32", "arm32", "rv64", "wasm32"]

var _folder := ""


## [param folder] is the add-on's.
func setup(folder: String) -> void:
	_folder = folder


func _get_name() -> String:
	return "Undergrowth"


func _export_begin(
	features: PackedStringArray, _is_debug: bool, _path: String, _flags: int
) -> void:
	for fault in find_faults(features):
		get_export_platform().add_message(
			EditorExportPlatform.EXPORT_MESSAGE_ERROR, "Undergrowth", fault
		)


## Returns one sentence for each library that an export with these [param features] lacks.
func find_faults(features: PackedStringArray) -> PackedStringArray:
	var faults: PackedStringArray = []
	var list := ConfigFile.new()
	if list.load(_folder.path_join(EXTENSION)) != OK:
		return faults
	for architecture in _architectures(features):
		var fault := _fault_of(_find_library(list, features, architecture), features)
		if not fault.is_empty() and fault not in faults:
			faults.append(fault)
	return faults


func _fault_of(library: String, features: PackedStringArray) -> String:
	if library.is_empty():
		return (
			"There is no library for this platform (%s): the game will have no plants."
			% ", ".join(features)
		)
	if FileAccess.file_exists(library):
		return ""
	return (
		("%s is missing: the game will have no plants. " % library)
		+ "Install the whole release of the add-on, or build this library with "
		+ "./run build %s." % _build_options(library.get_file())
	)


# The name of a library is libundergrowth.PLATFORM.TARGET.ARCH and the file's type.
func _build_options(file: String) -> String:
	var parts := file.split(".")
	var options := "platform=%s arch=%s target=%s" % [parts[1], parts[3], parts[2]]
	return options + (" threads=no" if "nothreads" in parts else "")


# An export for macOS is for both processors or for one.
func _architectures(features: PackedStringArray) -> Array[String]:
	if UNIVERSAL in features:
		return ARCHITECTURES.slice(0, 2)
	return ARCHITECTURES.filter(func(name: String) -> bool: return name in features)


# The engine's rule: all words of a key are features of the export. A key without an architecture is
# for all of them.
func _find_library(list: ConfigFile, features: PackedStringArray, architecture: String) -> String:
	for key in list.get_section_keys(SECTION):
		var words := Array(key.split("."))
		var holds := func(word: String) -> bool:
			return word == architecture or (word in features and word not in ARCHITECTURES)
		if words.all(holds):
			return _folder.path_join(list.get_value(SECTION, key))
	return ""
