@tool
extends RefCounted
## One entry of the list: a species or a mix of the add-on, a class of the library, or a script or a
## resource of the project.

enum Kind { CLASS, SCRIPT, RESOURCE, MIX }

const FirstDrawing := preload("../inspector/first_drawing.gd")
const CLASS_ENDING := "Function"
const TOOL_MARK := "@tool"
const FIELD_CLASS := &"PlantField3D"
const CURVES_CLASS := "CurvePlantFunction"
const CURVES_TITLE := "Own Drawing"
## Start of the main resource in a text file. Sub-resources are above it.
const MAIN_PART := "\n[resource]\n"
const NAME_LINE := '(?m)^resource_name = "(.+)"$'

var kind := Kind.CLASS
## Class of a species of the library, or path of any other entry.
var key := ""
var title := ""
## Time of the file's last change. A thumbnail is valid for one time.
var stamp := 0
## True if it ships with the add-on. Changes in the dock stay in the dock until they are saved.
var is_ready := false


static func from_class(native_class: String) -> RefCounted:
	var entry := new()
	entry.key = native_class
	entry.title = native_class.trim_suffix(CLASS_ENDING).capitalize()
	entry.is_ready = true
	if native_class == CURVES_CLASS:
		entry.title = CURVES_TITLE
	return entry


static func from_file(path: String, is_script: bool, script_class: String) -> RefCounted:
	var entry := new()
	entry.kind = Kind.SCRIPT if is_script else Kind.RESOURCE
	entry.key = path
	if not is_script:
		entry.title = _to_title(_name_within(path))
	if entry.title.is_empty():
		var named := _file_title(path) if script_class.is_empty() else script_class
		entry.title = named.trim_suffix(CLASS_ENDING).capitalize()
	entry.stamp = FileAccess.get_modified_time(path)
	return entry


## Creates an entry for a species or a mix in a file of the add-on.
static func from_ready_file(path: String, kind_of_file: Kind) -> RefCounted:
	var entry := new()
	entry.kind = kind_of_file
	entry.key = path
	entry.is_ready = true
	entry.title = find_title(path)
	entry.stamp = FileAccess.get_modified_time(path)
	return entry


## Returns the title of a species or a mix in a file of the add-on.
static func find_title(path: String) -> String:
	var title_within := _name_within(path)
	if not title_within.is_empty():
		return _to_title(title_within)
	return _to_title(_file_title(path).replace("_", " "))


## Returns the title of a species outside of the list: its own name, or that of its file, script or
## class.
static func title_of(function: PlantFunction) -> String:
	if function.resource_name:
		return _to_title(function.resource_name)
	var script := function.get_script() as Script
	if not function.is_built_in():
		return find_title(function.resource_path)
	if script and script.get_global_name():
		return String(script.get_global_name()).trim_suffix(CLASS_ENDING).capitalize()
	if script and script.resource_path:
		return _file_title(script.resource_path).capitalize()
	return from_class(function.get_class()).title


## Returns its file in the project, or an empty text for entries of the add-on.
func get_path() -> String:
	return "" if is_ready else key


## Returns the species, or null with the reason in [method explain_failure]. A ready species is a
## copy.
func instantiate() -> PlantFunction:
	match kind:
		Kind.CLASS:
			return _instantiate_class()
		Kind.SCRIPT:
			return _load_script().call(&"new") as PlantFunction if refresh() else null
		Kind.RESOURCE:
			var function := _load_file() as PlantFunction
			return function.duplicate(true) if function and is_ready else function
		_:
			return null


## Returns the file of the add-on that [method instantiate] copies, or null.
func get_origin() -> PlantFunction:
	return _load_file() as PlantFunction if is_ready and kind == Kind.RESOURCE else null


## Returns the scene of a mix, or null if this is no mix or the root of its scene is no field.
func load_mix() -> PackedScene:
	var scene := _load_file() as PackedScene if kind == Kind.MIX else null
	return scene if scene and scene.get_state().get_node_type(0) == FIELD_CLASS else null


## Returns the subject of its picture, or null: a species, or a field that the caller frees.
func make_sitter() -> Object:
	var scene := load_mix()
	return scene.instantiate() if scene else instantiate()


## Reloads a script's file after a change. Returns false if the script cannot run.
func refresh() -> bool:
	var script := _load_script()
	if not script:
		return false
	var text := FileAccess.get_file_as_string(key)
	if script is GDScript and script.source_code != text:
		script.source_code = text
		script.reload(true)
	return script.can_instantiate()


## Returns the reason of a failed [method instantiate] and its solution.
func explain_failure(translator: Object) -> String:
	if not FileAccess.file_exists(key):
		return translator.tr("%s is gone. Choose another species.") % key
	if kind != Kind.SCRIPT:
		return translator.tr("%s holds no plant. See the output below for what is wrong.") % key
	var script := _load_script()
	if script is GDScript and not script.source_code.contains(TOOL_MARK):
		return translator.tr("%s cannot run in the editor. Begin it with @tool.") % key
	return translator.tr("%s has an error. Open it in the script editor and mend it.") % key


# Capitalises each word, as the editor's texts do. A word with a hyphen is one word.
static func _to_title(words: String) -> String:
	var capitalised: PackedStringArray = []
	for word in words.split(" ", false):
		capitalised.append(word.left(1).to_upper() + word.substr(1))
	return " ".join(capitalised)


static func _file_title(path: String) -> String:
	return path.get_file().get_basename()


# Reads the name of a text resource without loading it.
static func _name_within(path: String) -> String:
	if path.get_extension() != "tres":
		return ""
	var text := FileAccess.get_file_as_string(path)
	var begin := text.rfind(MAIN_PART)
	if begin < 0:
		return ""
	var found := RegEx.create_from_string(NAME_LINE).search(text, begin + MAIN_PART.length() - 1)
	return found.get_string(1).c_unescape() if found else ""


func _instantiate_class() -> PlantFunction:
	var function := ClassDB.instantiate(key) as PlantFunction
	var curves := function as CurvePlantFunction
	if curves and FirstDrawing.is_missing(curves):
		curves.width_curve = FirstDrawing.make_curve()
		curves.color_gradient = FirstDrawing.make_gradient()
	return function


func _load_file() -> Resource:
	return ResourceLoader.load(key) if ResourceLoader.exists(key) else null


func _load_script() -> Script:
	return _load_file() as Script
