@tool
extends VBoxContainer
## The wind of the edited scene over the 3D view: presets, speed and direction. Without one it shows
## the wind of the first plants to come.

const EditorState := preload("../editor_state.gd")
const DirectionDial := preload("../widgets/direction_dial.gd")
const Inspecting := preload("../actions/inspecting.gd")
const StatusLine := preload("../widgets/status_line.gd")
const Beaufort := preload("beaufort.gd")
const WindActions := preload("wind_actions.gd")
const WindPresets := preload("wind_presets.gd")

## In m/s.
const MAX_SPEED := 100.0
## Step in degrees of angles that are stored in radians.
const DEGREE_STEP := 0.001

var _state: EditorState
var _is_choosing := false

@onready var _shown: Label = %Shown
@onready var _presets: WindPresets = %Presets
@onready var _dial: DirectionDial = %Dial
@onready var _speed: EditorSpinSlider = %Speed
@onready var _beaufort: Label = %Beaufort
@onready var _direction: EditorSpinSlider = %Direction
@onready var _inspect: Button = %Inspect
@onready var _actions: WindActions = %WindActions


## Shows and changes the wind of [param state]. Changes of the scene are steps of undo of
## [param plugin].
func setup(state: EditorState, plugin: EditorPlugin) -> void:
	_state = state
	_state.wind_changed.connect(_show_wind)
	(%Status as StatusLine).setup(state, true)
	_actions.setup(state, plugin.get_undo_redo())
	_presets.setup(_apply_preset)
	(%Numbers as Control).custom_minimum_size.x *= EditorInterface.get_editor_scale()
	_connect_controls()
	_follow(plugin)
	_translate()
	_apply_theme()
	_show_wind()


# What can change the wind of the scene: another scene or selection, and steps of undo.
func _follow(plugin: EditorPlugin) -> void:
	plugin.scene_changed.connect(_on_scene_changed)
	plugin.get_undo_redo().history_changed.connect(_choose_wind_soon)
	plugin.get_undo_redo().version_changed.connect(_choose_wind_soon)
	EditorInterface.get_selection().selection_changed.connect(_choose_wind_soon)
	_choose_wind_soon()


func _on_scene_changed(_root: Node) -> void:
	_choose_wind_soon()


# Once for any number of changes in a frame.
func _choose_wind_soon() -> void:
	if not _is_choosing:
		_is_choosing = true
		_choose_wind.call_deferred()


func _choose_wind() -> void:
	_is_choosing = false
	var found := WindActions.find_scene_wind()
	var wind := found if found else _state.own_wind
	if wind and wind != _state.wind:
		_state.wind = wind
	_shown.text = tr("Wind of the Scene") if found else tr("Wind of New Plants")


func _connect_controls() -> void:
	_speed.value_changed.connect(_set_speed)
	_direction.value_changed.connect(_set_degrees)
	_dial.direction_changed.connect(_set_degrees)
	(%Gust as Button).pressed.connect(func() -> void: _state.wind.trigger_gust())
	(%SetForScene as Button).pressed.connect(_actions.set_for_scene)
	(%Save as Button).pressed.connect(_actions.choose_file)
	_inspect.pressed.connect(func() -> void: Inspecting.open(_state.wind))


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _state:
		_apply_theme()
	elif what == NOTIFICATION_TRANSLATION_CHANGED and _state:
		_translate()
		_show_wind()
		_choose_wind_soon()


func _apply_theme() -> void:
	_inspect.icon = get_theme_icon(&"Tools", &"EditorIcons")


# These sliders do not translate their labels themselves.
func _translate() -> void:
	_speed.label = tr("Speed")
	_direction.label = tr("Direction")


# A wind in newtons becomes air.
func _set_speed(value: float) -> void:
	var accepted := minf(value, MAX_SPEED)
	if accepted < value:
		var message := tr("%s can be at most %d %s.") % [tr("Speed"), MAX_SPEED, "m/s"]
		_state.report_wind(message, EditorState.Severity.WARNING)
	_change({&"kind": PlantWind.KIND_AIR, &"speed": accepted}, "Speed")


func _set_degrees(degrees: float) -> void:
	var is_turn := degrees >= 0.0 and degrees <= 360.0
	var turned := degrees if is_turn else fposmod(degrees, 360.0)
	_change({&"direction": deg_to_rad(turned)}, "Direction")


func _change(values: Dictionary[StringName, Variant], what: String) -> void:
	var is_new := func(property: StringName) -> bool:
		return _state.wind.get(property) != values[property]
	if values.keys().any(is_new):
		_actions.change(values, "%s: %s" % [tr("Change Wind"), tr(what)])
	else:
		_show_wind()


func _apply_preset(preset: PlantWind) -> void:
	var values: Dictionary[StringName, Variant] = {}
	for property in WindPresets.PROPERTIES:
		values[property] = preset.get(property)
	_actions.change(values, tr("Choose Wind"))


func _show_wind() -> void:
	var wind := _state.wind
	if not wind:
		return
	_speed.set_value_no_signal(wind.speed)
	_beaufort.text = _describe(wind)
	_beaufort.tooltip_text = _beaufort.text
	var degrees := snappedf(rad_to_deg(wind.direction), DEGREE_STEP)
	_direction.set_value_no_signal(degrees)
	_dial.degrees = degrees
	_presets.mark(wind)


# The inspector has the details of winds in newtons.
func _describe(wind: PlantWind) -> String:
	if wind.kind == PlantWind.KIND_AIR:
		return tr("Beaufort %s") % Beaufort.describe(wind)
	return tr("Now a force of %s N") % String.num(wind.strength, 2)
