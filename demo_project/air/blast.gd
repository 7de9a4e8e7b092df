extends PlantWindSource3D
## An explosion on the ground ahead of the camera, on a key.

const AHEAD := 7.0  # m.
const ABOVE := 0.3  # m over the ground.

## What it goes off on: a node with a `height_at(x, z)` method.
@export var ground: Node3D


func _unhandled_input(event: InputEvent) -> void:
	var camera := get_viewport().get_camera_3d()
	if not event.is_action_pressed(&"explode") or camera == null:
		return
	var place := camera.global_position - camera.global_basis.z * AHEAD
	place.y = float(ground.call(&"height_at", place.x, place.z)) + ABOVE
	global_position = place
	explode()
