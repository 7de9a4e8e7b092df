@tool
extends Label
## The line of a dialog that says what will happen, or what is wrong.

var _is_problem := false


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
	var color := get_theme_color(&"font_color", &"Label")
	if _is_problem:
		color = get_theme_color(&"error_color", &"Editor")
	# Set anew only where it differs: setting it tells that the theme changed.
	if not has_theme_color_override(&"font_color") or get_theme_color(&"font_color") != color:
		add_theme_color_override(&"font_color", color)
