## Motion vectors of fields are those of a Plant3D in the same state.
extends "res://tests/engine/picture_harness.gd"

const STEP := 1.0 / 60.0
const SETTLING_STEPS := 600
const FLOWER_SCALE := 2.0
const SIZE := Vector2i(144, 288)
## Pixels, mean over a plant and some frames.
const MAX_ERROR := 0.1
## Pixels, mean length of vectors in comparisons.
const MIN_LENGTH := 0.03
const FRAMES_OF_BANDS := 8
## Pixels.
const MIN_WAY := 2.0
## The same over the mean length.
const MAX_SHARE := 0.3
## Share of a moving plant's pixels with a vector.
const MIN_SHARE := 0.95
## Pixels. Shorter vectors do not count as motion.
const STILL := 0.02
## Pixels. The engine marks pixels without a vector by a length outside of the picture.
const NONE := 200.0
## Minimum number of moving pixels.
const MIN_MOVING := 100
const READY := "res://addons/undergrowth/species/%s.tres"

var _wind: PlantWind
var _field: PlantField3D
var _stages: Array[SubViewport] = []
var _eyes: Array[Eye] = []


## Reads the velocity buffer of a camera after each of its frames.
class Eye:
	extends CompositorEffect

	# The engine's buffer cannot be read directly.
	const COPY := """#version 450
		layout(local_size_x = 8, local_size_y = 8) in;
		layout(set = 0, binding = 0) uniform sampler2D from;
		layout(set = 0, binding = 1, rg32f) uniform writeonly image2D to;
		void main() {
			ivec2 at = ivec2(gl_GlobalInvocationID.xy);
			if (all(lessThan(at, imageSize(to)))) imageStore(to, at, texelFetch(from, at, 0));
		}"""
	# Of a pixel without a vector.
	const NOTHING := Vector2(-1, -1)

	var device := RenderingServer.get_rendering_device()
	var size: Vector2i
	var shader: RID
	var pipeline: RID
	var sampler: RID
	var copy: RID

	func _init() -> void:
		effect_callback_type = EFFECT_CALLBACK_TYPE_POST_TRANSPARENT
		needs_motion_vectors = true
		var source := RDShaderSource.new()
		source.source_compute = COPY
		shader = device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
		pipeline = device.compute_pipeline_create(shader)
		sampler = device.sampler_create(RDSamplerState.new())

	func _render_callback(_type: int, data: RenderData) -> void:
		var buffers: RenderSceneBuffersRD = data.get_render_scene_buffers()
		if not copy.is_valid():
			size = buffers.get_internal_size()
			var format := RDTextureFormat.new()
			format.width = size.x
			format.height = size.y
			format.format = RenderingDevice.DATA_FORMAT_R32G32_SFLOAT
			format.usage_bits = (
				RenderingDevice.TEXTURE_USAGE_STORAGE_BIT
				| RenderingDevice.TEXTURE_USAGE_CAN_COPY_FROM_BIT
			)
			copy = device.texture_create(format, RDTextureView.new())
		var from := RDUniform.new()
		from.uniform_type = RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE
		from.add_id(sampler)
		from.add_id(buffers.get_velocity_texture())
		var to := RDUniform.new()
		to.uniform_type = RenderingDevice.UNIFORM_TYPE_IMAGE
		to.binding = 1
		to.add_id(copy)
		var list := device.compute_list_begin()
		device.compute_list_bind_compute_pipeline(list, pipeline)
		var uniforms := UniformSetCacheRD.get_cache(shader, 0, [from, to])
		device.compute_list_bind_uniform_set(list, uniforms, 0)
		device.compute_list_dispatch(list, ceili(size.x / 8.0), ceili(size.y / 8.0), 1)
		device.compute_list_end()

	## Returns the vectors of all pixels, in pixels. Those without a vector are far outside of the
	## picture.
	func read() -> PackedVector2Array:
		var numbers := device.texture_get_data(copy, 0).to_float32_array()
		var vectors := PackedVector2Array()
		vectors.resize(size.x * size.y)
		vectors.fill(NOTHING * Vector2(size))
		for i in vectors.size():
			if numbers[2 * i] != NOTHING.x:
				vectors[i] = Vector2(numbers[2 * i], numbers[2 * i + 1]) * Vector2(size)
		return vectors

	func free_all() -> void:
		for rid: RID in [copy, sampler, shader]:
			device.free_rid(rid)


