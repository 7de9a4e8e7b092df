@tool
extends "worded_slider.gd"
## The variation of the speed of air, as a fraction of it. Below 0 the ground's roughness sets it.

const Translations := preload("../translations/translations.gd")


func get_shown() -> String:
	return Translations.text("by roughness") if value < 0.0 else ""
