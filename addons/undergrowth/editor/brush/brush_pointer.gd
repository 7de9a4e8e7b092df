@tool
extends RefCounted
## The pointer over a 3D view, and its point on the ground. It casts a ray only after a change of
## pixel, camera or field.

const BrushGround := preload("brush_ground.gd")

var is_ctrl_pressed := false
## Whether the left button is down.
var is_pressed := false

var _camera: Camera3D
var _point := Vector2.ZERO
var _found: Variant
var _found_by: Array = []


## Moves the pointer to the position of [param event] in the view of [param camera].
func move_to(camera: Camera3D, event: InputEventMouse) -> void:
	_camera = camera
	_point = event.position
	if event is InputEventMouseButton:
		_found_by = []  # A stroke starts on the current ground.
	is_ctrl_pressed = event.ctrl_pressed
	is_pressed = event.button_mask & MOUSE_BUTTON_MASK_LEFT != 0


## Returns the position of the pointer in its 3D view.
func get_point() -> Vector2:
	return _point


func get_camera() -> Camera3D:
	return _camera


## True if [param overlay] covers the 3D view of the pointer.
func is_over(overlay: Control) -> bool:
	return is_instance_valid(_camera) and overlay.get_parent().is_ancestor_of(_camera)


## The values that determine the result of a ray through the pointer.
func get_sight() -> Array:
	if not is_instance_valid(_camera):
		return []
	return [_camera, _camera.global_transform, _camera.get_camera_projection(), _point.floor()]


## Returns the point on the ground of [param field] under the pointer, or null in the sky.
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
