## Base of the engine tests of painted fields: a field of two species, and a map for it.
extends "res://tests/engine/field_harness.gd"

const TULIP := "Tulip"
const GRASS := "Grass"

var map: PlantMap


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 10.0
	map = PlantMap.new()


## Returns all values of a plant, by its id.
func all_plants() -> Dictionary:
	var found := {}
	for id in field.get_plant_ids():
		found[id] = [
			field.get_plant_transform(id),
			field.get_plant_height(id),
			field.get_plant_seed(id),
			field.get_plant_species(id).get_class(),
		]
	return found
