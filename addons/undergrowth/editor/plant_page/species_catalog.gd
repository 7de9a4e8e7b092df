@tool
extends Node
## Finds every species: the library's, and the project's own scripts and resources.
##
## A file is only read from the editor's own index; nothing is loaded. The search goes on for a few
## milliseconds a frame and begins anew whenever files change.

## The list is complete and differs from the one before.
signal changed

const SpeciesEntry := preload("species_entry.gd")
const BASE_CLASS := &"PlantFunction"
## The ready species of the thesis in its order; what the library has besides follows.
const FIRST_READY: Array[String] = [
	"GrassFunction", "ReedFunction", "CattailFunction", "TulipFunction", "BellflowerFunction"
]
const LAST_READY := "CurvePlantFunction"
const SCRIPT_TYPES: Array[StringName] = [&"GDScript", &"CSharpScript"]
const SEARCH_USEC_PER_FRAME := 4000

## The library's species.
var ready_species: Array[SpeciesEntry] = []
## The project's own, by path.
var project_species: Array[SpeciesEntry] = []

var _waiting: PackedStringArray = []
var _found: Array[SpeciesEntry] = []
var _script_bases: Dictionary[String, String] = {}


func _ready() -> void:
	set_process(false)


## Begins to look, and keeps the lists current from now on.
func start() -> void:
	_collect_ready()
	var files := EditorInterface.get_resource_filesystem()
	files.filesystem_changed.connect(search)
	files.script_classes_updated.connect(search)
	search()


## Looks through all folders anew.
func search() -> void:
	if EditorInterface.get_resource_filesystem().is_scanning():
		return  # It ends with filesystem_changed.
	_waiting = ["res://"]
	_found = []
	_script_bases.clear()
	for global: Dictionary in ProjectSettings.get_global_class_list():
		_script_bases[global["class"]] = global["base"]
	set_process(true)


func _process(_delta: float) -> void:
	var begin := Time.get_ticks_usec()
	var files := EditorInterface.get_resource_filesystem()
	while not _waiting.is_empty():
		var folder := files.get_filesystem_path(_waiting[-1])
		_waiting.remove_at(_waiting.size() - 1)
		if folder:
			_search_folder(folder)
		if Time.get_ticks_usec() - begin > SEARCH_USEC_PER_FRAME:
			return
	set_process(false)
	_finish()


func _search_folder(folder: EditorFileSystemDirectory) -> void:
	for i in folder.get_subdir_count():
		_waiting.append(folder.get_subdir(i).get_path())
	for i in folder.get_file_count():
		var type := folder.get_file_type(i)
		var is_script := type in SCRIPT_TYPES
		var script_class := folder.get_file_script_class_name(i)
		var base := folder.get_file_script_class_extends(i) if is_script else String(type)
		if _is_species(base):
			_found.append(SpeciesEntry.from_file(folder.get_file_path(i), is_script, script_class))


func _is_species(class_title: String) -> bool:
	for i in _script_bases.size() + 1:
		if not _script_bases.has(class_title):
			break
		class_title = _script_bases[class_title]
	return ClassDB.class_exists(class_title) and ClassDB.is_parent_class(class_title, BASE_CLASS)


func _finish() -> void:
	_found.sort_custom(func(a: SpeciesEntry, b: SpeciesEntry) -> bool: return a.key < b.key)
	if _fingerprint(_found) == _fingerprint(project_species):
		return
	project_species = _found
	changed.emit()


func _fingerprint(entries: Array[SpeciesEntry]) -> Array:
	return entries.map(func(entry: SpeciesEntry) -> Array: return [entry.key, entry.stamp])


func _collect_ready() -> void:
	var classes := FIRST_READY.duplicate()
	for other in ClassDB.get_inheriters_from_class(BASE_CLASS):
		if other not in classes and other != LAST_READY and ClassDB.can_instantiate(other):
			classes.append(other)
	classes.append(LAST_READY)
	for title in classes:
		if ClassDB.class_exists(title):
			ready_species.append(SpeciesEntry.ready_species(title))
	changed.emit()
