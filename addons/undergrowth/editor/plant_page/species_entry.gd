@tool
extends RefCounted
## One species of the list: a ready one of the add-on, a script, or a resource of the project.

enum Kind { READY, SCRIPT, RESOURCE }

const CLASS_ENDING := "Function"
const TOOL_MARK := "@tool"
const CURVES_CLASS := "CurvePlantFunction"

var kind := Kind.READY
## The class of a ready species, the path of the others.
var key := ""
var title := ""
## When the file was last written; a thumbnail is good for one stamp.
var stamp := 0


static func ready_species(native_class: String) -> RefCounted:
	var entry := new()
	entry.key = native_class
	entry.title = native_class.trim_suffix(CLASS_ENDING).capitalize()
	if native_class == CURVES_CLASS:
		entry.title = "Curves"
	return entry


static func from_file(path: String, is_script: bool, script_class: String) -> RefCounted:
	var entry := new()
	entry.kind = Kind.SCRIPT if is_script else Kind.RESOURCE
	entry.key = path
	var named := script_class if is_script and not script_class.is_empty() else _file_title(path)
	entry.title = named.trim_suffix(CLASS_ENDING).capitalize()
	entry.stamp = FileAccess.get_modified_time(path)
	return entry


## The file it comes from; nothing for a ready species.
func get_path() -> String:
	return "" if kind == Kind.READY else key


## The species, or null and in [method explain_failure] why.
func instantiate() -> PlantFunction:
	match kind:
		Kind.READY:
			return _instantiate_ready()
		Kind.SCRIPT:
			return _load_script().call(&"new") as PlantFunction if refresh() else null
		_:
			return _load_file() as PlantFunction


## Takes over what was written into the file of a script since it was loaded; false where the script
## cannot run.
func refresh() -> bool:
	var script := _load_script()
	if not script:
		return false
	var text := FileAccess.get_file_as_string(key)
	if script is GDScript and script.source_code != text:
		script.source_code = text
		script.reload(true)
	return script.can_instantiate()


## Why [method instantiate] gave nothing, and what to do.
func explain_failure(translator: Object) -> String:
	if not FileAccess.file_exists(key):
		return translator.tr("%s is gone. Choose another species.") % key
	if kind == Kind.RESOURCE:
		return translator.tr("%s holds no plant. See the output below for what is wrong.") % key
	var script := _load_script()
	if script is GDScript and not script.source_code.contains(TOOL_MARK):
		return translator.tr("%s cannot run in the editor. Begin it with @tool.") % key
	return translator.tr("%s has an error. Open it in the script editor and mend it.") % key


static func _file_title(path: String) -> String:
	return path.get_file().get_basename()


func _instantiate_ready() -> PlantFunction:
	var function := ClassDB.instantiate(key) as PlantFunction
	var curves := function as CurvePlantFunction
	if curves and not curves.width_curve and not curves.color_gradient:
		curves.width_curve = _leaf_curve()
		curves.color_gradient = _leaf_gradient()
	return function


func _load_file() -> Resource:
	return ResourceLoader.load(key) if ResourceLoader.exists(key) else null


func _load_script() -> Script:
	return _load_file() as Script


## Something to start drawing from: a leaf.
func _leaf_curve() -> Curve:
	var curve := Curve.new()
	curve.add_point(Vector2(0.0, 0.35), 0.0, 1.0)
	curve.add_point(Vector2(0.45, 1.0))
	curve.add_point(Vector2(1.0, 0.0), -2.5, 0.0)
	return curve


func _leaf_gradient() -> Gradient:
	var gradient := Gradient.new()
	gradient.colors = PackedColorArray([Color("3b6e22"), Color("a9c95b")])
	return gradient
