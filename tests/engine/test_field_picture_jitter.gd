## Painted jitter of color is visible where it is painted, and nowhere else.
extends "res://tests/engine/picture_harness.gd"

const MEADOW := preload("res://addons/undergrowth/species/meadow_grass.tres")
const MIN_CHANGED := 400
## Of all pixels of the half with jitter, as a factor.
const MEAN_TOLERANCE := 0.15

var _field: PlantField3D


func before_each() -> void:
	make_stage()


func after_each() -> void:
	stage.free()


func test_plants_of_parts_differ_in_color() -> void:
	await _check(MEADOW)


func test_plants_of_one_stem_differ_in_color() -> void:
	await _check(TulipFunction.new())


func test_a_turned_field_shows_the_same_jitter() -> void:
	await _check(TulipFunction.new(), Basis(Vector3(1, 2, 0.5).normalized(), 0.4))


func _check(species: PlantFunction, turn := Basis.IDENTITY) -> void:
	_field = PlantField3D.from_species([species])
	_field.size = Vector2(2, 2)
	_field.density = 60.0
	_field.basis = turn
	_field.simulation_enabled = false
	var map := PlantMap.new()
	var layer := _field.species[0].get_layer_name()
	stage.add_child(_field)
	map.fill_polygon(_field.get_outline_points(), layer)
	_field.map = map
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(turn * Vector3(0, 4, 0.1), Vector3.ZERO, turn * Vector3.FORWARD)
	var plain := await picture()
	map.paint_color_jitter(Vector3(-50, 0, 0), 50.0, layer, 1.0, 1.0, 0.0)
	var colored := await picture()
	var left := _changed(plain, colored, 0, PICTURE_SIZE.x / 2 - 30)
	var right := _changed(plain, colored, PICTURE_SIZE.x / 2 + 30, PICTURE_SIZE.x)
	check(left > MIN_CHANGED, "%d pixels with jitter have another color" % left)
	check_equal(right, 0, "changed pixels without jitter")
	var factor := _mean(colored) / _mean(plain)
	check_near(factor, 1.0, MEAN_TOLERANCE, "mean of the picture")
	map.paint_color_jitter(Vector3(-50, 0, 0), 51.0, layer, 0.0, 1.0, 0.0)
	var back := await picture()
	check_equal(
		_changed(plain, back, 0, PICTURE_SIZE.x), 0, "changed pixels after it is taken away"
	)


func _changed(one: Image, other: Image, from: int, to: int) -> int:
	var area := Rect2i(from, 0, to - from, PICTURE_SIZE.y)
	return count_different(one.get_region(area), other.get_region(area))


func _mean(of: Image) -> float:
	var sum := 0.0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			sum += of.get_pixel(x, y).get_luminance()
	return sum
