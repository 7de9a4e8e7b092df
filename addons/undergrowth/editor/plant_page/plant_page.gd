@tool
extends VBoxContainer
## The page for species: choose one, see it move, change its properties, use it.

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("species_entry.gd")
const SpeciesList := preload("species_list.gd")
const PlantPreview := preload("plant_preview.gd")
const PropertyPanel := preload("property_panel.gd")
const ViewControls := preload("view_controls.gd")
const ActionBar := preload("../actions/action_bar.gd")

var _state: EditorState
var _chosen: SpeciesEntry

@onready var _list: SpeciesList = %List
@onready var _preview: PlantPreview = %Preview
@onready var _view_controls: ViewControls = %ViewControls
@onready var _properties: PropertyPanel = %Properties
@onready var _actions: ActionBar = %Actions


## Fills the page; the first ready species is chosen.
func setup(state: EditorState, undo: EditorUndoRedoManager, dock: Control) -> void:
	_state = state
	_list.chosen.connect(_choose)
	_list.refreshed.connect(_on_list_refreshed)
	_list.setup()
	_preview.setup(state)
	_view_controls.setup(state)
	_properties.setup(state)
	_actions.setup(state, undo, dock)
	_choose(_list.get_first())
	_list.mark(_chosen.key)


func _choose(entry: SpeciesEntry) -> void:
	var function := entry.instantiate()
	if not function:
		_state.report(entry.explain_failure(self), EditorState.Severity.ERROR)
		_list.mark(_chosen.key if _chosen else "")
		return
	_chosen = entry
	_state.report("")
	_state.choose(function, entry.get_path(), entry.title)


# A chosen script was saved anew, or the chosen file is gone or has another name.
func _on_list_refreshed() -> void:
	if not _chosen or _chosen.kind == SpeciesEntry.Kind.READY:
		return
	var now := _list.find(_chosen.key)
	if not now:
		_on_chosen_gone()
	elif now.stamp != _chosen.stamp and now.kind == SpeciesEntry.Kind.SCRIPT:
		_choose(now)


func _on_chosen_gone() -> void:
	var renamed := _list.find(_state.function.resource_path)
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
