extends PanelContainer
## The panel over the picture: sets a wind while the plants move, pauses them, and shows their cost.

const WindDial := preload("wind_dial.gd")
const Figures := preload("figures.gd")

const WINDS := "res://addons/undergrowth/winds/"
const WEATHER: Array[String] = ["calm", "light_air", "breeze", "fresh", "gale", "storm"]
## Seconds in which other weather comes up.
const BLEND := 5.0

## The wind that the panel sets.
@export var wind: PlantWind
## The fields that the wind travels through, of which figures are shown. None: all Plant3D nodes.
@export var fields: Array[PlantField3D] = []
## Frames per second are shown; off where pictures are taken off screen.
@export var shows_frame_rate := true:
	set(shows):
		shows_frame_rate = shows
		if is_node_ready():
			(%Figures as Figures).shows_frame_rate = shows

@onready var _kind: OptionButton = %Kind
@onready var _weather: OptionButton = %Weather
@onready var _speed: Slider = %Speed
@onready var _strength: Slider = %Strength
@onready var _direction: WindDial = %Direction
@onready var _frequency: Slider = %Frequency
@onready var _travel_speed: Slider = %TravelSpeed
@onready var _pause: Button = %Pause


func _ready() -> void:
	_kind.selected = wind.kind
	for weather in WEATHER:
		_weather.add_item(weather.capitalize())
	_speed.value = wind.speed
	_strength.value = wind.strength
	_direction.value = rad_to_deg(wind.direction)
	_frequency.value = wind.frequency
	_travel_speed.value = wind.travel_speed
	(%Figures as Figures).fields = fields
	(%Figures as Figures).shows_frame_rate = shows_frame_rate
	_kind.item_selected.connect(_on_kind_selected)
	_weather.item_selected.connect(_on_weather_selected)
	wind.changed.connect(_show_values)
	_speed.value_changed.connect(_on_value_changed.bind(&"speed"))
	_strength.value_changed.connect(_on_value_changed.bind(&"strength"))
	_direction.value_changed.connect(_on_direction_turned)
	_frequency.value_changed.connect(_on_value_changed.bind(&"frequency"))
	_travel_speed.value_changed.connect(_on_value_changed.bind(&"travel_speed"))
	_pause.button_pressed = get_tree().paused
	_pause.toggled.connect(_on_pause_toggled)
	(%Gust as Button).pressed.connect(wind.trigger_gust)
	_show_values()


func _exit_tree() -> void:
	get_tree().paused = false


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"trigger_gust"):
		wind.trigger_gust()
	elif event.is_action_pressed(&"pause_simulation"):
		_pause.button_pressed = not _pause.button_pressed


func _on_kind_selected(kind: int) -> void:
	wind.kind = kind as PlantWind.Kind
	_show_values()


func _on_weather_selected(index: int) -> void:
	var weather: PlantWind = load(WINDS + WEATHER[index] + ".tres").duplicate()
	weather.direction = wind.direction
	wind.blend_to(weather, BLEND)


func _on_value_changed(value: float, property: StringName) -> void:
	wind.set(property, value)
	_show_values()


func _on_direction_turned(degrees: float) -> void:
	wind.direction = deg_to_rad(degrees)
	_show_values()


# Which of the offered weathers the wind is; none while another one comes up.
func _weather_now() -> int:
	return WEATHER.find_custom(
		func(weather: String) -> bool:
			var offered: PlantWind = load(WINDS + weather + ".tres")
			return is_equal_approx(offered.speed, wind.speed)
	)


func _on_pause_toggled(on: bool) -> void:
	get_tree().paused = on
	_pause.text = "Resume" if on else "Pause"


func _show_values() -> void:
	var is_air := wind.kind == PlantWind.KIND_AIR
	for row: Control in [%WeatherRow, %SpeedRow]:
		row.visible = is_air
	for row: Control in [%StrengthRow, %FrequencyRow]:
		row.visible = not is_air
	_speed.set_value_no_signal(wind.speed)
	_weather.selected = _weather_now()
	(%SpeedValue as Label).text = "%.1f m/s · %d" % [wind.speed, wind.get_beaufort()]
	var has_frequency := wind.kind in [PlantWind.KIND_BURSTS, PlantWind.KIND_WAVES]
	(%StrengthValue as Label).text = "%.1f N" % wind.strength
	(%DirectionValue as Label).text = "%d°" % roundi(rad_to_deg(wind.direction))
	(%FrequencyValue as Label).text = "%.2f Hz" % wind.frequency
	(%TravelSpeedRow as Control).visible = not fields.is_empty() and not is_air
	var is_everywhere := wind.travel_speed == 0.0
	(%TravelSpeedValue as Label).text = (
		"at once" if is_everywhere else "%.1f m/s" % wind.travel_speed
	)
	_frequency.editable = has_frequency
	(%FrequencyRow as Control).modulate.a = 1.0 if has_frequency else 0.35
