## Shadows of the plants around the cameras, which ShadowPlants lists.
extends "res://tests/engine/picture_harness.gd"

const MEADOW_GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
const SIZE := 60.0  # m
const WIDTH := 8.0  # m
const MIN_SHADOW := 40  # Pixels.
## Frames in which a field reads the engine's own properties again.
const POLLED := 20
const MAX_SHADOW_PRIMITIVES := 0.35e6
const MAX_SHADOW_DRAWS := 30

var _field: PlantField3D
var _ground: MeshInstance3D


func before_each() -> void:
	make_stage()
	_ground = MeshInstance3D.new()
	_ground.mesh = PlaneMesh.new()
	(_ground.mesh as PlaneMesh).size = 2.0 * Vector2(SIZE, SIZE)
	stage.add_child(_ground)
	for light: DirectionalLight3D in stage.find_children("*", "DirectionalLight3D", true, false):
		light.shadow_enabled = true
		light.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
		light.directional_shadow_max_distance = 20.0
		light.rotation = Vector3(-0.8, 0.6, 0)
	_field = PlantField3D.from_species([load(MEADOW_GRASS)])
	_field.size = Vector2(SIZE, WIDTH)
	_field.simulation_enabled = false


func after_each() -> void:
	stage.free()


func test_plants_around_a_camera_that_moved_cast_shadows() -> void:
	_field.density = 3.0
	stage.add_child(_field)
	_look_from(Vector3(-0.4 * SIZE, 1.2, 0))
	await settled(_field)
	check(await _count_shadows() > MIN_SHADOW, "shadows where the camera begins")
	_look_from(Vector3(0.4 * SIZE, 1.2, 0))
	check(await _count_shadows() > MIN_SHADOW, "shadows 48 m farther")


func test_dense_plants_beyond_the_nearest_ones_cast_shadows() -> void:
	_field.density = 30.0
	_field.size = Vector2(12, 12)
	stage.add_child(_field)
	stage.get_camera_3d().fov = 20.0
	stage.get_camera_3d().look_at_from_position(Vector3(0, 4, 12), Vector3(0, 0, 2))
	await settled(_field)
	check(await _count_shadows() > MIN_SHADOW, "shadows 10 m from the camera")


func test_plants_at_the_end_of_a_long_tile_cast_shadows() -> void:
	_field.density = 3.0
	_field.size = Vector2(100, 8)
	_field.tile_size = 64.0
	stage.add_child(_field)
	_look_from(Vector3(47, 1.2, 1.5))
	await settled(_field)
	check(await _count_shadows() > MIN_SHADOW, "shadows 47 m from the other end")


func test_plants_of_a_field_that_moved_cast_shadows() -> void:
	_field.density = 3.0
	_field.size = Vector2(12, 12)
	stage.add_child(_field)
	_look_from(Vector3(0, 1.2, 1.5))
	await settled(_field)
	var shadows := float(await _count_shadows())
	check(shadows > MIN_SHADOW, "shadows where the field is built")
	var way := Vector3(2.0 * SIZE, 0, 0)
	for node: Node3D in [_field, _ground]:
		node.position += way
	_look_from(way + Vector3(0, 1.2, 1.5))
	check_near(float(await _count_shadows()), shadows, 0.1 * shadows, "shadows 120 m farther")


func test_each_camera_has_shadows_around_it() -> void:
	_field.density = 3.0
	stage.add_child(_field)
	var other := SubViewport.new()
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	other.size = PICTURE_SIZE
	other.world_3d = stage.find_world_3d()
	var camera := Camera3D.new()
	other.add_child(camera)
	stage.add_child(other)
	camera.look_at_from_position(Vector3(-0.4 * SIZE, 1.2, 0), Vector3(-0.4 * SIZE, 0, -1.5))
	_look_from(Vector3(0.4 * SIZE, 1.2, 0))
	await settled(_field)
	check(await _count_shadows() > MIN_SHADOW, "shadows before the first camera")
	check(await _count_shadows(other) > MIN_SHADOW, "shadows before the second camera")


