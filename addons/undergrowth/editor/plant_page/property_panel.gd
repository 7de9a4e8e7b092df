@tool
extends VBoxContainer
## The chosen species' profile, and its properties in the editor's own inspector with its undo.

const EditorState := preload("../editor_state.gd")
const ProfilePlot := preload("../widgets/profile_plot.gd")
## On the inspector: what add-ons put on top of a species there, the dock shows already.
const EMBEDDED_META := &"undergrowth_embedded"
const SECTION_CLASS := "EditorInspectorSection"
const RESOURCE_SECTION := "Resource"

var _state: EditorState
var _inspector: EditorInspector

@onready var _plot: ProfilePlot = %Plot


## Shows the species of [param state].
func setup(state: EditorState) -> void:
	_state = state
	_inspector = EditorInspector.new()
	_inspector.set_meta(EMBEDDED_META, true)
	_inspector.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_inspector.resource_selected.connect(_on_resource_selected)
	add_child(_inspector)
	(_inspector.get_child(0) as Control).minimum_size_changed.connect(_hide_resource_section)
	_plot.setup(state)
	_state.function_chosen.connect(_show_function)
	_show_function()


func _show_function() -> void:
	_inspector.edit(_state.function)


# Name, path and scene of a resource say nothing about a species; the inspector itself has them.
func _hide_resource_section() -> void:
	for section: Control in _inspector.find_children("*", SECTION_CLASS, true, false):
		if section.tooltip_text == RESOURCE_SECTION:
			section.hide()


func _on_resource_selected(resource: Resource, _path: String) -> void:
	EditorInterface.edit_resource(resource)
