@tool
extends RefCounted
## Line shapes for gizmos, as pairs of points, and the position of a drag on a line.

const ARC_STEPS := 24


## Returns the twelve edges of [param box].
static func box(box: AABB) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for i in 8:
		for axis_bit: int in [1, 2, 4]:
			if not i & axis_bit:
				lines.append(_corner(box, i))
				lines.append(_corner(box, i | axis_bit))
	return lines


## Returns a closed line through all of [param points].
static func loop(points: PackedVector3Array) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for i in points.size():
		lines.append(points[i])
		lines.append(points[(i + 1) % points.size()])
	return lines


## Returns a line through [param joints], with a small cross at each.
static func chain(joints: PackedVector3Array) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for i in joints.size():
		var link := joints[maxi(i, 1)] - joints[maxi(i, 1) - 1]
		lines.append_array(cross(joints[i], link.length() * 0.08))
		if i > 0:
			lines.append_array([joints[i - 1], joints[i]])
	return lines


## Returns an arrow from [param from] to [param to], with two barbs in the plane across [param up].
static func arrow(from: Vector3, to: Vector3, up: Vector3) -> PackedVector3Array:
	var along := to - from
	var across := along.cross(up).normalized() * along.length() * 0.16
	var neck := to - along * 0.28
	return PackedVector3Array([from, to, to, neck + across, to, neck - across])


## Returns the arc from direction [param from] to [param to], both unit vectors, with a radius in
## metres.
static func arc(from: Vector3, to: Vector3, radius: float) -> PackedVector3Array:
	var lines := PackedVector3Array()
	var axis := from.cross(to)
	if axis.length() < 1e-4:
		return lines
	var angle := from.angle_to(to)
	for i in ARC_STEPS:
		lines.append(from.rotated(axis.normalized(), angle * i / ARC_STEPS) * radius)
		lines.append(from.rotated(axis.normalized(), angle * (i + 1) / ARC_STEPS) * radius)
	return lines


## Returns a small cross of three lines.
static func cross(at: Vector3, arm: float) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		lines.append(at - axis * arm)
		lines.append(at + axis * arm)
	return lines


## Returns the point of [param way], a unit vector in the axes of [param node], that is nearest to
## the line of sight through [param point]: in metres of the node from [param start], at most
## [param farthest] in both directions.
static func reach_along(
	node: Node3D,
	way: Vector3,
	farthest: float,
	camera: Camera3D,
	point: Vector2,
	start := Vector3.ZERO
) -> float:
	var to_node := node.global_transform.affine_inverse()
	var eye := to_node * camera.project_ray_origin(point)
	var sight := (to_node.basis * camera.project_ray_normal(point)).normalized()
	var far := way * farthest
	var near := Geometry3D.get_closest_points_between_segments(
		start - far, start + far, eye, eye + sight * (farthest + eye.length())
	)
	return (near[0] - start).dot(way)


static func _corner(box: AABB, i: int) -> Vector3:
	return box.position + box.size * Vector3(i & 1, i >> 1 & 1, i >> 2 & 1)
