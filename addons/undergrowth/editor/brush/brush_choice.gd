@tool
extends RefCounted
## The species that the brush paints: species of the field, and those picked in the panel's tiles. A
## stroke adds picked species to a field without them.

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
# Painted, whether or not the field already has them.
var _picked: Array[PlantFunction] = []
var _picked_titles: PackedStringArray = []
# Those that the field does not have, by their future layers.
var _new: Dictionary[String, PlantFunction] = {}


## Changes [param options] and shows in [param settings] the species picked in the tiles of
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
	_picked.clear()
	refresh()


## Call after a possible change of the field's species.
func refresh() -> void:
	var names := FieldEntries.layers_of(_field) if _field else PackedStringArray()
	var titles: Dictionary[String, String] = {}
	_new.clear()
	for i in _picked.size():
		if not FieldEntries.find(_field, _picked[i]):
			var layer := FieldEntries.make(_picked[i], names).get_layer_name()
			_new[layer] = _picked[i]
			titles[layer] = Translations.text(_picked_titles[i])
			names.append(layer)
	_settings.show_field(_field, _new, titles)
	_keep_only(names)


## Returns the entries that a stroke adds to the field, usually none.
func take_new_entries() -> Array[PlantFieldSpecies]:
	var entries: Array[PlantFieldSpecies] = []
	var names := FieldEntries.layers_of(_field)
	for layer in _new:
		if layer in _options.species:
			entries.append(FieldEntries.make(_new[layer], names))
		names.append(layer)
	return entries


func _on_picked(functions: Array[PlantFunction], titles: PackedStringArray) -> void:
	if not _field or functions.is_empty() or _state.problem:
		return
	_picked.clear()
	_picked_titles = titles
	var root := EditorInterface.get_edited_scene_root()
	for function in functions:
		_picked.append(SceneActions.to_scene_function(function, root))
	refresh()
	var layers: PackedStringArray = _new.keys()
	for function in _picked:
		var known := FieldEntries.find(_field, function)
		if known:
			layers.append(known.get_layer_name())
	_options.species = layers
	_report()


func _report() -> void:
	var names: PackedStringArray = []
	for title in _picked_titles:
		names.append(Translations.text(title))
	var joined := ", ".join(names)
	if _new:
		var message := Translations.text("The brush above the 3D view paints %s into %s.")
		_state.report(message % [joined, _field.name])
	else:
		_state.report(Translations.text("The brush above the 3D view paints %s.") % joined)


func _keep_only(names: PackedStringArray) -> void:
	var kept: PackedStringArray = []
	for title in _options.species:
		if title in names:
			kept.append(title)
	if kept != _options.species:
		_options.species = kept
