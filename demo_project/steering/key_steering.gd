extends RefCounted
## Steering by W, A, S, D or the arrow keys, for nodes that otherwise move by
## themselves. Steering ends some seconds after the last key.

const PATIENCE := 6.0  # s without a key.

## The direction of the keys: x to the right, y back, up to a length of 1.
var wish := Vector2.ZERO

var _idle_time := PATIENCE


## Reads the keys for a frame of [param delta] seconds; [param is_busy]: others of its keys are
## held.
func update(delta: float, is_busy := false) -> void:
	wish = Input.get_vector(&"walk_left", &"walk_right", &"walk_forward", &"walk_back")
	_idle_time = 0.0 if wish or is_busy else _idle_time + delta


## A frame in which the keys steer another node.
func ignore(delta: float) -> void:
	wish = Vector2.ZERO
	_idle_time += delta


## Whether the keys steer.
func is_on() -> bool:
	return _idle_time < PATIENCE


## The wish as the camera of [param node] sees it: x and z of the world.
func seen_from(node: Node3D) -> Vector2:
	var camera := node.get_viewport().get_camera_3d()
	return wish.rotated(-camera.global_rotation.y if camera else 0.0)
