@tool
extends RefCounted
## Finds the ground along a ray: colliders, meshes, or the plane y = 0.

const FARTHEST := 2000.0
## Distance in front of a camera whose view is empty.
const DISTANCE_WITHOUT_GROUND := 4.0
## Minimum up part of the normal. On steeper surfaces the search continues with the ground below.
const MIN_UPRIGHT := 0.4
const OFF_WALL := 0.05
## Metres from a mesh within which a collider is its own.
const SAME_GROUND := 0.2
## Margin (m) around the edge of a flat mesh.
const EDGE := 1e-3
## Maximum number of triangles of a searched mesh. A search in a larger one takes too long.
const MAX_TRIANGLES := 50000


## A mesh in the world.
class Part:
	var mesh: Mesh
	var place: Transform3D
	var inverse: Transform3D


## Returns the ground along a ray of [param world]: its "position" and "normal", the "node" of its
## mesh, and its "collider" if it has one. At the foot of a wall without ground it is the plane
## y = 0. Empty: none.
static func find_hit(world: World3D, from: Vector3, direction: Vector3) -> Dictionary:
	var hit := _cast(world, from, from + direction * FARTHEST)
	if hit.is_empty():
		return {}
	var normal: Vector3 = hit["normal"]
	if normal.y >= MIN_UPRIGHT:
		return hit
	var beside: Vector3 = hit["position"] + normal * OFF_WALL
	var below := _cast(world, beside, beside + Vector3.DOWN * FARTHEST)
	var foot := {"position": on_plane(beside, Vector3.DOWN), "normal": Vector3.UP}
	return below if not below.is_empty() else foot


## Returns the first hit of a ray of [param world], or its intersection with [param plane], or null.
static func find_seen(world: World3D, from: Vector3, direction: Vector3, plane: Plane) -> Variant:
	var hit := _cast(world, from, from + direction * FARTHEST)
	if not hit.is_empty():
		return hit["position"]
	return plane.intersects_segment(from, from + direction * FARTHEST)


## Returns the first hits of vertical rays from [param tops] downwards, with a length of
## [param depth] metres. A ray without a hit gives Vector3.INF. All rays share one search for
## meshes, which makes many of them fast.
static func find_below(
	world: World3D, tops: PackedVector3Array, depth: float
) -> PackedVector3Array:
	var down := Vector3.DOWN * depth
	var box := AABB(tops[0], down).abs()
	for top in tops:
		box = box.expand(top).expand(top + down)
	var parts := _parts_in(world, box)
	var query := PhysicsRayQueryParameters3D.new()
	var hits := PackedVector3Array()
	for top in tops:
		query.from = top
		query.to = top + down
		var solid := world.direct_space_state.intersect_ray(query)
		var nearest: Vector3 = Vector3.INF if solid.is_empty() else solid["position"]
		for part in parts:
			var hit := _cast_on_part(part, top, top + down)
			if not hit.is_empty() and _is_nearer(top, hit["position"], nearest):
				nearest = hit["position"]
		hits.append(nearest)
	return hits


## Returns the intersection of a ray with the plane y = 0, or a point of it in front of
## [param from].
static func on_plane(from: Vector3, direction: Vector3) -> Vector3:
	var met: Variant = Plane(Vector3.UP, 0.0).intersects_ray(from, direction)
	if met is Vector3 and from.distance_to(met) <= FARTHEST:
		return met
	var ahead := from + direction * DISTANCE_WITHOUT_GROUND
	return Vector3(ahead.x, 0.0, ahead.z)


## Returns the nearest hit with its "position" and "normal", or an empty dictionary.
static func _cast(world: World3D, from: Vector3, to: Vector3) -> Dictionary:
	var query := PhysicsRayQueryParameters3D.create(from, to)
	var solid := world.direct_space_state.intersect_ray(query)
	var nearest := solid
	for id in RenderingServer.instances_cull_ray(from, to, world.scenario):
		var hit := _cast_on(instance_from_id(id) as Node3D, from, to)
		if hit.is_empty():
			continue
		if nearest.is_empty() or _is_nearer(from, hit["position"], nearest["position"]):
			nearest = hit
	if not solid.is_empty() and nearest["position"].distance_to(solid["position"]) < SAME_GROUND:
		nearest["collider"] = solid["collider"]
	return nearest


