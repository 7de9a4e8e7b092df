## Shadows of plants of parts in pictures: leaves and petals cast them, without stripes on
## themselves.
extends "res://tests/engine/picture_harness.gd"

const GARDEN_TULIP := "res://addons/undergrowth/species/garden_tulip.tres"
## Share of a flower's pixels whose neighbour may differ in shadow.
const MAX_BORDERS := 0.06

var _sun: DirectionalLight3D
var _plant: Plant3D


func before_each() -> void:
	make_stage()
	_sun = stage.find_children("*", "DirectionalLight3D", false, false)[0]
	_sun.rotation_degrees = Vector3(-17, -142, 0)
	_sun.light_energy = 3.0
	_sun.shadow_bias = 0.03
	_sun.shadow_normal_bias = 0.6
	_sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	_sun.directional_shadow_max_distance = 18.0
	_plant = Plant3D.new()
	_plant.species = load(GARDEN_TULIP)
	_plant.segments = 12
	_plant.height = 0.4
	_plant.seed = 3
	_plant.simulation_enabled = false
	stage.add_child(_plant)


func after_each() -> void:
	stage.free()


func test_petals_are_not_striped_by_their_own_shadow() -> void:
	stage.get_camera_3d().look_at_from_position(Vector3(0.05, 0.42, 0.22), Vector3(0, 0.37, 0))
	var lit := await picture()
	_sun.shadow_enabled = true
	var shaded := await picture()
	check(count_different(lit, empty_picture()) > 20 * MIN_PLANT, "a flower fills the picture")
	var borders := 0
	for y in PICTURE_SIZE.y:
		for x in range(1, PICTURE_SIZE.x):
			var before := _is_shaded(lit, shaded, x - 1, y)
			borders += 1 if _is_shaded(lit, shaded, x, y) != before else 0
	var share := float(borders) / count_different(lit, empty_picture())
	check(share < MAX_BORDERS, "%.3f of its pixels are at borders of shadows" % share)


func test_plants_throw_shadows() -> void:
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	(ground.mesh as PlaneMesh).size = Vector2(4, 4)
	stage.add_child(ground)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 2.0, 0.1), Vector3.ZERO)
	var lit := await picture()
	_sun.shadow_enabled = true
	check(count_different(lit, await picture()) > MIN_PLANT, "pixels in shadow")


func _is_shaded(lit: Image, shaded: Image, x: int, y: int) -> bool:
	return lit.get_pixel(x, y).r - shaded.get_pixel(x, y).r > 0.5 * TOLERANCE
