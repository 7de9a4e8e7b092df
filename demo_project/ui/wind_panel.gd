extends PanelContainer
## The panel over the picture: sets a wind while the plants move, pauses them, and shows their cost.

const WindDial := preload("wind_dial.gd")
const SMOOTHING := 0.06

## The wind that the panel sets.
@export var wind: PlantWind
## Frames per second are shown; off where pictures are taken off screen.
@export var shows_frame_rate := true

var _step_time := -1.0  # µs.

@onready var _kind: OptionButton = %Kind
@onready var _strength: Slider = %Strength
@onready var _direction: WindDial = %Direction
@onready var _frequency: Slider = %Frequency
@onready var _pause: Button = %Pause


func _ready() -> void:
	_kind.selected = wind.kind
	_strength.value = wind.strength
	_direction.value = wind.direction_degrees
	_frequency.value = wind.frequency
	_kind.item_selected.connect(_on_kind_selected)
	_strength.value_changed.connect(_on_value_changed.bind(&"strength"))
	_direction.value_changed.connect(_on_value_changed.bind(&"direction_degrees"))
	_frequency.value_changed.connect(_on_value_changed.bind(&"frequency"))
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


func _process(_delta: float) -> void:
	(%FrameRate as Label).text = "%d fps" % Engine.get_frames_per_second()
	(%FrameRow as Control).visible = shows_frame_rate
	if get_tree().paused:
		return  # Plants that pause have left the simulation: the last figures stay.
	var simulation := Engine.get_singleton(&"PlantSimulation")
	var step_time: float = simulation.call(&"get_step_time_usec")
	_step_time = step_time if _step_time < 0.0 else lerpf(_step_time, step_time, SMOOTHING)
	(%Plants as Label).text = "%d" % simulation.call(&"get_plant_count")
	(%StepTime as Label).text = _as_time(_step_time)


func _on_kind_selected(kind: int) -> void:
	wind.kind = kind as PlantWind.Kind
	_show_values()


func _on_value_changed(value: float, property: StringName) -> void:
	wind.set(property, value)
	_show_values()


func _on_pause_toggled(on: bool) -> void:
	get_tree().paused = on
	_pause.text = "Resume" if on else "Pause"


func _show_values() -> void:
	var has_frequency := wind.kind in [PlantWind.KIND_BURSTS, PlantWind.KIND_WAVES]
	(%StrengthValue as Label).text = "%.1f N" % wind.strength
	(%DirectionValue as Label).text = "%d°" % roundi(wind.direction_degrees)
	(%FrequencyValue as Label).text = "%.2f Hz" % wind.frequency
	_frequency.editable = has_frequency
	(%FrequencyRow as Control).modulate.a = 1.0 if has_frequency else 0.35


func _as_time(microseconds: float) -> String:
	if microseconds < 1000.0:
		return "%d µs" % roundi(microseconds)
	return "%.2f ms" % (microseconds / 1000.0)
