@tool
extends Camera3D
## A camera that orbits a point. A drag rotates it, the wheel or a pinch zooms.

const RADIANS_PER_PIXEL := 0.01
const ZOOM_STEP := 1.12
const STEEPEST := 1.5
const START_TURN := 0.6
const START_TILT := 0.18
## Margin around the framed box.
const MARGIN := 1.15
## Minimum visible part of the view's height.
const MIN_FREE := 0.4

var _turn := START_TURN
var _tilt := START_TILT
var _zoom := 1.0
var _center := Vector3.ZERO
var _size := Vector2.ONE
# Covered pixels at the top and at the bottom of the view.
var _covered := Vector2.ZERO


## Initial offset to the right in the picture.
static func get_start_side() -> Vector3:
	return Vector3.RIGHT.rotated(Vector3.UP, START_TURN)


## Frames a box of that size (width and height in metres) around [param center].
func frame(center: Vector3, size: Vector2) -> void:
	_center = center
	_size = size
	place()


## Sets the covered pixels at the top (x) and at the bottom (y) of the view.
func spare(covered: Vector2) -> void:
	if covered != _covered:
		_covered = covered
		place()


## Resets the camera to its initial position.
func restart() -> void:
	_turn = START_TURN
	_tilt = START_TILT
	_zoom = 1.0
	place()


## Sets the angles in radians, and the zoom.
func turn_to(turn: float, tilt: float, zoom: float) -> void:
	_turn = turn
	_tilt = tilt
	_zoom = zoom
	place()


func get_turn() -> float:
	return _turn


func get_tilt() -> float:
	return _tilt


func get_zoom() -> float:
	return _zoom


## Handles one event over the view. Returns true if the camera used it.
func handle(event: InputEvent, scale_factor: float) -> bool:
	if event is InputEventMouseMotion:
		return _drag(event, scale_factor)
	if event is InputEventMouseButton and event.pressed:
		return _press(event)
	if event is InputEventMagnifyGesture:
		_zoom_by(1.0 / (event as InputEventMagnifyGesture).factor)
		return true
	if event is InputEventPanGesture:
		_zoom_by(pow(ZOOM_STEP, (event as InputEventPanGesture).delta.y))
		return true
	return false


## Moves the camera to its angles and zoom, for any aspect ratio of the view.
func place() -> void:
	if not is_inside_tree():
		return
	var view := Vector2(get_viewport().get_visible_rect().size).max(Vector2.ONE)
	var free := maxf(view.y - _covered.x - _covered.y, view.y * MIN_FREE) / view.y
	var tangent := tan(deg_to_rad(fov) * 0.5)
	var half := maxf(_size.y / free, _size.x * view.y / view.x) * 0.5 * MARGIN
	var distance := (half / tangent + _size.x * 0.5) * _zoom
	var rise := (_covered.x - _covered.y) / view.y * tangent * distance
	basis = Basis.from_euler(Vector3(-_tilt, _turn, 0.0))
	position = _center + basis.z * distance + basis.y * rise
	near = distance * 0.02
	far = distance * 20.0


func _drag(event: InputEventMouseMotion, scale_factor: float) -> bool:
	if not event.button_mask & (MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_MIDDLE):
		return false
	_turn -= event.relative.x * RADIANS_PER_PIXEL / scale_factor
	_tilt = clampf(_tilt + event.relative.y * RADIANS_PER_PIXEL / scale_factor, -0.2, STEEPEST)
	place()
	return true


func _press(event: InputEventMouseButton) -> bool:
	match event.button_index:
		MOUSE_BUTTON_WHEEL_UP:
			_zoom_by(1.0 / ZOOM_STEP)
		MOUSE_BUTTON_WHEEL_DOWN:
			_zoom_by(ZOOM_STEP)
		MOUSE_BUTTON_LEFT when event.double_click:
			restart()
		_:
			return false
	return true


func _zoom_by(factor: float) -> void:
	_zoom = clampf(_zoom * factor, 0.1, 8.0)
	place()
