## The number of plants of each instance that the renderer draws for a camera.
extends "res://tests/engine/drawing/drawing_harness.gd"

const END := 6.0
const CAMERA_STEP := 0.24  # Less than the movement that makes a field count again.

var _camera: Camera3D


func before_each() -> void:
	field = make_field(10.0, 30.0)
	field.levels = [PlantFieldLevel.of(3, END, 0.0)]
	field.tile_size = 2.0
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.make_current()


func after_each() -> void:
	_camera.free()
	super()


func test_all_plants_that_have_a_width_are_drawn() -> void:
	await start()
	for x: float in [-7.0, -3.1, 0.0, 2.6]:
		await _view_from(Vector3(x, 0.5, 0.7))
		_check_all_with_a_width()
		await _view_from(_camera.position + CAMERA_STEP * Vector3.RIGHT)
		_check_all_with_a_width()


func test_fewer_are_drawn_where_none_have_a_width() -> void:
	await start()
	await _view_from(Vector3(0.0, 0.5, 0.0))
	var near := _count_drawn()
	check(near < 0.7 * field.get_plant_count(), "%d are drawn near" % near)
	await _view_from(Vector3(20.0, 0.5, 0.0))
	check(_count_drawn() < 0.1 * near, "%d are drawn far away" % _count_drawn())


func test_fields_of_any_place_and_scale_draw_all_plants_that_have_a_width() -> void:
	field.position = Vector3(30.0, 2.0, -20.0)
	field.rotation.y = 0.7
	field.scale = Vector3(1.5, 1.0, 0.8)
	await start()
	for x: float in [-3.0, 0.0, 2.0]:
		await _view_from(field.to_global(Vector3(x, 0.3, 0.5)))
		_check_all_with_a_width()
	field.position = Vector3.ZERO
	await frames(2)
	await _view_from(field.to_global(Vector3(1.0, 0.3, 0.5)))
	_check_all_with_a_width()


func _view_from(place: Vector3) -> void:
	_camera.position = place
	await frames(2)
	RenderingServer.force_draw(false)  # A headless engine draws no frame without this call.


func _shown_of(instance: Dictionary) -> int:
	return instance["shown"] if instance["shown"] >= 0 else instance["buffer"].size() / STRIDE


func _count_drawn() -> int:
	var count := 0
	for instance in drawn_instances():
		count += _shown_of(instance)
	return count


## As in the shader (undergrowth_width.gdshaderinc).
func _check_all_with_a_width() -> void:
	var away_from_eye := 0
	for instance in drawn_instances():
		var plants := plants_of(instance)
		for i in range(_shown_of(instance), plants.size()):
			var away := field.to_global(plants[i].root).distance_to(_camera.position)
			var share := 1.0 - clampf(away / END, 0.0, 1.0)
			var cut := share + minf(0.1, 0.25 * share)
			check(plants[i].rank >= cut, "rank %f at %f m is left away" % [plants[i].rank, away])
			away_from_eye += 1
	check(away_from_eye > 0, "some plants are left away")
