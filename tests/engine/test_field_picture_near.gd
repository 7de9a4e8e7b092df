## Plants near a camera, which are drawn one by one, and the cost of fields with default settings.
extends "res://tests/engine/picture_harness.gd"

const MEADOW_GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
const EYE_HEIGHT := 1.7
const STEPS := 4
## Segments of the plants without levels. More of them change no pixel.
const WHOLE := 10

var _field: PlantField3D


func before_each() -> void:
	make_stage()


func after_each() -> void:
	stage.free()


func test_plants_of_a_turned_field_near_a_moving_camera_are_all_drawn() -> void:
	_sow()
	_field.rotation.y = 2.0
	var by_error := await _walk()
	_field.levels = [PlantFieldLevel.of(WHOLE)]
	var whole := await _walk()
	for step in STEPS:
		check(whole[step] > 10 * MIN_PLANT, "plants are drawn: %d pixels" % whole[step])
		check_near(float(by_error[step]), float(whole[step]), 0.1 * whole[step], "pixels of plants")


func test_a_camera_that_keeps_the_width_of_a_tall_picture_sees_all_plants() -> void:
	stage.size = Vector2i(80, 240)
	_sow()
	_field.size = Vector2(12, 12)
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(Vector3(0, 3, 0), Vector3.ZERO, Vector3.FORWARD)
	camera.keep_aspect = Camera3D.KEEP_WIDTH
	camera.fov = 60.0
	var shown := await picture()
	camera.keep_aspect = Camera3D.KEEP_HEIGHT
	camera.fov = 120.0  # The same picture: its height is three times its width.
	var same := await picture()
	check(_count_green(same) > 10 * MIN_PLANT, "plants are drawn")
	check(count_different(shown, same) <= MAX_DIFFERENT, "the same picture")


func test_tops_of_near_plants_are_drawn_without_their_roots() -> void:
	_sow()
	_field.species[0].scale_range = Vector2(4.0, 4.0)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 0.3, 0), Vector3(0, 1.6, -1))
	var shown := _count_green(await picture())
	_field.levels = [PlantFieldLevel.of(WHOLE)]
	var whole := _count_green(await picture())
	check(whole > 10 * MIN_PLANT, "plants are drawn: %d pixels" % whole)
	check_near(float(shown), float(whole), 0.15 * whole, "pixels of plants")


func test_a_camera_that_turns_sees_plants_in_the_same_frame() -> void:
	_sow()
	await settled(_field)
	var camera := stage.get_camera_3d()
	var place := Vector3(0, 0.6, 0)
	camera.look_at_from_position(place, place + Vector3(0, -0.4, -1))
	await picture()
	camera.look_at_from_position(place, place + Vector3(0, -0.4, 1))
	await RenderingServer.frame_post_draw
	var at_once := stage.get_texture().get_image()
	var later := await picture()
	check(_count_green(later) > 10 * MIN_PLANT, "plants are drawn")
	check(count_different(at_once, later) <= MAX_DIFFERENT, "the first frame is complete")


func test_plants_are_drawn_again_when_a_camera_turns_back() -> void:
	_sow()
	await settled(_field)
	var camera := stage.get_camera_3d()
	var place := Vector3(0, 0.6, 0)
	var pictures: Array[Image] = []
	for ahead: float in [-1.0, 1.0, -1.0]:
		camera.look_at_from_position(place, place + Vector3(0, -0.4, ahead))
		pictures.append(await picture())
	check(_count_green(pictures[0]) > 10 * MIN_PLANT, "plants are drawn")
	check(count_different(pictures[0], pictures[2]) <= MAX_DIFFERENT, "the same as before")


func test_the_nearest_plants_cast_shadows_of_a_coarser_level() -> void:
	cast_shadows_on_ground(6.0)
	turn_lights(Vector3(-0.8, 0.6, 0))
	_sow()
	await settled(_field)
	_field.density = 3.0
	await settled(_field)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 1.0, 1.4), Vector3(0, 0.1, 0))
	var shaded := await picture()
	_field.shadow_distance = 0.0
	await settled(_field)
	var bright := await picture()
	check(count_different(shaded, bright) > MIN_PLANT, "near plants cast shadows")


func test_shade_near_the_camera_is_as_dark_as_that_of_whole_plants() -> void:
	cast_shadows_on_ground(20.0)
	turn_lights(Vector3(-0.5, 0.6, 0))
	_sow()
	_field.size = Vector2(7, 7)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 0.8, 2), Vector3(0, 0, 0.5))
	await settled(_field)
	var by_error := _mean_light(await picture())
	_field.levels = [PlantFieldLevel.of(WHOLE)]
	await settled(_field)
	var whole := _mean_light(await picture())
	check_near(by_error, whole, 0.12 * whole, "mean light")


func test_fields_with_default_settings_cost_little() -> void:
	stage.size = Vector2i(320, 180)
	cast_shadows()
	await _check_cost(PlantField3D.new(), 2.0e6, 150)
	var mix: PackedScene = load("res://addons/undergrowth/mixes/meadow.tscn")
	await _check_cost(mix.instantiate(), 0.8e6, 150)


## Returns the pixels of plants at each place of a moving camera.
func _walk() -> PackedInt32Array:
	var counts := PackedInt32Array()
	for step in STEPS:
		var place := Vector3(0.9 * step - 1.0, 0.6, 1.2 - 0.7 * step)
		stage.get_camera_3d().look_at_from_position(
			place, place + Vector3(0.2, -0.4, -1).rotated(Vector3.UP, step)
		)
		counts.append(_count_green(await picture()))
	return counts


func _check_cost(field: PlantField3D, max_primitives: float, max_draws: int) -> void:
	field.simulation_enabled = false
	stage.add_child(field)
	await settled(field)
	var place := Vector3(0, EYE_HEIGHT, 0.25 * field.size.y)
	stage.get_camera_3d().look_at_from_position(place, place + Vector3(0, -0.25, -1))
	await picture()
	var primitives := _count(RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME)
	var draws := _count(RenderingServer.VIEWPORT_RENDER_INFO_DRAW_CALLS_IN_FRAME)
	check(primitives > 1000, "%d primitives" % primitives)
	check(primitives <= max_primitives, "%d primitives of %s" % [primitives, field.name])
	check(draws <= max_draws, "%d draws of %s" % [draws, field.name])
	field.free()


func _count(info: RenderingServer.ViewportRenderInfo) -> int:
	var sum := 0
	for kind: RenderingServer.ViewportRenderInfoType in [
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_SHADOW
	]:
		sum += RenderingServer.viewport_get_render_info(stage.get_viewport_rid(), kind, info)
	return sum


func _sow() -> void:
	_field = PlantField3D.from_species([load(MEADOW_GRASS)])
	_field.density = 30.0
	_field.size = Vector2(5, 5)
	_field.simulation_enabled = false
	stage.add_child(_field)


func _mean_light(image: Image) -> float:
	var sum := 0.0
	for y in image.get_height():
		for x in image.get_width():
			sum += image.get_pixel(x, y).get_luminance()
	return sum / (image.get_width() * image.get_height())


func _count_green(image: Image) -> int:
	var count := 0
	for y in image.get_height():
		for x in image.get_width():
			var color := image.get_pixel(x, y)
			count += 1 if color.r + color.g + color.b > 0.05 else 0
	return count
