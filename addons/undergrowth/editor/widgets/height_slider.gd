@tool
extends "worded_slider.gd"
## A height in metres. 0 is shown as text and means the species' own height of each plant.

const Translations := preload("../translations/translations.gd")


func _init() -> void:
	super()
	max_value = 5.0
	step = 0.01
	allow_greater = true
	suffix = "m"


func get_shown() -> String:
	return Translations.text("by species") if is_zero_approx(value) else ""
