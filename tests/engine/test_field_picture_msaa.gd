## Antialiasing adds no pixels that are brighter than the plants, and none without a valid value.
extends "res://tests/engine/picture_harness.gd"

const LAWN := preload("res://addons/undergrowth/mixes/lawn.tscn")
const SIZE := Vector2i(480, 270)
## Factor by which channels may be brighter, because antialiasing samples other points of a plant.
const TOLERANCE_OF_LIGHT := 1.1


func before_each() -> void:
	make_stage()
	stage.size = SIZE
	stage.use_hdr_2d = true  # The picture has the unclipped colours that glow uses.
	_turn_on_glow()


func after_each() -> void:
	stage.free()


func test_a_lawn_has_no_brighter_pixels_with_msaa() -> void:
	var lawn: PlantField3D = LAWN.instantiate()
	lawn.simulation_enabled = false
	stage.add_child(lawn)
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(Vector3(0, 1.7, 8.0), Vector3.ZERO)
	var plain := await picture()
	var brightest := brightest_of(plain)
	check(brightest > 0.1 and brightest < 4.0, "the lawn is lit, by at most %.2f" % brightest)
	check_equal(count_wrong(plain, brightest), 0, "wrong pixels without MSAA")
	for msaa: Viewport.MSAA in [Viewport.MSAA_4X, Viewport.MSAA_8X]:
		stage.msaa_3d = msaa
		var wrong := count_wrong(await picture(), TOLERANCE_OF_LIGHT * brightest)
		check_equal(wrong, 0, "wrong pixels with MSAA %d" % msaa)


func _turn_on_glow() -> void:
	var found := stage.find_children("*", "WorldEnvironment", true, false)
	var environment := (found[0] as WorldEnvironment).environment
	environment.glow_enabled = true
	environment.glow_hdr_threshold = 1.0
