@tool
extends RefCounted
## The species that the brush paints: species of the field, and the one picked in the dock's list. A
## stroke adds the picked species to a field without it.

const EditorState := preload("../editor_state.gd")
const FieldEntries := preload("../actions/field_entries.gd")
const SceneActions := preload("../actions/scene_actions.gd")
const Translations := preload("../translations/translations.gd")
const BrushOptions := preload("brush_options.gd")
const BrushSettings := preload("brush_settings.gd")

var _state: EditorState
var _options: BrushOptions
var _settings: BrushSettings
var _field: PlantField3D
# The dock's species is painted, whether or not the field already has it.
var _has_picked := false
# Map layer for the picked species. Empty if the field already has the species.
var _new_layer := ""


## Changes [param options] and shows in [param settings] the species picked in the dock of
## [param state].
func setup(state: EditorState, options: BrushOptions, settings: BrushSettings) -> void:
	_state = state
	_options = options
	_settings = settings
	state.picked.connect(_on_picked)


func close() -> void:
	_state.picked.disconnect(_on_picked)


## Sets the edited field, or none if [param field] is null.
func edit(field: PlantField3D) -> void:
	_field = field
	_has_picked = false
	refresh()


## Call after a possible change of the field's species.
func refresh() -> void:
	var names := FieldEntries.layers_of(_field) if _field else PackedStringArray()
	_new_layer = ""
	if _has_picked and _state.function and not FieldEntries.find(_field, _get_picked()):
		_new_layer = _make_entry().get_layer_name()
		names.append(_new_layer)
	var function := _state.function if _new_layer else null
	_settings.show_field(_field, function, _new_layer, Translations.text(_state.title))
	_keep_only(names)


## Returns the entry that a stroke adds to the field, usually null.
func take_new_entry() -> PlantFieldSpecies:
	if not _new_layer or not _new_layer in _options.species:
		return null
	var entry := _make_entry()
	var chosen := _options.species.duplicate()
	chosen[chosen.find(_new_layer)] = entry.get_layer_name()
	_options.species = chosen
	return entry


func _on_picked() -> void:
	if not _field or not _state.function or _state.problem:
		return
	_has_picked = true
	refresh()
	if _new_layer:
		_options.species = [_new_layer]
		var message := Translations.text("The brush above the 3D view paints %s into %s.")
		_state.report(message % [Translations.text(_state.title), _field.name])
	else:
		_options.species = [FieldEntries.find(_field, _get_picked()).get_layer_name()]
		var message := Translations.text("The brush above the 3D view paints %s.")
		_state.report(message % Translations.text(_state.title))


func _keep_only(names: PackedStringArray) -> void:
	var kept: PackedStringArray = []
	for title in _options.species:
		if title in names:
			kept.append(title)
	if kept != _options.species:
		_options.species = kept


func _get_picked() -> PlantFunction:
	var root := EditorInterface.get_edited_scene_root()
	return SceneActions.to_scene_function(_state.function, root, _state.origin)


func _make_entry() -> PlantFieldSpecies:
	return FieldEntries.make(_field, _get_picked())
