@tool
extends RefCounted
## Line shapes for gizmos, as pairs of points.

const ARC_STEPS := 24


## The twelve edges of [param box].
static func box(box: AABB) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for i in 8:
		for axis_bit: int in [1, 2, 4]:
			if not i & axis_bit:
				lines.append(_corner(box, i))
				lines.append(_corner(box, i | axis_bit))
	return lines


## A line through all of [param points] and back to the first.
static func loop(points: PackedVector3Array) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for i in points.size():
		lines.append(points[i])
		lines.append(points[(i + 1) % points.size()])
	return lines


## An arrow from [param from] to [param to], with two barbs in the plane across [param up].
static func arrow(from: Vector3, to: Vector3, up: Vector3) -> PackedVector3Array:
	var along := to - from
	var across := along.cross(up).normalized() * along.length() * 0.16
	var neck := to - along * 0.28
	return PackedVector3Array([from, to, to, neck + across, to, neck - across])


## The turn from direction [param from] to [param to], both unit vectors, with a radius in metres.
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


## A small cross of three lines.
static func cross(at: Vector3, arm: float) -> PackedVector3Array:
	var lines := PackedVector3Array()
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		lines.append(at - axis * arm)
		lines.append(at + axis * arm)
	return lines


static func _corner(box: AABB, i: int) -> Vector3:
	return box.position + box.size * Vector3(i & 1, i >> 1 & 1, i >> 2 & 1)