static func _is_nearer(from: Vector3, a: Vector3, b: Vector3) -> bool:
	return from.distance_squared_to(a) < from.distance_squared_to(b)


static func _cast_on(node: Node3D, from: Vector3, to: Vector3) -> Dictionary:
	var best := {}
	for part in _parts_of(node):
		var hit := _cast_on_part(part, from, to)
		if hit.is_empty():
			continue
		if best.is_empty() or _is_nearer(from, hit["position"], best["position"]):
			best = hit
			best["node"] = node
	return best


static func _cast_on_part(part: Part, from: Vector3, to: Vector3) -> Dictionary:
	var hit := _cast_in_mesh(part.mesh, part.inverse * from, part.inverse * to)
	if hit.is_empty():
		return {}
	var normal: Vector3 = part.inverse.basis.transposed() * (hit["normal"] as Vector3)
	return {"position": part.place * (hit["position"] as Vector3), "normal": normal.normalized()}


## Returns the same in the mesh's own axes.
static func _cast_in_mesh(mesh: Mesh, from: Vector3, to: Vector3) -> Dictionary:
	if mesh is PlaneMesh:  # With any number of subdivisions.
		return _cast_on_flat(mesh as PlaneMesh, from, to)
	if _count_triangles(mesh) > MAX_TRIANGLES:
		return {}
	var triangles := mesh.generate_triangle_mesh()
	return triangles.intersect_segment(from, to) if triangles else {}


static func _cast_on_flat(mesh: PlaneMesh, from: Vector3, to: Vector3) -> Dictionary:
	var box := mesh.get_aabb()
	var normal := Vector3.ZERO
	normal[box.get_shortest_axis_index()] = 1.0
	var met: Variant = Plane(normal, box.position.dot(normal)).intersects_segment(from, to)
	if met is Vector3 and box.grow(EDGE).has_point(met):
		return {"position": met, "normal": normal}
	return {}


static func _parts_in(world: World3D, box: AABB) -> Array[Part]:
	var parts: Array[Part] = []
	for id in RenderingServer.instances_cull_aabb(box, world.scenario):
		parts.append_array(_parts_of(instance_from_id(id) as Node3D))
	return parts


# Returns the meshes of a visible node that is not a plant.
static func _parts_of(node: Node3D) -> Array[Part]:
	var found: Array[Part] = []
	if not node or not node.is_visible_in_tree() or _is_part_of_plant(node):
		return found
	if node is MeshInstance3D:
		_add_part(found, (node as MeshInstance3D).mesh, node.global_transform)
	elif node is CSGShape3D or node is GridMap:
		var meshes: Array = node.call(&"get_meshes")
		for i in range(0, meshes.size(), 2):
			var place: Transform3D = meshes[i]
			_add_part(found, meshes[i + 1] as Mesh, node.global_transform * place)
	return found


static func _add_part(parts: Array[Part], mesh: Mesh, place: Transform3D) -> void:
	if not mesh or is_zero_approx(place.basis.determinant()):
		return
	var part := Part.new()
	part.mesh = mesh
	part.place = place
	part.inverse = place.affine_inverse()
	parts.append(part)


static func _is_part_of_plant(node: Node) -> bool:
	while node:
		if node is Plant3D:
			return true
		node = node.get_parent()
	return false


static func _count_triangles(mesh: Mesh) -> int:
	var stored := mesh as ArrayMesh
	var count := 0
	for i in stored.get_surface_count() if stored else 0:
		var indices := stored.surface_get_array_index_len(i)
		count += (indices if indices > 0 else stored.surface_get_array_len(i)) / 3
	return count
