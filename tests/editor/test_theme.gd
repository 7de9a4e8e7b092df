@tool
extends "actions_test.gd"
## The dock after a change of the theme while it is open.


func test_dock_follows_a_light_theme() -> void:
	await open_panel()
	var before := used_theme()
	var dark := _lightness()
	await use_theme(LIGHT)
	await _choose("Bellflower")
	await take_picture("light")
	check(_lightness() > dark + 0.3, "the dock is light")
	await use_theme(before)
	check(absf(_lightness() - dark) < 0.05, "and dark again")


func _lightness() -> float:
	return dock().get_theme_color(&"base_color", &"Editor").get_luminance()
