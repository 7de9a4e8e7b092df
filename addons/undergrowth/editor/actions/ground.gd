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
	if not node or not node.is_visible_in_tree() or _is_part_of_plant(node):
		return {}
	var best := {}
	for part in _meshes_of(node):
		var place: Transform3D = part["place"]
		var hit := _cast_on_mesh(part["mesh"], place, from, to)
		if hit.is_empty():
			continue
		if best.is_empty() or _is_nearer(from, hit["position"], best["position"]):
			best = hit
			best["node"] = node
	return best


static func _cast_on_mesh(mesh: Mesh, place: Transform3D, from: Vector3, to: Vector3) -> Dictionary:
	if not mesh or is_zero_approx(place.basis.determinant()):
		return {}
	var inverse := place.affine_inverse()
	var hit := _cast_in_mesh(mesh, inverse * from, inverse * to)
	if hit.is_empty():
		return {}
	var normal: Vector3 = inverse.basis.transposed() * (hit["normal"] as Vector3)
	return {"position": place * (hit["position"] as Vector3), "normal": normal.normalized()}


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


static func _meshes_of(node: Node3D) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	if node is MeshInstance3D:
		found.append({"mesh": (node as MeshInstance3D).mesh, "place": node.global_transform})
	elif node is CSGShape3D or node is GridMap:
		var parts: Array = node.call(&"get_meshes")
		for i in range(0, parts.size(), 2):
			found.append({"mesh": parts[i + 1], "place": node.global_transform * parts[i]})
	return found


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
