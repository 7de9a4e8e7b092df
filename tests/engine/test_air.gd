## PlantWind.KIND_AIR: a wind in metres per second, for scripts, single plants and fields.
extends "res://tests/engine/air_harness.gd"

const WINDS := "res://addons/undergrowth/winds/"
## Beaufort numbers of the shipped winds.
const PRESETS := {"calm": 0, "light_air": 1, "breeze": 3, "fresh": 5, "gale": 8, "storm": 10}
const STEP := 1.0 / 60.0
const DENSITY := 1.225
const ROUGHNESS := 0.03
## Of the tangent of a bend.
const BEND_TOLERANCE := 2e-3
## Metres per second.
const VELOCITY_TOLERANCE := 1e-3

var _wind: PlantWind
var _changes := 0


func before_each() -> void:
	_changes = 0
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.speed = 8.0


func after_each() -> void:
	super()
	_wind = null


func test_smooth_air_follows_the_logarithmic_law() -> void:
	_wind.turbulence = 0.0
	_wind.direction = deg_to_rad(90.0)
	for height: float in [0.3, 1.0, 2.0, 10.0, 25.0]:
		var expected := 8.0 * log(height / ROUGHNESS) / log(10.0 / ROUGHNESS)
		var velocity := _wind.sample_velocity(3.0, Vector3(5, height, -7))
		check_near(velocity, Vector3(expected, 0, 0), VELOCITY_TOLERANCE, "at %f m" % height)
	var force := _wind.sample(3.0)
	var speed := _wind.sample_velocity(3.0, Vector3(0, 1, 0)).length()
	check_near(force, Vector3(0.5 * DENSITY * speed * speed, 0, 0), 1e-3, "force on a square metre")


func test_turbulent_air_differs_from_place_to_place_and_is_carried_along() -> void:
	_wind.gustiness = 0.0
	var carried := 8.0 * log(1.0 / ROUGHNESS) / log(10.0 / ROUGHNESS)
	var here := _wind.sample_velocity(20.0, Vector3(0, 1, 0))
	check(here.distance_to(_wind.sample_velocity(20.0, Vector3(9, 1, 4))) > 0.1, "another place")
	var mean := 0.0
	for i in 2000:
		mean += _wind.sample_velocity(3.7 * i, Vector3(0, 1, 0)).z / 2000.0
	check_near(mean, carried, 0.1, "mean speed a metre above the ground")
	# The drift across the wind is much smaller than half a metre.
	var later := _wind.sample_velocity(20.0 + 0.5 / carried, Vector3(0, 1, 0.5))
	check(later.distance_to(here) < 0.35 * carried * 0.25, "the same gust, half a metre downwind")


func test_a_plant_alone_bends_by_the_drag_of_its_tip() -> void:
	_wind.turbulence = 0.0
	var plant := _add_plant()
	for area: float in [-1.0, 0.004]:
		plant.species.drag_area = area
		for i in 1200:
			plant.advance(STEP)
		var speed := _wind.sample_velocity(0.0, Vector3(0, 0.8, 0)).length()
		var force := 0.5 * DENSITY * speed * speed * (0.02 if area < 0.0 else area)
		var tip := plant.get_tip_position()
		check_near(tip.z / tip.y, force / _stiffness(), BEND_TOLERANCE, "drag area %f" % area)


func test_plants_that_lie_are_blown_the_same_way() -> void:
	_wind.turbulence = 0.0
	var upright := _add_plant()
	for turn: Vector3 in [Vector3(0, 0, -PI / 2.0), Vector3(0, 0, PI / 2.0), Vector3(PI, 0, 0)]:
		var lying := _add_plant()
		lying.rotation = turn
		await frames(1)
		for i in 1200:
			lying.advance(STEP)
			upright.advance(STEP)
		var tip := lying.global_basis * lying.get_tip_position()
		var along := tip.dot(lying.global_basis.y)
		var expected := upright.get_tip_position().z / upright.get_tip_position().y
		check_near(tip.z / along, expected, BEND_TOLERANCE, "bend with the root turned %s" % turn)


