extends PanelContainer
## The panel of what the picture is made of beside plants: each thing can be switched off.
##
## What the renderer cannot do is off, and says why.

## The picture's light, haze, glow and tones.
@export var environment: Environment
## Pollen and seeds.
@export var air: Node3D
## A node with the butterflies.
@export var butterflies: Node3D
## A node that flies, or not, by its property `is_flying`.
@export var helicopter: Node3D

@onready var _rows: VBoxContainer = %Rows


func _ready() -> void:
	_add("Haze", environment.fog_enabled, func(on: bool) -> void: environment.fog_enabled = on)
	_add("Glow", environment.glow_enabled, func(on: bool) -> void: environment.glow_enabled = on)
	_add("Film tones", true, _set_film_tones)
	_add("Pollen and seeds", air.visible, _show.bind(air))
	_add("Butterflies", butterflies.visible, _show.bind(butterflies))
	var flight := _add("Helicopter  [H]", false, _fly)
	helicopter.connect(&"flight_changed", flight.set_pressed_no_signal)
	_add_for_forward("Shade in corners", &"ssao_enabled")
	_add_for_forward("Sun shafts", &"volumetric_fog_enabled")


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


func _set_film_tones(on: bool) -> void:
	environment.tonemap_mode = (
		Environment.TONE_MAPPER_AGX if on else Environment.TONE_MAPPER_LINEAR
	)


func _fly(on: bool) -> void:
	helicopter.set(&"is_flying", on)


func _show(on: bool, node: Node3D) -> void:
	node.visible = on
	node.process_mode = PROCESS_MODE_INHERIT if on else PROCESS_MODE_DISABLED
