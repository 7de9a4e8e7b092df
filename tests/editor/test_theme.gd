@tool
extends "actions_test.gd"
## The dock in another theme, changed while it is open.

const PRESET := "interface/theme/color_preset"
const LIGHT := "Light"


func test_dock_follows_a_light_theme() -> void:
	await open_page("Plant")
	var before: String = EditorInterface.get_editor_settings().get_setting(PRESET)
	var dark := _lightness()
	await _wear(LIGHT)
	await _choose("Bellflower")
	await take_picture("light")
	check(_lightness() > dark + 0.3, "the dock is light")
	await open_page("Wind")
	await take_picture("light_wind")
	await _wear(before)
	check(absf(_lightness() - dark) < 0.05, "and dark again")


func _lightness() -> float:
	return dock().get_theme_color(&"base_color", &"Editor").get_luminance()


func _wear(preset: String) -> void:
	EditorInterface.get_editor_settings().set_setting(PRESET, preset)
	var root := EditorInterface.get_base_control().get_tree().root
	root.propagate_notification(EditorSettings.NOTIFICATION_EDITOR_SETTINGS_CHANGED)
	await frames(10)
