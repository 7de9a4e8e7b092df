@tool
extends RefCounted
## The border of a PlantField3D, as its gizmo draws it: in the field's own axes, on its plane y = 0.

# As exact as the field itself is.
const STAGES := 5
const TOLERANCE_DEGREES := 4.0


## The corners one after the other; the last one is joined to the first. Fewer than three: the field
## has no area.
static func of(field: PlantField3D) -> PackedVector3Array:
	if not field.area:
		return _rectangle(field.size)
	return _flat(field.area.tessellate(STAGES, TOLERANCE_DEGREES), Transform3D.IDENTITY)


## True where the field's size says what its area is, and can be dragged.
static func is_rectangle(field: PlantField3D) -> bool:
	return not field.area


## What the border depends on: where this is the same, so is the border.
static func look(field: PlantField3D) -> Array:
	return [field.size, field.area.get_baked_points() if field.area else null]


static func _rectangle(size: Vector2) -> PackedVector3Array:
	var x := size.x * 0.5
	var z := size.y * 0.5
	return [Vector3(-x, 0, -z), Vector3(x, 0, -z), Vector3(x, 0, z), Vector3(-x, 0, z)]


static func _flat(points: PackedVector3Array, place: Transform3D) -> PackedVector3Array:
	var corners := PackedVector3Array()
	for point in points:
		var corner := (place * point) * Vector3(1, 0, 1)
		if corners.is_empty() or not corner.is_equal_approx(corners[-1]):
			corners.append(corner)
	if corners.size() > 1 and corners[0].is_equal_approx(corners[-1]):
		corners.remove_at(corners.size() - 1)
	return corners
