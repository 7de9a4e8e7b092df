## PlantWind: the four kinds against their formulas (thesis, section 4.3), and their settings.
extends "res://tests/engine/harness.gd"

const PATH := "user://saved_wind.tres"
const FORCE_TOLERANCE := 1e-4
const NORTH_TO_SOUTH := Vector3(0, 0, 1)
const STEP := 1.0 / 60.0

var _wind: PlantWind
var _plant: Plant3D
var _changes := 0


func before_each() -> void:
	_changes = 0
	_wind = PlantWind.new()
	_wind.strength = 8.0
	_wind.frequency = 0.5


func after_each() -> void:
	if _plant:
		_plant.free()
		_plant = null
	_wind = null


func test_a_constant_wind_is_constant() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	for time: float in [-5.0, 0.0, 0.7, 100.0, 1e7]:
		check_near(_wind.sample(time), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "at %f" % time)


func test_a_gust_happens_once() -> void:
	_wind.kind = PlantWind.KIND_GUST
	_wind.gust_duration = 0.5
	for time: float in [0.0, 0.25, 0.49]:
		check_near(_wind.sample(time), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "at %f" % time)
	for time: float in [-0.1, 0.5, 0.6, 3.0, 1000.0]:
		check_equal(_wind.sample(time), Vector3.ZERO, "at %f" % time)


func test_bursts_fill_the_first_half_of_each_period() -> void:
	_wind.kind = PlantWind.KIND_BURSTS
	for period: float in [0.0, 1.0, 7.0, 1000.0]:
		check_near(_wind.sample(2.0 * period + 0.1), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE)
		check_near(_wind.sample(2.0 * period + 0.9), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE)
		check_equal(_wind.sample(2.0 * period + 1.1), Vector3.ZERO)
		check_equal(_wind.sample(2.0 * period + 1.9), Vector3.ZERO)


func test_waves_swing_about_the_strength_from_none_to_twice() -> void:
	_wind.kind = PlantWind.KIND_WAVES
	for step in 200:
		var time := step * 0.037
		var strength := 8.0 * (1.0 + sin(TAU * 0.5 * time))
		check_near(_wind.sample(time), NORTH_TO_SOUTH * strength, FORCE_TOLERANCE, str(time))


func test_directions_turn_from_plus_z_to_plus_x() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	var ways := {
		0.0: Vector3(0, 0, 8),
		90.0: Vector3(8, 0, 0),
		180.0: Vector3(0, 0, -8),
		270.0: Vector3(-8, 0, 0),
		-90.0: Vector3(-8, 0, 0),
		450.0: Vector3(8, 0, 0),
		45.0: Vector3(1, 0, 1).normalized() * 8.0,
	}
	for degrees: float in ways:
		_wind.direction = deg_to_rad(degrees)
		check_equal(_wind.direction, deg_to_rad(degrees), "direction as it was set")
		check_near(_wind.sample(0.0), ways[degrees], FORCE_TOLERANCE, "%f degrees" % degrees)


func test_a_triggered_gust_adds_to_the_other_kinds() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.gust_duration = 0.5
	_wind.trigger_gust()
	check_near(_wind.sample(0.25), NORTH_TO_SOUTH * 16.0, FORCE_TOLERANCE, "while it blows")
	check_near(_wind.sample(0.75), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "after it")


func test_a_gust_can_be_triggered_again() -> void:
	_wind.kind = PlantWind.KIND_GUST
	_wind.gust_duration = 0.5
	_run(2.0)
	var now := _wind.get_time()
	check_near(now, 2.0, 1e-6, "the clock")
	check_equal(_wind.sample(now), Vector3.ZERO, "the first is over")
	_wind.trigger_gust()
	check_near(_wind.sample(now), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "the second blows")
	check_equal(_wind.sample(now + 0.6), Vector3.ZERO, "and is over")


