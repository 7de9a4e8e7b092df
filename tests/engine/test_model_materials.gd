## Materials of models: a field draws each of their features as the engine draws the material.
extends "res://tests/engine/picture_harness.gd"

const Maker := preload("res://tests/engine/model_maker.gd")
## On outlines.
const MAX_PIXELS := 10
const SIZE := Vector2i(80, 96)

var _field: PlantField3D
var _mesh: ArrayMesh
var _plain: Image


func before_each() -> void:
	make_stage()
	stage.size = SIZE
	_field = PlantField3D.new()
	_field.density = 0.0
	_field.simulation_enabled = false
	stage.add_child(_field)
	_mesh = _sheets()
	_plain = null


func after_each() -> void:
	stage.free()


func test_surfaces_of_models_keep_their_light() -> void:
	await _check("plain", _material())
	var metal := _material()
	metal.metallic = 0.8
	metal.roughness = 0.3
	metal.metallic_specular = 0.9
	await _check("metal", metal)
	var channels := _material()
	channels.metallic = 1.0
	channels.metallic_texture = _checks(Color(0.0, 1.0, 0.2), Color(1.0, 0.0, 0.5))
	channels.metallic_texture_channel = BaseMaterial3D.TEXTURE_CHANNEL_GREEN
	channels.roughness_texture = _checks(Color(1.0, 0.5, 0.1), Color(1.0, 0.5, 0.9))
	channels.roughness_texture_channel = BaseMaterial3D.TEXTURE_CHANNEL_BLUE
	await _check("channels of textures", channels)
	var orm := ORMMaterial3D.new()
	orm.cull_mode = BaseMaterial3D.CULL_DISABLED
	orm.orm_texture = _checks(Color(1.0, 0.2, 0.9), Color(0.3, 0.9, 0.1))
	await _check("ORM", orm)
	orm.ao_enabled = true
	await _check("ORM with occlusion", orm)


func test_normal_maps_of_models_keep_their_depth() -> void:
	turn_lights(Vector3(deg_to_rad(-40.0), deg_to_rad(70.0), 0.0))
	var bumpy := _material()
	bumpy.normal_enabled = true
	bumpy.normal_texture = _checks(Color(0.9, 0.5, 0.7), Color(0.5, 0.2, 0.8))
	await _check("normal map", bumpy)
	bumpy.normal_scale = 0.3
	await _check("less deep", bumpy)


func test_textures_of_models_keep_their_place() -> void:
	var placed := _material()
	placed.albedo_texture = _checks(Color.RED, Color.BLUE)
	placed.uv1_scale = Vector3(3.0, 0.5, 1.0)
	placed.uv1_offset = Vector3(0.25, 0.1, 0.0)
	await _check("scale and offset of UV", placed)
	var clamped := placed.duplicate() as StandardMaterial3D
	clamped.texture_repeat = false
	await _check("without repetition", clamped)
	var sharp := placed.duplicate() as StandardMaterial3D
	sharp.texture_filter = BaseMaterial3D.TEXTURE_FILTER_NEAREST
	await _check("filter", sharp)


func test_models_glow_as_their_material() -> void:
	var glow := _material()
	glow.emission_enabled = true
	glow.emission = Color(0.5, 0.1, 0.0)
	glow.emission_energy_multiplier = 1.5
	glow.emission_texture = _checks(Color(0.0, 0.6, 0.0), Color(0.0, 0.0, 0.6))
	await _check("added emission", glow)
	glow.emission_operator = BaseMaterial3D.EMISSION_OP_MULTIPLY
	glow.emission = Color.WHITE
	await _check("multiplied emission", glow)


func test_models_are_shaded_as_their_material() -> void:
	var shaded := _material()
	shaded.ao_enabled = true
	shaded.ao_light_affect = 0.7
	shaded.ao_texture = _checks(Color(1.0, 0.2, 1.0), Color(0.2, 1.0, 1.0))
	await _check("occlusion", shaded)
	shaded.ao_texture_channel = BaseMaterial3D.TEXTURE_CHANNEL_GREEN
	shaded.ao_on_uv2 = true
	await _check("occlusion on UV2", shaded)
	var through := _material()
	through.backlight_enabled = true
	through.backlight = Color(0.4, 0.7, 0.1)
	through.backlight_texture = _checks(Color(0.3, 0.0, 0.0), Color(0.0, 0.0, 0.3))
	stage.get_camera_3d().look_at_from_position(Vector3(0, 1.0, -2.8), Vector3(0, 0.7, 0))
	await _check("light from behind", through)


