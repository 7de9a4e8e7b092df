@tool
extends Label
## The line of a dialog that says what will happen, or what is wrong.

## In pixels at 100 %: the text wraps at that width, so that its dialog knows its own height.
const LEAST_SIZE := Vector2(320.0, 50.0)

var _is_problem := false


func _ready() -> void:
	if not is_part_of_edited_scene():
		custom_minimum_size = LEAST_SIZE * EditorInterface.get_editor_scale()


## Says what will happen.
func show_text(what: String) -> void:
	_show(what, false)


## Says what is wrong and what to do.
func show_problem(what: String) -> void:
	_show(what, true)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_dress()


func _show(what: String, is_problem: bool) -> void:
	text = what
	_is_problem = is_problem
	_dress()


func _dress() -> void:
	# Set anew only where it differs: setting it tells that the theme changed.
	var color := get_theme_color(&"error_color", &"Editor")
	var is_dressed := has_theme_color_override(&"font_color")
	if _is_problem and not (is_dressed and get_theme_color(&"font_color") == color):
		add_theme_color_override(&"font_color", color)
	elif is_dressed and not _is_problem:
		remove_theme_color_override(&"font_color")
