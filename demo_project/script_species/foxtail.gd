@tool
class_name FoxtailFunction
extends PlantFunction
## Foxtail grass, a species in one script: a thin stem under a soft, fluffy spike.

const SPIKE_START := 0.55


func _get_base_shape(lod: int) -> PackedVector3Array:
	var ring := PackedVector3Array()
	var points := 2 * maxi(6, lod)
	for i in points:
		var radius := 0.028 if i % 2 == 0 else 0.016  # Every other point is a bristle.
		ring.append(Vector3.LEFT.rotated(Vector3.UP, TAU * i / points) * radius)
	return ring


func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(0.5, 0.9)


func _calculate_curve_point(offset: float) -> float:
	var along_spike := clampf(inverse_lerp(SPIKE_START, 1.0, offset), 0.0, 1.0)
	return 0.12 + 0.88 * sqrt(sin(PI * along_spike))


func _calculate_color_at_point(offset: float) -> Color:
	var along_spike := inverse_lerp(SPIKE_START, 1.0, offset)
	return Color("5d8f2e").lerp(Color("f0dca6"), smoothstep(-0.1, 0.9, along_spike))
