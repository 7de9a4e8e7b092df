@tool
extends Label
## The line of a dialog that describes the result or an error.

## Wrapping width of the text in pixels at 100 %. It determines the height of the dialog.
const MIN_SIZE := Vector2(320.0, 50.0)

var _is_problem := false


func _ready() -> void:
	if not is_part_of_edited_scene():
		custom_minimum_size = MIN_SIZE * EditorInterface.get_editor_scale()


## Shows the expected result.
func show_text(what: String) -> void:
	_show(what, false)


## Shows an error and its solution.
func show_problem(what: String) -> void:
	_show(what, true)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()


func _show(what: String, is_problem: bool) -> void:
	text = what
	_is_problem = is_problem
	_apply_theme()


func _apply_theme() -> void:
	# Sets the value only if it differs, because every change sends a theme notification.
	var color := get_theme_color(&"error_color", &"Editor")
	var has_override := has_theme_color_override(&"font_color")
	if _is_problem and not (has_override and get_theme_color(&"font_color") == color):
		add_theme_color_override(&"font_color", color)
	elif has_override and not _is_problem:
		remove_theme_color_override(&"font_color")
