## undergrowth_wind.gdshaderinc: the wind on the graphics card equals PlantWind's own.
extends "res://tests/engine/harness.gd"

const SIDE := 64
## Metres of the world in the picture, and its start.
const SPAN := 40.0
const CORNER := Vector3(-213.0, 2.0, 77.0)
## The picture contains velocities from -RANGE to RANGE in 16 bits.
const RANGE := 32.0
## Of the mean speed.
const TOLERANCE := 0.01
const SHADER := """shader_type canvas_item;
#include "res://addons/undergrowth/shaders/undergrowth_wind.gdshaderinc"
uniform vec3 corner;
uniform float along_z;
uniform bool over_canopy;
void fragment() {
	vec3 place = corner + vec3(UV.x, 0.0, UV.y) * 40.0;
	vec3 velocity = over_canopy ? undergrowth_wind_over_canopy(place.xz).xyy : undergrowth_wind(place);
	float part = (mix(velocity.x, velocity.z, along_z) / 32.0 * 0.5 + 0.5) * 65535.0;
	COLOR = vec4(floor(part / 256.0) / 255.0, floor(mod(part, 256.0)) / 255.0, 0.0, 1.0);
}
"""

const PARTICLES := """shader_type particles;
#include "res://addons/undergrowth/shaders/undergrowth_wind.gdshaderinc"
void process() {
	VELOCITY = undergrowth_wind(TRANSFORM[3].xyz);
}
"""

var _stage: SubViewport


func after_each() -> void:
	if _stage:
		_stage.free()
		_stage = null


func test_the_shader_shows_the_same_wind() -> void:
	var wind := _apply_wind()
	var material := _show(wind)
	var sample := func(place: Vector3) -> Vector3:
		return wind.sample_velocity(wind.get_time(), place)
	await _check_shown(material, sample, wind.speed)


func test_the_shader_shows_the_same_wind_over_a_canopy() -> void:
	var wind := _apply_wind()
	wind.gustiness = 0.3
	var material := _show(wind)
	material.set_shader_parameter("over_canopy", true)
	var sample := func(place: Vector3) -> Vector3:
		var flat := PackedVector2Array([Vector2(place.x, place.z)])
		var velocity := wind.sample_over_canopy(wind.get_time(), flat)[0]
		return Vector3(velocity.x, 0.0, velocity.y)
	for canopy_wave_amount: float in [0.0, 0.7]:
		wind.canopy_wave_amount = canopy_wave_amount
		wind.apply_to_material(material)
		var mean := wind.sample_over_canopy(0.0, PackedVector2Array([Vector2.ZERO]))[0].length()
		await _check_shown(material, sample, mean)


func test_a_scene_wind_needs_no_call_for_any_material() -> void:
	var wind := _apply_wind()
	wind.scene_wind = true
	var material := _make_sheet(SHADER.replace("undergrowth_wind.gd", "undergrowth_scene_wind.gd"))
	var sample := func(place: Vector3) -> Vector3:
		return wind.sample_velocity(wind.get_time(), place)
	await frames(3)
	paused = true
	wind.advance(0.0)  # Shows its own time, between two steps.
	await _check_shown(material, sample, wind.speed)
	var held := wind.get_time()
	await frames(20)
	check_equal(wind.get_time(), held, "clock in a pause")
	paused = false
	wind.scene_wind = false
	await _check_shown(material, func(_place: Vector3) -> Vector3: return Vector3.ZERO, wind.speed)


func test_a_scene_wind_is_shown_at_most_two_frames_late() -> void:
	var wind := _apply_wind()
	wind.scene_wind = true
	var material := _make_sheet(SHADER.replace("undergrowth_wind.gd", "undergrowth_scene_wind.gd"))
	material.set_shader_parameter("along_z", 1.0)
	await frames(20)
	await RenderingServer.frame_post_draw
	var picture := _stage.get_texture().get_image()
	var least := INF
	for half_frames in 5:
		var time := wind.get_time() - half_frames / 120.0
		var worst := 0.0
		for i in SIDE:
			var part := (i + 0.5) / SIDE * SPAN
			var own := wind.sample_velocity(time, CORNER + Vector3(part, 0, part)).z
			worst = maxf(worst, absf(_read(picture.get_pixel(i, i)) - own))
		least = minf(least, worst)
	check(least < 5.0 * TOLERANCE * wind.speed, "the nearest time is off by %f m/s" % least)
	wind.scene_wind = false


