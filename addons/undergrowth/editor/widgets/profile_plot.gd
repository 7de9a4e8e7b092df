@tool
extends Control
## A species' outline and colour along its height. The plant is horizontal: root left, tip right.
## The width curve of a CurvePlantFunction can be dragged. Other species are only plotted.

const EditorState := preload("../editor_state.gd")
const ProfilePoints := preload("profile_points.gd")
const Translations := preload("../translations/translations.gd")
const SAMPLES := 64
const MIN_HEIGHT := 56
const MIN_HEIGHT_TO_EDIT := 100
const MARGIN := 6.0
## Thinner pieces of the outline are not drawn, in pixels of both of their ends.
const MIN_PIECE := 0.02

var _function: PlantFunction
var _widths: PackedFloat32Array = []
var _colors: PackedColorArray = []
# The base shape's radius in metres, and the width that fills the plot.
var _radius := 0.0
var _max_width := 0.0
var _points: ProfilePoints


## Plots [param function]. Changes of its curve are steps of [param undo].
func setup(function: PlantFunction, undo: EditorUndoRedoManager) -> void:
	_function = function
	set_translation_domain(Translations.DOMAIN)
	_points = ProfilePoints.new()
	_points.name = "Points"
	add_child(_points)
	_points.setup(undo)
	function.changed.connect(_sample)
	resized.connect(_place_points)
	var curves := function as CurvePlantFunction
	var minimum := MIN_HEIGHT_TO_EDIT if curves else MIN_HEIGHT
	custom_minimum_size.y = minimum * EditorInterface.get_editor_scale()
	_points.edit(curves)
	_sample()


func _sample() -> void:
	_widths.clear()
	_colors.clear()
	if _function.find_problem(0.0, EditorState.NEAR_SEGMENTS, EditorState.FIRST_SEED).is_empty():
		_sample_function(_function)
	_points.queue_redraw()
	queue_redraw()


func _sample_function(function: PlantFunction) -> void:
	_radius = 0.0
	for point in function.get_base_shape(EditorState.NEAR_SEGMENTS):
		_radius = maxf(_radius, Vector2(point.x, point.z).length())
	for i in SAMPLES + 1:
		var offset := float(i) / SAMPLES
		_widths.append(function.calculate_curve_point(offset))
		_colors.append(function.calculate_color_at_point(offset))
	var curves := function as CurvePlantFunction
	if curves:
		_max_width = curves.width_curve.max_value if curves.width_curve else 1.0
	else:
		_max_width = maxf(_widest(), 1e-6)


func _widest() -> float:
	var widest := 0.0
	for width in _widths:
		widest = maxf(widest, width)
	return widest


func _place_points() -> void:
	var area := _area()
	_points.position = area.position
	_points.size = area.size


# Area of the outline, above a line of text.
func _area() -> Rect2:
	var area := Rect2(Vector2.ZERO, size).grow(-MARGIN * EditorInterface.get_editor_scale())
	area.size.y -= _font().get_height(_font_size())
	return area


func _font() -> Font:
	return get_theme_font(&"main", &"EditorFonts")


func _font_size() -> int:
	return get_theme_font_size(&"main_size", &"EditorFonts")


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"normal", &"LineEdit"), Rect2(Vector2.ZERO, size))
	if not _widths.is_empty():
		_draw_outline(_area())
		_draw_text(_area())


func _draw_outline(area: Rect2) -> void:
	for i in SAMPLES:
		var piece := get_piece(i, area)
		if piece[3].y - piece[0].y + piece[2].y - piece[1].y < MIN_PIECE:
			continue
		var colors := [_colors[i], _colors[i + 1], _colors[i + 1], _colors[i]]
		draw_primitive(piece, colors, [])


## Returns the corners of the outline between two samples in [param area]: above on the left, above
## on the right, below on the right, below on the left.
func get_piece(i: int, area: Rect2) -> PackedVector2Array:
	var middle := area.get_center().y
	var left := area.position.x + area.size.x * i / SAMPLES
	var right := area.position.x + area.size.x * (i + 1) / SAMPLES
	var here := _widths[i] / _max_width * area.size.y * 0.5
	var there := _widths[i + 1] / _max_width * area.size.y * 0.5
	return [
		Vector2(left, middle - here),
		Vector2(right, middle - there),
		Vector2(right, middle + there),
		Vector2(left, middle + here)
	]


func _draw_text(area: Rect2) -> void:
	var color := get_theme_color(&"font_disabled_color", &"Editor")
	var base := Vector2(area.position.x, area.end.y + _font().get_ascent(_font_size()))
	var breadth := tr("Root · up to %s cm wide") % String.num(_widest() * _radius * 200.0, 1)
	var width := area.size.x
	draw_string(_font(), base, breadth, HORIZONTAL_ALIGNMENT_LEFT, width, _font_size(), color)
	draw_string(_font(), base, tr("Tip"), HORIZONTAL_ALIGNMENT_RIGHT, width, _font_size(), color)
