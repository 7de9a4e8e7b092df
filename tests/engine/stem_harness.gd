## Base of the engine tests of stems: a single reed, and control of its time.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
const PATH := "user://saved_stem.tscn"

## Moves only by calls of the test.
var reed: Plant3D


func before_each() -> void:
	reed = add_stem(make_reed())


func after_each() -> void:
	for child in root.get_children():
		if child is Plant3D:
			child.free()
	DirAccess.remove_absolute(PATH)


func make_reed() -> PlantFunction:
	var species := CurvePlantFunction.new()
	species.height_min = 1.2
	species.height_max = 1.2
	species.radius = 0.004
	species.wind_weight = 1.0
	species.natural_frequency = 1.0
	species.damping_ratio = 0.05
	species.stem = PlantStem.new()
	return species


func add_stem(species: PlantFunction) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	root.add_child(plant)
	return plant


func swing(plant: Plant3D, steps: int) -> void:
	for i in steps:
		plant.advance(STEP)
