@tool
extends RefCounted
## Finds the ground under the brush: the field's ground object, such as a terrain of another add-on,
## which needs no colliders. Without one, the first hit of a ray in the world.

const Ground := preload("../actions/ground.gd")

## Step of a ray over an object's ground: a fraction of its length, and a minimum in metres.
const STEP_SHARE := 0.02
const MIN_STEP := 0.25
## Number of bisections between two steps.
const HALVINGS := 14

## Rays since the add-on was loaded: the whole cost of the brush while the pointer moves.
static var ray_count := 0


## Returns the first ground of [param field] from [param from] on, or null.
static func find(field: PlantField3D, from: Vector3, direction: Vector3, plane: Plane) -> Variant:
	ray_count += 1
	var terrain := find_object(field)
	var met: Variant = find_on(terrain, from, direction) if terrain else null
	return met if met is Vector3 else Ground.find_seen(field.get_world_3d(), from, direction, plane)


## Returns the ground of [param field] below each of [param tops], or Vector3.INF where rays of
## [param depth] metres meet none.
static func find_below(
	field: PlantField3D, tops: PackedVector3Array, depth: float
) -> PackedVector3Array:
	ray_count += tops.size()
	var terrain := find_object(field)
	if not terrain:
		return Ground.find_below(field.get_world_3d(), tops, depth)
	var places := PackedVector3Array()
	for top in tops:
		var met: Variant = find_on(terrain, top, Vector3.DOWN)
		places.append(met if met is Vector3 else Vector3.INF)
	if places.has(Vector3.INF):  # Other ground can close a hole.
		var others := Ground.find_below(field.get_world_3d(), tops, depth)
		for i in places.size():
			places[i] = places[i] if places[i].is_finite() else others[i]
	return places


## Returns the ground object of [param field], or null if it uses another ground.
static func find_object(field: PlantField3D) -> Object:
	var path := field.ground_object
	if field.ground_mode != PlantField3D.GROUND_OBJECT or path.is_empty():
		return null
	var found: Variant = field.get_node_or_null(path)
	if found and path.get_subname_count() > 0:
		found = (found as Node).get_indexed(NodePath(":" + path.get_concatenated_subnames()))
	var ground := found as Object
	return ground if ground and ground.has_method(&"get_height") else null


## Returns the first point of a ray below the heights of [param terrain], or null.
static func find_on(terrain: Object, from: Vector3, direction: Vector3) -> Variant:
	if direction.is_equal_approx(Vector3.DOWN):
		var over := _height_over(terrain, from)
		return from + Vector3.DOWN * over if is_finite(over) else null
	var above := 0.0
	var way := MIN_STEP
	while way < Ground.FARTHEST:
		var over := _height_over(terrain, from + direction * way)
		if over <= 0.0:
			return _narrow(terrain, from, direction, above, way)
		above = way
		way += maxf(way * STEP_SHARE, MIN_STEP)
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


# NAN over a hole. Comparisons with it are false, so that it never counts as ground.
static func _height_over(terrain: Object, place: Vector3) -> float:
	var height: Variant = terrain.call(&"get_height", place)
	return place.y - height if height is float or height is int else NAN
