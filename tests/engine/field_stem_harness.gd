## Base of the engine tests of fields of stems: a field of reeds in slow waves, and a camera.
extends "res://tests/engine/field_harness.gd"

const TIP_TOLERANCE := 1e-3
const HEIGHT := 1.2

var _camera: Camera3D


func before_each() -> void:
	field = PlantField3D.new()
	field.species = [PlantFieldSpecies.of(_reed())]
	field.species[0].scale_range = Vector2.ONE
	field.size = Vector2(12, 12)
	field.density = 4.0
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES
	field.wind.strength = 0.02


func after_each() -> void:
	if is_instance_valid(_camera):
		_camera.free()
	for body in get_nodes_in_group(&"walkers"):
		body.free()
	super()


func _reed() -> PlantFunction:
	var species := CurvePlantFunction.new()
	species.height_min = HEIGHT
	species.height_max = HEIGHT
	species.radius = 0.004
	species.wind_weight = 1.0
	species.natural_frequency = 1.0
	species.damping_ratio = 0.1
	species.stem = PlantStem.new()
	species.stem.taper = 0.5
	return species
