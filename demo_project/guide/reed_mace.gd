@tool
extends PlantFunction
## The guide's species of four functions: one stem with a thick, brown part.


func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(1.4, 2.0)


func _calculate_curve_point(offset: float) -> float:
	return 0.1 if offset > 0.7 and offset < 0.9 else 0.02


func _calculate_color_at_point(offset: float) -> Color:
	return Color("5a3a22") if offset > 0.7 and offset < 0.9 else Color("6f8f3a")
