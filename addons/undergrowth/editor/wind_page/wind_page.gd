@tool
extends ScrollContainer
## The page for the wind of the edited scene. Without one it shows the wind of the first plants to
## come. The preview sways in the same wind.

const EditorState := preload("../editor_state.gd")
const DirectionDial := preload("../widgets/direction_dial.gd")
const Beaufort := preload("beaufort.gd")
const ForceGraph := preload("../widgets/force_graph.gd")
const SceneWind := preload("scene_wind.gd")
const WindActions := preload("wind_actions.gd")
const WindClock := preload("wind_clock.gd")
const WindPresets := preload("wind_presets.gd")

## Maximum values of a wind, in the units of its properties.
const MAX_VALUES: Dictionary[StringName, float] = {
	&"strength": 1e6,
	&"frequency": 1000.0,
	&"gust_duration": 3600.0,
	&"travel_speed": 1e4,
	&"speed": 100.0,
	&"turbulence": 2.0,
}
## Step in degrees of angles that are stored in radians.
const DEGREE_STEP := 0.001
const KINDS: Array[String] = ["Gust", "Constant", "Bursts", "Waves", "Air"]
## Controls for air only, and for the other kinds only.
const AIR: Array[StringName] = [
	&"speed", &"turbulence", &"gustiness", &"roughness", &"canopy_height", &"canopy_wave_amount"
]
const NEWTONS: Array[StringName] = [&"strength", &"travel_speed"]

var _state: EditorState
# Property of the wind for each slider.
var _sliders: Dictionary[StringName, EditorSpinSlider] = {}
var _is_choosing := false
# True while the status line shows a limit.
var _shows_limit := false

@onready var _kind: OptionButton = %Kind
@onready var _frequency_label: Label = %FrequencyLabel
@onready var _direction: EditorSpinSlider = %Direction
@onready var _heading: Label = %Heading
@onready var _dial: DirectionDial = %Dial
@onready var _graph: ForceGraph = %Graph
@onready var _shown: Label = %Shown
@onready var _scene_wind: SceneWind = %SceneWind
@onready var _actions: WindActions = %WindActions


## Shows and changes the wind of [param state]. Changes of the scene are steps of undo of
## [param plugin].
func setup(state: EditorState, plugin: EditorPlugin) -> void:
	_state = state
	var undo := plugin.get_undo_redo()
	_state.wind_changed.connect(_show_wind)
	_actions.setup(state, undo)
	_scene_wind.setup(state)
	_sliders = {
		&"strength": %Strength,
		&"frequency": %Frequency,
		&"gust_duration": %Duration,
		&"travel_speed": %TravelSpeed,
		&"speed": %Speed,
		&"turbulence": %Turbulence,
		&"gustiness": %Gustiness,
		&"roughness": %Roughness,
		&"canopy_height": %CanopyHeight,
		&"canopy_wave_amount": %CanopyWaveAmount,
	}
	(%Presets as WindPresets).setup(_apply_preset)
	for part: Control in [%Fields, %Outcome]:
		part.custom_minimum_size.x *= EditorInterface.get_editor_scale()
	for kind in KINDS:
		_kind.add_item(kind)
	_connect_controls()
	_follow(plugin)
	_show_wind()


# What can change the wind of the scene: another scene or selection, and steps of undo.
func _follow(plugin: EditorPlugin) -> void:
	plugin.scene_changed.connect(func(_root: Node) -> void: _choose_wind_soon())
	plugin.get_undo_redo().history_changed.connect(_choose_wind_soon)
	plugin.get_undo_redo().version_changed.connect(_choose_wind_soon)
	EditorInterface.get_selection().selection_changed.connect(_choose_wind_soon)


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
	_kind.item_selected.connect(_set_wind.bind(&"kind"))
	for property in _sliders:
		_sliders[property].value_changed.connect(_set_wind.bind(property))
	_direction.value_changed.connect(_set_degrees)
	_dial.direction_changed.connect(_set_degrees)
	(%Gust as Button).pressed.connect(func() -> void: _state.wind.trigger_gust())
	(%SetForScene as Button).pressed.connect(_actions.set_for_scene)
	(%Save as Button).pressed.connect(_actions.choose_file)


func _process(delta: float) -> void:
	if _state and _state.wind and is_visible_in_tree():
		WindClock.advance(_state.wind, delta)


func _set_degrees(degrees: float) -> void:
	var is_turn := degrees >= 0.0 and degrees <= 360.0
	_set_wind(deg_to_rad(degrees if is_turn else fposmod(degrees, 360.0)), &"direction")


func _set_wind(value: float, property: StringName) -> void:
	var accepted := minf(value, MAX_VALUES.get(property, INF))
	_report_limit(property, accepted < value and MAX_VALUES.has(property))
	if _state.wind.get(property) == accepted:
		_show_wind()
	else:
		var title := "%s: %s" % [tr("Change Wind"), tr(property.capitalize())]
		_actions.change({property: accepted}, title)


func _apply_preset(preset: PlantWind) -> void:
	var values: Dictionary[StringName, Variant] = {}
	for property in WindPresets.PROPERTIES:
		values[property] = preset.get(property)
	_actions.change(values, tr("Choose Wind"))


func _report_limit(property: StringName, is_reached: bool) -> void:
	if is_reached:
		var message := tr("%s can be at most %d %s.")
		var words := [
			tr(property.capitalize()), roundi(MAX_VALUES[property]), _sliders[property].suffix
		]
		_state.report(message % words, EditorState.Severity.WARNING)
	elif _shows_limit:
		_state.report("")
	_shows_limit = is_reached


func _show_wind() -> void:
	var wind := _state.wind
	if not wind:
		return
	if _graph.wind != wind:
		_graph.wind = wind
	_kind.select(wind.kind)
	for property in _sliders:
		_sliders[property].set_value_no_signal(wind.get(property))
	var degrees := snappedf(rad_to_deg(wind.direction), DEGREE_STEP)
	_direction.set_value_no_signal(degrees)
	_dial.degrees = degrees
	_heading.text = _dial.describe().replace("° ", "°\n")
	(%Presets as WindPresets).mark(wind)
	_show_fields(wind)


# Each kind has its own controls.
func _show_fields(wind: PlantWind) -> void:
	var is_air := wind.kind == PlantWind.KIND_AIR
	for property in AIR + NEWTONS:
		var is_shown := is_air == AIR.has(property)
		_sliders[property].visible = is_shown
		(get_node("%" + _sliders[property].name + "Label") as Label).visible = is_shown
	(%BeaufortLabel as Label).visible = is_air
	(%Beaufort as Label).visible = is_air
	(%Beaufort as Label).text = Beaufort.describe(wind)
	_keep_columns()
	var is_periodic := wind.kind in [PlantWind.KIND_BURSTS, PlantWind.KIND_WAVES]
	_frequency_label.visible = is_periodic
	_sliders[&"frequency"].visible = is_periodic


# The same width of the labels' column for every kind, so that no control moves.
func _keep_columns() -> void:
	var widest := 0.0
	for child in _kind.get_parent().get_children():
		if child is Label and child != %Beaufort and child != _heading:
			widest = maxf(widest, (child as Label).get_minimum_size().x)
	(%KindLabel as Label).custom_minimum_size.x = widest
