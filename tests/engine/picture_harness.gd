## Base of the engine tests with pictures: a stage with a camera and a light.
extends "res://tests/engine/settling_harness.gd"

const PICTURE_SIZE := Vector2i(200, 240)
## Pixels differ if a channel differs by more than this.
const TOLERANCE := 10.0 / 255.0
## Number of pixels that may differ, on the outline, by rounding of vertices.
const MAX_DIFFERENT := 12
## Minimum number of pixels of the plant.
const MIN_PLANT := 100
## Frames at the end of a wait in which the stage is drawn.
const DRAWN_FRAMES := 2

var stage: SubViewport


## Returns a new stage. [code]stage.free()[/code] removes it with all of its nodes.
func make_stage() -> void:
	stage = SubViewport.new()
	stage.size = PICTURE_SIZE
	stage.own_world_3d = true
	stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(stage)
	_add_light()


## Returns a constant wind that crosses the picture at an angle.
## Adds a ground of [param side] (m) to the stage, and lets its lights cast shadows on it.
func cast_shadows_on_ground(side: float) -> void:
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	(ground.mesh as PlaneMesh).size = Vector2(side, side)
	stage.add_child(ground)
	cast_shadows()


## Lets the lights of the stage cast shadows.
func cast_shadows() -> void:
	for light: DirectionalLight3D in stage.find_children("*", "DirectionalLight3D", true, false):
		light.shadow_enabled = true


## Turns the lights of the stage to these angles (rad).
func turn_lights(rotation: Vector3) -> void:
	for light: DirectionalLight3D in stage.find_children("*", "DirectionalLight3D", true, false):
		light.rotation = rotation


func make_crossing_wind() -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	wind.direction = deg_to_rad(60.0)
	return wind


## Returns a field of added plants only, which the test steps.
func make_added_field(wind: PlantWind) -> PlantField3D:
	var field := PlantField3D.new()
	field.density = 0.0  # Added plants only.
	field.wind = wind
	field.simulation_enabled = false
	stage.add_child(field)
	field.rebuild()
	while field.is_building():
		await process_frame
	return field


## Returns a single plant at [param place], equal to one of a field after these steps in that wind.
func make_twin(
	field: PlantField3D, id: int, species: PlantFunction, place: Transform3D, steps: int
) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	var axes := (field.global_transform * field.get_plant_transform(id)).basis
	plant.height = field.get_plant_height(id) / axes.y.length()
	plant.seed = field.get_plant_seed(id)
	stage.add_child(plant)
	plant.global_transform = place
	await frames(2)  # The plant reads its position at the end of a frame.
	for i in steps:
		plant._preview(1.0 / 60.0, field.wind)
	await frames(2)
	return plant


## Returns a new reed with a stem of eight joints.
func make_reed() -> PlantFunction:
	var species := ReedFunction.new()
	species.law = PlantFunction.LAW_STEM
	species.stem = PlantStem.new()
	species.stem.joints = 8
	return species


## Draws nothing while it waits: each frame takes longer than the build's part of it.
func settled(field: PlantField3D) -> void:
	var is_drawn := RenderingServer.render_loop_enabled
	RenderingServer.render_loop_enabled = false
	await super(field)
	RenderingServer.render_loop_enabled = is_drawn


## Waits as in all tests, but draws the stage in the last frames only. In software that takes most
## of the time. Fields do the same work in each frame.
func frames(count: int) -> void:
	var unseen := maxi(count - DRAWN_FRAMES, 0)
	_draw_stage(false)
	await super(unseen)
	_draw_stage(true)
	await super(count - unseen)


func _draw_stage(is_drawn: bool) -> void:
	if is_instance_valid(stage):
		stage.render_target_update_mode = (
			SubViewport.UPDATE_ALWAYS if is_drawn else SubViewport.UPDATE_DISABLED
		)


## Returns the picture of the stage, two frames after all of its fields show their settings. Only
## the last one is drawn.
func picture() -> Image:
	if DisplayServer.get_name() == "headless":
		printerr("There is nothing to take a picture of: run this script with a renderer.")
		quit(1)
	for field: PlantField3D in stage.find_children("*", "PlantField3D", true, false):
		await settled(field)
	_draw_stage(false)
	for i in 3:  # A frame starts a list of shadows, and a list can start another one.
		await process_frame
		await until(_lists_no_shadows, "all shadows are listed")
	_draw_stage(true)
	await RenderingServer.frame_post_draw
	return stage.get_texture().get_image()


