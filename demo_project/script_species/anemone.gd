@tool
class_name AnemoneFunction
extends PlantFunction
## Wood anemone, a plant of parts in one script: a stem, three leaves about it, and a flower.

var stalk := (
	PlantAxis
	. of(
		{
			length = Vector2(0.14, 0.22),
			diameter = Vector2(0.003, 0.0018),
			bend = deg_to_rad(14.0),
			base_color = Color("7d5a46"),
			tip_color = Color("8ea860"),
		}
	)
)
var leaf := (
	PlantBlade
	. of(
		{
			length = Vector2(0.05, 0.065),
			width = 0.026,
			profile = PlantBlade.PROFILE_OBOVATE,
			teeth = 5,
			bend = deg_to_rad(50.0),
			fold = deg_to_rad(15.0),
			base_color = Color("4d7030"),
			tip_color = Color("84a24a"),
		}
	)
)
var petal := (
	PlantBlade
	. of(
		{
			length = 0.021,
			width = 0.011,
			profile = PlantBlade.PROFILE_ELLIPTIC,
			bend = deg_to_rad(-25.0),
			base_color = Color("dfe6c8"),
			tip_color = Color("fbf8f6"),
		}
	)
)
var anther := PlantBead.of({length = 0.002, diameter = 0.0012, tip_color = Color("e9c94a")})


func _grow(plant: PlantGrowth) -> void:
	var stems := plant.scatter(stalk, plant.rng.randi_range(3, 5), {radius = 0.05, tilt = 0.2})
	plant.along(leaf, stems, 9, {from = 0.7, to = 0.7, per_node = 9, angle = 1.1})
	plant.whorl(petal, stems, 6, {radius = 0.002, angle = 1.35})
	plant.disc(anther, stems, 30, {radius = 0.0035, dome = 1.3})
