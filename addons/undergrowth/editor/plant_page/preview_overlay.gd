@tool
extends RefCounted
## Line meshes that are skinned like a plant and so bend with it: its rings, and its two bones.

const ROOT_BONE := 0
const TIP_BONE := 1
## Breadth and place of the thick end of a drawn bone, in shares of its length.
const BONE_BREADTH := 0.04
const BONE_WAIST := 0.12


## The cross-sections that the plant's mesh is stretched over (thesis, figure 2.4), and lines along
## the stem that join them.
static func make_rings(function: PlantFunction, height: float, segments: int) -> ArrayMesh:
	var lines := PackedVector3Array()
	var shape := function.get_base_shape(segments)
	var below := PackedVector3Array()
	for level in segments + 1:
		var offset := float(level) / segments
		var ring := PackedVector3Array()
		var width := function.calculate_curve_point(offset)
		for point in shape:
			ring.append(Vector3(point.x * width, offset * height, point.z * width))
		for i in ring.size():
			lines.append_array([ring[i], ring[(i + 1) % ring.size()]])
			if not below.is_empty():
				lines.append_array([below[i], ring[i]])
		below = ring
	return _make_mesh(lines, height)


## The bone from root to tip, drawn as the engine's skeleton editor draws bones.
static func make_bone(height: float) -> ArrayMesh:
	var lines := PackedVector3Array()
	var waist: Array[Vector3] = []
	for i in 4:
		var side := Vector3.RIGHT.rotated(Vector3.UP, i * TAU / 4.0) * BONE_BREADTH * height
		waist.append(side + Vector3.UP * BONE_WAIST * height)
	for i in 4:
		lines.append_array([Vector3.ZERO, waist[i], waist[i], Vector3.UP * height])
		lines.append_array([waist[i], waist[(i + 1) % 4]])
	return _make_mesh(lines, height)


static func make_material(color: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = color
	material.no_depth_test = true
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


static func _make_mesh(lines: PackedVector3Array, height: float) -> ArrayMesh:
	var bones := PackedInt32Array()
	var weights := PackedFloat32Array()
	for point in lines:
		var share := clampf(point.y / height, 0.0, 1.0)
		bones.append_array([ROOT_BONE, TIP_BONE, 0, 0])
		weights.append_array([1.0 - share, share, 0.0, 0.0])
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = lines
	arrays[Mesh.ARRAY_BONES] = bones
	arrays[Mesh.ARRAY_WEIGHTS] = weights
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return mesh