func test_a_gust_of_its_own_strength_and_length() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.trigger_gust(3.0, 2.0)
	check_near(_wind.sample(1.9), NORTH_TO_SOUTH * 11.0, FORCE_TOLERANCE, "while it blows")
	check_near(_wind.sample(2.1), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "after it")
	_wind.trigger_gust(3.0)
	check_near(_wind.sample(0.4), NORTH_TO_SOUTH * 11.0, FORCE_TOLERANCE, "its strength alone")
	check_near(_wind.sample(0.6), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "as long as the wind's")
	for bad: Array in [[NAN, 1.0], [1e9, 1.0], [1.0, NAN], [1.0, 1e9]]:
		_wind.trigger_gust(bad[0], bad[1])
		check_error("the gust's ")
		check_near(_wind.sample(0.4), NORTH_TO_SOUTH * 11.0, FORCE_TOLERANCE, "as before")


func test_a_gust_of_its_own_length_does_not_outlive_a_change_of_kind() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.gust_duration = 0.5
	_wind.trigger_gust(3.0, 2.0)
	_wind.kind = PlantWind.KIND_GUST
	check_near(_wind.sample(0.4), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE, "while it blows")
	check_equal(_wind.sample(1.0), Vector3.ZERO, "after it")


func test_a_plant_driven_by_hand_feels_only_what_is_left_of_a_gust() -> void:
	_wind.kind = PlantWind.KIND_GUST
	_wind.gust_duration = 0.5
	_run(0.5)
	_wind.trigger_gust(20.0)
	_wind.advance(0.6)
	var before := _plant.get_deflection()
	_run(0.3)
	check(_plant.get_deflection() < before + 0.01, "the gust is over: %f" % _plant.get_deflection())


func test_a_gust_reaches_plants_driven_by_hand_whatever_their_clocks_show() -> void:
	for ahead: float in [0.0, 10.0]:
		for behind: float in [0.0, 3.0]:
			_wind = PlantWind.new()
			_wind.kind = PlantWind.KIND_GUST
			_wind.gust_duration = 0.5
			_wind.advance(ahead)
			_run(behind)
			_plant.reset_motion()
			_run(0.5)
			_wind.trigger_gust(20.0)
			var before := _plant.get_deflection()
			_run(0.5)
			var label := "%f s of the wind, %f s of the plant" % [ahead, behind]
			check(_plant.get_deflection() > before + 0.2, "it bends: " + label)
			_plant.free()
			_plant = null


func test_a_gust_chosen_while_running_starts_now() -> void:
	_wind.kind = PlantWind.KIND_CONSTANT
	_run(3.0)
	_wind.kind = PlantWind.KIND_GUST
	check_near(_wind.sample(_wind.get_time()), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE)


func test_a_change_of_frequency_keeps_the_phase() -> void:
	_wind.kind = PlantWind.KIND_WAVES
	for frequency: float in [1.7, 0.3, 3.0, 0.0, 0.5]:
		_run(1.234)
		var now := _wind.get_time()
		var force := _wind.sample(now)
		_wind.frequency = frequency
		check_near(_wind.sample(now), force, 1e-3, "force at %f Hz" % frequency)


func test_values_out_of_range_give_one_error_and_are_not_kept() -> void:
	var bad := {
		"strength": [-1.0, 1.1e6, INF, -INF, NAN],
		"direction": [INF, -INF, NAN, 1e9],
		"travel_speed": [-1.0, 1e5, INF, NAN],
		"frequency": [-0.1, 1001.0, INF, NAN],
		"gust_duration": [-0.1, 3601.0, INF, NAN],
	}
	for property: String in bad:
		var before: float = _wind.get(property)
		for value: float in bad[property]:
			_wind.set(property, value)
			check_error(property + " cannot be ")
			check_equal(_wind.get(property), before, property)


func test_kinds_that_do_not_exist_give_one_error() -> void:
	var before := _wind.kind
	for value: int in [-1, 5, 1000, 1 << 32]:
		_wind.set("kind", value)
		check_error("kind %d does not exist" % value)
	check_equal(_wind.kind, before)


