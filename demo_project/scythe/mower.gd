extends Node3D
## A mower that goes its rounds over an endless field, and leaves stubble that grows back.
##
## With W, A, S, D or the arrow keys it goes where you like, and some seconds after the last key on
## from there.

const KeySteering := preload("res://steering/key_steering.gd")

const TURNING := 4.0  # 1/s.

## What it mows.
@export var field: PlantField3D
## How high the stubble is.
@export_range(0.0, 0.5, 0.01, "suffix:m") var stubble := 0.05
## How wide it mows.
@export_range(0.2, 4.0, 0.1, "suffix:m") var width := 1.4
## How fast it goes.
@export_range(0.1, 10.0, 0.1, "suffix:m/s") var speed := 1.6
## How fast its rounds turn.
@export_range(0.0, 1.0, 0.01, "suffix:1/s") var turning := 0.2

var _keys := KeySteering.new()
var _velocity := Vector2(0.0, -1.0)


func _physics_process(delta: float) -> void:
	_keys.update(delta)
	var wanted := _velocity.normalized().rotated(turning * delta) * speed
	if is_steered():
		wanted = _keys.seen_from(self) * 2.0 * speed
		wanted = wanted if _keys.wish else _velocity.limit_length(0.01)
	_velocity = _velocity.lerp(wanted, 1.0 - exp(-TURNING * delta))
	global_position += Vector3(_velocity.x, 0.0, _velocity.y) * delta
	global_rotation.y = atan2(-_velocity.x, -_velocity.y)
	field.set_height_in_sphere(global_position, 0.5 * width, stubble)


## Whether the keys steer it.
func is_steered() -> bool:
	return _keys.is_on()
