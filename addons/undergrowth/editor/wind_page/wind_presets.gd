@tool
extends GridContainer
## The winds that ship with the add-on, as buttons. A press sets the wind to that weather.

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


## Creates the buttons. A press calls [param chosen] with the preset's wind.
func setup(chosen: Callable) -> void:
	_chosen = chosen
	_add("calm", tr("Calm"))
	_add("light_air", tr("Light Air"))
	_add("breeze", tr("Breeze"))
	_add("fresh", tr("Fresh Breeze"))
	_add("gale", tr("Gale"))
	_add("storm", tr("Storm"))


func _add(file: String, title: String) -> void:
	var button := Button.new()
	button.name = file.to_pascal_case()
	button.text = title
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	button.tooltip_text = tr("Sets this air.")
	button.pressed.connect(func() -> void: _chosen.call(load(FOLDER + file + ".tres")))
	add_child(button)
	button.owner = owner
	button.unique_name_in_owner = true
