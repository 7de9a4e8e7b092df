@tool
extends EditorSpinSlider
## A slider that shows some values as words: those that leave the choice to another value.

## The engine's gap between a label and its number, in pixels at 100 %, without the left margin,
## which has the same width.
const SEPARATION := 4.0
## Opacity of the engine's own label beside a number.
const LABEL_OPACITY := 0.5


func _init() -> void:
	value_changed.connect(func(_number: float) -> void: queue_redraw())


## Returns the text shown instead of the number, or an empty text.
func get_shown() -> String:
	return ""


# Over the engine's own drawing.
func _draw() -> void:
	var shown := get_shown()
	if shown.is_empty():
		return
	var box := get_theme_stylebox(&"normal", &"LineEdit")
	draw_style_box(box, Rect2(Vector2.ZERO, size))
	var font := get_theme_font(&"font", &"LineEdit")
	var font_size := get_theme_font_size(&"font_size", &"LineEdit")
	var line := size.y * 0.5 + (font.get_ascent(font_size) - font.get_descent(font_size)) * 0.5
	var margin := box.get_offset().x
	var at := Vector2(margin, line)
	var color := get_theme_color(&"font_color", &"LineEdit")
	_write(label, font, font_size, at, color * Color(1, 1, 1, LABEL_OPACITY))
	at.x += font.get_string_size(label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	at.x += margin + SEPARATION * EditorInterface.get_editor_scale()
	_write(shown, font, font_size, at, color)


func _write(text: String, font: Font, font_size: int, at: Vector2, color: Color) -> void:
	var room := size.x - at.x
	draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, room, font_size, color)