func test_added_and_removed_plants_change_the_shadows() -> void:
	_field.density = 0.0
	stage.add_child(_field)
	_look_from(Vector3(0, 1.2, 1.5))
	await settled(_field)
	check_equal(await _count_shadows(), 0, "pixels of shadow without plants")
	var places: Array[Transform3D] = []
	for i in 40:
		places.append(Transform3D(Basis(), Vector3(0.15 * (i % 8) - 0.5, 0, 0.03 * i - 0.6)))
	_field.add_plants(places, load(MEADOW_GRASS))
	await settled(_field)
	check(await _count_shadows() > MIN_SHADOW, "shadows of added plants")
	_field.remove_in_sphere(Vector3.ZERO, 3.0)
	await settled(_field)
	check_equal(await _count_shadows(), 0, "pixels of shadow of removed plants")


func test_tiles_that_load_after_the_camera_moved_cast_shadows() -> void:
	_field.density = 3.0
	_field.view_distance = 25.0
	stage.add_child(_field)
	_look_from(Vector3(-0.4 * SIZE, 1.2, 0))
	await settled(_field)
	_look_from(Vector3(0.4 * SIZE, 1.2, 0))
	await frames(1)  # The plants around this camera are listed before its tiles exist.
	await until(_has_all_tiles_here, "all tiles are loaded")
	var loaded := await picture()
	check(await _count_shadows() > MIN_SHADOW, "shadows of the loaded tiles")
	check(count_different(loaded, await picture()) <= MAX_DIFFERENT, "the same in a new list")


func test_shadows_come_again_after_they_were_off() -> void:
	_field.density = 3.0
	stage.add_child(_field)
	_look_from(Vector3(0, 1.2, 1.5))
	await settled(_field)
	var first := await picture()
	_field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	await frames(POLLED)
	check(count_different(first, await picture()) > MIN_SHADOW, "no shadows when they are off")
	_field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	await frames(POLLED)
	check(count_different(first, await picture()) <= MAX_DIFFERENT, "the same shadows again")


func test_shadows_of_a_large_meadow_cost_little() -> void:
	_field.free()
	_field = (load("res://addons/undergrowth/mixes/meadow.tscn") as PackedScene).instantiate()
	_field.size = Vector2(40, 24)  # To beyond the distance of shadows from the camera.
	_field.simulation_enabled = false
	stage.add_child(_field)
	stage.size = Vector2i(160, 90)
	_look_from(Vector3(0, 1.7, 10))
	await settled(_field)
	await picture()
	var primitives := _shadow_info(RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME)
	var draws := _shadow_info(RenderingServer.VIEWPORT_RENDER_INFO_DRAW_CALLS_IN_FRAME)
	check(primitives > 1000, "%d primitives of shadows" % primitives)
	check(primitives <= MAX_SHADOW_PRIMITIVES, "%d primitives of shadows" % primitives)
	check(draws <= MAX_SHADOW_DRAWS, "%d draw calls of shadows" % draws)


func _has_all_tiles_here() -> bool:
	var place := stage.get_camera_3d().position
	var has_plants := _field.find_nearest_plant(Vector3(place.x, 0, place.z), 1.0) >= 0
	return has_plants and is_settled(_field) and _field.get_statistics()["tiles_waiting"] == 0


func _look_from(place: Vector3) -> void:
	stage.get_camera_3d().look_at_from_position(place, Vector3(place.x, 0, place.z - 1.5))


## Returns the number of pixels of a viewport that differ without shadows.
func _count_shadows(seen: SubViewport = stage) -> int:
	var shaded := await _picture_of(seen)
	var usual := _field.shadow_distance
	_field.shadow_distance = 0.0
	var bright := await _picture_of(seen)
	_field.shadow_distance = usual
	return count_different(shaded, bright)


func _picture_of(seen: SubViewport) -> Image:
	await picture()
	return seen.get_texture().get_image()


func _shadow_info(info: RenderingServer.ViewportRenderInfo) -> int:
	return RenderingServer.viewport_get_render_info(
		stage.get_viewport_rid(), RenderingServer.VIEWPORT_RENDER_INFO_TYPE_SHADOW, info
	)
