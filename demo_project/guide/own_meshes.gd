extends "sheet.gd"
## Own meshes as plants: leaf cards, flat triangles, two materials, and a field of all three.

const Models := preload("models.gd")
const TURN := 1.9  # rad, of the wind.
const SECONDS := 4.0


func _fill(row: HBoxContainer) -> void:
	_add_plant(row, "leaf cards", MeshPlantFunction.of(Models.make_shrub()), 1.0)
	_add_plant(row, "low poly", MeshPlantFunction.of(Models.make_fir()), 1.15)
	_add_plant(row, "two materials", MeshPlantFunction.of(Models.make_toadstool()), 0.36)
	var world := add_cell(row, "a field of all", Vector3(0, 1.5, 4.6), Vector3(0, 0.45, 0), 36.0)
	var models := [Models.make_shrub(), Models.make_fir(), Models.make_toadstool()]
	var species := MeshPlantFunction.of(models)
	species.weights = PackedFloat32Array([2.0, 1.0, 3.0])
	var field := PlantField3D.from_species([species])
	field.species[0].variants = 16
	field.size = Vector2(6, 6)
	field.density = 3.0
	field.seed = 4
	world.add_child(field)


func _add_plant(row: HBoxContainer, title: String, species: PlantFunction, scale: float) -> void:
	var from := Vector3(0.0, 1.0, 2.6) * scale
	var world := add_cell(row, title, from, Vector3(0.0, 0.52, 0.0) * scale, 30.0)
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_AIR
	plant.wind.speed = 9.0
	plant.wind.direction = TURN
	world.add_child(plant)
	plant.advance(SECONDS)
