@tool
extends MeshInstance3D
## Ground that continues a field: it takes the mean colour of the field's plants, gets lighter where
## gusts pass, and, if [member shows_density] is on, is bare where no plants are.
##
## It needs a material with ground.gdshader or ground_layer.gdshader and changes a copy of it. The
## static functions do the same for the material of a terrain.

const FarField := preload("far_field.gd")
## Pixels of one side of the picture of the density.
const MASK_SIZE := 128
## Maximum number of plants that the picture counts. Of more plants it counts evenly chosen ones.
const MASK_PLANTS := 20000

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
	if shows_density:
		field.build_finished.connect(_show_density)
		_show_density()


func _process(_delta: float) -> void:
	if _material == null or not is_instance_valid(field) or field.wind == null:
		return
	if field.wind.kind == PlantWind.KIND_AIR:
		field.wind.apply_to_material(_material)


## Gives [param material] the mean colour of the plants of [param of_field]:
## [code]field_color[/code], [code]field_translucency[/code] and [code]field_openness[/code].
static func apply_color(material: ShaderMaterial, of_field: PlantField3D) -> void:
	var far := FarField.new(of_field)
	if far.covered == 0:
		return
	var color := Color(far.color.x, far.color.y, far.color.z).linear_to_srgb()
	material.set_shader_parameter(&"field_color", color)
	material.set_shader_parameter(&"field_translucency", far.translucency)
	material.set_shader_parameter(&"field_openness", far.openness)


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


func _show_density() -> void:
	apply_density(_material, field)
	_material.set_shader_parameter(&"field_beyond", 0.0)


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
