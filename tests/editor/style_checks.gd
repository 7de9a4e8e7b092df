@tool
extends "actions_test.gd"
## Automatic checks of a picture of the dock: truncated texts, and controls that are smaller than
## their minimum.

## Margins above and below the label and number of a slider, as a fraction of its height.
const SLIDER_MARGIN := 0.5


## Prefix of the pictures of this run: width of the screen, and other differences.
func style_name(name: String) -> String:
	var light := "_light" if _is_light() else ""
	var screen := DisplayServer.screen_get_size().x
	return "look_%d%s_%s" % [screen, light, name]


func take_style(name: String) -> void:
	await frames(3)
	await _photograph(style_name(name))


func take_dialog_style(dialog: Window, name: String) -> void:
	check_nothing_is_cut(dialog, name)
	await frames(6)
	await drawn()
	if not pictures_folder.is_empty():
		var path := pictures_folder.path_join(style_name("dialog_" + name) + ".png")
		dialog.get_texture().get_image().save_png(path)


## Fails the test if a text in [param root] is truncated or a control is too small.
func check_nothing_is_cut(root: Node, where: String) -> void:
	for problem in _find_cut(root):
		check(false, "%s: %s" % [where, problem])
	check(true, where)


func _find_cut(node: Node) -> PackedStringArray:
	var found: PackedStringArray = []
	if node is EditorInspector or node is SubViewport:
		return found  # Controls of the engine.
	var control := node as Control
	if control and not control.is_visible_in_tree():
		return found
	if control:
		var minimum := control.get_combined_minimum_size()
		if control.size.x < minimum.x - 0.5 or control.size.y < minimum.y - 0.5:
			found.append("%s is %s, not %s" % [_path_of(control), control.size, minimum])
		var wanted := _text_width(control)
		if wanted > control.size.x + 0.5:
			found.append("%s wants %.0f of %.0f" % [_path_of(control), wanted, control.size.x])
	for child in node.get_children():
		if child is not Window:
			found.append_array(_find_cut(child))
	return found


# Returns the width of a text on one line, or 0 if it wraps or has a tooltip with the whole text.
func _text_width(control: Control) -> float:
	if control is EditorSpinSlider:
		return _slider_width(control as EditorSpinSlider)
	if control is Label and (control as Label).autowrap_mode == TextServer.AUTOWRAP_OFF:
		return _width_of(control, control.atr((control as Label).text))
	if control is Button and (control as Button).clip_text:
		var button := control as Button
		var box := button.get_theme_stylebox(&"normal").get_minimum_size().x
		return _width_of(control, control.atr(button.text)) + box
	if control is LineEdit:
		return _width_of(control, (control as LineEdit).placeholder_text)
	return 0.0


func _slider_width(slider: EditorSpinSlider) -> float:
	var value := String.num(slider.value, step_decimals(slider.step)) + " " + slider.suffix
	if slider.has_method(&"get_shown") and slider.call(&"get_shown") != "":
		value = slider.call(&"get_shown")
	return _width_of(slider, slider.label + " " + value) + slider.size.y * SLIDER_MARGIN


func _width_of(control: Control, text: String) -> float:
	var kind := &"LineEdit" if control is EditorSpinSlider else &""
	var font := control.get_theme_font(&"font", kind)
	var font_size := control.get_theme_font_size(&"font_size", kind)
	return font.get_multiline_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x


func _path_of(control: Control) -> String:
	var text: Variant = control.get("text") if "text" in control else ""
	if control is EditorSpinSlider:
		text = (control as EditorSpinSlider).label
	return "%s (%s)" % [control.name, text]


func _is_light() -> bool:
	return dock().get_theme_color(&"base_color", &"Editor").get_luminance() > 0.5
