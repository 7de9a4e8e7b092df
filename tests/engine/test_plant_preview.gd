## Plants moved by tools in a previewed wind: Plant3D._preview() and PlantWind.advance().
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0

var _plant: Plant3D
var _wind: PlantWind


func before_each() -> void:
	_plant = Plant3D.new()
	_plant.species = TulipFunction.new()
	_plant.simulation_enabled = false
	root.add_child(_plant)
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_CONSTANT
	_wind.strength = 2.0
	_wind.direction = deg_to_rad(90.0)


func after_each() -> void:
	_plant.free()


func test_preview_bends_with_the_given_wind_and_changes_no_property() -> void:
	_preview(120)
	check(_plant.get_tip_position().x > 0.01, "the tip goes where the wind blows to")
	check(_plant.wind == null, "the plant's own wind stays")
	_plant.reset_motion()
	check_equal(_plant.get_deflection(), 0.0, "deflection after reset")


func test_preview_equals_step_under_the_same_wind() -> void:
	_wind.kind = PlantWind.KIND_WAVES
	_preview(90)
	var tip := _plant.get_tip_position()
	var twin := Plant3D.new()
	twin.species = _plant.species
	twin.simulation_enabled = false
	twin.wind = _wind.duplicate()
	root.add_child(twin)
	for i in 90:
		twin.advance(STEP)
	check(twin.get_tip_position().is_equal_approx(tip), "both tips are at %s" % tip)
	twin.free()


func test_the_preview_shows_a_gust() -> void:
	_wind.kind = PlantWind.KIND_GUST
	_preview(60)
	_plant.reset_motion()
	_wind.trigger_gust()
	_preview(10)
	check(_plant.get_deflection() > 1e-3, "the gust moves the plant")


func test_preview_leaves_others_alone() -> void:
	_plant._preview(-1.0, _wind)
	_plant._preview(NAN, _wind)
	_plant._preview(STEP, null)
	check_equal(_plant.get_deflection(), 0.0, "deflection")
	var bare := Plant3D.new()
	bare._preview(STEP, _wind)
	check(bare.get_mesh() == null, "a plant without a function stays without a mesh")
	bare.free()


func test_advance_refuses_impossible_times() -> void:
	_wind.advance(1.5)
	check_equal(_wind.get_time(), 1.5, "time")
	_wind.advance(-1.0)
	check_error("is impossible")
	_wind.advance(INF)
	check_error("is impossible")
	check_equal(_wind.get_time(), 1.5, "time")


func _preview(count: int) -> void:
	for i in count:
		_wind.advance(STEP)
		_plant._preview(STEP, _wind)