func test_models_have_the_colors_of_their_vertices() -> void:
	var colored := _material()
	colored.vertex_color_use_as_albedo = true
	await _check("vertex colors", colored)
	colored.vertex_color_is_srgb = true
	_plain = null  # Compatibility draws both alike.
	await _check("vertex colors in sRGB", colored)


func test_models_are_cut_out_as_their_material() -> void:
	var holes := _material()
	holes.albedo_texture = _checks(Color(1, 0, 0, 0.3), Color(0, 0, 1, 0.7))
	holes.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR
	holes.alpha_scissor_threshold = 0.2
	await _check("a low threshold", holes)
	holes.alpha_scissor_threshold = 0.5
	await _check("a high threshold", holes)
	holes.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_DEPTH_PRE_PASS
	await _check("transparency", holes)


func test_models_show_the_sides_of_their_material() -> void:
	for cull: BaseMaterial3D.CullMode in [
		BaseMaterial3D.CULL_BACK, BaseMaterial3D.CULL_FRONT, BaseMaterial3D.CULL_DISABLED
	]:
		var sides := _material()
		sides.cull_mode = cull
		await _check("cull mode %d" % cull, sides)


func test_the_light_of_a_model_has_the_mode_of_its_material() -> void:
	var toon := _material()
	toon.diffuse_mode = BaseMaterial3D.DIFFUSE_TOON
	toon.specular_mode = BaseMaterial3D.SPECULAR_TOON
	await _check("toon", toon)
	var flat := _material()
	flat.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	await _check("unshaded", flat)


# Compares a plant at rest in a field with a MeshInstance3D. Each material differs from the plain
# one.
func _check(title: String, material: BaseMaterial3D) -> void:
	_mesh.surface_set_material(0, material)
	var alone := MeshInstance3D.new()
	alone.mesh = _mesh
	_field.hide()
	stage.add_child(alone)
	var wanted := await picture()
	stage.remove_child(alone)
	alone.free()
	_field.show()
	var ids := _field.add_plants([Transform3D.IDENTITY], MeshPlantFunction.of(_mesh.duplicate()))
	var shown := await picture()
	_field.remove_plants(ids)
	check(brightest_of(shown) > 0.05, "%s: a plant is drawn" % title)
	var different := count_different(shown, wanted)
	check(different <= MAX_PIXELS, "%s: %d pixels differ" % [title, different])
	if _plain:
		check(count_different(wanted, _plain) > 20, "%s: it differs from others" % title)
	_plain = wanted


func _material() -> StandardMaterial3D:
	return Maker.plain(Color(0.8, 0.8, 0.8))


# Two sheets that cross, with colours and UV2.
func _sheets() -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for across: Vector3 in [Vector3(0.6, 0, 0.2), Vector3(-0.2, 0, 0.6)]:
		var normal := across.cross(Vector3.UP).normalized()
		for at: Vector2 in [
			Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 0), Vector2(1, 1), Vector2(0, 1)
		]:
			tool.set_normal(normal)
			tool.set_uv(Vector2(at.x, 1.0 - at.y))
			tool.set_uv2(Vector2(0.3 * at.y, 0.8 * at.x))
			tool.set_color(Color(0.2 + 0.6 * at.x, 0.7, 0.3 * at.y))
			tool.add_vertex((at.x - 0.5) * 2.0 * across + 1.4 * at.y * Vector3.UP)
	tool.generate_tangents()
	return tool.commit()


func _checks(one: Color, other: Color) -> ImageTexture:
	var image := Image.create_empty(4, 4, false, Image.FORMAT_RGBA8)
	for y in 4:
		for x in 4:
			image.set_pixel(x, y, one if (x + y) % 2 == 0 else other)
	return ImageTexture.create_from_image(image)