func test_a_fields_plants_shelter_each_other() -> void:
	_wind.turbulence = 0.0
	var field := PlantField3D.new()
	field.density = 0.0
	field.wind = _wind
	_add(field)
	var id := field.add_plants([Transform3D.IDENTITY], _species())[0]
	await frames(400)
	var height := field.get_plant_height(id)
	var top := 8.0 * log(3.0) / log((10.0 - 0.7 * height) / (0.1 * height))
	var tip := field.get_tip_position(id)
	var force := 0.5 * DENSITY * top * top * 0.02
	var stiff := _stiffness() / 0.8 * height
	check_near(tip.z / tip.y, force / stiff, 4.0 * BEND_TOLERANCE, "bend in a canopy")


func test_a_field_away_from_the_origin_has_the_gusts_of_its_place() -> void:
	var at := Vector3(40, 0, 70)
	var field := PlantField3D.new()
	field.density = 0.0
	field.wind = _wind
	field.transform = Transform3D(Basis(Vector3.UP, 0.7), at)
	_add(field)
	await frames(2)
	var species := _species()
	var id := field.add_plants([Transform3D.IDENTITY], species)[0]
	var plant := Plant3D.new()
	plant.species = species
	plant.height = field.get_plant_height(id)
	plant.wind = _wind
	plant.position = at
	_add(plant)
	await frames(400)
	var strongest := 0.0
	for i in 100:
		await frames(1)
		var tip := field.to_global(field.get_tip_position(id)) - at
		check_near(tip, plant.get_tip_position(), 0.02 * plant.height, "tip in frame %d" % i)
		strongest = maxf(strongest, Vector2(tip.x, tip.z).length())
	check(strongest > 0.05 * plant.height, "it bends by %f m" % strongest)


func test_fields_and_plants_rest_in_still_air() -> void:
	_wind.speed = 0.0
	check_equal(_wind.sample_velocity(7.0, Vector3(1, 2, 3)), Vector3.ZERO, "still")
	var plant := _add_plant()
	plant.advance(1.0)
	check_equal(plant.get_deflection(), 0.0, "bend")


func test_a_change_during_a_gust_makes_no_jump() -> void:
	_wind.advance(50.0)
	var now := _wind.get_time()
	var before := _deviate(now)
	for change: Array in [
		["speed", 3.0],
		["direction", 2.0],
		["roughness", 0.1],
		["turbulence", 0.3],
		["canopy_height", 2.0]
	]:
		_wind.set(change[0], change[1])
		check_near(_deviate(now), before, 2e-3, "deviation after another " + change[0])


func test_blending_ends_at_the_other_wind() -> void:
	var gale: PlantWind = load(WINDS + "gale.tres")
	_wind.direction = deg_to_rad(350.0)
	_wind.changed.connect(func() -> void: _changes += 1)
	_wind.blend_to(gale, 4.0)
	_wind.advance(2.0)
	check_near(_wind.speed, 0.5 * (8.0 + gale.speed), 1e-5, "speed half way")
	check_near(_wind.direction, deg_to_rad(355.0), 1e-5, "the shorter way around")
	check_equal(_changes, 0, "signals on the way")
	_wind.advance(2.0)
	check_near(_wind.speed, gale.speed, 1e-6, "speed at the end")
	check_equal(_changes, 1, "signals at the end")
	_wind.blend_to(gale, 0.0)
	check_equal(_changes, 2, "at once")
	_wind.blend_to(PlantWind.new(), 1.0)
	check_error("blend_to() needs KIND_AIR in both winds")
	_wind.blend_to(null, 1.0)
	check_error("blend_to() needs KIND_AIR in both winds")
	_wind.blend_to(gale, NAN)
	check_error("the blend's seconds cannot be ")
	check_near(_wind.speed, gale.speed, 1e-6, "as before")


