## The share of its height with which each plant is drawn.
extends "res://tests/engine/drawing/drawing_harness.gd"

const DISTANCE := 16.0
const FAR := 40.0

var _camera: Camera3D
var _whole: Dictionary[int, float] = {}  # Heights before mowing.


func before_each() -> void:
	field = make_field(120.0, 6.0)
	field.tile_size = 8.0
	field.view_distance = DISTANCE
	_camera = Camera3D.new()
	root.add_child(_camera)


func after_each() -> void:
	super()
	_camera.free()


func test_mown_plants_are_drawn_as_high_as_they_are() -> void:
	await _start_streamed()
	_check_heights(0)
	var first := field.set_height_in_sphere(Vector3(-8, 0, 0), 6.0, 0.1)
	await frames(3)
	_check_heights(first)
	# Tiles of a layer with mown plants.
	var second := field.set_height_in_sphere(Vector3(9, 0, 5), 6.0, 0.05)
	await frames(3)
	_check_heights(first + second)
	field.set_height_in_sphere(Vector3.ZERO, 40.0, 50.0)
	await frames(3)
	_check_heights(0)


func test_plants_mown_after_others_have_regrown_are_drawn_as_high_as_they_are() -> void:
	await _start_streamed()
	field.regrowth_rate = 0.5
	var first := field.set_height_in_sphere(Vector3(-8, 0, 0), 6.0, 0.1)
	await frames(30)
	field.regrowth_rate = 0.0
	var second := field.set_height_in_sphere(Vector3(9, 0, 5), 6.0, 0.1)
	await frames(3)
	_check_heights(first + second)


func test_plants_that_come_are_drawn_whole_where_mown_ones_went() -> void:
	await _start_streamed()
	check(field.set_height_in_sphere(Vector3.ZERO, 60.0, 0.1) > 2000, "all are mown")
	await frames(3)
	var mown := _rows()
	_camera.position.x = FAR
	await _streamed()
	var used_again := 0
	for row: Vector2i in _rows():
		used_again += 1 if mown.has(row) else 0
	check(used_again > 0, "%d rows are used again" % used_again)
	_whole.clear()
	_check_heights(0, Vector3(FAR, 0, 0), 6.0)


func test_removed_plants_are_hidden() -> void:
	await _check_removed()


func test_removed_plants_of_a_field_without_simulation_are_hidden() -> void:
	field.simulation_enabled = false
	await _check_removed()


func _check_removed() -> void:
	field.view_distance = 0.0
	field.size = Vector2(20, 20)
	await start()
	var drawn := drawn_shares()
	check_equal(drawn.size(), field.get_plant_count(), "drawn")
	var gone := field.find_plants_in_sphere(Vector3.ZERO, 4.0)
	var places := field.get_plant_transforms(gone)
	check_equal(field.remove_in_sphere(Vector3.ZERO, 4.0), gone.size(), "removed")
	await frames(3)
	drawn = drawn_shares()
	check_equal(drawn.size(), field.get_plant_count(), "drawn then")
	for place: Transform3D in places:
		check(not drawn.has(place.origin), "a removed plant at %s" % place.origin)


func _start_streamed() -> void:
	await start()
	await _streamed()
	_whole.clear()
	for id in field.get_plant_ids():
		_whole[id] = field.get_plant_height(id)


func _streamed() -> void:
	await frames(20)
	while field.is_building() or field.get_statistics()["tiles_waiting"] > 0:
		await process_frame
	await frames(20)


## Returns all rows of layers with drawn plants.
func _rows() -> Dictionary[Vector2i, bool]:
	var rows: Dictionary[Vector2i, bool] = {}
	for plant: DrawnPlant in drawn_plants().values():
		rows[Vector2i(plant.layer, plant.texel / SIDE)] = true
	return rows


## Checks that plants within [param radius] of [param middle] have their own height, and counts the
## mown ones.
func _check_heights(mown: int, middle := Vector3.ZERO, radius := 60.0) -> void:
	var shares := drawn_shares()
	var count := 0
	var wrong := 0
	var seen := 0
	for id in field.find_plants_in_sphere(middle, radius):
		var place := field.get_plant_transform(id)
		var height := field.get_plant_height(id)
		if not shares.has(place.origin):
			wrong += 1
			continue
		seen += 1
		var share := shares[place.origin]
		count += 1 if share < 0.999 else 0
		wrong += 1 if absf(share - height / _whole.get(id, height)) > 2e-3 else 0
	check(seen > 50, "%d plants are drawn" % seen)
	check_equal(wrong, 0, "plants of %d of another height" % seen)
	check_equal(count, mown, "mown plants")