func _lists_no_shadows() -> bool:
	return stage.find_children("*", "PlantField3D", true, false).all(
		func(field: PlantField3D) -> bool: return not field.get_statistics()["is_listing_shadows"]
	)


func empty_picture() -> Image:
	var empty := Image.create_empty(PICTURE_SIZE.x, PICTURE_SIZE.y, false, Image.FORMAT_RGBA8)
	empty.fill(Color.BLACK)
	return empty


## Returns the number of pixels in which two pictures differ.
func count_different(one: Image, other: Image) -> int:
	if _has_bytes(one) and _has_bytes(other) and one.get_size() == other.get_size():
		return _count_different_bytes(_bytes_of(one), _bytes_of(other))
	var count := 0
	for y in one.get_height():
		for x in one.get_width():
			var a := one.get_pixel(x, y)
			var b := other.get_pixel(x, y)
			var apart := maxf(absf(a.r - b.r), maxf(absf(a.g - b.g), absf(a.b - b.b)))
			count += 1 if apart > TOLERANCE else 0
	return count


# Bytes instead of colours take a fraction of the time of get_pixel(). Equal pixels are most.
func _count_different_bytes(one: PackedByteArray, other: PackedByteArray) -> int:
	var count := 0
	var most := roundi(TOLERANCE * 255.0)
	var pixels := one.to_int32_array()
	var others := other.to_int32_array()
	for i in 0 if one == other else pixels.size():
		if pixels[i] == others[i]:
			continue
		for at in range(4 * i, 4 * i + 3):
			if absi(one[at] - other[at]) > most:
				count += 1
				break
	return count


func _has_bytes(image: Image) -> bool:
	return image.get_format() in [Image.FORMAT_RGB8, Image.FORMAT_RGBA8]


# Returns four bytes a pixel. Renderers give three where the picture is opaque.
func _bytes_of(image: Image) -> PackedByteArray:
	if image.get_format() == Image.FORMAT_RGBA8:
		return image.get_data()
	var copy: Image = image.duplicate()
	copy.convert(Image.FORMAT_RGBA8)
	return copy.get_data()


## Returns the sum of the linear colours of the rows from [param top] to before [param bottom], of
## all by default. w: the number of pixels that are not black.
func sum_of_light(shown: Image, top := 0, bottom := shown.get_height()) -> Vector4:
	var light := PackedFloat32Array()
	for byte in 256:
		light.append(Color8(byte, 0, 0).srgb_to_linear().r)
	var bytes := _bytes_of(shown)
	var pixels := bytes.to_int32_array()
	var sum := Vector4.ZERO
	for i in range(top * shown.get_width(), bottom * shown.get_width()):
		if pixels[i] & 0xffffff == 0:
			continue
		sum += Vector4(light[bytes[4 * i]], light[bytes[4 * i + 1]], light[bytes[4 * i + 2]], 1.0)
	return sum


## Returns the maximum value of all channels.
func brightest_of(shown: Image) -> float:
	var maximum := 0.0
	for channel in _channels_of(shown):
		if channel > maximum:
			maximum = channel
	return maximum


## Returns the number of pixels with NaN, with a negative value, or brighter than [param maximum].
func count_wrong(shown: Image, maximum: float) -> int:
	var count := 0
	var last := -1
	var channels := _channels_of(shown)
	for i in channels.size():
		if channels[i] >= 0.0 and channels[i] <= maximum:
			continue
		count += 1 if i / 3 != last else 0
		last = i / 3
	return count


# Returns red, green and blue of all pixels.
func _channels_of(shown: Image) -> PackedFloat32Array:
	var copy: Image = shown.duplicate()
	copy.convert(Image.FORMAT_RGBF)
	return copy.get_data().to_float32_array()


func _add_light() -> void:
	var camera := Camera3D.new()
	stage.add_child(camera)
	camera.look_at_from_position(Vector3(0, 1.0, 2.8), Vector3(0, 0.7, 0))
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50, 30, 0)
	stage.add_child(sun)
	var surroundings := WorldEnvironment.new()
	surroundings.environment = Environment.new()
	surroundings.environment.background_mode = Environment.BG_COLOR
	surroundings.environment.background_color = Color.BLACK
	surroundings.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	surroundings.environment.ambient_light_color = Color(0.4, 0.4, 0.4)
	stage.add_child(surroundings)
