## A species in GDScript with occasional errors.
extends PlantFunction


func _get_base_shape(lod: int) -> PackedVector3Array:
	var points := PackedVector3Array()
	for i in lod if randf() < 0.95 else 0:
		var angle := TAU * i / lod
		points.append(Vector3(-cos(angle), 0.0, sin(angle)) * 0.05)
	return points


func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(0.3, 0.9) if randf() < 0.97 else NAN


func _calculate_curve_point(offset: float) -> float:
	return 1.0 - 0.9 * offset if randf() < 0.999 else NAN


func _calculate_color_at_point(offset: float) -> Color:
	return Color(offset, 0.5, 0.0)
