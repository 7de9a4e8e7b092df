## The motion of a plant stepped by the test, compared with closed forms of its laws.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const GRAVITY := 9.81
## Of a frequency or a ratio measured over several swings with steps of 1/60 s.
const MEASURE_TOLERANCE := 0.01
const LENGTH_TOLERANCE := 1e-5

var _plant: Plant3D
var _function: PlantFunction


func before_each() -> void:
	_function = TulipFunction.new()
	_plant = Plant3D.new()
	_plant.species = _function
	_plant.height = 1.5
	_plant.simulation_enabled = false
	root.add_child(_plant)


func after_each() -> void:
	_plant.free()
	_function = null


func test_a_plant_at_rest_stays_at_rest() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		_function.law = law
		_run(2.0)
		check_near(_plant.get_tip_position(), Vector3(0, 1.5, 0), LENGTH_TOLERANCE, "tip")


func test_natural_frequency_and_damping_ratio_are_those_of_the_swing() -> void:
	for rate: int in [30, 60, 144]:
		for frequency: float in [0.7, 1.5]:
			for damping: float in [0.05, 0.2]:
				_function.natural_frequency = frequency
				_function.damping_ratio = damping
				_check_swing(rate, frequency, damping)


func test_frame_rates_give_the_same_motion() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		_function.law = law
		var expected := _tips_at_whole_seconds(60)
		for rate: int in [10, 30, 144, 1000]:
			check_equal(_tips_at_whole_seconds(rate), expected, "tips at %d frames" % rate)


func test_small_swings_of_the_elasticity_law_have_their_frequency() -> void:
	_function.law = PlantFunction.LAW_ELASTICITY
	_function.inner_friction = 0.0
	for elasticity: float in [0.5, 4.0, 20.0]:
		for height: float in [0.4, 2.0]:
			_function.elasticity = elasticity
			_plant.height = height
			var expected := sqrt(elasticity * GRAVITY / height) / TAU
			var label := "e = %f, L = %f" % [elasticity, height]
			check_near(_frequency(60), expected, MEASURE_TOLERANCE * expected, label)


func test_constant_wind_bends_the_elasticity_law_to_its_equilibrium() -> void:
	_function.law = PlantFunction.LAW_ELASTICITY
	_function.wind_weight = 1.0
	_function.inner_friction = 1.0
	_function.mass = 0.5
	_function.elasticity = 6.0
	for degrees: float in [5.0, 15.0, 30.0]:
		var angle := deg_to_rad(degrees)
		_plant.reset_motion()
		_apply_wind(0.5 * GRAVITY * tan(angle) * (7.0 * cos(angle) - 1.0))
		_run(30.0)
		check_near(rad_to_deg(_plant.get_deflection()), degrees, 0.01, "deflection")


func test_constant_wind_bends_the_spring_law_to_its_equilibrium() -> void:
	_function.wind_weight = 0.5
	_function.mass = 0.25
	_function.natural_frequency = 1.0
	_function.damping_ratio = 0.5
	var stiffness := 0.25 * TAU * TAU * 1.5
	for strength: float in [1.0, 10.0, 100.0]:
		_plant.reset_motion()
		_apply_wind(strength)
		_run(20.0)
		check_near(tan(_plant.get_deflection()), 0.5 * strength / stiffness, 1e-4 * strength)


func test_past_the_tipping_angle_the_elasticity_law_stays_down() -> void:
	_function.law = PlantFunction.LAW_ELASTICITY
	_function.elasticity = 1.0
	_function.inner_friction = 2.0
	_lean_to(55.0)
	_run(20.0)
	check(_plant.get_deflection() < 0.01, "from 55 degrees it comes back: acos(1/2) is 60")
	_lean_to(65.0)
	_run(20.0)
	check(_plant.get_deflection() > 1.2, "from 65 degrees it falls")


func test_without_a_ground_the_elasticity_law_hangs() -> void:
	_function.law = PlantFunction.LAW_ELASTICITY
	_function.stays_above_ground = false
	_function.elasticity = -0.5
	_function.inner_friction = 2.0
	_plant.apply_impulse(Vector3(0.1, 0, 0))
	_run(30.0)
	check_near(_plant.get_tip_position(), Vector3(0, -1.5, 0), 0.01, "tip")


func test_the_tip_keeps_its_distance() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		_function.law = law
		_plant.apply_impulse(Vector3(3, -1, 2))
		_apply_wind(5.0)
		for i in 300:
			_plant.advance(STEP)
			check_near(_plant.get_tip_position().length(), 1.5, LENGTH_TOLERANCE, "distance")


func test_the_spring_law_always_returns() -> void:
	_function.damping_ratio = 0.3
	for impulse: float in [1.0, 100.0, 1e6]:
		_plant.apply_impulse(Vector3(impulse, -impulse, 0))
		for i in 60:
			_plant.advance(STEP)
			check(_plant.get_tip_position().y >= 0.0, "above the ground")
		_run(30.0)
		check_near(_plant.get_deflection(), 0.0, 0.01, "deflection after %f N·s" % impulse)


