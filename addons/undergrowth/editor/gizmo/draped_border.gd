@tool
extends RefCounted
## Lines of a field on its ground. It casts rays only after a change of the lines, of the field's
## place or ground, or of its plants.

const BrushGround := preload("../brush/brush_ground.gd")

## Number of points of a line with few corners, and their minimum distance in metres.
const POINTS := 64
const MIN_STEP := 0.25
## Metres above the ground.
const LIFT := 0.03
## Metres above and below the box of the plants, or around a field without plants.
const MARGIN := 1.0
const REACH_WITHOUT_PLANTS := 100.0


## Lines of one field.
class Lines:
	extends RefCounted
	## Ground and place of the field.
	var state: Array = []
	## Draped points by those of the flat line.
	var found: Dictionary[PackedVector3Array, PackedVector3Array] = {}


var _of_field: Dictionary[int, Lines] = {}


## Returns true if [param field] has a ground.
static func is_needed(field: PlantField3D) -> bool:
	return field.is_inside_tree() and field.ground_mode != PlantField3D.GROUND_NONE


## Returns the closed line through [param corners] on the ground of [param field], with additional
## points. Both are in the field's axes.
func drape_loop(field: PlantField3D, corners: PackedVector3Array) -> PackedVector3Array:
	return drape(field, _subdivide(corners)) if is_needed(field) else corners


## Returns [param points] on the ground of [param field]. Points without ground stay.
func drape(field: PlantField3D, points: PackedVector3Array) -> PackedVector3Array:
	if not is_needed(field) or points.is_empty():
		return points
	var lines := _lines_of(field)
	if not lines.found.has(points):
		lines.found[points] = _find(field, points)
	return lines.found[points]


## Casts the rays for [param field] again at its next line.
func forget(field_id: int) -> void:
	_of_field.erase(field_id)


func _lines_of(field: PlantField3D) -> Lines:
	var lines: Lines = _of_field.get_or_add(field.get_instance_id(), Lines.new())
	var state := [field.global_transform, field.ground_mode, field.ground_mesh]
	state.append_array([field.ground_object, field.ground_collision_mask, field.size])
	if lines.state != state:
		lines.state = state
		lines.found.clear()
	return lines


static func _find(field: PlantField3D, points: PackedVector3Array) -> PackedVector3Array:
	var place := field.global_transform
	var box := field.get_aabb()
	var world_box := place * box
	var top := world_box.end.y + MARGIN
	var depth := world_box.size.y + 2.0 * MARGIN
	if not box.has_surface():
		top = place.origin.y + REACH_WITHOUT_PLANTS
		depth = 2.0 * REACH_WITHOUT_PLANTS
	var tops := PackedVector3Array()
	for point in points:
		var at := place * point
		tops.append(Vector3(at.x, top, at.z))
	var met := BrushGround.find_below(field, tops, depth)
	var inverse := place.affine_inverse()
	var draped := PackedVector3Array()
	for i in points.size():
		var is_hit := met[i].is_finite() and met[i].y > top - depth
		draped.append(inverse * (met[i] + Vector3.UP * LIFT) if is_hit else points[i])
	return draped


static func _subdivide(corners: PackedVector3Array) -> PackedVector3Array:
	var length := 0.0
	for i in corners.size():
		length += corners[i].distance_to(corners[(i + 1) % corners.size()])
	var step := maxf(length / POINTS, MIN_STEP)
	var points := PackedVector3Array()
	for i in corners.size():
		var next := corners[(i + 1) % corners.size()]
		var count := maxi(floori(corners[i].distance_to(next) / step), 1)
		for k in count:
			points.append(corners[i].lerp(next, float(k) / count))
	return points
