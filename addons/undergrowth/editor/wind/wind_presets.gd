@tool
extends GridContainer
## The winds that ship with the add-on, as buttons with their speeds. A press sets the wind to that
## weather. The button of the current wind is pressed.

const FOLDER := "res://addons/undergrowth/winds/"
## Properties of a preset. The wind's direction does not change.
const PROPERTIES: Array[StringName] = [
	&"kind",
	&"speed",
	&"turbulence",
	&"gustiness",
	&"roughness",
	&"canopy_height",
	&"canopy_wave_amount"
]

var _chosen: Callable
var _buttons: Dictionary[Button, PlantWind] = {}


## Creates the buttons. A press calls [param chosen] with the preset's wind.
func setup(chosen: Callable) -> void:
	_chosen = chosen
	_add("calm", tr("Calm"))
	_add("light_air", tr("Light Air"))
	_add("breeze", tr("Breeze"))
	_add("fresh", tr("Fresh Breeze"))
	_add("gale", tr("Gale"))
	_add("storm", tr("Storm"))


## Marks the preset that is equal to [param wind], if one is.
func mark(wind: PlantWind) -> void:
	for button in _buttons:
		button.set_pressed_no_signal(_is_equal(_buttons[button], wind))


static func _is_equal(a: PlantWind, b: PlantWind) -> bool:
	return PROPERTIES.all(
		func(property: StringName) -> bool: return is_equal_approx(a.get(property), b.get(property))
	)


func _add(file: String, title: String) -> void:
	var preset: PlantWind = load(FOLDER + file + ".tres")
	var button := Button.new()
	button.name = file.to_pascal_case()
	button.text = "%s\n%s m/s" % [title, String.num(preset.speed, 1)]
	button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	button.toggle_mode = true
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	button.tooltip_text = tr("Sets this air.")
	button.pressed.connect(_on_pressed.bind(button))
	_buttons[button] = preset
	add_child(button)
	button.owner = owner
	button.unique_name_in_owner = true


# A press of the current preset's button leaves it pressed.
func _on_pressed(button: Button) -> void:
	_chosen.call(_buttons[button])
	mark(_buttons[button])
