@tool
extends Node
## Finds every species: files and mixes of the add-on, classes of the library, and scripts and
## resources of the project.
##
## It lists the folders of the add-on. Files of the project come from the editor's index, without
## loading them. The search takes a few milliseconds per frame and restarts when files change.

## Emitted when the list is complete and differs from the previous one.
signal changed

const SpeciesEntry := preload("species_entry.gd")
const BASE_CLASS := &"PlantFunction"
## Species of the thesis in its order. Other classes of the library follow.
const FIRST_CLASSES: Array[String] = [
	"GrassFunction", "ReedFunction", "CattailFunction", "TulipFunction", "BellflowerFunction"
]
const LAST_CLASS := "CurvePlantFunction"
## Has no plant before a model is set.
const EMPTY_CLASS := "MeshPlantFunction"
## Added to the editor's folder.
const READY_FOLDER := "species"
const MIXES_FOLDER := "mixes"
## Leaves of climbers, which are no plants by themselves.
const CLIMBERS_FOLDER := "climbers"
const SCRIPT_TYPES: Array[StringName] = [&"GDScript", &"CSharpScript"]
const SEARCH_USEC_PER_FRAME := 4000

## Species that ship with the add-on, and fields of several of them, by title.
var ready_species: Array[SpeciesEntry] = []
var mixes: Array[SpeciesEntry] = []
## Classes of the library: one stem each.
var simple_species: Array[SpeciesEntry] = []
## Species of the project, by path.
var project_species: Array[SpeciesEntry] = []

var _waiting: PackedStringArray = []
var _found: Array[SpeciesEntry] = []
var _script_bases: Dictionary[String, String] = {}


func _ready() -> void:
	set_process(false)


## Starts the search and updates the lists after every change.
func start() -> void:
	_collect_classes()
	_collect_shipped()
	changed.emit()
	var files := EditorInterface.get_resource_filesystem()
	files.filesystem_changed.connect(search)
	files.script_classes_updated.connect(search)
	search()


## Returns the found species, by groups in the order of the list.
func list_groups() -> Array[Array]:
	return [mixes, ready_species, simple_species, project_species]


## Searches all folders again.
func search() -> void:
	if EditorInterface.get_resource_filesystem().is_scanning():
		return  # The scan ends with filesystem_changed.
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
		if folder and not _is_shipped(folder.get_path()):
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
	var before := _fingerprint(ready_species + mixes + project_species)
	project_species = _found
	_collect_shipped()
	if _fingerprint(ready_species + mixes + project_species) != before:
		changed.emit()


func _fingerprint(entries: Array[SpeciesEntry]) -> Array:
	return entries.map(func(entry: SpeciesEntry) -> Array: return [entry.key, entry.stamp])


func _collect_classes() -> void:
	var classes := FIRST_CLASSES.duplicate()
	for other in ClassDB.get_inheriters_from_class(BASE_CLASS):
		var is_known := other in classes or other == LAST_CLASS or other == EMPTY_CLASS
		if not is_known and ClassDB.can_instantiate(other):
			classes.append(other)
	classes.append(LAST_CLASS)
	for title in classes:
		if ClassDB.class_exists(title):
			simple_species.append(SpeciesEntry.from_class(title))


func _collect_shipped() -> void:
	ready_species = _list_files(READY_FOLDER, "tres", SpeciesEntry.Kind.RESOURCE)
	mixes = _list_files(MIXES_FOLDER, "tscn", SpeciesEntry.Kind.MIX)


func _list_files(folder: String, ending: String, kind: SpeciesEntry.Kind) -> Array[SpeciesEntry]:
	var entries: Array[SpeciesEntry] = []
	for file in ResourceLoader.list_directory(_shipped(folder)):
		if file.get_extension() == ending:
			entries.append(SpeciesEntry.from_ready_file(_shipped(folder).path_join(file), kind))
	var is_before := func(a: SpeciesEntry, b: SpeciesEntry) -> bool:
		return a.title.naturalnocasecmp_to(b.title) < 0
	entries.sort_custom(is_before)
	return entries


func _is_shipped(folder: String) -> bool:
	var path := folder.trim_suffix("/")
	return path in [READY_FOLDER, MIXES_FOLDER, CLIMBERS_FOLDER].map(_shipped)


func _shipped(folder: String) -> String:
	var own := (get_script() as Script).resource_path.get_base_dir()
	return own.path_join("../..").simplify_path().path_join(folder)