func before_each() -> void:
	_add_stage()
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_WAVES
	_wind.direction = deg_to_rad(60.0)
	_wind.strength = 0.0
	_wind.frequency = 0.5
	_field = await make_added_field(_wind)


func after_each() -> void:
	paused = false
	for eye in _eyes:
		eye.free_all()
	_eyes.clear()
	for each in _stages:
		each.free()
	_stages.clear()


func test_a_reed_has_the_vectors_of_a_plant() -> void:
	await _compare(make_reed(), 5.0, 1.0)


func test_a_reed_between_two_steps_has_the_vectors_of_a_plant() -> void:
	await _compare(make_reed(), 5.0, 0.6)


func test_a_reed_of_two_modes_has_the_vectors_of_a_plant() -> void:
	var species := make_reed()
	species.stem.modes = 2
	await _compare(species, 5.0, 0.7)


func test_leaves_have_the_vectors_of_a_plant() -> void:
	_wind.frequency = 0.2
	await _compare(_of_one_pace("yarrow"), 12.0, 0.7)


## The stem is still, and only the flutter of leaves moves.
func test_flutter_has_the_vectors_of_a_plant() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	await _compare(_of_one_pace("oxeye_daisy"), 12.0, 0.7)


func test_a_moving_camera_gives_the_vectors_of_a_plant() -> void:
	await _compare(make_reed(), 5.0, 1.0, Vector3(0.004, 0.002, 0.0))


func test_still_plants_have_no_vectors() -> void:
	_add_plant(make_reed())
	_field.simulation_enabled = true
	_wind.strength = 5.0
	await frames(20)
	check(_count(await _read(0)) > MIN_MOVING, "vectors in wind")
	paused = true
	await frames(3)
	check_equal(_count(await _read(0)), 0, "vectors of a paused field")
	paused = false
	await frames(3)
	check(_count(await _read(0)) > MIN_MOVING, "vectors in wind again")
	_field.simulation_enabled = false
	await frames(3)
	check_equal(_count(await _read(0)), 0, "vectors of a field that does not move")


## Bands of a reed's height are colours: their centres move as their vectors say.
func test_a_follower_has_the_vectors_of_its_picture() -> void:
	_field.prototypes = 1
	await settled(_field)
	var species := make_reed()
	species.material = _banded()
	_add_plant(species)
	_wind.strength = 5.0
	_field.simulation_enabled = true
	await frames(160)
	await _check_bands()


func test_a_pushed_follower_has_the_vectors_of_its_picture() -> void:
	_field.prototypes = 1
	await settled(_field)
	var species := make_reed()
	species.material = _banded()
	_add_plant(species)
	_field.simulation_enabled = true
	await frames(4)
	_field.apply_impulse_in_sphere(_field.global_position, 1.0, Vector3(0.2, 0.0, -0.1))
	await frames(8)
	await _check_bands()


## Returns a species of which a plant swings like that of a field, wherever it is.
func _of_one_pace(species: String) -> PlantFunction:
	var found: PlantFunction = load(READY % species).duplicate()
	found.frequency_deviation = 0.0
	return found


func _add_stage() -> void:
	make_stage()
	stage.size = SIZE
	var camera: Camera3D = stage.find_children("*", "Camera3D", true, false)[0]
	camera.compositor = Compositor.new()
	_eyes.append(Eye.new())
	camera.compositor.compositor_effects = [_eyes.back()]
	_stages.append(stage)


func _add_plant(species: PlantFunction) -> int:
	return _field.add_plants([Transform3D(Basis(Vector3.UP, 0.7))], species)[0]


func _read(number: int) -> PackedVector2Array:
	await RenderingServer.frame_post_draw
	return _eyes[number].read()


func _moves(vector: Vector2) -> bool:
	return vector.length() > STILL and vector.length() < NONE


func _count(vectors: PackedVector2Array) -> int:
	var count := 0
	var nothing := Eye.NOTHING * Vector2(SIZE)
	for vector in vectors:
		count += 1 if vector != nothing and _moves(vector) else 0
	return count


