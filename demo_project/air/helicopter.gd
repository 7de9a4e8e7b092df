extends PlantWindSource3D
## A small helicopter, on a key: its rotor blows plants aside and outward.
##
## It goes round by itself. With the arrow keys or W, A, S, D, E up and Q down, it goes where you
## like, and some seconds after the last key back to its round.

## Emitted when it starts and when it flies home.
signal flight_changed(is_flying: bool)

const KeySteering := preload("res://steering/key_steering.gd")

const SPEED := 9.0  # m/s.
const CLIMB := 3.0  # m/s.
const STEADINESS := 1.2  # 1/s: how fast it takes up a speed.
const LEAN := 0.05  # rad for each metre per second.
const ROUND := 13.0  # m, the radius of its round.
const LOWEST := 2.6  # m over the ground.
const HIGHEST := 14.0
const SPIN := 34.0  # rad/s of the rotor.

## What it flies over: a node with a `height_at(x, z)` method.
@export var ground: Node3D
## The node that the keys steer while it does not fly.
@export var walker: Node3D
## The camera that follows the steered node.
@export var camera: Camera3D
@export var rotor: Node3D
@export var tail_rotor: Node3D

## Whether it is in the air.
var is_flying := false:
	set(flies):
		if flies == is_flying:
			return
		is_flying = flies
		_apply_mode()
		flight_changed.emit(flies)

var _velocity := Vector3.ZERO
var _height := 4.0
var _keys := KeySteering.new()
var _time := 0.0


func _ready() -> void:
	_apply_mode()


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"fly"):
		is_flying = not is_flying


func _process(delta: float) -> void:
	var climb := Input.get_axis(&"fly_down", &"fly_up")
	_keys.update(delta, climb != 0.0)
	_time += delta
	_height = clampf(_height + climb * CLIMB * delta, LOWEST, HIGHEST)
	var wanted := _steered() if is_steered() else _on_round()
	_velocity = _velocity.lerp(wanted, 1.0 - exp(-STEADINESS * delta))
	_velocity.y = 0.0
	var place := global_position + _velocity * delta
	var high := float(ground.call(&"height_at", place.x, place.z)) + _height
	place.y = lerpf(global_position.y, high, 1.0 - exp(-STEADINESS * delta))
	_turn(delta)
	global_position = place
	rotor.rotate_y(SPIN * delta)
	tail_rotor.rotate_x(2.0 * SPIN * delta)


## Whether the keys steer it.
func is_steered() -> bool:
	return is_flying and _keys.is_on()


# The direction of the keys, relative to the camera.
func _steered() -> Vector3:
	var turned := _keys.seen_from(self) * SPEED
	return Vector3(turned.x, 0.0, turned.y)


# Round the meadow's middle, against the clock.
func _on_round() -> Vector3:
	var out := Vector2(global_position.x, global_position.z)
	var way := out.orthogonal().normalized() * 0.4 * SPEED
	way += out.normalized() * clampf(ROUND - out.length(), -1.0, 1.0) * 0.3 * SPEED
	return Vector3(way.x, 0.0, way.y)


# Its nose goes ahead and down as it flies.
func _turn(delta: float) -> void:
	var yaw := global_rotation.y
	if _velocity.length() > 0.3:
		yaw = lerp_angle(yaw, atan2(-_velocity.x, -_velocity.z), 1.0 - exp(-2.0 * delta))
	global_rotation = Vector3(-LEAN * _velocity.length(), yaw, 0.03 * sin(1.7 * _time))


func _apply_mode() -> void:
	active = is_flying
	visible = is_flying
	set_process(is_flying)
	walker.set(&"uses_keys", not is_flying)
	camera.set(&"companion", self if is_flying else walker)
