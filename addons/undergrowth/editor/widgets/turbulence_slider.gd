@tool
extends "worded_slider.gd"
## How much the speed of air varies, as a share of it; below 0 the ground's roughness says it.

const Translations := preload("../translations/translations.gd")


func get_shown() -> String:
	return Translations.text("by roughness") if value < 0.0 else ""
