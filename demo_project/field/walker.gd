extends AnimatableBody3D
## A walker that pushes plants aside.
##
## It goes round its route by itself. With the arrow keys or W, A, S, D it goes where you like, and
## some seconds after the last key back to its route.

const KeySteering := preload("res://steering/key_steering.gd")

const TURNING := 6.0  # 1/s.

## The round that it goes.
@export var route: Path3D
## Where on the route it starts.
@export_range(0.0, 200.0, 0.1, "suffix:m") var start := 0.0
## How fast it goes.
@export_range(0.1, 10.0, 0.1, "suffix:m/s") var speed := 1.5
## How fast it goes with the keys.
@export_range(0.1, 10.0, 0.1, "suffix:m/s") var steered_speed := 3.2
## What it walks on: a node with a `height_at(x, z)` method.
@export var ground: Node3D
## Farthest from the scene's middle that it goes.
@export_range(1.0, 200.0, 1.0, "suffix:m") var roaming_radius := 34.0

## Whether the keys steer it.
var uses_keys := true

var _keys := KeySteering.new()
var _velocity := Vector2.ZERO

@onready var _along := start


func _ready() -> void:
	var place := _route_place()
	_move_to(Vector2(place.x, place.y))


func _process(delta: float) -> void:
	if uses_keys:
		_keys.update(delta)
	else:
		_keys.ignore(delta)
	var wanted := _steered() if is_steered() else _on_route(delta)
	_velocity = _velocity.lerp(wanted, 1.0 - exp(-TURNING * delta))
	var here := Vector2(global_position.x, global_position.z) + _velocity * delta
	_move_to(here.limit_length(roaming_radius))
	if _velocity.length() > 0.1:
		var yaw := atan2(_velocity.x, _velocity.y)
		global_rotation.y = lerp_angle(global_rotation.y, yaw, 1.0 - exp(-TURNING * delta))


## Whether the keys steer it.
func is_steered() -> bool:
	return _keys.is_on()


## The direction of the keys, relative to the camera.
func _steered() -> Vector2:
	_along = route.curve.get_closest_offset(route.to_local(global_position))
	return _keys.seen_from(self) * steered_speed


## Towards the next place of its route.
func _on_route(delta: float) -> Vector2:
	var way := _route_place() - Vector2(global_position.x, global_position.z)
	if way.length() < speed:
		_along = fposmod(_along + speed * delta, route.curve.get_baked_length())
	return way.limit_length(speed)


func _route_place() -> Vector2:
	var ahead := fposmod(_along + speed, route.curve.get_baked_length())
	var place := route.to_global(route.curve.sample_baked(ahead, true))
	return Vector2(place.x, place.z)


func _move_to(place: Vector2) -> void:
	var height := float(ground.call(&"height_at", place.x, place.y)) if ground else 0.0
	global_position = Vector3(place.x, height, place.y)
