@tool
class_name FoxtailFunction
extends PlantFunction
## Foxtail grass, a species in one script: leaves, thin culms, and a soft spike on each.

var leaf := PlantBlade.of({length = Vector2(0.2, 0.36), width = 0.01, bend = 1.1, fold = 0.4})
var culm := PlantAxis.of({length = Vector2(0.4, 0.65), diameter = 0.002, bend = 0.4})
var spike := PlantBead.of({length = Vector2(0.06, 0.09), diameter = 0.009})
var bristle := PlantBlade.of({length = Vector2(0.012, 0.02), width = 0.0012})


func _init() -> void:
	leaf.base_color = Color("3f5c1e")
	leaf.tip_color = Color("93ab52")
	culm.tip_color = Color("a8b06a")
	spike.base_color = Color("76893f")
	spike.tip_color = Color("c2b684")
	bristle.base_color = spike.base_color
	bristle.tip_color = Color("efe0b6")


func _grow(plant: PlantGrowth) -> void:
	plant.scatter(leaf, 20, {radius = 0.025, tilt = Vector2(0.1, 0.5), swept = 0.4})
	var culms := plant.scatter(culm, 5, {radius = 0.015, tilt = Vector2(0.05, 0.25)})
	plant.along(leaf, culms, 1, {from = 0.3, to = 0.3, angle = 0.5, scale = 0.6})
	var spikes := plant.add(spike, culms)
	plant.along(bristle, spikes, 40, {from = 0.05, angle = Vector2(0.8, 0.3)})
