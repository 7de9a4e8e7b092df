@tool
extends RefCounted
## The pointer over a 3D view, and where it meets the ground. It casts a ray only where the pixel,
## the camera or the field is another one.

const BrushGround := preload("brush_ground.gd")

var is_ctrl_pressed := false

var _camera: Camera3D
var _point := Vector2.ZERO
var _found: Variant
var _found_by: Array = []


## The pointer is where [param event] says, in the view of [param camera].
func move_to(camera: Camera3D, event: InputEventMouse) -> void:
	_camera = camera
	_point = event.position
	if event is InputEventMouseButton:
		_found_by = []  # A stroke begins on the ground as it is now.
	is_ctrl_pressed = event.ctrl_pressed


## What a ray through the pointer depends on.
func get_sight() -> Array:
	if not is_instance_valid(_camera):
		return []
	return [_camera, _camera.global_transform, _camera.get_camera_projection(), _point.floor()]


## On the ground of [param field] under the pointer; null in the sky.
func find_place(field: PlantField3D) -> Variant:
	if not is_instance_valid(_camera):
		return null
	var sight := get_sight()
	sight.append_array([field, field.global_transform])
	if sight != _found_by:
		_found_by = sight
		_found = _cast(field)
	return _found


func _cast(field: PlantField3D) -> Variant:
	var plane := Plane(field.global_basis.y.normalized(), field.global_position)
	var from := _camera.project_ray_origin(_point)
	return BrushGround.find(field, from, _camera.project_ray_normal(_point), plane)
