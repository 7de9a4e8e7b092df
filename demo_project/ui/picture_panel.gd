extends PanelContainer
## The panel of what the picture is made of beside plants: each thing can be switched off.
##
## What the renderer cannot do is off, and says why. Where a processor draws in a graphics card's
## place, plants are coarser from half as far away on.

const COARSE := 0.5

## The picture's light, haze, glow and tones.
@export var environment: Environment
## Pollen and seeds.
@export var air: Node3D
## A node with the butterflies.
@export var butterflies: Node3D
## A node that flies, or not, by its property `is_flying`.
@export var helicopter: Node3D

## What is drawn coarser where a processor draws.
@export var fields: Array[PlantField3D] = []

var _fine: CheckButton

@onready var _rows: VBoxContainer = %Rows


func _ready() -> void:
	_fine = _add("Fine plants", true, _set_fine)
	_fine.button_pressed = not _is_drawn_by_processor()
	_add("Haze", environment.fog_enabled, func(on: bool) -> void: environment.fog_enabled = on)
	_add("Glow", environment.glow_enabled, func(on: bool) -> void: environment.glow_enabled = on)
	_add("Film tones", true, _set_film_tones)
	_add("Pollen and seeds", air.visible, _show.bind(air))
	_add("Butterflies", butterflies.visible, _show.bind(butterflies))
	var flight := _add("Helicopter  [H]", false, _fly)
	helicopter.connect(&"flight_changed", flight.set_pressed_no_signal)
	_add_for_forward("Shade in corners", &"ssao_enabled")
	_add_for_forward("Sun shafts", &"volumetric_fog_enabled")


## Whatever draws: for pictures of what a graphics card shows.
func draw_fine_plants() -> void:
	_fine.button_pressed = true


func _add(text: String, is_on: bool, act: Callable) -> CheckButton:
	var button := CheckButton.new()
	button.text = text
	button.focus_mode = Control.FOCUS_NONE
	for style: StringName in [&"normal", &"pressed", &"hover", &"hover_pressed", &"disabled"]:
		button.add_theme_stylebox_override(style, StyleBoxEmpty.new())
	for color: StringName in [&"font_pressed_color", &"font_hover_pressed_color"]:
		button.add_theme_color_override(color, get_theme_color(&"font_color", &"Label"))
	button.button_pressed = is_on
	button.toggled.connect(act)
	_rows.add_child(button)
	return button


## What only Forward+ can do.
func _add_for_forward(text: String, property: StringName) -> void:
	var can_do := RenderingServer.get_current_rendering_method() == "forward_plus"
	var is_on := can_do and environment.get(property) as bool
	var act := func(on: bool) -> void: environment.set(property, on)
	var button := _add(text, is_on, act)
	button.disabled = not can_do
	if not can_do:
		button.tooltip_text = "Only the Forward+ renderer has this."


func _is_drawn_by_processor() -> bool:
	var is_software := RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU
	return is_software or "llvmpipe" in RenderingServer.get_video_adapter_name()


func _set_fine(on: bool) -> void:
	for field in fields:
		field.lod_bias = 1.0 if on else COARSE


func _set_film_tones(on: bool) -> void:
	environment.tonemap_mode = (
		Environment.TONE_MAPPER_AGX if on else Environment.TONE_MAPPER_LINEAR
	)


func _fly(on: bool) -> void:
	helicopter.set(&"is_flying", on)


func _show(on: bool, node: Node3D) -> void:
	node.visible = on
	node.process_mode = PROCESS_MODE_INHERIT if on else PROCESS_MODE_DISABLED
