## Makes plant models as users' files have them, for tests of [MeshPlantFunction].
extends RefCounted

const UP := Vector3(0, 1, 0)

var _surfaces: Array[SurfaceTool] = []
var _materials: Array[Material] = []
var _has_uvs := true


## Starts a surface with a material.
func surface(material: Material = null) -> void:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	_surfaces.append(tool)
	_materials.append(material)


## Sets the vertex colour of all that follows in the surface.
func paint(color: Color) -> void:
	_surfaces.back().set_color(color)


func without_uvs() -> void:
	_has_uvs = false


## Adds a sheet in rows along [param spine], as wide as [param widths] at the rows.
func sheet(spine: PackedVector3Array, widths: PackedFloat32Array, across: Vector3) -> void:
	var tool: SurfaceTool = _surfaces.back()
	for row in spine.size() - 1:
		var corners: Array[Vector3] = [
			spine[row] - across * 0.5 * widths[row],
			spine[row] + across * 0.5 * widths[row],
			spine[row + 1] + across * 0.5 * widths[row + 1],
			spine[row + 1] - across * 0.5 * widths[row + 1],
		]
		var normal := (corners[1] - corners[0]).cross(spine[row + 1] - spine[row]).normalized()
		var low := 1.0 - float(row) / (spine.size() - 1)
		var high := 1.0 - float(row + 1) / (spine.size() - 1)
		var uvs: Array[Vector2] = [
			Vector2(0, low), Vector2(1, low), Vector2(1, high), Vector2(0, high)
		]
		for corner: int in [0, 2, 1, 0, 3, 2]:
			tool.set_normal(-normal)
			if _has_uvs:
				tool.set_uv(uvs[corner])
			tool.add_vertex(corners[corner])


## Adds a flat leaf or card from [param base] along [param way].
func leaf(base: Vector3, way: Vector3, width: float, rows := 1) -> void:
	var across := way.cross(UP)
	across = Vector3.RIGHT if across.length() < 0.05 * way.length() else across.normalized()
	var spine: PackedVector3Array = []
	var widths: PackedFloat32Array = []
	for row in rows + 1:
		spine.append(base + way * row / rows)
		widths.append(width)
	sheet(spine, widths, across)


## Adds a stem from the ground with [param rows] of [param sides] faces.
func stem(height: float, radius: float, root := Vector3.ZERO, rows := 8, sides := 6) -> void:
	var tool: SurfaceTool = _surfaces.back()
	for row in rows:
		for side in sides:
			var corners: Array[Vector3] = []
			for at: Vector2i in [
				Vector2i(side, row),
				Vector2i(side + 1, row),
				Vector2i(side + 1, row + 1),
				Vector2i(side, row + 1)
			]:
				var turn := TAU * at.x / sides
				var wide := radius * (1.0 - 0.6 * at.y / rows)
				corners.append(
					root + Vector3(wide * cos(turn), height * at.y / rows, wide * sin(turn))
				)
			var turned := TAU * (side + 0.5) / sides
			for corner: int in [0, 1, 2, 0, 2, 3]:
				tool.set_normal(Vector3(cos(turned), 0, sin(turned)))
				if _has_uvs:
					tool.set_uv(Vector2(float(corner % 2), 1.0 - float(row) / rows))
				tool.add_vertex(corners[corner])


## Adds leaves around a stem at the axis.
func leaves(count: int, from: float, to: float, length: float, width: float, rows := 1) -> void:
	for i in count:
		var turn := 2.4 * i
		var side := Vector3(cos(turn), 0, sin(turn))
		var base := Vector3(0, lerpf(from, to, float(i) / count), 0) + 0.004 * side
		leaf(base, length * (side + Vector3(0, 0.5, 0)).normalized(), width, rows)


func mesh() -> ArrayMesh:
	var made := ArrayMesh.new()
	for i in _surfaces.size():
		_surfaces[i].index()
		if _has_uvs:
			_surfaces[i].generate_tangents()
		made = _surfaces[i].commit(made)
		made.surface_set_material(i, _materials[i])
	return made


## Returns a scene with one node, at [param place].
static func scene_of(shown: Mesh, place := Transform3D()) -> PackedScene:
	return scene_of_nodes({"Plant": shown}, place)


## Returns a scene with a node for each mesh, by name.
static func scene_of_nodes(shown: Dictionary, place := Transform3D()) -> PackedScene:
	var root := Node3D.new()
	for name: String in shown:
		var node := MeshInstance3D.new()
		node.name = name
		node.mesh = shown[name]
		node.transform = place
		root.add_child(node)
		node.owner = root
	var packed := PackedScene.new()
	packed.pack(root)
	root.free()
	return packed


## Returns the scene after it was written as a glTF file and read again.
static func through_gltf(scene: PackedScene, path: String) -> PackedScene:
	var written := scene.instantiate()
	var to := GLTFDocument.new()
	var state := GLTFState.new()
	to.append_from_scene(written, state)
	to.write_to_filesystem(state, path)
	written.free()
	var from := GLTFDocument.new()
	var read := GLTFState.new()
	from.append_from_file(path, read)
	var root := from.generate_scene(read)
	for node in root.find_children("*", "", true, false):
		node.owner = root
	var packed := PackedScene.new()
	packed.pack(root)
	root.free()
	return packed


## Returns a cut-out material with a drawn leaf, a normal map, and both sides.
static func cutout(tint := Color(0.35, 0.6, 0.2)) -> StandardMaterial3D:
	var image := Image.create_empty(32, 64, false, Image.FORMAT_RGBA8)
	for y in 64:
		var half := 15.0 * sin(PI * (y + 1.0) / 66.0)
		for x in 32:
			var inside := absf(x - 15.5) < half
			image.set_pixel(x, y, Color(1, 1, 1, 1.0 if inside else 0.0))
	image.generate_mipmaps()
	var material := StandardMaterial3D.new()
	material.albedo_texture = ImageTexture.create_from_image(image)
	material.albedo_color = tint
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	material.normal_enabled = true
	return material


static func plain(tint: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = tint
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	return material
