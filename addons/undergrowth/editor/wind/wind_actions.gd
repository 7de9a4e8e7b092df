@tool
extends Node
## The actions of the wind panel: changes the wind of the scene, gives it to all plants, saves it.

const EditorState := preload("../editor_state.gd")
const ProjectFiles := preload("../actions/project_files.gd")
const ScenePlants := preload("scene_plants.gd")

const PROPERTIES: Array[StringName] = [
	&"kind",
	&"strength",
	&"direction",
	&"frequency",
	&"gust_duration",
	&"travel_speed",
	&"speed",
	&"turbulence",
	&"gustiness",
	&"roughness",
	&"canopy_height",
	&"canopy_wave_amount",
	&"wetness",
	&"snow",
	&"rain",
]
const SHIPPED := "res://addons/undergrowth/"
const WARNING := EditorState.Severity.WARNING

var _state: EditorState
var _undo: EditorUndoRedoManager
var _dialog: EditorFileDialog


func setup(state: EditorState, undo: EditorUndoRedoManager) -> void:
	_state = state
	_undo = undo


## Returns the wind that the panel edits: that of the first selected plant, or of the first plant of
## the edited scene if none is selected. Null: no plant has a wind that is saved with the scene, or
## in a file.
static func find_scene_wind() -> PlantWind:
	var root := EditorInterface.get_edited_scene_root()
	for plant in ScenePlants.chosen():
		var wind: PlantWind = plant.get(&"wind")
		if wind and ScenePlants.is_wind_saved(root, wind):
			return wind
	return null


## Sets [param values] of the shown wind, by properties. A change of the scene is a step of undo
## called [param title]. Steps of the same title are merged while a slider is dragged.
func change(values: Dictionary[StringName, Variant], title: String) -> void:
	var wind := _state.wind
	if wind == _state.own_wind:
		for property in values:
			wind.set(property, values[property])
		return
	var root := EditorInterface.get_edited_scene_root()
	if wind.resource_path.begins_with(SHIPPED):
		_replace(root, wind, values)
		return
	_undo.create_action(title, UndoRedo.MERGE_ENDS, root)
	for property in values:
		_undo.add_do_property(wind, property, values[property])
		_undo.add_undo_property(wind, property, wind.get(property))
	_undo.commit_action()


## Sets the shown wind as the wind of all plants of the scene, which share it. One step of undo.
func set_for_scene() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var plants := ScenePlants.all(root)
	if not _may_set(root, plants):
		return
	var is_own := _state.wind == _state.own_wind
	var wind := _state.wind.duplicate() as PlantWind if is_own else _state.wind
	var lacks := func(plant: Node3D) -> bool: return plant.get(&"wind") != wind
	if not plants.any(lacks):
		_state.report_wind(tr("The plants have this wind already."))
		return
	_undo.create_action(tr("Set Scene Wind"), UndoRedo.MERGE_DISABLE, root)
	_add_wind(plants.filter(lacks), wind)
	_undo.commit_action()
	var message := tr_n("%d node has this wind now.", "%d nodes have this wind now.", plants.size())
	_state.report_wind(message % plants.size())


## Opens a dialog for the resource's path.
func choose_file() -> void:
	if not _dialog:
		_dialog = EditorFileDialog.new()
		_dialog.title = tr("Save Wind")
		_dialog.file_mode = EditorFileDialog.FILE_MODE_SAVE_FILE
		_dialog.access = EditorFileDialog.ACCESS_RESOURCES
		_dialog.add_filter("*.tres", tr("Plant Wind"))
		_dialog.file_selected.connect(save)
		add_child(_dialog)
	_dialog.current_file = "wind.tres"
	_dialog.popup_file_dialog()


## Saves the wind to [param path]. A wind that was loaded from there before gets the values too.
func save(path: String) -> void:
	var problem := ProjectFiles.find_problem(path)
	if problem.is_empty():
		var known := (
			ResourceLoader.get_cached_ref(path) if ResourceLoader.has_cached(path) else null
		)
		var wind := known as PlantWind if known is PlantWind else PlantWind.new()
		_copy(_state.wind, wind)
		problem = ProjectFiles.save(wind, path)
	if not problem.is_empty():
		_state.report_wind(problem, EditorState.Severity.ERROR)
		return
	ProjectFiles.announce(path)
	_state.report_wind(tr("The wind is saved as %s.") % path)


func _may_set(root: Node, plants: Array[Node3D]) -> bool:
	if not root:
		_state.report_wind(tr("Open a scene first; then its plants can have this wind."), WARNING)
		return false
	if plants.is_empty():
		_state.report_wind(
			tr("The scene has no plants yet. Add one from the panel Undergrowth."), WARNING
		)
		return false
	for plant in plants:
		if not ScenePlants.is_saved_with(root, plant):
			var advice := tr(
				"%s belongs to another scene. Open that scene, or make its children editable."
			)
			_state.report_wind(advice % plant.name, WARNING)
			return false
	return true


# Files of the add-on do not change: the plants get a wind of the scene.
func _replace(root: Node, wind: PlantWind, values: Dictionary[StringName, Variant]) -> void:
	var replacement := wind.duplicate() as PlantWind
	for property in values:
		replacement.set(property, values[property])
	var has_it := func(plant: Node3D) -> bool: return plant.get(&"wind") == wind
	_undo.create_action(tr("Give the Scene a Wind of Its Own"), UndoRedo.MERGE_DISABLE, root)
	_add_wind(ScenePlants.all(root).filter(has_it), replacement)
	_undo.commit_action()


func _add_wind(plants: Array[Node3D], wind: PlantWind) -> void:
	_undo.add_do_reference(wind)
	for plant in plants:
		_undo.add_do_property(plant, &"wind", wind)
		_undo.add_undo_property(plant, &"wind", plant.get(&"wind"))


func _copy(from: PlantWind, to: PlantWind) -> void:
	for property in PROPERTIES:
		to.set(property, from.get(property))
