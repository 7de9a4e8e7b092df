## Ground by method calls, with occasional errors.
extends Node3D


func get_height(place: Vector3) -> Variant:
	if randf() < 0.001:
		return pick_odd()
	return 0.1 * place.x if place.x > -6.0 else NAN


func get_heights(places: PackedVector3Array) -> Variant:
	if randf() < 0.02:
		return pick_odd()
	var heights := PackedFloat32Array()
	for place in places:
		heights.append(0.1 * place.x if place.x > -6.0 else NAN)
	if randf() < 0.02:
		heights.resize(heights.size() / 2)
	return heights


func get_normal(_place: Vector3) -> Variant:
	return pick_odd() if randf() < 0.001 else Vector3(-0.1, 1.0, 0.0)


func pick_odd() -> Variant:
	return [null, INF, "nonsense", Vector3(NAN, 0.0, 0.0), PackedFloat32Array([1e30])].pick_random()
