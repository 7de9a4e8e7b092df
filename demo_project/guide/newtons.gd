extends "sheet.gd"
## What winds of several strengths do, at their mean.

const FORCES: Array[float] = [0.0, 1.0, 5.0, 20.0]


func _fill(row: HBoxContainer) -> void:
	for force in FORCES:
		var from := Vector3(0.0, 1.1, 3.4)
		var world := add_cell(row, "%d N" % force, from, Vector3(0.0, 0.45, 0.0), 36.0)
		var field := PlantField3D.from_species(
			[GrassFunction.new(), TulipFunction.new()], PackedFloat32Array([60.0, 1.0])
		)
		field.species[0].scale_range = Vector2(0.65, 0.95)
		field.species[1].scale_range = Vector2(0.4, 0.46)
		field.density = 60.0
		field.size = Vector2(5.0, 4.0)
		field.wind = PlantWind.new()
		field.wind.kind = PlantWind.KIND_CONSTANT
		field.wind.strength = force
		field.wind.direction = PI / 2.0
		world.add_child(field)
