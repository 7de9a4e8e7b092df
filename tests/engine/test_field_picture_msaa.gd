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
	var brightest := _brightest(plain)
	check(brightest > 0.1 and brightest < 4.0, "the lawn is lit, by at most %.2f" % brightest)
	check_equal(_count_wrong(plain, brightest), 0, "wrong pixels without MSAA")
	for msaa: Viewport.MSAA in [Viewport.MSAA_4X, Viewport.MSAA_8X]:
		stage.msaa_3d = msaa
		var wrong := _count_wrong(await picture(), TOLERANCE_OF_LIGHT * brightest)
		check_equal(wrong, 0, "wrong pixels with MSAA %d" % msaa)


func _turn_on_glow() -> void:
	var found := stage.find_children("*", "WorldEnvironment", true, false)
	var environment := (found[0] as WorldEnvironment).environment
	environment.glow_enabled = true
	environment.glow_hdr_threshold = 1.0


## Returns the maximum value of all channels.
func _brightest(shown: Image) -> float:
	var maximum := 0.0
	for y in SIZE.y:
		for x in SIZE.x:
			var color := shown.get_pixel(x, y)
			maximum = maxf(maximum, maxf(color.r, maxf(color.g, color.b)))
	return maximum


## Returns the number of pixels with NaN, with a negative value, or brighter than [param most].
func _count_wrong(shown: Image, maximum: float) -> int:
	var count := 0
	for y in SIZE.y:
		for x in SIZE.x:
			var color := shown.get_pixel(x, y)
			for channel: float in [color.r, color.g, color.b]:
				if not (channel >= 0.0 and channel <= maximum):
					count += 1
					break
	return count
