## The lean of ready species in winds in metres per second.
extends "res://tests/engine/harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
const STEP := 1.0 / 60.0
## Wind at the tip (m/s) that bends each to 30 and to 60 degrees: typical values for plants of this
## build.
const SPEEDS: Dictionary[String, Vector2] = {
	"meadow_grass": Vector2(3.6, 8.2),
	"lawn_grass": Vector2(3.9, 8.9),
	"common_reed": Vector2(4.1, 9.2),
	"cattail": Vector2(10.7, 24.0),
	"garden_tulip": Vector2(10.3, 23.0),
	"bellflower": Vector2(4.8, 11.0),
	"wheat": Vector2(6.6, 15.0),
	"poppy": Vector2(3.3, 7.5),
	"oxeye_daisy": Vector2(6.0, 14.0),
	"male_fern": Vector2(2.9, 6.6),
}
const SPEED_TOLERANCE := 0.15
const ROUGHNESS := 0.001
const HIGH := 10.0

var _plant: Plant3D


func after_each() -> void:
	_plant.free()


func test_ready_species_lean_in_the_winds_of_their_structure() -> void:
	_plant = Plant3D.new()
	_plant.simulation_enabled = false
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_AIR
	_plant.wind.turbulence = 0.0
	_plant.wind.roughness = ROUGHNESS
	root.add_child(_plant)
	for species: String in SPEEDS:
		_plant.species = load(FOLDER + species + ".tres").duplicate()
		_plant.species.lean = 0.0
		_plant.species.damping_ratio = 0.5
		_plant.species.frequency_deviation = 0.0
		_plant.height = _plant.species.frequency_height
		await frames(1)
		for angle: float in [30.0, 60.0]:
			var speed := SPEEDS[species].x if angle == 30.0 else SPEEDS[species].y
			var needed := _speed_for(deg_to_rad(angle), speed)
			check_near(
				needed / speed,
				1.0,
				SPEED_TOLERANCE,
				"speed for %.0f degrees, %s" % [angle, species]
			)


## Returns the wind at the tip (m/s) that gives this angle from upright, from poses in a wind of
## [param speed].
func _speed_for(angle: float, speed: float) -> float:
	var height := _plant.get_plant_height()
	_plant.wind.speed = speed * log(HIGH / ROUGHNESS) / log(height / ROUGHNESS)
	_plant.reset_motion()
	for i in 600:
		_plant.advance(STEP)
	var state := _plant.get_motion_state()
	var seen := atan2(Vector2(state[0], state[2]).length(), state[1])
	return speed * sqrt(_slope_of(angle) / _slope_of(seen))


## For a stem with this angle of the tip at rest in air: the angle if it were proportional to the
## force.
func _slope_of(angle: float) -> float:
	return sin(angle) / cos(angle) ** 2
