@tool
extends BoxContainer
## Tiles of species and mixes, and actions for the chosen one: beside the tiles, or below them in a
## narrow dock.

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("species_entry.gd")
const TileList := preload("tile_list.gd")
const ActionBar := preload("../actions/action_bar.gd")
const Inspecting := preload("../actions/inspecting.gd")
const SameResource := preload("../actions/same_resource.gd")
const SceneSpecies := preload("scene_species.gd")

## Minimum width with the actions beside the tiles, in pixels at 100 %.
const WIDE := 560

var _state: EditorState
var _chosen: SpeciesEntry
# Changes of the user on ready species. They survive the choice of another species.
var _ready_functions: Dictionary[String, PlantFunction] = {}
var _scene_species := SceneSpecies.new()

@onready var _list: TileList = %List
@onready var _actions: ActionBar = %Actions


## Fills the list and chooses the first entry.
func setup(state: EditorState, undo: EditorUndoRedoManager, dock: Control) -> void:
	_state = state
	resized.connect(_arrange)
	_arrange()
	_list.chosen.connect(_on_list_chosen)
	_list.opened.connect(_on_list_opened)
	_list.refreshed.connect(_on_list_refreshed)
	_list.new_wanted.connect(_actions.open_new_dialog)
	_list.setup(state)
	_actions.setup(state, undo, dock)
	_actions.saved.connect(_on_saved)
	_actions.added.connect(_scene_species.skip)
	_choose_first()
	_scene_species.selected.connect(_show_species)
	_scene_species.setup(self)


func _arrange() -> void:
	vertical = size.x < WIDE * EditorInterface.get_editor_scale()


func _choose_first() -> void:
	_choose(_list.get_first())
	_list.mark(_chosen.key if _chosen else "")


## Returns true if [param data] of a drag is a mix or a species.
func accepts_drag(data: Variant) -> bool:
	return _find_dragged(data) != null


## Chooses the mix or the species of a drag and adds a field of it at [param pixel] of [param view].
func drop(data: Variant, view: SubViewport, pixel: Vector2) -> void:
	var dragged := _find_dragged(data)
	var entry := dragged as SpeciesEntry
	if entry:
		_choose(entry)
	elif dragged:
		_chosen = null
		_state.choose(dragged as PlantFunction, "", SpeciesEntry.title_of(dragged))
	_list.mark(_chosen.key if _chosen else "")
	if not entry or (_chosen and _chosen.key == entry.key):
		_actions.add_field(view, pixel)


# Returns an entry of the list, another species, or null. Scenes outside of the list are the
# editor's.
func _find_dragged(data: Variant) -> RefCounted:
	if data is not Dictionary:
		return null
	var files: PackedStringArray = data.get("files", [])
	var key: String = data.get(TileList.DRAGGED_KEY, files[0] if files.size() == 1 else "")
	var entry := _list.find(key) if key else null
	return entry if entry else (data.get("resource") as PlantFunction)


# Follows the selection of the scene: chooses its entry of the list, or the scene's own species.
func _show_species(function: PlantFunction) -> void:
	if function == _state.origin or SameResource.are_equal(function, _state.function):
		return
	var entry := null if function.is_built_in() else _list.find(function.resource_path)
	if entry:
		_choose(entry)
		var text := tr(
			"%s is selected. To change it, choose another species and press Use for Selected."
		)
		_state.report(text % tr(entry.title))
	else:
		_chosen = null
		_state.choose(function, "", SpeciesEntry.title_of(function))
		_state.report(tr("%s is selected, and the scene's own.") % tr(_state.title))
	_list.mark(entry.key if entry else "")
	_list.reveal_chosen()


func _on_list_chosen(entries: Array[SpeciesEntry]) -> void:
	var last: SpeciesEntry = entries[-1]
	_choose(last)
	if not _chosen or _chosen.key != last.key:
		return
	var functions: Array[PlantFunction] = []
	var titles: PackedStringArray = []
	for entry in entries:
		var function := _find_function(entry)
		if function:
			functions.append(entry.get_origin() if _is_unchanged(entry, function) else function)
			titles.append(entry.title)
	_state.picked.emit(functions, titles)


# A ready species that the user has not changed is painted from its file.
func _is_unchanged(entry: SpeciesEntry, function: PlantFunction) -> bool:
	var origin := entry.get_origin()
	return origin != null and SameResource.has_equal_properties(origin, function)


# A mix has no properties of its own: its species are in the tile's tooltip.
func _on_list_opened(entry: SpeciesEntry) -> void:
	_choose(entry)
	if _chosen and _chosen.key == entry.key and _state.function:
		Inspecting.open(_state.function)
	elif _state.mix:
		_state.report(tr("A mix is a field of several species. Add it, then change it there."))


func _choose(entry: SpeciesEntry) -> void:
	if _chosen and entry.key == _chosen.key:
		return
	if entry.kind == SpeciesEntry.Kind.MIX:
		_choose_mix(entry)
		return
	var function := _find_function(entry)
	if not function:
		_refuse(entry)
		return
	_chosen = entry
	_state.report("")
	_state.choose(function, entry.get_path(), entry.title, entry.get_origin())


# Null for a mix, or a file with an error.
func _find_function(entry: SpeciesEntry) -> PlantFunction:
	var function: PlantFunction = _ready_functions.get(entry.key)
	if not function:
		function = entry.instantiate()
	if function and entry.is_ready:
		_ready_functions[entry.key] = function
	return function


func _choose_mix(entry: SpeciesEntry) -> void:
	var mix := entry.load_mix()
	if not mix:
		_refuse(entry)
		return
	_chosen = entry
	_state.report("")
	_state.choose_mix(mix, entry.title)


func _refuse(entry: SpeciesEntry) -> void:
	_state.report(entry.explain_failure(self), EditorState.Severity.ERROR)
	_list.mark(_chosen.key if _chosen else "")


# The file has the content of the chosen species.
func _on_saved(entry: SpeciesEntry) -> void:
	_chosen = entry
	_list.mark(entry.key)


# A chosen script was saved again, or the chosen file was removed or renamed.
func _on_list_refreshed() -> void:
	if not _chosen or _chosen.is_ready:
		return
	var now := _list.find(_chosen.key)
	if not now:
		_on_chosen_gone()
	elif now.stamp != _chosen.stamp:
		_on_chosen_written(now)


# The plant stays the same object with the same properties.
func _on_chosen_written(now: SpeciesEntry) -> void:
	_chosen = now
	if now.kind != SpeciesEntry.Kind.SCRIPT:
		return
	if not now.refresh():
		_state.fail(now.explain_failure(self))
		return
	_state.function.notify_property_list_changed()
	_state.function.emit_changed()


func _on_chosen_gone() -> void:
	var renamed := _list.find(_path_of(_state.function))
	if renamed:
		_chosen = renamed
		_state.choose(_state.function, renamed.get_path(), renamed.title)
		_list.mark(renamed.key)
		return
	_state.report(
		tr("%s is gone. The plant is still here: save it to keep it.") % _chosen.key,
		EditorState.Severity.WARNING
	)
	_chosen = null
	_state.path = ""


# The editor updates the path of a moved resource.
func _path_of(function: PlantFunction) -> String:
	var script := function.get_script() as Script
	var is_script := _chosen.kind == SpeciesEntry.Kind.SCRIPT and script
	return script.resource_path if is_script else function.resource_path