func test_samples_need_a_finite_time() -> void:
	for time: float in [INF, -INF, NAN]:
		check_equal(_wind.sample(time), Vector3.ZERO)
		check_error("finite time")


func test_samples_are_finite_at_the_limits() -> void:
	_wind.strength = 1e6
	_wind.frequency = 1000.0
	for kind in 5:
		_wind.set("kind", kind)
		for time: float in [0.0, 1e-300, 1e15, -1e15, 1e300]:
			check(_wind.sample(time).is_finite(), "kind %d at %s" % [kind, str(time)])


func test_each_change_is_signalled_once() -> void:
	_wind.changed.connect(func() -> void: _changes += 1)
	var values := {
		"kind": PlantWind.KIND_BURSTS,
		"strength": 3.0,
		"direction": 0.2,
		"frequency": 2.0,
		"gust_duration": 2.0,
		"travel_speed": 3.0,
	}
	for property: String in values:
		_changes = 0
		_wind.set(property, values[property])
		check_equal(_changes, 1, "signals for " + property)


func test_setting_what_is_set_already_signals_nothing() -> void:
	_wind.direction = deg_to_rad(33.3)
	_wind.changed.connect(func() -> void: _changes += 1)
	for property: String in [
		"kind", "strength", "direction", "frequency", "gust_duration", "travel_speed"
	]:
		_wind.set(property, _wind.get(property))
		check_equal(_changes, 0, "signals for " + property)


func test_tenths_of_a_degree_come_back_as_they_were_written() -> void:
	for tenth in 3600:
		var degrees := tenth / 10.0
		_wind.direction = deg_to_rad(degrees)
		check_equal(_wind.direction, deg_to_rad(degrees), "direction of %f degrees" % degrees)
		check_equal(str(snappedf(rad_to_deg(_wind.direction), 1e-9)), str(degrees), "as shown")


func test_a_new_wind_never_comes_to_rest() -> void:
	var wind := PlantWind.new()
	check_equal(wind.kind, PlantWind.KIND_WAVES, "kind")
	check_equal(wind.strength, 5.0, "strength")
	check_equal(wind.frequency, 0.4, "frequency")
	_wind = wind
	_run(60.0)
	var minimum := INF
	var maximum := 0.0
	for i in 300:
		_run(STEP)
		minimum = minf(minimum, _plant.get_deflection())
		maximum = maxf(maximum, _plant.get_deflection())
	check(maximum - minimum > 0.05, "it still sways after a minute, by %f" % (maximum - minimum))


func test_saved_it_loads_equal() -> void:
	_wind.kind = PlantWind.KIND_BURSTS
	_wind.direction = deg_to_rad(33.3)
	_wind.frequency = 2.7
	_wind.gust_duration = 1.25
	check_equal(ResourceSaver.save(_wind, PATH), OK, "saving")
	var loaded: PlantWind = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	for property: String in [
		"kind", "strength", "direction", "travel_speed", "frequency", "gust_duration"
	]:
		check_equal(loaded.get(property), _wind.get(property), property)
	for time: float in [0.0, 0.3, 1.1, 20.0]:
		check_equal(loaded.sample(time), _wind.sample(time), "force at %f" % time)
	DirAccess.remove_absolute(PATH)


func test_a_gust_of_a_loaded_wind_still_happens() -> void:
	_wind.kind = PlantWind.KIND_GUST
	check_equal(ResourceSaver.save(_wind, PATH), OK, "saving")
	var loaded: PlantWind = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	check_near(loaded.sample(0.1), NORTH_TO_SOUTH * 8.0, FORCE_TOLERANCE)
	DirAccess.remove_absolute(PATH)


## Runs the wind on a plant stepped by the test for [param seconds].
func _run(seconds: float) -> void:
	if not _plant:
		_plant = Plant3D.new()
		_plant.species = TulipFunction.new()
		_plant.simulation_enabled = false
		_plant.wind = _wind
		root.add_child(_plant)
	for i in roundi(seconds / STEP):
		_plant.advance(STEP)
