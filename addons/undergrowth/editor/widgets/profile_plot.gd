@tool
extends Control
## A species' outline and colour along its height. The plant lies on its side: root left, tip right.

const EditorState := preload("../editor_state.gd")
const SAMPLES := 64
const LEAST_HEIGHT := 56

var _state: EditorState
var _widths: PackedFloat32Array = []
var _colors: PackedColorArray = []
var _radius := 0.0


## Plots the species of [param state].
func setup(state: EditorState) -> void:
	_state = state
	custom_minimum_size.y = LEAST_HEIGHT * EditorInterface.get_editor_scale()
	_state.function_chosen.connect(_sample)
	_state.function_edited.connect(_sample)
	_sample()


func _sample() -> void:
	_widths.clear()
	_colors.clear()
	if _state.function and _state.problem.is_empty():
		_radius = 0.0
		for point in _state.function.get_base_shape(EditorState.DEFAULT_LOD):
			_radius = maxf(_radius, Vector2(point.x, point.z).length())
		for i in SAMPLES + 1:
			var offset := float(i) / SAMPLES
			_widths.append(_state.function.calculate_curve_point(offset))
			_colors.append(_state.function.calculate_color_at_point(offset))
	queue_redraw()


func _draw() -> void:
	var box := get_theme_stylebox(&"normal", &"LineEdit")
	draw_style_box(box, Rect2(Vector2.ZERO, size))
	if _widths.is_empty():
		return
	var font := get_theme_font(&"main", &"EditorFonts")
	var font_size := get_theme_font_size(&"main_size", &"EditorFonts")
	var line := font.get_height(font_size)
	var area := Rect2(Vector2.ZERO, size).grow(-6.0 * EditorInterface.get_editor_scale())
	area.size.y -= line
	_draw_outline(area)
	_draw_text(font, font_size, area)


func _draw_outline(area: Rect2) -> void:
	var widest := 0.0
	for width in _widths:
		widest = maxf(widest, width)
	var middle := area.get_center().y
	for i in SAMPLES:
		var left := area.position.x + area.size.x * i / SAMPLES
		var right := area.position.x + area.size.x * (i + 1) / SAMPLES
		var here := _widths[i] / maxf(widest, 1e-6) * area.size.y * 0.5
		var there := _widths[i + 1] / maxf(widest, 1e-6) * area.size.y * 0.5
		if here + there < 0.01:
			continue
		draw_primitive(
			[
				Vector2(left, middle - here),
				Vector2(right, middle - there),
				Vector2(right, middle + there),
				Vector2(left, middle + here)
			],
			[_colors[i], _colors[i + 1], _colors[i + 1], _colors[i]],
			[]
		)


func _draw_text(font: Font, font_size: int, area: Rect2) -> void:
	var widest := 0.0
	for width in _widths:
		widest = maxf(widest, width)
	var color := get_theme_color(&"font_disabled_color", &"Editor")
	var base := Vector2(area.position.x, area.end.y + font.get_ascent(font_size))
	var breadth := tr("Root · up to %s cm wide") % String.num(widest * _radius * 200.0, 1)
	draw_string(font, base, breadth, HORIZONTAL_ALIGNMENT_LEFT, area.size.x, font_size, color)
	draw_string(font, base, tr("Tip"), HORIZONTAL_ALIGNMENT_RIGHT, area.size.x, font_size, color)