## Compares the vectors of a field's plant and of a Plant3D in frames in which the camera moves by
## [param walk].
func _compare(
	species: PlantFunction, strength: float, time_scale: float, walk := Vector3.ZERO
) -> void:
	var size := 1.0 if species is ReedFunction else FLOWER_SCALE
	var place := Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3.ONE * size))
	var id := _field.add_plants([place], species)[0]
	await frames(3)
	_add_stage()
	var plant := await make_twin(_field, id, species, place, 0)
	plant.wind = _wind
	_wind.strength = strength
	var sums := Vector4()
	for i in SETTLING_STEPS if _wind.kind == PlantWind.KIND_CONSTANT else 0:
		_field._preview(STEP, _wind)
		plant._preview(STEP, _wind)
	for i in 84:
		# Vectors are those from the previous drawn frame.
		var is_compared := i >= 36 and i % 4 == 0
		for each in _stages:
			each.get_camera_3d().position += walk
			each.render_target_update_mode = (
				SubViewport.UPDATE_ALWAYS
				if is_compared or i % 4 == 3
				else SubViewport.UPDATE_DISABLED
			)
		_field._preview(time_scale * STEP, _wind)
		plant._preview(time_scale * STEP, _wind)
		if is_compared:
			sums += await _sums()
		await process_frame
	_check_sums(sums)


## Returns the numbers of moving pixels of the field (x) and of the Plant3D (y), and the sums of the
## lengths of vectors (z) and of their differences (w) over pixels that move in both.
func _sums() -> Vector4:
	var of_field := await _read(0)
	var of_plant := _eyes[1].read()
	var sums := Vector4()
	var nothing := Eye.NOTHING * Vector2(SIZE)
	for i in of_field.size():
		if of_field[i] == nothing and of_plant[i] == nothing:
			continue
		var moves := _moves(2.0 * of_field[i])
		var moves_alone := _moves(of_plant[i])
		sums.x += 1.0 if moves else 0.0
		sums.y += 1.0 if moves_alone else 0.0
		if moves and moves_alone:
			sums.z += of_plant[i].length()
			sums.w += of_field[i].distance_to(of_plant[i])
	return sums


func _check_sums(sums: Vector4) -> void:
	check(sums.y > MIN_MOVING, "%d pixels move" % sums.y)
	check(sums.x >= MIN_SHARE * sums.y, "%d of %d pixels have vectors" % [sums.x, sums.y])
	check(sums.z > MIN_LENGTH * sums.y, "mean length %.2f pixels" % (sums.z / sums.y))
	check(sums.w <= MAX_ERROR * sums.y, "mean error %.3f pixels" % (sums.w / sums.y))
	check(sums.w <= MAX_SHARE * sums.z, "error of %.2f of the lengths" % (sums.w / sums.z))


func _banded() -> ShaderMaterial:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = """
		shader_type spatial;
		render_mode unshaded, cull_disabled;
		#include "res://addons/undergrowth/shaders/undergrowth_bend.gdshaderinc"
		varying float way;
		void vertex() { UNDERGROWTH_BEND way = CUSTOM0.x; }
		void fragment() { ALBEDO = vec3(way > 0.5 && way < 0.8 ? 1.0 : 0.0, 1.0, 0.0); }
	"""
	return material


func _check_bands() -> void:
	await _read(0)
	var first := _center(stage.get_texture().get_image())
	var way := Vector2()
	var last := first
	for i in FRAMES_OF_BANDS:
		await process_frame
		var vectors := await _read(0)
		var shown := stage.get_texture().get_image()
		way -= _mean(vectors, shown)
		last = _center(shown)
	check((last - first).length() > MIN_WAY, "the band moves by %s" % (last - first))
	check_near(way, last - first, MAX_ERROR * FRAMES_OF_BANDS, "the sum of its vectors")


func _mean(vectors: PackedVector2Array, shown: Image) -> Vector2:
	var sum := Vector2()
	var count := 0
	for y in SIZE.y:
		for x in SIZE.x:
			if shown.get_pixel(x, y).r > 0.5:
				sum += vectors[y * SIZE.x + x]
				count += 1
	return sum / count


func _center(of: Image) -> Vector2:
	var sum := Vector2()
	var count := 0
	for y in of.get_height():
		for x in of.get_width():
			if of.get_pixel(x, y).r > 0.5:
				sum += Vector2(x, y)
				count += 1
	return sum / count
