@tool
extends "wind_view.gd"
## The spectrum of a wind's turbulence, measured one metre above the ground, beside the line that
## Kaimal and others measured over a field in Kansas (1972). For winds that are forces, the axes
## only.

const PowerSpectrum := preload("power_spectrum.gd")

## Number of samples of one record, and samples per second.
const COUNT := 2048
const RATE := 16.0
## Number of consecutive records in the drawn mean. One is measured per frame.
const RECORDS := 8
## Limits in Hz, and limits of frequency times power divided by the variance.
const LOWEST := 0.01
const HIGHEST := 8.0
const MIN_POWER := 0.01
const MAX_POWER := 1.0
const PER_DECADE := 8

# Of the records so far: number, sum of powers (m²/s), sums of speeds and of their squares.
var _count := 0
var _sum := PackedFloat64Array()
var _speeds := 0.0
var _squares := 0.0


func _get_minimum_size() -> Vector2:
	return Vector2(136, 120) * EditorInterface.get_editor_scale()


func _process(_delta: float) -> void:
	if _is_air() and wind.speed > 0.0 and _count < RECORDS and is_visible_in_tree():
		_measure()
		queue_redraw()


## Measured frequencies (Hz), and frequency times power divided by the variance at each.
func get_points() -> PackedVector2Array:
	var points := PackedVector2Array()
	if _count == 0:
		return points
	var samples := float(_count * COUNT)
	var variance := _squares / samples - (_speeds / samples) ** 2
	if variance < 1e-9:
		return points
	var band := pow(10.0, 1.0 / PER_DECADE)
	var low := LOWEST
	while low < HIGHEST:
		var sum := Vector2.ZERO
		var inside := 0
		for i in range(1, COUNT / 2):
			var hertz := i * RATE / COUNT
			if hertz >= low and hertz < low * band:
				sum += Vector2(log(hertz), hertz * _sum[i] / (_count * variance))
				inside += 1
		if inside > 0:
			points.append(Vector2(exp(sum.x / inside), sum.y / inside))
		low *= band
	return points


## Returns Kaimal's line at that frequency (Hz), divided by the variance: 105·f/(1 + 33·f)^(5/3)
## times the squared friction velocity. The variance is 2.185² times that square.
func kaimal(hertz: float) -> float:
	var height := 1.0
	var carried := wind.speed * log(height / wind.roughness) / log(10.0 / wind.roughness)
	var f := hertz * height / maxf(carried, 1e-3)
	return 105.0 * f / pow(1.0 + 33.0 * f, 5.0 / 3.0) / (2.185 * 2.185)


# All records are measured again.
func _on_wind_changed() -> void:
	_sum.resize(COUNT / 2)
	_sum.fill(0.0)
	_count = 0
	_speeds = 0.0
	_squares = 0.0
	queue_redraw()


func _measure() -> void:
	var speeds := PackedFloat64Array()
	var ahead := Vector3(sin(wind.direction), 0.0, cos(wind.direction))
	var start := _count * COUNT / RATE
	for i in COUNT:
		var speed := wind.sample_velocity(start + i / RATE, Vector3.UP).dot(ahead)
		speeds.append(speed)
		_speeds += speed
		_squares += speed * speed
	var powers := PowerSpectrum.of(speeds, RATE)
	for i in powers.size():
		_sum[i] += powers[i]
	_count += 1


func _draw() -> void:
	var font_size := roundi(get_theme_font_size("font_size", "Label") * 0.8)
	var font := get_theme_font("font", "Label")
	var text := Color(get_theme_color("font_color", "Label"), 0.75)
	var frame := Rect2(4.0, font_size * 1.5, size.x - 8.0, size.y - font_size * 3.0)
	for hertz: float in [0.01, 0.1, 1.0]:
		var x := _place(frame, hertz, MIN_POWER).x
		draw_line(Vector2(x, frame.position.y), Vector2(x, frame.end.y), Color(text, 0.15))
		var at := Vector2(x + 2.0, frame.end.y + font.get_ascent(font_size) + 2.0)
		var label := "%s Hz" % String.num(hertz)
		draw_string(font, at, label, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, text)
	draw_rect(frame, Color(text, 0.15), false)
	if not _is_air() or wind.speed <= 0.0:
		return
	var line := PackedVector2Array()
	for i in 65:
		var hertz := LOWEST * pow(HIGHEST / LOWEST, i / 64.0)
		line.append(_place(frame, hertz, kaimal(hertz)))
	draw_polyline(line, text, EditorInterface.get_editor_scale(), true)
	var accent := get_theme_color("accent_color", "Editor")
	for point in get_points():
		var place := _place(frame, point.x, point.y)
		draw_circle(place, 2.5 * EditorInterface.get_editor_scale(), accent, true, -1.0, true)
	var at := Vector2(frame.position.x, frame.position.y - font.get_descent(font_size) - 2.0)
	var label := tr("Gusts, beside Kaimal's line")
	draw_string(font, at, label, HORIZONTAL_ALIGNMENT_LEFT, frame.size.x, font_size, text)


func _place(frame: Rect2, hertz: float, value: float) -> Vector2:
	var along := log(hertz / LOWEST) / log(HIGHEST / LOWEST)
	var up := log(maxf(value, MIN_POWER) / MIN_POWER) / log(MAX_POWER / MIN_POWER)
	return frame.position + Vector2(along, 1.0 - clampf(up, 0.0, 1.0)) * frame.size
