## Drawn climbers: leaves flutter in the wind, and rest without it, near the camera and far away.
extends "res://tests/engine/picture_harness.gd"

const MIN_MOVED := 150  # Pixels.

var _climber: PlantClimber3D
var _camera: Camera3D


func before_each() -> void:
	make_stage()
	var wall := MeshInstance3D.new()
	wall.mesh = BoxMesh.new()
	(wall.mesh as BoxMesh).size = Vector3(3.0, 2.0, 0.2)
	stage.add_child(wall)
	_climber = PlantClimber3D.new()
	_climber.position = Vector3(0.0, -0.6, 0.1)
	_climber.length = 1.2
	_climber.branching = 6.0
	_climber.wind = PlantWind.new()
	_climber.wind.kind = PlantWind.KIND_AIR
	_climber.wind.speed = 0.0
	_climber.wind.turbulence = 0.0  # Then only the flutter goes on.
	wall.add_child(_climber)
	_camera = Camera3D.new()
	_camera.fov = 50.0
	stage.add_child(_camera)
	_camera.position = Vector3(0.0, 0.0, 1.1)
	_camera.make_current()


func after_each() -> void:
	stage.free()


func test_leaves_flutter_in_the_wind_and_rest_without_it() -> void:
	await _grown()
	await frames(30)
	var calm := await picture()
	await frames(20)
	check(count_different(calm, await picture()) < MIN_MOVED / 10, "leaves rest in calm air")
	_climber.wind.speed = 9.0
	await frames(240)
	var blown := await picture()
	check(count_different(calm, blown) > MIN_MOVED, "wind moves leaves")
	await frames(7)
	check(count_different(blown, await picture()) > MIN_MOVED, "leaves flutter")


func test_every_level_is_drawn() -> void:
	await _grown()
	for away: float in [1.1, 8.0, 25.0, 50.0]:
		_camera.position.z = away
		_camera.fov = clampf(50.0 / away, 2.0, 50.0)
		_climber.show()
		await frames(3)
		var shown := await picture()
		_climber.hide()
		await frames(3)
		var hidden := await picture()
		var pixels := count_different(shown, hidden)
		check(pixels > 2000, "%d pixels at %.0f m" % [pixels, away])


func _grown() -> void:
	await until(func() -> bool: return _climber.get_leaf_count() > 0, "it has grown")


func test_it_grows_again_while_it_is_drawn() -> void:
	await _grown()
	for i in 3:
		_climber.length = 1.3 + 0.1 * i
		await frames(3)
		await until(func() -> bool: return not _climber.is_growing(), "it has grown")
	var shown := await picture()
	_climber.hide()
	check(count_different(shown, await picture()) > 2000, "it is drawn")
