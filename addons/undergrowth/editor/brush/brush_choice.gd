@tool
extends RefCounted
## Which species the brush paints: of those that the field grows, and the one that was picked in the
## dock's list, which a stroke adds to the field where it is not there yet.

const EditorState := preload("../editor_state.gd")
const FieldNewcomer := preload("../actions/field_newcomer.gd")
const SceneActions := preload("../actions/scene_actions.gd")
const Translations := preload("../translations/translations.gd")
const BrushOptions := preload("brush_options.gd")
const BrushSettings := preload("brush_settings.gd")

var _state: EditorState
var _options: BrushOptions
var _settings: BrushSettings
var _field: PlantField3D
# The dock's species is painted, whether the field has it yet or not.
var _has_picked := false
# What the field's map will call the picked species; nothing where the field has it.
var _newcomer := ""


## Changes [param options] and shows in [param settings] what is picked in the dock of
## [param state].
func setup(state: EditorState, options: BrushOptions, settings: BrushSettings) -> void:
	_state = state
	_options = options
	_settings = settings
	state.picked.connect(_on_picked)


func close() -> void:
	_state.picked.disconnect(_on_picked)


## Is about [param field] from now on; null: about none.
func edit(field: PlantField3D) -> void:
	_field = field
	_has_picked = false
	refresh()


## The field may grow something else now.
func refresh() -> void:
	var names := FieldNewcomer.layers_of(_field) if _field else PackedStringArray()
	_newcomer = ""
	if _has_picked and _state.function and not FieldNewcomer.find(_field, _get_picked()):
		_newcomer = _make_entry().get_layer_name()
		names.append(_newcomer)
	_settings.show_field(_field, _state.function if _newcomer else null, _newcomer)
	_keep_only(names)


## The entry that a stroke adds to the field; null for most strokes.
func bring_newcomer() -> PlantFieldSpecies:
	if not _newcomer or not _newcomer in _options.species:
		return null
	var entry := _make_entry()
	var chosen := _options.species.duplicate()
	chosen[chosen.find(_newcomer)] = entry.get_layer_name()
	_options.species = chosen
	return entry


func _on_picked() -> void:
	if not _field or not _state.function or _state.problem:
		return
	_has_picked = true
	refresh()
	if _newcomer:
		_options.species = [_newcomer]
		var told := Translations.text("The brush above the 3D view paints %s into %s.")
		_state.report(told % [_state.title, _field.name])
	else:
		_options.species = [FieldNewcomer.find(_field, _get_picked()).get_layer_name()]
		_state.report(Translations.text("The brush above the 3D view paints %s.") % _state.title)


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
	return FieldNewcomer.make(_field, _get_picked())