func test_a_freed_scene_wind_leaves_calm_air() -> void:
	var wind := _apply_wind()
	wind.scene_wind = true
	var material := _make_sheet(SHADER.replace("undergrowth_wind.gd", "undergrowth_scene_wind.gd"))
	await frames(2)
	wind = null
	await _check_shown(material, func(_place: Vector3) -> Vector3: return Vector3.ZERO, 12.0)


func test_a_second_scene_wind_replaces_the_first_with_a_warning() -> void:
	var first := _apply_wind()
	var second := _apply_wind()
	first.scene_wind = true
	var start := first.get_time()
	await frames(20)
	check(first.get_time() > start, "its clock runs without any plant")
	second.scene_wind = true
	check_error("replaces another scene wind")
	first.scene_wind = false
	start = second.get_time()
	await frames(20)
	check(second.get_time() > start, "the second one runs")
	second.scene_wind = false
	start = second.get_time()
	await frames(20)
	check_equal(second.get_time(), start, "clock of a wind that nothing uses")


func test_telling_it_in_each_frame_gives_the_renderer_nothing_to_draw() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	var material := _float_in(wind)
	var drawn: Array[int] = [0]
	var count := func() -> void: drawn[0] += 1
	RenderingServer.frame_post_draw.connect(count)
	for i in 24:
		wind.advance(0.1)
		wind.apply_to_material(material)
		await frames(1)
		RenderingServer.render_loop_enabled = i < 4
		if i == 16:  # The discarded picture is freed.
			drawn[0] = 0
	RenderingServer.frame_post_draw.disconnect(count)
	RenderingServer.render_loop_enabled = true
	check_equal(drawn[0], 0, "frames drawn although none was requested")


func test_unsupported_input_is_reported() -> void:
	var wind := PlantWind.new()
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	wind.apply_to_material(material)
	check_error("apply_to_material() needs KIND_AIR")
	wind.kind = PlantWind.KIND_AIR
	for without: Material in [null, ShaderMaterial.new(), StandardMaterial3D.new()]:
		wind.apply_to_material(without)
		check_error("apply_to_material() needs a material")


func _apply_wind() -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.speed = 12.0
	wind.direction = deg_to_rad(37.0)
	wind.advance(1234.5)
	return wind


func _check_shown(material: ShaderMaterial, sample: Callable, mean: float) -> void:
	for component in 2:
		material.set_shader_parameter("along_z", float(component))
		await frames(2)
		await RenderingServer.frame_post_draw
		var picture := _stage.get_texture().get_image()
		var worst := 0.0
		for y in SIDE:
			for x in SIDE:
				var part := Vector2(x + 0.5, y + 0.5) / SIDE * SPAN
				var velocity: Vector3 = sample.call(CORNER + Vector3(part.x, 0, part.y))
				var own := velocity.z if component else velocity.x
				worst = maxf(worst, absf(_read(picture.get_pixel(x, y)) - own))
		check(worst < TOLERANCE * mean, "component %d is off by %f m/s" % [component, worst])


func _show(wind: PlantWind) -> ShaderMaterial:
	var material := _make_sheet(SHADER)
	wind.apply_to_material(material)
	return material


func _make_sheet(code: String) -> ShaderMaterial:
	_stage = SubViewport.new()
	_stage.size = Vector2i(SIDE, SIDE)
	_stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_stage)
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = code
	material.set_shader_parameter("corner", CORNER)
	var sheet := ColorRect.new()
	sheet.size = Vector2(SIDE, SIDE)
	sheet.material = material
	_stage.add_child(sheet)
	return material


func _float_in(wind: PlantWind) -> ShaderMaterial:
	_stage = SubViewport.new()
	_stage.size = Vector2i(SIDE, SIDE)
	_stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_stage)
	var camera := Camera3D.new()
	camera.position.z = 3.0
	_stage.add_child(camera)
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = PARTICLES
	var particles := GPUParticles3D.new()
	particles.process_material = material
	particles.draw_pass_1 = QuadMesh.new()
	_stage.add_child(particles)
	wind.apply_to_material(material)
	return material


func _read(color: Color) -> float:
	var part := roundf(color.r * 255.0) * 256.0 + roundf(color.g * 255.0)
	return (part / 65535.0 - 0.5) * 2.0 * RANGE
