@tool
extends MeshInstance3D
## Ground that continues a field: it takes the mean colour of the field's plants, gets lighter where
## gusts pass, and, if [member shows_density] is on, is bare where no plants are.
##
## It needs a material with ground.gdshader or ground_layer.gdshader and changes a copy of it. The
## static functions do the same for the material of a terrain.

## Pixels of one side of the picture of the density.
const MASK_SIZE := 128
## Maximum number of plants that the picture counts. Of more plants it counts evenly chosen ones.
const MASK_PLANTS := 20000
## Few, as of distant plants: the many parts of a head that hide each other count once.
const SEGMENTS := 3
const SEEDS := 3
## Layers of height by which tall plants hide low ones.
const LAYERS := 48
## Extinction of the view per m² of leaves on a m² of ground. Evenly spread leaves would have 4.4 in
## a view 6.5° below the horizon. Those of plants overlap, and leave gaps.
const EXTINCTION := 1.5
## The species of fields without own ones.
const DEFAULT_SPECIES := "res://addons/undergrowth/species/meadow_grass.tres"

## The field on this ground.
@export var field: PlantField3D
## If [code]true[/code], the ground is bare where the field has no plants, and beyond the field.
## Otherwise the field continues to the horizon.
@export var shows_density := false

var _material: ShaderMaterial


func _ready() -> void:
	var shown := get_active_material(0) as ShaderMaterial
	if field == null or shown == null or Engine.is_editor_hint():
		return
	_material = shown.duplicate()
	material_override = _material
	apply_color(_material, field)
	if field.is_inside_tree():
		_show_bounds()
	field.build_finished.connect(_show_bounds)
	if shows_density:
		field.build_finished.connect(_show_density)
		_show_density()


func _process(_delta: float) -> void:
	if _material == null or not is_instance_valid(field) or field.wind == null:
		return
	if field.wind.kind == PlantWind.KIND_AIR:
		field.wind.apply_to_material(_material)


## Gives [param material] the mean colour of the plants of [param of_field]:
## [code]field_color[/code] and [code]field_translucency[/code].
static func apply_color(material: ShaderMaterial, of_field: PlantField3D) -> void:
	var species := _species_of(of_field)
	var weights := 0.0
	for entry in species:
		weights += entry.weight if entry != null and entry.species != null else 0.0
	var meshes: Array[Array] = []  # Each with the size and the density of its plants.
	var tallest := 1e-6
	for entry in species:
		if entry == null or entry.species == null or weights <= 0.0:
			continue
		var size := (entry.scale_range.x + entry.scale_range.y) * 0.5
		var density := of_field.density * entry.density_factor * entry.weight / weights
		for i in SEEDS:
			var mesh := entry.species.generate_mesh(0.0, SEGMENTS, i + 1)
			if mesh == null:
				break  # The species has an error, which it reports.
			tallest = maxf(tallest, mesh.get_aabb().end.y * size)
			meshes.append([mesh, size, density / SEEDS])
	var layers: Array[Layer] = []
	for i in LAYERS:
		layers.append(Layer.new())
	for of_mesh in meshes:
		var mesh: ArrayMesh = of_mesh[0]
		for surface in mesh.get_surface_count():
			_add_triangles(
				mesh.surface_get_arrays(surface), of_mesh[1], of_mesh[2], tallest, layers
			)
	var sum := Layer.new()
	var above := 0.0
	for i in LAYERS:  # Each layer hides the ones below it.
		var layer := layers[LAYERS - 1 - i]
		var seen := exp(-EXTINCTION * (above + 0.5 * layer.area))
		sum.color += seen * layer.color
		sum.area += seen * layer.area
		above += layer.area
	if sum.area <= 0.0:
		return
	var mean := sum.color / sum.area
	var color := Color(mean.x, mean.y, mean.z).linear_to_srgb()
	material.set_shader_parameter(&"field_color", color)
	material.set_shader_parameter(&"field_translucency", mean.w)
	material.set_shader_parameter(&"field_height", maxf(_middle_of(layers) * tallest, 0.01))


## Gives [param material] the rectangle of the plants of [param of_field], outside of which the far
## field starts close to the camera: [code]field_bounds[/code]. A turned field has a larger one.
static func apply_bounds(material: ShaderMaterial, of_field: PlantField3D) -> void:
	if not of_field.is_inside_tree():
		push_error("apply_bounds() needs the field in the tree. Add it first.")
		return
	var half := Vector3(of_field.size.x, 0.0, of_field.size.y) * 0.5
	var box := of_field.global_transform * AABB(-half, 2.0 * half)
	material.set_shader_parameter(
		&"field_bounds", Vector4(box.position.x, box.position.z, box.size.x, box.size.z)
	)


