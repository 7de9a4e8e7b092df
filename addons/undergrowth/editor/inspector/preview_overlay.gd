@tool
extends RefCounted
## Line meshes with the skin of a plant, so that they bend with it: its rings, and its bones. A stem
## that bends along its length has one bone per joint. Other plants have 0 joints.

const ROOT_BONE := 0
const TIP_BONE := 1
const FIRST_LINK := 2
## Breadth and position of the thick end of a drawn bone, as fractions of its length.
const BONE_BREADTH := 0.04
const BONE_WAIST := 0.12


## Returns the cross-sections of the plant's mesh (thesis, figure 2.4), and lines along the stem
## between them.
static func make_rings(
	function: PlantFunction, height: float, segments: int, joints := 0
) -> ArrayMesh:
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
	return _make_mesh(lines, height, joints)


## Returns the bones from root to tip, in the shape of the engine's skeleton editor.
static func make_bones(height: float, joints := 0) -> ArrayMesh:
	var lines := PackedVector3Array()
	var length := height / maxi(joints, 1)
	for link in maxi(joints, 1):
		var base := Vector3.UP * length * link
		var waist: Array[Vector3] = []
		for i in 4:
			var side := Vector3.RIGHT.rotated(Vector3.UP, i * TAU / 4.0) * BONE_BREADTH * length
			waist.append(base + side + Vector3.UP * BONE_WAIST * length)
		for i in 4:
			lines.append_array([base, waist[i], waist[i], base + Vector3.UP * length])
			lines.append_array([waist[i], waist[(i + 1) % 4]])
	return _make_mesh(lines, height, joints)


static func make_material(color: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = color
	material.no_depth_test = true
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


static func _make_mesh(lines: PackedVector3Array, height: float, joints: int) -> ArrayMesh:
	var bones := PackedInt32Array()
	var weights := PackedFloat32Array()
	for point in lines:
		var share := clampf(point.y / height, 0.0, 1.0)
		var lower := ROOT_BONE
		var upper := TIP_BONE
		if joints > 0:  # From the middle of a link to the middle of the next.
			var place := clampf(share * joints - 0.5, 0.0, joints - 1.0)
			lower = FIRST_LINK + floori(place)
			upper = FIRST_LINK + ceili(place)
			share = place - floorf(place)
		bones.append_array([lower, upper, 0, 0])
		weights.append_array([1.0 - share, share, 0.0, 0.0])
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = lines
	arrays[Mesh.ARRAY_BONES] = bones
	arrays[Mesh.ARRAY_WEIGHTS] = weights
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return mesh
