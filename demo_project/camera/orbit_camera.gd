extends Camera3D
## A camera that looks at a point over the ground.
##
## Drag with the left button to orbit, with the right or middle button to pan, turn the wheel to
## zoom, and walk with W, A, S, D or the arrow keys. Where it has a companion, the keys move that
## one, and the camera comes along.

const DRAG_SPEED := 0.005  # rad per pixel.
const WALK_SPEED := 0.7  # Distances to the target per second.
const ZOOM_STEP := 1.1
const SMOOTHING := 10.0  # 1/s.

## The point that the camera looks at.
@export var target := Vector3(0.0, 0.8, 0.0)
## Metres between camera and target.
@export_range(0.5, 40.0, 0.1, "suffix:m") var distance := 6.0
## Turn around the target; 0 looks towards -z.
@export_range(-180.0, 180.0, 0.5, "suffix:°") var yaw_degrees := 0.0
## How far the camera looks down.
@export_range(-20.0, 80.0, 0.5, "suffix:°") var pitch_degrees := 12.0
## Farthest distance of the target from the scene's middle.
@export_range(1.0, 50.0, 0.5, "suffix:m") var roaming_radius := 14.0
## What the camera stays above: a node with a `height_at(x, z)` method. None: the plane y = 0.
@export var ground: Node3D
## Minimum height of the camera above the ground, in metres.
@export_range(0.0, 2.0, 0.05, "suffix:m") var clearance := 0.35
## The node that the camera follows while the keys steer it; it has an `is_steered()` method.
@export var companion: Node3D
## How far above the companion's feet the camera looks.
@export_range(0.0, 3.0, 0.05, "suffix:m") var companion_height := 1.0

@onready var _shown_target := target
@onready var _shown_distance := distance
@onready var _yaw := deg_to_rad(yaw_degrees)
@onready var _pitch := deg_to_rad(pitch_degrees)


func _ready() -> void:
	process_mode = PROCESS_MODE_ALWAYS
	_place(1.0)


func _unhandled_input(event: InputEvent) -> void:
	var motion := event as InputEventMouseMotion
	if motion:
		if motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			_yaw -= motion.relative.x * DRAG_SPEED
			_pitch = clampf(_pitch + motion.relative.y * DRAG_SPEED, -0.35, 1.4)
		elif motion.button_mask & (MOUSE_BUTTON_MASK_RIGHT | MOUSE_BUTTON_MASK_MIDDLE):
			_walk(Vector2(-motion.relative.x, -motion.relative.y) * 0.0015)
	var button := event as InputEventMouseButton
	if button and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			distance = maxf(0.8, distance / ZOOM_STEP)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			distance = minf(30.0, distance * ZOOM_STEP)


func _process(delta: float) -> void:
	if not companion:
		var walk := Input.get_vector("walk_left", "walk_right", "walk_forward", "walk_back")
		_walk(walk * WALK_SPEED * delta)
	elif companion.call(&"is_steered"):
		target = companion.global_position + Vector3.UP * companion_height
	_place(1.0 - exp(-SMOOTHING * delta))


func _walk(by: Vector2) -> void:
	target += Basis(Vector3.UP, _yaw) * Vector3(by.x, 0.0, by.y) * distance
	var flat := Vector2(target.x, target.z).limit_length(roaming_radius)
	target = Vector3(flat.x, target.y, flat.y)


func _place(share: float) -> void:
	_shown_target = _shown_target.lerp(target, share)
	_shown_distance = lerpf(_shown_distance, distance, share)
	var back := Basis(Vector3.UP, _yaw) * Basis(Vector3.RIGHT, -_pitch) * Vector3.BACK
	var place := _shown_target + back * _shown_distance
	place.y = maxf(place.y, _ground_height(place) + clearance)
	look_at_from_position(place, _shown_target)


func _ground_height(place: Vector3) -> float:
	return float(ground.call(&"height_at", place.x, place.z)) if ground else 0.0
