## The form of a default field: blades of neighbours point one way, and light tips have a dark base.
extends "res://tests/engine/picture_harness.gd"

const DAY := preload("res://addons/undergrowth/environments/day.tscn")
const SIZE := Vector2i(320, 180)
## The view has as many pixels per degree as one of 1280 by 720 with 75 degrees.
const VIEW_DEGREES := 21.7
## Side of the squares (pixels) in which the direction of blades is measured.
const SQUARE := 40
## Of this part of the view. With 1280 by 720 pixels, all of it below the sky had 0.46 and 20.
const MIN_COHERENCE := 0.35
const MIN_VALUE_RANGE := 12.0


func before_each() -> void:
	make_stage()
	stage.size = SIZE
	stage.msaa_3d = Viewport.MSAA_4X
	for kind in ["DirectionalLight3D", "WorldEnvironment"]:
		stage.find_children("*", kind, true, false)[0].free()
	stage.add_child(DAY.instantiate())


func after_each() -> void:
	stage.free()


func test_a_default_field_has_direction_and_depth() -> void:
	var field := PlantField3D.new()
	field.size = Vector2(6, 8)  # All that the camera sees.
	field.simulation_enabled = false
	stage.add_child(field)
	var camera := stage.get_camera_3d()
	camera.fov = VIEW_DEGREES
	camera.look_at_from_position(Vector3(0, 1.7, 4.0), Vector3(0, 0.2, 1.8))
	var shown := await picture()
	var coherence := _coherence_of(shown)
	check(coherence >= MIN_COHERENCE, "coherence of blade directions: %.2f" % coherence)
	var values := _values_of(shown)
	values.sort()
	var count := values.size()
	var low := values[count * 5 / 100]
	var spread := values[count * 95 / 100] / maxf(low, 1e-4)
	check(spread >= MIN_VALUE_RANGE, "range of values: %.1f" % spread)
	field.combed = 0.0
	var free := _coherence_of(await picture())
	check(free < coherence - 0.1, "without combing: %.2f, with it %.2f" % [free, coherence])


## Returns the mean over squares of (a - b) / (a + b), with the eigenvalues a and b of the structure
## tensor: 1 if all edges are parallel, 0 if they have no direction.
func _coherence_of(shown: Image) -> float:
	var grey := PackedFloat32Array()
	for y in SIZE.y:
		for x in SIZE.x:
			var color := shown.get_pixel(x, y)
			grey.append(0.299 * color.r + 0.587 * color.g + 0.114 * color.b)
	var sum := 0.0
	var count := 0
	for top in range(1, SIZE.y - SQUARE, SQUARE):
		for left in range(1, SIZE.x - SQUARE, SQUARE):
			sum += _coherence_in(grey, left, top)
			count += 1
	return sum / count


func _coherence_in(grey: PackedFloat32Array, left: int, top: int) -> float:
	var xx := 0.0
	var yy := 0.0
	var xy := 0.0
	for y in range(top, top + SQUARE):
		for x in range(left, left + SQUARE):
			var at := y * SIZE.x + x
			var dx := grey[at + 1] - grey[at - 1]
			var dy := grey[at + SIZE.x] - grey[at - SIZE.x]
			xx += dx * dx
			yy += dy * dy
			xy += dx * dy
	return Vector2(xx - yy, 2.0 * xy).length() / maxf(xx + yy, 1e-9)


func _values_of(shown: Image) -> PackedFloat32Array:
	var values := PackedFloat32Array()
	for y in SIZE.y:
		for x in SIZE.x:
			values.append(shown.get_pixel(x, y).srgb_to_linear().get_luminance())
	return values
