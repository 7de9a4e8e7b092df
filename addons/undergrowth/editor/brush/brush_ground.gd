@tool
extends RefCounted
## The ground under the brush: an object's where a field stands on one, such as a terrain of another
## add-on, which need not have colliders. Else what a ray meets in the world.

const Ground := preload("../actions/ground.gd")

## A ray over an object's ground goes on in steps: a part of its way, and at least so many metres.
const STEP_SHARE := 0.02
const LEAST_STEP := 0.25
## Then the place is looked for between two steps.
const HALVINGS := 14

## Rays since the add-on was loaded: all that the brush costs while the pointer moves.
static var ray_count := 0


## Where the ground of [param field] is met from [param from] on; null where it is not.
static func find(field: PlantField3D, from: Vector3, direction: Vector3, plane: Plane) -> Variant:
	ray_count += 1
	var terrain := find_object(field)
	var met: Variant = _find_on(terrain, from, direction) if terrain else null
	return met if met is Vector3 else Ground.find_seen(field.get_world_3d(), from, direction, plane)


## What tells [param field] of heights; null where it stands on something else.
static func find_object(field: PlantField3D) -> Object:
	var path := field.ground_object
	if field.ground_mode != PlantField3D.GROUND_OBJECT or path.is_empty():
		return null
	var found: Variant = field.get_node_or_null(path)
	if found and path.get_subname_count() > 0:
		found = (found as Node).get_indexed(NodePath(":" + path.get_concatenated_subnames()))
	var told := found as Object
	return told if told and told.has_method(&"get_height") else null


static func _find_on(terrain: Object, from: Vector3, direction: Vector3) -> Variant:
	if direction.is_equal_approx(Vector3.DOWN):
		var over := _height_over(terrain, from)
		return from + Vector3.DOWN * over if is_finite(over) else null
	var above := 0.0
	var way := LEAST_STEP
	while way < Ground.FARTHEST:
		var over := _height_over(terrain, from + direction * way)
		if over <= 0.0:
			return _narrow(terrain, from, direction, above, way)
		above = way
		way += maxf(way * STEP_SHARE, LEAST_STEP)
	return null


static func _narrow(
	terrain: Object, from: Vector3, direction: Vector3, above: float, below: float
) -> Vector3:
	for i in HALVINGS:
		var middle := (above + below) * 0.5
		if _height_over(terrain, from + direction * middle) > 0.0:
			above = middle
		else:
			below = middle
	return from + direction * below


# NAN over a hole, which no comparison takes for ground.
static func _height_over(terrain: Object, place: Vector3) -> float:
	var height: Variant = terrain.call(&"get_height", place)
	return place.y - height if height is float or height is int else NAN
