@tool
extends RefCounted
## Draws a mesh from its side, triangle by triangle, with its vertex colours and the colours of its
## materials, for plants of parts and of meshes. It uses no scene.

const LIGHT := Vector3(-0.45, 0.7, 0.55)
const AMBIENT := 0.65
const MARGIN := 0.04
## Rotation of the camera, the same as in a list's pictures.
const TURN := -0.45

## Pixels of a texture that are less opaque are not drawn.
const MIN_ALPHA := 0.4

var _canvas: Image
var _depths: PackedFloat32Array = []
## Of the material of a surface; null without one.
var _texture: Image


## Returns a picture of [param mesh] on a transparent background.
func paint(mesh: ArrayMesh, size: Vector2i) -> Image:
	_canvas = Image.create_empty(size.x, size.y, false, Image.FORMAT_RGBA8)
	_depths.resize(size.x * size.y)
	_depths.fill(-INF)
	var places := PackedVector3Array()
	for surface in mesh.get_surface_count():
		places.append_array(mesh.surface_get_arrays(surface)[Mesh.ARRAY_VERTEX])
	places = _place(places, Vector2(size))
	var first := 0
	for surface in mesh.get_surface_count():
		var arrays := mesh.surface_get_arrays(surface)
		_paint_surface(arrays, places.slice(first), mesh.surface_get_material(surface))
		first += (arrays[Mesh.ARRAY_VERTEX] as PackedVector3Array).size()
	return _canvas


func _paint_surface(arrays: Array, points: PackedVector3Array, material: Material) -> void:
	var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var plain := material as BaseMaterial3D
	var tint := plain.albedo_color if plain else Color.WHITE
	var uses_colors: bool = (
		arrays[Mesh.ARRAY_COLOR] != null and (not plain or plain.vertex_color_use_as_albedo)
	)
	var colors := PackedColorArray()
	if uses_colors:
		colors = arrays[Mesh.ARRAY_COLOR]
	var uvs := PackedVector2Array()
	_texture = _image_of(plain)
	if _texture and arrays[Mesh.ARRAY_TEX_UV]:
		uvs = arrays[Mesh.ARRAY_TEX_UV]
	for i in range(0, indices.size(), 3):
		var light := _light(normals[indices[i]])
		var color := tint
		if uses_colors:
			color *= colors[indices[i]].lerp(colors[indices[i + 1]], 0.5)
		color = Color(color.r * light, color.g * light, color.b * light, 1.0)
		var corners := PackedVector2Array()
		for corner in 3 if not uvs.is_empty() else 0:
			corners.append(uvs[indices[i + corner]])
		_fill(points[indices[i]], points[indices[i + 1]], points[indices[i + 2]], color, corners)


static func _image_of(material: BaseMaterial3D) -> Image:
	var image := (
		material.albedo_texture.get_image() if material and material.albedo_texture else null
	)
	if image and image.is_compressed() and image.decompress() != OK:
		return null
	return image


# In pixels, at the largest scale that fits. A larger z is nearer.
func _place(points: PackedVector3Array, size: Vector2) -> PackedVector3Array:
	var turned := PackedVector3Array()
	var seen := Rect2()
	for point in points:
		var at := point.rotated(Vector3.UP, TURN)
		var flat := Vector2(at.x, -at.y)
		seen = Rect2(flat, Vector2.ZERO) if turned.is_empty() else seen.expand(flat)
		turned.append(at)
	var free := size * (1.0 - 2.0 * MARGIN)
	var meter := minf(free.x / maxf(seen.size.x, 1e-6), free.y / maxf(seen.size.y, 1e-6))
	var middle := seen.get_center()
	for i in turned.size():
		var at := turned[i]
		var flat := (Vector2(at.x, -at.y) - middle) * meter + size * 0.5
		turned[i] = Vector3(flat.x, flat.y, at.z)
	return turned


# Both sides of a leaf are lit.
func _light(normal: Vector3) -> float:
	var turned := normal.rotated(Vector3.UP, TURN)
	return AMBIENT + (1.0 - AMBIENT) * absf(turned.dot(LIGHT.normalized()))


## [param uvs]: of the corners; empty without a texture.
func _fill(a: Vector3, b: Vector3, c: Vector3, color: Color, uvs: PackedVector2Array) -> void:
	var low := a.min(b).min(c).floor()
	var high := a.max(b).max(c).ceil()
	var area := (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
	if is_zero_approx(area):
		return
	for y in range(maxi(0, int(low.y)), mini(_canvas.get_height(), int(high.y))):
		for x in range(maxi(0, int(low.x)), mini(_canvas.get_width(), int(high.x))):
			var px := x + 0.5
			var py := y + 0.5
			var to_c := ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area
			var to_b := ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area
			var depth := a.z + (b.z - a.z) * to_b + (c.z - a.z) * to_c
			var at := y * _canvas.get_width() + x
			if minf(to_b, to_c) >= 0.0 and to_b + to_c <= 1.0 and depth > _depths[at]:
				var shown := color
				if not uvs.is_empty():
					var uv := uvs[0] + (uvs[1] - uvs[0]) * to_b + (uvs[2] - uvs[0]) * to_c
					var texel := _texel(uv)
					if texel.a < MIN_ALPHA:
						continue
					shown = Color(color.r * texel.r, color.g * texel.g, color.b * texel.b, 1.0)
				_depths[at] = depth
				_canvas.set_pixel(x, y, shown)


func _texel(uv: Vector2) -> Color:
	var size := _texture.get_size()
	return _texture.get_pixel(
		mini(int(fposmod(uv.x, 1.0) * size.x), size.x - 1),
		mini(int(fposmod(uv.y, 1.0) * size.y), size.y - 1)
	)
