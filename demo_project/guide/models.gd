extends RefCounted
## Meshes as an artist would export them, for the scenes of the guide.

const BARK := Color("5a4632")
const LEAF := Color("6f9a3c")
const NEEDLE := Color("3f6f45")
const CAP := Color("b53a2c")
const STALK := Color("e6dcc6")
const CARD_SIZE := Vector2i(96, 192)
const GOLDEN_ANGLE := 2.399963


## A shrub of 1.1 m: branches, and cards with a cut-out texture of leaves.
static func make_shrub() -> ArrayMesh:
	var wood := _begin()
	var cards := _begin()
	for i in 9:
		var turn := GOLDEN_ANGLE * i
		var side := Vector3(cos(turn), 0.0, sin(turn))
		var way := (side * (0.25 + 0.06 * i) + Vector3.UP).normalized() * (1.0 - 0.045 * i)
		_tube(wood, side * 0.015, way, 0.016, 0.004, 5)
		for k in 16:
			var place := side * 0.015 + way * (0.22 + 0.05 * k)
			var around := Vector3(cos(GOLDEN_ANGLE * k + i), 0.25, sin(GOLDEN_ANGLE * k + i))
			_card(cards, place, (around + 0.4 * way).normalized() * 0.24, 0.12, Vector3(0, 0.5, 0))
	var leaves := StandardMaterial3D.new()
	leaves.albedo_texture = ImageTexture.create_from_image(_draw_sprig())
	leaves.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR
	leaves.alpha_scissor_threshold = 0.4
	leaves.cull_mode = BaseMaterial3D.CULL_DISABLED
	leaves.roughness = 0.8
	leaves.backlight_enabled = true
	leaves.backlight = Color(0.16, 0.2, 0.08)
	return _commit(cards, leaves, _commit(wood, _plain(BARK)))


## A fir of 1.3 m in flat triangles.
static func make_fir() -> ArrayMesh:
	var trunk := _begin()
	_tube(trunk, Vector3.ZERO, Vector3(0, 0.4, 0), 0.05, 0.04, 5)
	var mesh := _commit(trunk, _plain(BARK))
	var needles := _begin()
	for i in 4:
		_tube(needles, Vector3(0, 0.25 + 0.22 * i, 0), Vector3(0, 0.4, 0), 0.36 - 0.07 * i, 0.0, 7)
	return _commit(needles, _plain(NEEDLE), mesh)


## A toadstool of 0.35 m in two materials.
static func make_toadstool() -> ArrayMesh:
	var stalk := _begin()
	_tube(stalk, Vector3.ZERO, Vector3(0, 0.28, 0), 0.03, 0.022, 8)
	var mesh := _commit(stalk, _plain(STALK))
	var cap := _begin()
	_tube(cap, Vector3(0, 0.25, 0), Vector3(0, 0.06, 0), 0.14, 0.1, 10)
	_tube(cap, Vector3(0, 0.31, 0), Vector3(0, 0.05, 0), 0.1, 0.0, 10)
	return _commit(cap, _plain(CAP), mesh)


static func _begin() -> SurfaceTool:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	return tool


static func _commit(tool: SurfaceTool, material: Material, mesh := ArrayMesh.new()) -> ArrayMesh:
	tool.commit(mesh)
	mesh.surface_set_material(mesh.get_surface_count() - 1, material)
	return mesh


static func _plain(color: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = color
	material.roughness = 0.9
	return material


# Flat faces around a way, closed below.
static func _tube(
	tool: SurfaceTool, from: Vector3, way: Vector3, low: float, high: float, sides: int
) -> void:
	var x := way.cross(Vector3(0.31, 0.2, 0.93)).normalized()
	var z := x.cross(way).normalized()
	var corners: Array[Vector3] = []
	for side in sides + 1:
		var turn := TAU * side / sides
		var out := x * cos(turn) + z * sin(turn)
		corners.append(from + out * low)
		corners.append(from + way + out * high)
	for side in sides:
		var at := 2 * side
		_triangle(tool, corners[at], corners[at + 2], corners[at + 1])
		_triangle(tool, corners[at + 1], corners[at + 2], corners[at + 3])
		_triangle(tool, from, corners[at + 2], corners[at])


static func _triangle(tool: SurfaceTool, a: Vector3, b: Vector3, c: Vector3) -> void:
	var normal := (c - a).cross(b - a)
	if normal.length() < 1e-9:
		return
	for corner: Vector3 in [a, b, c]:
		tool.set_normal(normal.normalized())
		tool.set_uv(Vector2.ZERO)
		tool.add_vertex(corner)


# The normals point away from the middle of the crown, as artists set them for soft light.
static func _card(
	tool: SurfaceTool, from: Vector3, way: Vector3, width: float, middle: Vector3
) -> void:
	var across := way.cross(Vector3.UP).normalized() * width * 0.5
	var corners: Array[Vector3] = [
		from - across, from + across, from + way + across, from + way - across
	]
	var uvs: Array[Vector2] = [Vector2(0, 1), Vector2(1, 1), Vector2(1, 0), Vector2(0, 0)]
	for corner: int in [0, 2, 1, 0, 3, 2]:
		tool.set_normal((corners[corner] - middle).normalized())
		tool.set_uv(uvs[corner])
		tool.add_vertex(corners[corner])


# Seven leaves on a stalk.
static func _draw_sprig() -> Image:
	var image := Image.create_empty(CARD_SIZE.x, CARD_SIZE.y, false, Image.FORMAT_RGBA8)
	image.fill(Color(LEAF, 0.0))
	for y in CARD_SIZE.y:
		for x in CARD_SIZE.x:
			var at := Vector2(x + 0.5, y + 0.5)
			for i in 7:
				var side := -1.0 if i % 2 == 0 else 1.0
				var base := Vector2(48.0, 170.0 - 22.0 * i)
				var way := Vector2(0, -46.0) if i == 6 else Vector2(side * 40.0, -24.0)
				var along := (at - base).dot(way) / way.length_squared()
				var away := absf((at - base).cross(way)) / way.length()
				if along > 0.0 and along < 1.0 and away < 13.0 * sin(PI * pow(along, 0.8)):
					var tone := 0.85 + 0.25 * along - 0.12 * float(away < 1.0)
					image.set_pixel(x, y, Color(LEAF.r * tone, LEAF.g * tone, LEAF.b * tone, 1.0))
			if absf(at.x - 48.0) < 1.6 and at.y > 44.0 and image.get_pixel(x, y).a < 1.0:
				image.set_pixel(x, y, Color(BARK, 1.0))
	image.generate_mipmaps()
	return image
