@tool
extends RefCounted
## Saves the painted map of a field as files in tiles, which version control can merge. From then on
## the scene references them, and saving the scene writes the changed tiles.

const FileNames := preload("../actions/file_names.gd")
const ProjectFiles := preload("../actions/project_files.gd")
const MapTiles := preload("../../maps/map_tiles.gd")
const Translations := preload("../translations/translations.gd")

var _undo: EditorUndoRedoManager
var _dialog: EditorFileDialog
var _field: PlantField3D


func setup(undo: EditorUndoRedoManager) -> void:
	_undo = undo


func close() -> void:
	if _dialog:
		_dialog.queue_free()
	_dialog = null


## True if the map of [param field] exists and is not in tiles.
static func is_possible(field: PlantField3D) -> bool:
	return field.map != null and field.map.resource_path.get_extension() != MapTiles.EXTENSION


## Opens a dialog for the files of the map of [param field].
func choose_file(field: PlantField3D) -> void:
	_field = field
	if not _dialog:
		_dialog = EditorFileDialog.new()
		_dialog.set_translation_domain(Translations.DOMAIN)
		_dialog.file_mode = EditorFileDialog.FILE_MODE_SAVE_FILE
		_dialog.access = EditorFileDialog.ACCESS_RESOURCES
		_dialog.title = Translations.text("Save Map in Tiles")
		_dialog.add_filter("*." + MapTiles.EXTENSION, Translations.text("Plant Map"))
		_dialog.file_selected.connect(save)
		EditorInterface.get_base_control().add_child(_dialog)
	_dialog.current_file = "%s.%s" % [FileNames.to_stem(field.name), MapTiles.EXTENSION]
	_dialog.popup_file_dialog()


## Saves the map to the index [param path] and the folder of its tiles. One step of undo.
func save(path: String) -> void:
	if not is_instance_valid(_field) or not _field.map:
		return
	var map := _field.map
	var before := map.resource_path
	var problem := ProjectFiles.find_problem(path)
	if problem.is_empty():
		map.take_over_path(path)  # Before the save, so that the map knows its files.
		problem = ProjectFiles.save(map, path)
	if not problem.is_empty():
		map.resource_path = before
		EditorInterface.get_editor_toaster().push_toast(problem, EditorToaster.SEVERITY_ERROR)
		return
	_undo.create_action(Translations.text("Save Map in Tiles"), UndoRedo.MERGE_DISABLE, _field)
	_undo.add_do_method(map, &"take_over_path", path)
	_undo.add_undo_property(map, &"resource_path", before)
	_undo.commit_action()
	ProjectFiles.announce_all()
	var message := Translations.text("The map is saved in %s, with one file for each painted tile.")
	var folder := path.get_base_dir().path_join(MapTiles.folder_of(path))
	EditorInterface.get_editor_toaster().push_toast(message % folder)
