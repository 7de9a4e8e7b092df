## PlantWind.sample_over_canopy(): the air over the tops of a field, for maps and crops.
extends "res://tests/engine/harness.gd"

## Metres per second.
const TOLERANCE := 1e-3

var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.speed = 8.0
	_wind.gustiness = 0.0
	_wind.canopy_height = 0.8


func after_each() -> void:
	_wind = null


func test_smooth_air_has_the_speed_of_the_tops() -> void:
	_wind.turbulence = 0.0
	_wind.direction = deg_to_rad(90.0)
	for height: float in [0.1, 0.8, 3.0]:
		_wind.canopy_height = height
		var expected := _top_speed()
		for velocity in _wind.sample_over_canopy(3.0, _row(5)):
			check_near(velocity.x, expected, TOLERANCE, "over %f m" % height)
			check_near(velocity.y, 0.0, TOLERANCE, "across")


func test_waves_run_over_the_tops_at_their_speed() -> void:
	_wind.canopy_wave_amount = 1.0
	var way := 0.5 * 1.8 * _top_speed()
	var apart: Array[float] = []
	for share: float in [1.0, 0.95, 1.05, 0.0]:
		apart.append(_mean_square_apart(0.5, share * way))
	check(apart[0] < minf(apart[1], apart[2]), "nearest at their speed: %s" % [apart])
	check(apart[0] < 0.05 * apart[3], "they keep their form: %s" % [apart])


# Returns the difference between the current air and the later air, that many metres downwind.
func _mean_square_apart(seconds: float, way: float) -> float:
	var places := _row(200)
	var later := PackedVector2Array()
	for place in places:
		later.append(place + Vector2(0.0, way))
	var before := _wind.sample_over_canopy(20.0, places)
	var after := _wind.sample_over_canopy(20.0 + seconds, later)
	var sum := 0.0
	for i in places.size():
		sum += (after[i].y - before[i].y) ** 2
	return sum / places.size()


func test_still_air_and_no_places() -> void:
	_wind.speed = 0.0
	for velocity in _wind.sample_over_canopy(3.0, _row(4)):
		check_equal(velocity, Vector2.ZERO, "still")
	check_equal(_wind.sample_over_canopy(3.0, PackedVector2Array()).size(), 0, "no places")
	_wind.speed = 5.0
	_wind.canopy_height = 0.0
	var sum := 0.0  # In lulls the air over plants flows backwards at some places.
	for velocity in _wind.sample_over_canopy(3.0, _row(400)):
		sum += velocity.y
	check(sum > 0.0, "it blows over turf")


func test_bad_queries_are_reported() -> void:
	check_equal(_wind.sample_over_canopy(NAN, _row(2)).size(), 0, "at no time")
	check_error("sample_over_canopy() needs a finite time")
	check_equal(_wind.sample_over_canopy(1.0, PackedVector2Array([Vector2(0, INF)])).size(), 0)
	check_error("finite positions")
	_wind.kind = PlantWind.KIND_WAVES
	for i in 3:
		check_equal(_wind.sample_over_canopy(1.0, _row(2)).size(), 0, "of newtons")
	check_error("sample_over_canopy() needs KIND_AIR")


# The logarithmic law over a canopy, with a displacement of 0.7 heights and a roughness of 0.1.
func _top_speed() -> float:
	var height := _wind.canopy_height
	return _wind.speed * log(3.0) / log((10.0 - 0.7 * height) / (0.1 * height))


func _row(count: int) -> PackedVector2Array:
	var places := PackedVector2Array()
	for i in count:
		places.append(Vector2(1.7 * i - 20.0, 0.9 * i))
	return places
