@tool
extends "wind_view.gd"
## The force of a wind over the next seconds (thesis, figures 4.3 to 4.6): newtons over the wind's
## own time, with a mark that moves along at "now". For air, its speed in the last minute. Without a
## wind, the axes only. The owner advances the wind's clock.

## Seconds of the graph, for forces and for air.
const SPAN := 8.0
const AIR_SPAN := 60.0
## Metres above the ground of the drawn speed of air.
const AIR_PLACE := Vector3(0, 10, 0)
## Position of the mark on a new page, and position that turns the page, as fractions of the graph.
const PAGE_START := 0.15
const PAGE_END := 0.7
const SAMPLES := 480
## Maximum number of visible points in a minute of air. Its line is thinner.
const AIR_SAMPLES := 160
## Between a number and the axis, in pixels at 100 %.
const GAP := 4.0

var _start := 0.0
var _drawn_at := -1.0


## The wind's time at the mark, in seconds.
func get_now() -> float:
	return wind.get_time() if wind else 0.0


func _get_minimum_size() -> Vector2:
	return Vector2(180, 120) * EditorInterface.get_editor_scale()


func _on_wind_taken() -> void:
	_start = -PAGE_START * SPAN + (wind.get_time() if wind else 0.0)
	queue_redraw()


func _process(_delta: float) -> void:
	if not is_visible_in_tree() or not wind or wind.get_time() == _drawn_at:
		return
	_turn_page()
	queue_redraw()


# Air scrolls under the mark, which stays near the end. Forces turn whole pages.
func _turn_page() -> void:
	var now := wind.get_time()
	if _is_air():
		_start = now - (AIR_SPAN - 1.0)
	elif now < _start or now > _start + PAGE_END * SPAN:
		_start = now - PAGE_START * SPAN


func _span() -> float:
	return AIR_SPAN if _is_air() else SPAN


func _unit() -> String:
	return "m/s" if _is_air() else "N"


func _value(time: float) -> float:
	if _is_air():
		return wind.sample_velocity(time, AIR_PLACE).length()
	return wind.sample(time).length()


func _draw() -> void:
	if wind:
		_turn_page()
	var font_size := roundi(get_theme_font_size("font_size", "Label") * 0.8)
	var font := get_theme_font("font", "Label")
	var frame := _frame(font, font_size)
	var forces := _sample()
	var top := _axis_end(forces)
	_draw_axes(frame, top, font, font_size)
	if not wind:
		return
	_drawn_at = wind.get_time()
	_draw_curve(frame, forces, top)
	_draw_now(frame, top, font, font_size)


# Area of the curve: newtons are on its left, seconds below, the mark's text above.
func _frame(font: Font, font_size: int) -> Rect2:
	var widest := "100.0 " + _unit()
	var gap := GAP * EditorInterface.get_editor_scale()
	var left := gap + font.get_string_size(widest, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	var top := font_size * 1.5
	return Rect2(left, top, size.x - left - 2.0 * gap, size.y - top - font_size * 1.5)


func _sample() -> PackedFloat32Array:
	var forces := PackedFloat32Array()
	var count := AIR_SAMPLES if _is_air() else SAMPLES
	forces.resize(count + 1)
	if wind:
		for i in count + 1:
			forces[i] = _value(_start + _span() * i / count)
	return forces


# Returns a round number above the largest force: 1, 2 or 5 times a power of ten. Waves reach twice
# the strength, so that the axis stays the same when one leaves the page.
func _axis_end(forces: PackedFloat32Array) -> float:
	var largest := 1e-3
	for force in forces:
		largest = maxf(largest, force)
	if wind:
		var is_wave := wind.kind == PlantWind.KIND_WAVES
		if not _is_air():
			largest = maxf(largest, wind.strength * (2.0 if is_wave else 1.0))
	var power := pow(10.0, floorf(log(largest) / log(10.0)))
	for factor: float in [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]:
		if largest * 1.02 <= factor * power:
			return factor * power
	return 10.0 * power


func _draw_axes(frame: Rect2, top: float, font: Font, font_size: int) -> void:
	var text := Color(get_theme_color("font_color", "Label"), 0.75)
	var grid := Color(text, 0.15)
	for step in 3:
		var y := frame.end.y - frame.size.y * step / 2.0
		draw_line(Vector2(frame.position.x, y), Vector2(frame.end.x, y), grid)
		var label := "%s %s" % [String.num(top * step / 2.0, 3), _unit()]
		var at := Vector2(0, y + font.get_ascent(font_size) / 2.5)
		var width := frame.position.x - GAP * EditorInterface.get_editor_scale()
		draw_string(font, at, label, HORIZONTAL_ALIGNMENT_RIGHT, width, font_size, text)
	var span := _span()
	var every := 2 if frame.size.x / span > font_size * 1.6 else (10 if _is_air() else 4)
	for second in range(ceili(_start), floori(_start + span) + 1):
		if second % every != 0 or second < 0:
			continue
		var x := frame.position.x + (second - _start) / span * frame.size.x
		draw_line(Vector2(x, frame.position.y), Vector2(x, frame.end.y), grid)
		var label := "%d s" % second
		var wide := font.get_string_size(label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
		var left := clampf(x - wide / 2.0, frame.position.x, size.x - wide)
		var at := Vector2(left, frame.end.y + font.get_ascent(font_size) + 2.0)
		draw_string(font, at, label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, text)


func _draw_curve(frame: Rect2, forces: PackedFloat32Array, top: float) -> void:
	var accent := get_theme_color("accent_color", "Editor")
	var points := PackedVector2Array()
	for i in forces.size():
		var share := Vector2(float(i) / (forces.size() - 1), 1.0 - forces[i] / top)
		points.append(frame.position + share * frame.size)
	var width := 1.0 if _is_air() else 1.5
	width *= EditorInterface.get_editor_scale()
	if _is_air():
		draw_multiline(_pieces(points), accent, width, true)
	else:
		draw_polyline(points, accent, width, true)


# Segment by segment: one polyline has gaps at corners as sharp as those of gusts.
func _pieces(points: PackedVector2Array) -> PackedVector2Array:
	var pieces := PackedVector2Array()
	for i in points.size() - 1:
		pieces.append(points[i])
		pieces.append(points[i + 1])
	return pieces


func _draw_now(frame: Rect2, top: float, font: Font, font_size: int) -> void:
	var color := get_theme_color("warning_color", "Editor")
	var share := (wind.get_time() - _start) / _span()
	var x := frame.position.x + clampf(share, 0.0, 1.0) * frame.size.x
	var width := 1.5 * EditorInterface.get_editor_scale()
	draw_line(Vector2(x, frame.position.y), Vector2(x, frame.end.y), color, width)
	var force := _value(wind.get_time())
	var place := Vector2(x, frame.end.y - force / top * frame.size.y)
	draw_circle(place, 3.0 * EditorInterface.get_editor_scale(), color, true, -1.0, true)
	var label := tr("now: %s") % ("%s %s" % [String.num(force, 2), _unit()])
	var wide := font.get_string_size(label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	var left := clampf(x - wide / 2.0, frame.position.x, frame.end.x - wide)
	var at := Vector2(left, frame.position.y - font.get_descent(font_size) - 2.0)
	draw_string(font, at, label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, color)