## Gives [param material] the density of the plants of [param of_field]: [code]field_mask[/code] and
## [code]field_area[/code]. Call it after [signal PlantField3D.build_finished].
static func apply_density(material: ShaderMaterial, of_field: PlantField3D) -> void:
	if not of_field.is_inside_tree():
		push_error("apply_density() needs the field in the tree. Add it first.")
		return
	var ids := of_field.get_plant_ids()
	var step := maxi(1, ids.size() / MASK_PLANTS)
	var places := PackedVector2Array()
	var area := Rect2()
	for i in range(0, ids.size(), step):
		var at := of_field.global_transform * of_field.get_plant_transform(ids[i]).origin
		var place := Vector2(at.x, at.z)
		area = Rect2(place, Vector2.ZERO) if places.is_empty() else area.expand(place)
		places.append(place)
	if places.is_empty():
		return
	area = area.grow(0.02 * area.size.length() + 0.1)
	var texture := ImageTexture.create_from_image(_count(places, area))
	material.set_shader_parameter(&"field_mask", texture)
	material.set_shader_parameter(
		&"field_area", Vector4(area.position.x, area.position.y, area.size.x, area.size.y)
	)


func _show_bounds() -> void:
	apply_bounds(_material, field)


func _show_density() -> void:
	apply_density(_material, field)
	_material.set_shader_parameter(&"field_beyond", 0.0)


static func _species_of(field: PlantField3D) -> Array[PlantFieldSpecies]:
	if field.species.is_empty() and ResourceLoader.exists(DEFAULT_SPECIES):
		return [PlantFieldSpecies.of(load(DEFAULT_SPECIES) as PlantFunction)]
	return field.species


# Returns the height, as a share of that of all layers, below which 90 % of the area are.
static func _middle_of(layers: Array[Layer]) -> float:
	var sum := 0.0
	for layer in layers:
		sum += layer.area
	var below := 0.0
	for i in layers.size():
		below += layers[i].area
		if below >= 0.9 * sum:
			return (i + 1.0) / layers.size()
	return 1.0


# Adds the triangles of a surface to layers of height, for `density` plants/m² of this size.
static func _add_triangles(
	arrays: Array, size: float, density: float, tallest: float, layers: Array[Layer]
) -> void:
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var colors: PackedColorArray = arrays[Mesh.ARRAY_COLOR]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var own := PackedFloat32Array()
	if arrays[Mesh.ARRAY_CUSTOM0] != null:
		own = arrays[Mesh.ARRAY_CUSTOM0]
	var has_parts := own.size() == 4 * points.size()  # Other plants have one number per vertex.
	for i in range(0, indices.size(), 3):
		var a := points[indices[i]]
		var edges := (points[indices[i + 1]] - a).cross(points[indices[i + 2]] - a)
		var area := 0.5 * edges.length() * size * size * density
		var height := (a.y + points[indices[i + 1]].y + points[indices[i + 2]].y) * size / 3.0
		var number := clampi(int(height / tallest * LAYERS), 0, LAYERS - 1)
		var layer := layers[number]
		layer.area += area
		for corner in 3:
			var vertex := indices[i + corner]
			var color := colors[vertex].srgb_to_linear()
			var through := own[4 * vertex + 3] if has_parts else 0.0
			layer.color += Vector4(color.r, color.g, color.b, through) * (area / 3.0)


# A smooth picture of the number of places, 1 at their mean.
static func _count(places: PackedVector2Array, area: Rect2) -> Image:
	var side := mini(MASK_SIZE, ceili(sqrt(places.size() / 6.0)) + 1)
	var counts := PackedFloat32Array()
	counts.resize(side * side)
	for place in places:
		var at := ((place - area.position) / area.size * side).floor()
		# An area of plants farther apart than 1e18 m has an infinite size.
		var cell := Vector2i(at).clamp(Vector2i.ZERO, Vector2i(side - 1, side - 1))
		counts[cell.y * side + cell.x] += 1.0
	var used := 0
	for count in counts:
		used += 1 if count > 0.0 else 0
	var image := Image.create_empty(side, side, false, Image.FORMAT_RF)
	for y in side:
		for x in side:
			var share := counts[y * side + x] * used / places.size()
			image.set_pixel(x, y, Color(minf(2.0 * share, 1.0), 0.0, 0.0))
	image.resize(MASK_SIZE, MASK_SIZE, Image.INTERPOLATE_CUBIC)
	image.convert(Image.FORMAT_R8)
	image.generate_mipmaps()
	return image


# The parts of plants at one height, on a m² of ground: area (m²), linear colour, translucency.
class Layer:
	var area := 0.0
	var color := Vector4.ZERO
