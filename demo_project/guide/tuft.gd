@tool
extends PlantFunction
## The guide's plant of parts, after a number of steps.

@export_range(1, 3) var steps := 3

var blade := PlantBlade.of({length = Vector2(0.2, 0.35), width = 0.009, bend = 1.3, fold = 0.4})
var culm := PlantAxis.of({length = Vector2(0.45, 0.75), diameter = Vector2(0.002, 0.0008)})
var spikelet := PlantBead.of({length = Vector2(0.006, 0.008), diameter = 0.003})


func _grow(plant: PlantGrowth) -> void:
	plant.scatter(blade, 14, {radius = 0.025, tilt = Vector2(0.05, 0.5)})
	if steps < 2:
		return
	var culms := plant.scatter(culm, 3, {radius = 0.012, tilt = Vector2(0.03, 0.2)})
	plant.along(blade, culms, 2, {from = 0.12, to = 0.5, turn = PI, angle = Vector2(0.4, 0.6)})
	if steps > 2:
		plant.along(spikelet, culms, 60, {from = 0.75, angle = 0.5})
