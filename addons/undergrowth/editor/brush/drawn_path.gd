@tool
extends RefCounted
## The points of a path that the user draws on the ground of a field: with one drag, or with clicks.
## In the axes of the field or the climber.

## Distance of two points of a drag, as a fraction of the path's width, and its minimum in metres.
const SPACING := 0.5
const MIN_SPACING := 0.25
## A path whose ends are nearer than its width, or than this, in metres, is closed.
const MIN_GAP := 0.5
## Minimum length of a closed path, as a factor of the gap.
const MIN_LOOP := 4.0
## Allowed error of the simplified path, as a fraction of its length, and its range in metres.
const TOLERANCE := 0.005
const TOLERANCES := Vector2(0.03, 0.5)
## Fraction of the distance of the neighbours in the handles of a point.
const SMOOTHNESS := 1.0 / 6.0
## In pixels at 100 %.
const THICKNESS := 2.0
const DOT := 4.0

## In metres.
var width := 1.0
var points := PackedVector3Array()

var _is_dragged := false


## Adds a point where the button is pressed.
func press(place: Vector3) -> void:
	_is_dragged = false
	if not is_closed() or points.is_empty():
		points.append(place)


## Follows the pointer while the button is pressed.
func drag(place: Vector3) -> void:
	if points and points[-1].distance_to(place) > maxf(width * SPACING, MIN_SPACING):
		points.append(place)
		_is_dragged = true


## Returns true if the release of the button ends the path: after a drag, or after a click that
## closes it.
func release() -> bool:
	return _is_dragged or is_closed()


## True after a drag, until the next press.
func is_dragged() -> bool:
	return _is_dragged


func is_empty() -> bool:
	return points.is_empty()


## True if there is something to draw.
func is_complete() -> bool:
	return points.size() >= 2 and get_length() > MIN_SPACING


func is_closed() -> bool:
	if points.size() < 3:
		return false
	var gap := maxf(width, MIN_GAP)
	return points[0].distance_to(points[-1]) < gap and get_length() > MIN_LOOP * gap


func get_length() -> float:
	var length := 0.0
	for i in range(1, points.size()):
		length += points[i - 1].distance_to(points[i])
	return length


## Returns a smooth curve through as few points as describe the path.
func make_curve() -> Curve3D:
	var closed := is_closed()
	var corners := _simplify(points, clampf(get_length() * TOLERANCE, TOLERANCES.x, TOLERANCES.y))
	if closed and corners.size() > 3:
		corners.remove_at(corners.size() - 1)
	var curve := Curve3D.new()
	var count := corners.size()
	for i in count:
		var before := corners[posmod(i - 1, count)] if closed else corners[maxi(i - 1, 0)]
		var after := corners[posmod(i + 1, count)] if closed else corners[mini(i + 1, count - 1)]
		var handle := (after - before) * SMOOTHNESS
		curve.add_point(corners[i], -handle, handle)
	curve.closed = closed
	return curve


## Draws the points on [param overlay], and a line to the pointer at [param end], if that is a
## Vector3. All are in the axes of [param node].
func draw(overlay: Control, camera: Camera3D, node: Node3D, end: Variant, color: Color) -> void:
	var shown := points.duplicate()
	if end is Vector3:
		shown.append(end)
	var line := PackedVector2Array()
	for point in shown:
		var place := node.to_global(point)
		if not camera.is_position_behind(place):
			line.append(camera.unproject_position(place))
	var scale := EditorInterface.get_editor_scale()
	if line.size() > 1:
		overlay.draw_polyline(line, color, THICKNESS * scale, true)
	if line:
		overlay.draw_circle(line[0], DOT * scale, color, true, -1.0, true)


# The algorithm of Douglas and Peucker.
static func _simplify(line: PackedVector3Array, tolerance: float) -> PackedVector3Array:
	if line.size() < 3:
		return line
	var farthest := 0
	var distance := 0.0
	for i in range(1, line.size() - 1):
		var nearest := Geometry3D.get_closest_point_to_segment(line[i], line[0], line[-1])
		if nearest.distance_to(line[i]) > distance:
			distance = nearest.distance_to(line[i])
			farthest = i
	if distance <= tolerance:
		return PackedVector3Array([line[0], line[-1]])
	var first := _simplify(line.slice(0, farthest + 1), tolerance)
	first.remove_at(first.size() - 1)
	return first + _simplify(line.slice(farthest), tolerance)
