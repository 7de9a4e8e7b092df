@tool
extends "editor_test.gd"
## Base of the tests of the wind page: its controls.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")


func _wind() -> PlantWind:
	return (dock().get("state") as EditorState).wind


func _choose_kind(kind: PlantWind.Kind) -> void:
	await open_page("Wind")
	var button := part("Wind/Kind") as OptionButton
	await _reveal(button)
	await click(button)
	var inside := button.get_popup().get_child(0, true) as Control
	for i in button.item_count:
		if button.get_popup().get_focused_item() != kind:
			await press_key(inside, KEY_DOWN)
	await press_key(inside, KEY_ENTER)
	await frames(2)


func _type_number(name: String, number: String) -> void:
	var slider := part("Wind/" + name) as EditorSpinSlider
	await _reveal(slider)
	await click(slider, Vector2(slider.size.x * 0.3, slider.size.y * 0.4))
	await frames(3)
	await press_key(slider, KEY_A, 0, true)
	await type(slider, number)
	await press_key(slider, KEY_ENTER)
	await frames(2)


func _press_button(name: String) -> void:
	await open_page("Wind")
	var button := part("Wind/" + name) as Control
	await _reveal(button)
	await click(button)
	await frames(2)


func _reveal(control: Control) -> void:
	(part("Wind") as ScrollContainer).ensure_control_visible(control)
	await frames(2)
