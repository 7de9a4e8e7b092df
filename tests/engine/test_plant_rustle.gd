## A PlantRustle3D is as loud as the wind and the bodies in the plants near the listener.
extends "res://tests/engine/harness.gd"

const Rustle := preload("res://addons/undergrowth/sound/plant_rustle_3d.gd")
const SETTLED := 90
const DB_TOLERANCE := 0.5

var _stage: SubViewport
var _field: PlantField3D
var _camera: Camera3D
var _rustle: AudioStreamPlayer3D


func before_each() -> void:
	_stage = SubViewport.new()
	_stage.own_world_3d = true
	root.add_child(_stage)
	_camera = Camera3D.new()
	_camera.position.y = 1.6
	_stage.add_child(_camera)
	_camera.make_current()
	_field = PlantField3D.new()
	_field.size = Vector2(6, 6)
	_field.density = 4.0
	_field.wind = PlantWind.new()
	_field.wind.kind = PlantWind.KIND_AIR
	_field.wind.turbulence = 0.0
	_field.wind.canopy_wave_amount = 0.0
	_stage.add_child(_field)
	_field.build_now()
	_rustle = Rustle.new()
	_rustle.field = _field
	_stage.add_child(_rustle)


func after_each() -> void:
	_stage.free()


func test_it_has_its_full_level_at_full_speed_and_is_silent_in_calm_air() -> void:
	var levels: Array[float] = []
	for share: float in [1.0, 0.5, 0.0]:
		_rustle.full_speed = _set_speed_at_tops(share)
		await frames(SETTLED)
		levels.append(_rustle.volume_db)
	check_near(levels[0], _rustle.level_db, DB_TOLERANCE, "at full speed")
	check_near(levels[1], _rustle.level_db - 9.03, DB_TOLERANCE, "at half of it")
	check(not _rustle.playing, "stopped in calm air, %.1f dB" % levels[2])


func test_it_is_at_the_plants_near_the_listener() -> void:
	_field.wind.speed = 8.0
	_camera.position = Vector3(1.0, 1.6, -1.5)
	await frames(SETTLED)
	check(_flat_distance(_rustle, Vector3(1.0, 0, -1.5)) < 1.0, "below the listener")
	_camera.position = Vector3(30.0, 1.6, 1.0)
	await frames(SETTLED)
	check(_flat_distance(_rustle, Vector3(3.0, 0, 1.0)) < 1.0, "at the nearest edge")
	check(_rustle.playing, "it plays")


func test_a_body_that_moves_in_the_plants_is_heard_where_it_is() -> void:
	_field.wind.speed = 0.0
	_field.bodies_group = &"walkers"
	var body := _make_body()
	await frames(SETTLED)
	check(not _rustle.playing, "a resting body is silent")
	var loudest := -INF
	for i in 40:
		body.position.x += 0.03
		await frames(1)
		loudest = maxf(loudest, _rustle.volume_db)
	check(loudest > _rustle.level_db - 30.0, "a moving one is not: %.1f dB" % loudest)
	check(_flat_distance(_rustle, body.position) < 0.1, "where the body is")
	await frames(SETTLED)
	check(not _rustle.playing, "silent after it")


func test_its_own_sound_has_no_seam() -> void:
	_field.wind.speed = 8.0
	await frames(SETTLED)
	var sound := _rustle.stream as AudioStreamWAV
	check(sound != null, "it has a sound")
	check_equal(sound.loop_mode, AudioStreamWAV.LOOP_FORWARD, "loop")
	var mean := 0.0
	var loudest := 0.0
	for i in sound.loop_end:
		var value := sound.data.decode_s16(2 * i) / 32768.0
		mean += value / sound.loop_end
		loudest = maxf(loudest, absf(value))
	check_near(mean, 0.0, 0.01, "mean")
	check(loudest > 0.3 and loudest < 1.0, "loudest: %.2f" % loudest)


func test_a_wind_in_newtons_gives_a_configuration_warning() -> void:
	check_equal(_rustle._get_configuration_warnings().size(), 0, "warnings")
	_field.wind.kind = PlantWind.KIND_WAVES
	check_equal(_rustle._get_configuration_warnings().size(), 1, "warnings in newtons")
	_rustle.field = null
	check_equal(_rustle._get_configuration_warnings().size(), 1, "warnings without a field")


## Sets a wind of 8 m/s times `share`; returns the speed of 8 m/s at the tops.
func _set_speed_at_tops(share: float) -> float:
	_field.wind.speed = 8.0
	var full := _field.wind.sample_over_canopy(0.0, PackedVector2Array([Vector2.ZERO]))[0].length()
	_field.wind.speed = 8.0 * share
	return full


func _flat_distance(node: Node3D, place: Vector3) -> float:
	return Vector2(node.global_position.x - place.x, node.global_position.z - place.z).length()


func _make_body() -> Node3D:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	body.add_child(shape)
	body.add_to_group(&"walkers")
	body.position = Vector3(-0.5, 0.2, 0)
	_stage.add_child(body)
	return body
