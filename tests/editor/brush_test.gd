@tool
extends "viewport_test.gd"
## Base of the tests of the brush: a field under it, and its toolbar.

const BAR_SCRIPT := "res://addons/undergrowth/editor/brush/brush_bar.gd"
const SETTINGS_SCRIPT := "res://addons/undergrowth/editor/brush/brush_settings.gd"
const GRASS := "Grass"


func _edited_field() -> PlantField3D:
	var field := await _open_field()
	await _choose_only(field)
	await _rested(field)
	(_settings().get_node("%Strength") as EditorSpinSlider).value = 0.5
	(_settings().get_node("%Falloff") as EditorSpinSlider).value = 0.5
	(_settings().get_node("%Radius") as EditorSpinSlider).value = 0.8
	return field


func _rested(field: PlantField3D) -> void:
	await frames(3)
	var rests := func() -> bool: return not field.is_building()
	check(await until(rests), "it comes to rest")


func _bar() -> Control:
	return find_by_script(BAR_SCRIPT)


func _settings() -> Control:
	return find_by_script(SETTINGS_SCRIPT)


func _species_button(title: String) -> Button:
	for button: Button in _settings().get_node("%Species").get_children():
		if button.text == title:
			return button
	return null


# Or deselects the brush if it is selected.
func _choose_tool(title: String) -> void:
	await click(_bar().get_node("%" + title) as Control)


# Sets the brush to full effect per touch, within [param radius] metres.
func _sharpen(radius: float) -> void:
	(_settings().get_node("%Strength") as EditorSpinSlider).value = 1.0
	(_settings().get_node("%Falloff") as EditorSpinSlider).value = 0.0
	(_settings().get_node("%Radius") as EditorSpinSlider).value = radius
