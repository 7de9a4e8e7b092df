extends "sheet.gd"
## Grass, firs, a flag and smoke in one wind, with the shaders of the guide's page.

const Models := preload("models.gd")
const TREE := preload("scene_wind_tree.gdshader")
const FLAG := preload("scene_wind_flag.gdshader")
const SMOKE := preload("scene_wind_smoke.gdshader")
const GROUND := preload("res://addons/undergrowth/grounds/meadow.tres")
const FIRS: Dictionary[Vector3, float] = {
	Vector3(-3.1, 0, -1.6): 3.4, Vector3(-1.9, 0, -3.2): 2.7, Vector3(2.9, 0, -4.2): 3.1
}
const POLE := Vector3(0.4, 0, -0.6)
const POLE_HEIGHT := 3.0
const FIRE := Vector3(2.2, 0.1, 0.2)


func _fill(row: HBoxContainer) -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.speed = 12.0
	wind.direction = PI / 2.0
	wind.scene_wind = true
	var world := add_cell(row, "one wind", Vector3(0, 1.7, 6.5), Vector3(0, 1.2, 0), 42.0)
	(world.get_node("Ground") as MeshInstance3D).material_override = GROUND
	var field := make_field({"meadow_grass": 8.0, "oxeye_daisy": 1.0}, 40.0, Vector2(9, 7))
	field.wind = wind
	world.add_child(field)
	for place in FIRS:
		_add_fir(world, place, FIRS[place])
	_add_flag(world)
	_add_smoke(world)


func _add_fir(world: Node3D, place: Vector3, scale: float) -> void:
	var fir := MeshInstance3D.new()
	fir.mesh = Models.make_fir()
	fir.position = place
	fir.scale = Vector3.ONE * scale
	for surface in fir.mesh.get_surface_count():
		var plain := fir.mesh.surface_get_material(surface) as StandardMaterial3D
		var material := ShaderMaterial.new()
		material.shader = TREE
		material.set_shader_parameter("height", 1.3)
		material.set_shader_parameter("bend", 0.004)
		material.set_shader_parameter("albedo", plain.albedo_color)
		fir.set_surface_override_material(surface, material)
	world.add_child(fir)


func _add_flag(world: Node3D) -> void:
	var pole := MeshInstance3D.new()
	var rod := CylinderMesh.new()
	rod.height = POLE_HEIGHT
	rod.top_radius = 0.02
	rod.bottom_radius = 0.03
	pole.mesh = rod
	pole.position = POLE + Vector3(0, 0.5 * POLE_HEIGHT, 0)
	world.add_child(pole)
	var cloth := PlaneMesh.new()
	cloth.orientation = PlaneMesh.FACE_Z
	cloth.size = Vector2(1.5, 0.9)
	cloth.subdivide_width = 30
	var flag := MeshInstance3D.new()
	flag.mesh = cloth
	flag.position = POLE + Vector3(0, POLE_HEIGHT - 0.5, 0)
	var material := ShaderMaterial.new()
	material.shader = FLAG
	flag.material_override = material
	flag.extra_cull_margin = 2.0
	world.add_child(flag)


func _add_smoke(world: Node3D) -> void:
	var puff := QuadMesh.new()
	puff.size = Vector2.ONE * 0.35
	var look := StandardMaterial3D.new()
	look.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	look.billboard_mode = BaseMaterial3D.BILLBOARD_ENABLED
	look.albedo_color = Color(0.92, 0.92, 0.92, 0.16)
	look.albedo_texture = _draw_puff()
	puff.material = look
	var material := ShaderMaterial.new()
	material.shader = SMOKE
	var smoke := GPUParticles3D.new()
	smoke.draw_pass_1 = puff
	smoke.process_material = material
	smoke.amount = 500
	smoke.lifetime = 3.0
	smoke.preprocess = 3.0
	smoke.position = FIRE
	smoke.visibility_aabb = AABB(Vector3(-20, -2, -20), Vector3(40, 20, 40))
	world.add_child(smoke)


func _draw_puff() -> GradientTexture2D:
	var fade := Gradient.new()
	fade.set_color(0, Color.WHITE)
	fade.set_color(1, Color(1, 1, 1, 0))
	var texture := GradientTexture2D.new()
	texture.gradient = fade
	texture.fill = GradientTexture2D.FILL_RADIAL
	texture.fill_from = Vector2(0.5, 0.5)
	texture.fill_to = Vector2(1.0, 0.5)
	return texture