func test_what_is_set_by_hand_ends_a_blend() -> void:
	_wind.blend_to(load(WINDS + "storm.tres"), 4.0)
	_wind.advance(1.0)
	_wind.speed = 2.0
	_wind.advance(9.0)
	check_equal(_wind.speed, 2.0, "speed")


func test_shipped_winds_match_their_names() -> void:
	var files := Array(DirAccess.get_files_at(WINDS)).filter(
		func(file: String) -> bool: return file.ends_with(".tres")
	)
	check_equal(files.size(), PRESETS.size(), "winds")
	for preset: String in PRESETS:
		var wind: PlantWind = load(WINDS + preset + ".tres")
		check_equal(wind.kind, PlantWind.KIND_AIR, preset)
		check_equal(wind.get_beaufort(), PRESETS[preset], "Beaufort's number of " + preset)


func test_values_out_of_range_give_one_error_and_the_last_good_wind_stays() -> void:
	var before := _wind.sample_velocity(3.0, Vector3(0, 1, 0))
	var bad := {
		"speed": [-1.0, 101.0, INF, NAN],
		"turbulence": [-1.5, 3.0, INF, NAN],
		"gustiness": [-0.1, 0.5, INF, NAN],
		"roughness": [-0.03, 0.0, 1.0, INF, NAN],
		"canopy_height": [-1.0, 10.0, INF, NAN],
		"canopy_wave_amount": [-0.1, 1.1, INF, NAN],
	}
	for property: String in bad:
		var was: float = _wind.get(property)
		for value: float in bad[property]:
			_wind.set(property, value)
			check_error(property + " cannot be ")
			check_equal(_wind.get(property), was, property)
	check_equal(_wind.sample_velocity(3.0, Vector3(0, 1, 0)), before, "as before")
	for place: Vector3 in [Vector3(NAN, 0, 0), Vector3(0, INF, 0)]:
		check_equal(_wind.sample_velocity(1.0, place), Vector3.ZERO)
		check_error("sample_velocity() needs a finite time")


func test_a_wind_in_newtons_reports_once_that_it_has_no_velocity() -> void:
	_wind.kind = PlantWind.KIND_WAVES
	for i in 5:
		check_equal(_wind.sample_velocity(0.1 * i, Vector3.ZERO), Vector3.ZERO)
	check_error("sample_velocity() needs KIND_AIR")


func test_a_gust_that_is_called_for_is_in_metres_per_second() -> void:
	_wind.turbulence = 0.0
	var plant := _add_plant()
	for i in 1200:
		plant.advance(STEP)
	var before := plant.get_deflection()
	_wind.trigger_gust(6.0, 1.0)
	for i in 20:
		plant.advance(STEP)
	check(plant.get_deflection() > before + 0.05, "it bends more")


# Returns the deviation of the air from its mean, in standard deviations along and across the wind.
func _deviate(time: float) -> Vector2:
	var velocity := _wind.sample_velocity(time, Vector3(0, 10, 0))
	var along := Vector3(sin(_wind.direction), 0, cos(_wind.direction))
	var across := Vector3(along.z, 0, -along.x)
	var usual := 2.185 * 0.4 / log(10.0 / _wind.roughness)
	var deviation := _wind.speed * (usual if _wind.turbulence < 0.0 else _wind.turbulence)
	return Vector2(velocity.dot(along) - _wind.speed, velocity.dot(across) / 0.75) / deviation


func _stiffness() -> float:
	return 0.01 * (TAU * 1.5) ** 2 * 0.8


func _add_plant() -> Plant3D:
	var plant := Plant3D.new()
	plant.species = _species()
	plant.height = 0.8
	plant.wind = _wind
	plant.simulation_enabled = false
	_add(plant)
	return plant
