@tool
extends VBoxContainer
## The chosen species' profile, and its properties in the editor's own inspector with its undo.

const EditorState := preload("../editor_state.gd")
const ProfilePlot := preload("../widgets/profile_plot.gd")
const PlantInspectorView := preload("../inspector/plant_inspector_view.gd")
const SECTION_CLASS := "EditorInspectorSection"
const RESOURCE_SECTION := "Resource"
## Of a line's width: a dock is narrower than the editor's inspector, and names are longer than
## values.
const NAME_SHARE := 0.58

var _state: EditorState
var _inspector: EditorInspector

@onready var _plot: ProfilePlot = %Plot


## Shows the species of [param state]; changes are steps of [param undo].
func setup(state: EditorState, undo: EditorUndoRedoManager) -> void:
	_state = state
	_inspector = EditorInspector.new()
	_inspector.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_inspector.resource_selected.connect(_on_resource_selected)
	add_child(_inspector)
	(_inspector.get_child(0) as Control).minimum_size_changed.connect(_adapt)
	_plot.setup(state, undo)
	_state.function_chosen.connect(_show_function)
	_show_function()


func _show_function() -> void:
	_inspector.edit(_state.function)


# Names get more room. The dock shows the plant already. Name, path and scene of a resource say
# nothing about a species; the editor's own inspector has them.
func _adapt() -> void:
	for section: Control in _inspector.find_children("*", SECTION_CLASS, true, false):
		if section.tooltip_text == RESOURCE_SECTION:
			section.hide()
	for property: EditorProperty in _inspector.find_children("*", "EditorProperty", true, false):
		property.name_split_ratio = NAME_SHARE
	for view: Control in _inspector.find_children("*", "SubViewportContainer", true, false):
		if view is PlantInspectorView:
			view.hide()


func _on_resource_selected(resource: Resource, _path: String) -> void:
	EditorInterface.edit_resource(resource)
