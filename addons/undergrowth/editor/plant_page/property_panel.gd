@tool
extends VBoxContainer
## The chosen species' profile, and its properties in the editor's own inspector with its undo. For
## a mix, a list of its species.

const EditorState := preload("../editor_state.gd")
const ProfilePlot := preload("../widgets/profile_plot.gd")
const SpeciesEntry := preload("species_entry.gd")
const PlantInspectorView := preload("../inspector/plant_inspector_view.gd")
const SECTION_CLASS := "EditorInspectorSection"
const RESOURCE_SECTION := "Resource"
## Share of the names in a line's width. A dock is narrower than the editor's inspector, and names
## are longer than values.
const NAME_SHARE := 0.66

var _state: EditorState
var _inspector: EditorInspector

@onready var _plot: ProfilePlot = %Plot
@onready var _mix_scroll: ScrollContainer = %MixScroll
@onready var _mix_text: Label = %MixText


## Shows the species of [param state]. Changes are steps of [param undo].
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
	_inspector.visible = not _state.mix
	_mix_scroll.visible = _state.mix != null
	_mix_text.text = _describe(_state.mix) if _state.mix else ""


# One line per species, with its share of all plants.
func _describe(mix: PackedScene) -> String:
	var field: PlantField3D = mix.instantiate()
	var sum := 0.0
	for listed in field.species:
		sum += listed.weight * listed.density_factor
	var lines: PackedStringArray = []
	for listed in field.species:
		var percent := 100.0 * listed.weight * listed.density_factor / sum
		var title := SpeciesEntry.find_title(listed.species.resource_path)
		lines.append("%s · %s %%" % [tr(title), String.num(percent, 0 if percent >= 1.0 else 1)])
	field.free()
	var hint := tr("Add it as a field, then change weights and density in the inspector.")
	return "%s\n\n%s" % ["\n".join(lines), hint]


# Names get more room. The dock shows the plant already. A resource's name, path and scene are
# irrelevant for a species and stay in the editor's own inspector.
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
	var above: Node = EditorInterface.get_inspector()
	while above and above is not EditorDock:
		above = above.get_parent()
	if above:
		(above as EditorDock).make_visible()