func test_tall_plants_swing_slowly_and_low_ones_fast() -> void:
	_function.law = PlantFunction.LAW_ELASTICITY
	_plant.height = 0.3
	var low := _frequency(60)
	_plant.height = 3.0
	var tall := _frequency(60)
	check_near(low / tall, sqrt(10.0), 0.1, "ratio of frequencies")


func test_an_impulse_sets_the_tips_velocity() -> void:
	_function.mass = 0.5
	_plant.apply_impulse(Vector3(0.05, 0, 0))
	_plant.advance(STEP)
	# v = 0.1 m/s, with a small loss by the spring within the step.
	check_near(_plant.get_tip_position().x, 0.1 * STEP, 0.05 * 0.1 * STEP, "way of one step")


func test_an_impulse_along_the_stem_moves_nothing() -> void:
	_plant.apply_impulse(Vector3(0, -5, 0))
	_run(0.5)
	check_near(_plant.get_deflection(), 0.0, 1e-4, "deflection")


func test_deflection_is_the_angle_from_rest() -> void:
	_plant.apply_impulse(Vector3(0.3, 0, 0.1))
	for i in 60:
		_plant.advance(STEP)
		var angle := Vector3.UP.angle_to(_plant.get_tip_position())
		check_near(_plant.get_deflection(), angle, 1e-4, "deflection")


func test_reset_puts_it_back_to_rest() -> void:
	_apply_wind(5.0)
	var first := _tips_at_whole_seconds(60)
	_plant.reset_motion()
	check_near(_plant.get_tip_position(), Vector3(0, 1.5, 0), LENGTH_TOLERANCE, "tip")
	check_equal(_plant.get_deflection(), 0.0)
	check_equal(_tips_at_whole_seconds(60), first, "the same motion again")


func test_the_bone_turns_from_up_to_the_tip() -> void:
	_plant.apply_impulse(Vector3(0.3, 0, -0.2))
	for i in 60:
		var before := _plant.get_tip_position()
		_plant.advance(STEP)
		# Exactly one step: the drawn pose is the one before the last.
		var turned := _plant.get_skeleton().get_bone_pose_rotation(1) * Vector3.UP
		var nearest := minf(
			turned.angle_to(before.normalized()),
			turned.angle_to(_plant.get_tip_position().normalized())
		)
		check_near(nearest, 0.0, 1e-3, "angle between the bone and the tip")


## Lets the plant swing freely from a small push and compares it with exp(-ζωt)·sin(ωt√(1 - ζ²)).
func _check_swing(rate: int, frequency: float, damping: float) -> void:
	_plant.reset_motion()
	_plant.apply_impulse(Vector3(0.005, 0, 0))
	var omega := TAU * frequency
	var swing := omega * sqrt(1.0 - damping * damping)
	var amplitude := 0.005 / _function.mass / swing
	for i in range(1, 3 * rate):
		_plant.advance(1.0 / rate)
		# The plant has the pose of its last whole step of 1/60 s.
		var time := floorf(i * 60.0 / rate + 1e-3) / 60.0
		var expected := amplitude * exp(-damping * omega * time) * sin(swing * time)
		var label := "%f Hz, damping %f, %d frames, %f s" % [frequency, damping, rate, time]
		check_near(_plant.get_tip_position().x, expected, MEASURE_TOLERANCE * amplitude, label)


## Returns the frequency (Hz) of a small free swing, by the times at which it passes the middle.
func _frequency(rate: int) -> float:
	_plant.reset_motion()
	_plant.apply_impulse(Vector3(0.002, 0, 0))
	var crossings: PackedFloat64Array = []
	var last := 0.0
	for i in 12 * rate:
		_plant.advance(1.0 / rate)
		var place := _plant.get_tip_position().x
		if i > 0 and last * place < 0.0:
			crossings.append((i + last / (last - place)) / rate)
		last = place
	return (crossings.size() - 1) / (2.0 * (crossings[-1] - crossings[0]))


func _tips_at_whole_seconds(rate: int) -> PackedVector3Array:
	_plant.reset_motion()
	_plant.apply_impulse(Vector3(0.2, 0, 0.1))
	var tips := PackedVector3Array()
	for second in 5:
		for i in rate:
			_plant.advance(1.0 / rate)
		tips.append(_plant.get_tip_position())
	return tips


func _run(seconds: float) -> void:
	for i in roundi(seconds / STEP):
		_plant.advance(STEP)


func _apply_wind(strength: float) -> void:
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_CONSTANT
	_plant.wind.strength = strength
	_plant.wind.direction = deg_to_rad(90.0)


## Bends the plant by a steady wind and releases it.
func _lean_to(degrees: float) -> void:
	_plant.reset_motion()
	_function.law = PlantFunction.LAW_SPRING
	var stiffness := _function.mass * pow(TAU * _function.natural_frequency, 2.0) * 1.5
	_function.damping_ratio = 1.0
	_apply_wind(tan(deg_to_rad(degrees)) * stiffness / _function.wind_weight)
	_run(10.0)
	check_near(rad_to_deg(_plant.get_deflection()), degrees, 0.1, "bent")
	_plant.wind = null
	_function.law = PlantFunction.LAW_ELASTICITY
