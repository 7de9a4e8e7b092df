@tool
extends "viewport_test.gd"
## Base of the tests of the brush: a field under it, and its toolbar.

const SpeciesMenu := preload("res://addons/undergrowth/editor/brush/species_menu.gd")
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


# The tile of the brush for a species, or -1.
func _species_tile(title: String) -> int:
	var found := _species_tiles()
	for i in found.item_count:
		if found.get_item_text(i).replace("\n", " ") == title:
			return i
	return -1


func _species_tiles() -> ItemList:
	return (_settings().get_node("%SpeciesMenu") as SpeciesMenu).get_tiles()


func _is_painted(title: String) -> bool:
	var at := _species_tile(title)
	return at >= 0 and _species_tiles().is_selected(at)


# Chooses species as a user does. Without any: all species.
func _paint_only(titles: PackedStringArray) -> void:
	var menu := _settings().get_node("%SpeciesMenu") as SpeciesMenu
	await click(menu)
	if titles.is_empty():
		await click(_species_tiles(), _species_tiles().get_item_rect(0).get_center())
	holds_ctrl = titles.size() > 1
	for title in titles:
		var at := _species_tile(title)
		if titles.size() == 1 or not _is_painted(title):
			await click(_species_tiles(), _species_tiles().get_item_rect(at).get_center())
	holds_ctrl = false
	await click(menu)


# Or deselects the brush if it is selected.
func _choose_tool(title: String) -> void:
	await click(_bar().get_node("%" + title) as Control)


# Sets the brush to full effect per touch, within [param radius] metres.
func _sharpen(radius: float) -> void:
	(_settings().get_node("%Strength") as EditorSpinSlider).value = 1.0
	(_settings().get_node("%Falloff") as EditorSpinSlider).value = 0.0
	(_settings().get_node("%Radius") as EditorSpinSlider).value = radius
