extends Control
## Two charts of a stem while it bends: the angle of its tip against the load, beside the static law
## that it should follow, and the way of its tip, beside the places of the exact elastica.

const LoadStem := preload("load_stem.gd")

## The elastica under a load at its tip (Bisshopp and Drucker, 1945): α, the tip's angle in degrees,
## and where the tip is, in lengths.
const PUBLISHED: Array[Array] = [
	[1.0, 26.43, Vector2(0.302, 0.944)],
	[2.0, 44.79, Vector2(0.494, 0.839)],
	[5.0, 69.64, Vector2(0.714, 0.612)],
]
const MAX_DEGREES := 90.0
const POINTS := 64  # Of a line.
const MAX_TRAIL := 900
const TITLE_HEIGHT := 26.0
const GAP := 14.0
const AXIS := Color(1, 1, 1, 0.35)
const LAW := Color(1, 1, 1, 0.6)
const EXACT := Color(1.0, 0.78, 0.35)
const LIVE := Color(0.62, 0.86, 0.4)
const FONT_SIZE := 14

## The stem that bends.
@export var stem: LoadStem

var _angles := PackedVector2Array()  # α and degrees.
var _places := PackedVector2Array()


func _process(_delta: float) -> void:
	_angles.append(Vector2(stem.load_now, rad_to_deg(stem.get_tip_angle())))
	_places.append(stem.get_tip_place())
	if _angles.size() > MAX_TRAIL:
		_angles = _angles.slice(1)
		_places = _places.slice(1)
	queue_redraw()


func _draw() -> void:
	var each := (size.y - GAP) / 2.0
	_draw_angles(Rect2(0.0, TITLE_HEIGHT, size.x, each - TITLE_HEIGHT))
	_draw_places(Rect2(0.0, TITLE_HEIGHT + each + GAP, size.x, each - TITLE_HEIGHT))


func _draw_angles(frame: Rect2) -> void:
	_draw_frame(frame, "Angle of the tip, to 90°, against the load")
	var law := PackedVector2Array()
	for i in POINTS:
		var alpha := LoadStem.HEAVIEST * i / (POINTS - 1)
		law.append(_angle_at(frame, alpha, rad_to_deg(atan(0.5 * alpha))))
	draw_polyline(law, LAW, 1.5, true)
	for exact in PUBLISHED:
		draw_arc(_angle_at(frame, exact[0], exact[1]), 5.0, 0.0, TAU, 24, EXACT, 2.0, true)
	var trail := PackedVector2Array()
	for point in _angles:
		trail.append(_angle_at(frame, point.x, point.y))
	_draw_trail(trail)


func _draw_places(frame: Rect2) -> void:
	_draw_frame(frame, "Way of the tip; thin: that of a stick")
	var stick := PackedVector2Array()
	for i in POINTS:
		var angle := PI / 2.0 * i / (POINTS - 1)
		stick.append(_place_at(frame, Vector2(sin(angle), cos(angle))))
	draw_polyline(stick, AXIS, 1.0, true)
	for exact in PUBLISHED:
		draw_arc(_place_at(frame, exact[2]), 5.0, 0.0, TAU, 24, EXACT, 2.0, true)
	var trail := PackedVector2Array()
	for place in _places:
		trail.append(_place_at(frame, place))
	_draw_trail(trail)


func _draw_frame(frame: Rect2, title: String) -> void:
	var font := get_theme_default_font()
	draw_string(
		font, frame.position - Vector2(0.0, 9.0), title, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_SIZE
	)
	var corner := Vector2(frame.position.x, frame.end.y)
	draw_polyline(PackedVector2Array([frame.position, corner, frame.end]), AXIS, 1.0)


func _draw_trail(trail: PackedVector2Array) -> void:
	if trail.size() > 1:
		draw_polyline(trail, LIVE, 2.0, true)
	if not trail.is_empty():
		draw_circle(trail[-1], 4.5, LIVE)


func _angle_at(frame: Rect2, alpha: float, degrees: float) -> Vector2:
	var across := alpha / LoadStem.HEAVIEST
	return frame.position + frame.size * Vector2(across, 1.0 - degrees / MAX_DEGREES)


func _place_at(frame: Rect2, place: Vector2) -> Vector2:
	var unit := minf(frame.size.x, frame.size.y)
	return Vector2(frame.position.x, frame.end.y) + unit * Vector2(place.x, -place.y)
