@tool
extends Node
## The actions of the wind page: writes its wind to plants, reads it from them, saves it.

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
]
const WARNING := EditorState.Severity.WARNING

var _state: EditorState
var _undo: EditorUndoRedoManager
var _dialog: EditorFileDialog


func setup(state: EditorState, undo: EditorUndoRedoManager) -> void:
	_state = state
	_undo = undo


## Writes the values to the winds of the selected plants, or of all plants if none is selected.
## Plants without a wind, or with a wind saved in another scene, get a new one that they share. One
## step of undo.
func apply() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var plants := ScenePlants.chosen()
	if not _may_apply(root, plants):
		return
	var winds: Array[PlantWind] = []
	var calm: Array[Node3D] = []
	for plant in plants:
		var wind: PlantWind = plant.get(&"wind")
		if not _has_own_wind(root, plant):
			calm.append(plant)
		elif not winds.has(wind):
			winds.append(wind)
	var lacks := func(plant: Node3D) -> bool:
		return not plant.get(&"wind") or _differs(plant.get(&"wind"))
	if not winds.any(_differs) and not calm.any(lacks):
		_state.report(tr("The plants have this wind already."))
		return
	_undo.create_action(tr("Apply Wind to Plants"), UndoRedo.MERGE_DISABLE, root)
	for wind in winds:
		_add_values(wind)
	if calm:
		_add_new_wind(calm)
	_undo.commit_action()
	var message := tr_n(
		"%d plant feels this wind now.", "%d plants feel this wind now.", plants.size()
	)
	_state.report(message % plants.size())


## Reads the wind of the first chosen plant that has one into the page.
func take() -> void:
	for plant in ScenePlants.chosen():
		var wind: PlantWind = plant.get(&"wind")
		if wind:
			_copy(wind, _state.wind)
			_state.report(tr("This is the wind of %s.") % plant.name)
			return
	_state.report(tr("No plant here has a wind yet. Press Apply to give them this one."), WARNING)


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
		_state.report(problem, EditorState.Severity.ERROR)
		return
	ProjectFiles.announce(path)
	_state.report(tr("The wind is saved as %s.") % path)


func _may_apply(root: Node, plants: Array[Node3D]) -> bool:
	if not root:
		_state.report(tr("Open a scene first; then its plants can have this wind."), WARNING)
		return false
	if plants.is_empty():
		_state.report(tr("The scene has no plants yet. Add one on the Plant page."), WARNING)
		return false
	for plant in plants:
		if not ScenePlants.is_saved_with(root, plant) and not _has_own_wind(root, plant):
			var advice := tr(
				"%s belongs to another scene. Open that scene, or make its children editable."
			)
			_state.report(advice % plant.name, WARNING)
			return false
	return true


# True for a wind whose changes are saved.
func _has_own_wind(root: Node, plant: Node3D) -> bool:
	var wind: PlantWind = plant.get(&"wind")
	return wind and ScenePlants.is_wind_saved(root, wind)


func _differs(wind: PlantWind) -> bool:
	return PROPERTIES.any(
		func(property: StringName) -> bool: return wind.get(property) != _state.wind.get(property)
	)


func _add_values(wind: PlantWind) -> void:
	for property in PROPERTIES:
		_undo.add_do_property(wind, property, _state.wind.get(property))
		_undo.add_undo_property(wind, property, wind.get(property))


func _add_new_wind(plants: Array[Node3D]) -> void:
	var wind := PlantWind.new()
	_copy(_state.wind, wind)
	_undo.add_do_reference(wind)
	for plant in plants:
		_undo.add_do_property(plant, &"wind", wind)
		_undo.add_undo_property(plant, &"wind", plant.get(&"wind"))


func _copy(from: PlantWind, to: PlantWind) -> void:
	for property in PROPERTIES:
		to.set(property, from.get(property))
