## Water and snow on plants: PlantWind's wetness and snow.
extends "res://tests/engine/plant_harness.gd"

const WHEAT := preload("res://addons/undergrowth/species/wheat.tres")
const REED := preload("res://addons/undergrowth/species/common_reed.tres")
const SAME_TIP := 0.02  # m, between a single plant and one of a field.
const COMING := 300  # Frames in which plants bend to their load.

var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.speed = 0.0


func after_each() -> void:
	super()
	_wind = null


func test_snow_bends_the_plants_of_a_field_until_it_melts() -> void:
	var field := PlantField3D.from_species([WHEAT, REED])
	field.size = Vector2(6, 6)
	field.density = 20.0
	field.wind = _wind
	root.add_child(field)
	await until(func() -> bool: return not field.is_building(), "the field is built")
	await frames(COMING)
	var dry := _mean_height(field)
	_wind.snow = 0.5
	await frames(COMING)
	var laden := _mean_height(field)
	_wind.snow = 0.0
	await frames(2 * COMING)
	check(laden < dry - 0.005, "tips at %.4f m, without snow at %.4f m" % [laden, dry])
	check_near(_mean_height(field), dry, 1e-3, "height of tips after it melted")


func test_a_wet_single_plant_bends_as_that_of_a_field() -> void:
	_wind.wetness = 1.0
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_STEM, PlantFunction.LAW_SPRING]:
		var species := make_species(law)
		species.lean = 0.4
		var single := make_plant(species)
		single.wind = _wind
		root.add_child(single)
		var field := PlantField3D.new()
		field.density = 0.0
		field.wind = _wind
		root.add_child(field)
		await frames(4)
		var id := field.add_plants([Transform3D(Basis.IDENTITY, Vector3(40, 0, 0))], species)[0]
		await frames(COMING)
		var own := single.get_tip_position().y / single.height
		var other := field.get_tip_position(id).y / field.get_plant_height(id)
		check_near(own, other, SAME_TIP, "height of its tip")
		if law == PlantFunction.LAW_STEM:
			check(own < cos(0.4) - 0.003, "it bends below its rest: %.4f" % own)
		else:
			check_near(own, cos(0.4), 1e-3, "other laws have no weight of water")
		single.free()
		field.free()


func test_a_blend_brings_rain_and_snow() -> void:
	var rain: PlantWind = _wind.duplicate()
	rain.wetness = 0.8
	rain.snow = 0.2
	_wind.blend_to(rain, 2.0)
	_wind.advance(1.0)
	check_near(_wind.wetness, 0.4, 1e-6, "wetness after half of it")
	check_near(_wind.snow, 0.1, 1e-6, "snow after half of it")
	_wind.advance(1.5)
	check_equal(_wind.wetness, 0.8, "wetness at its end")
	_wind.wetness = 0.5
	_wind.advance(1.0)
	check_equal(_wind.wetness, 0.5, "wetness that was set")


func test_shares_out_of_range_are_refused() -> void:
	_wind.wetness = 1.5
	check_error("wetness")
	_wind.snow = -0.1
	check_error("snow")
	_wind.rain = -1.0
	check_error("rain")
	check_equal([_wind.wetness, _wind.snow, _wind.rain], [0.0, 0.0, 0.0], "their values")


## Returns the mean height of tips above the ground.
func _mean_height(field: PlantField3D) -> float:
	var sum := 0.0
	var tips := field.get_tip_positions(field.find_plants_in_sphere(Vector3.ZERO, 2.0))
	for tip in tips:
		sum += tip.y
	return sum / maxf(tips.size(), 1.0)
