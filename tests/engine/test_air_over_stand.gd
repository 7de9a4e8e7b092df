## PlantWind.sample_over_stand(): the air over the tops of a field, for maps and for crops of one's own.
extends "res://tests/engine/harness.gd"

## Metres per second.
const TOLERANCE := 1e-3
const WAVE_TOLERANCE := 0.02

var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.speed = 8.0
	_wind.gustiness = 0.0
	_wind.stand_height = 0.8


func after_each() -> void:
	_wind = null


func test_smooth_air_has_the_speed_of_the_tops() -> void:
	_wind.turbulence = 0.0
	_wind.direction = deg_to_rad(90.0)
	for height: float in [0.1, 0.8, 3.0]:
		_wind.stand_height = height
		var expected := _top_speed()
		for velocity in _wind.sample_over_stand(3.0, _row(5)):
			check_near(velocity.x, expected, TOLERANCE, "over %f m" % height)
			check_near(velocity.y, 0.0, TOLERANCE, "across")


func test_waves_run_over_the_tops_and_keep_their_form() -> void:
	_wind.wave_share = 1.0
	var way := 1.8 * _top_speed()
	var places := _row(40)
	var later := PackedVector2Array()
	for place in places:
		later.append(place + Vector2(0.0, 0.5 * way))
	var before := _wind.sample_over_stand(20.0, places)
	var after := _wind.sample_over_stand(20.5, later)
	var slowest := INF
	var fastest := 0.0
	for i in places.size():
		check_near(after[i].y, before[i].y, WAVE_TOLERANCE, "speed of wave %d" % i)
		slowest = minf(slowest, before[i].y)
		fastest = maxf(fastest, before[i].y)
	check(fastest > 1.5 * slowest, "there are waves: %f to %f m/s" % [slowest, fastest])


func test_still_air_and_no_places() -> void:
	_wind.speed = 0.0
	for velocity in _wind.sample_over_stand(3.0, _row(4)):
		check_equal(velocity, Vector2.ZERO, "still")
	check_equal(_wind.sample_over_stand(3.0, PackedVector2Array()).size(), 0, "no places")
	_wind.speed = 5.0
	_wind.stand_height = 0.0
	check(_wind.sample_over_stand(3.0, _row(1))[0].y > 0.0, "it blows over turf")


func test_what_cannot_be_asked_is_told() -> void:
	check_equal(_wind.sample_over_stand(NAN, _row(2)).size(), 0, "at no time")
	check_error("sample_over_stand() needs a finite time")
	check_equal(_wind.sample_over_stand(1.0, PackedVector2Array([Vector2(0, INF)])).size(), 0)
	check_error("finite places")
	_wind.kind = PlantWind.KIND_WAVES
	for i in 3:
		check_equal(_wind.sample_over_stand(1.0, _row(2)).size(), 0, "of newtons")
	check_error("sample_over_stand() needs KIND_AIR")


# The logarithmic law over a stand, with its displacement of 0.7 heights and roughness of 0.1.
func _top_speed() -> float:
	var height := _wind.stand_height
	return _wind.speed * log(3.0) / log((10.0 - 0.7 * height) / (0.1 * height))


func _row(count: int) -> PackedVector2Array:
	var places := PackedVector2Array()
	for i in count:
		places.append(Vector2(1.7 * i - 20.0, 0.9 * i))
	return places
