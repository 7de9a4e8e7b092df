## A species of parts in GDScript with occasional errors.
extends PlantFunction

var _blade := PlantBlade.new()
var _axis := PlantAxis.new()
var _bead := PlantBead.new()


func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(0.2, 1.1)


func _grow(plant: PlantGrowth) -> void:
	var stem := plant.add_stem() if randf() < 0.9 else plant.ground
	var branches := plant.along(_axis, stem, randi_range(1, 3))
	plant.whorl(_blade, branches, 3, {"angle": Vector2(randf_range(-4.0, 4.0), 1.0)})
	if randf() < 0.02:
		plant.add(_blade, stem, {"nonsense": 1})
	plant.disc(_bead, stem if randf() < 0.97 else PackedInt32Array([-1, 1 << 30]), 5)
	plant.scatter(_blade, randi_range(1, 4))
