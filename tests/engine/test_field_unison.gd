## Plants of a field swing at different frequencies, so that a blow does not ring down in unison.
extends "res://tests/engine/field_harness.gd"

const WHEAT := "res://addons/undergrowth/species/wheat.tres"
const SECONDS := 12.0
const BLOW := 0.0005  # N·s.
## Asked: standard deviation of the frequencies, and the decay of the sum over that of a plant.
const DEVIATION := 0.15
const TIMES_FASTER := 3.0


func test_wheat_after_a_blow_does_not_swing_in_unison() -> void:
	field = _field_of(load(WHEAT))
	await start()
	await rested()
	var tips := await _blow()
	var found := _swings(tips)
	check(found.count > 400, "%d plants" % found.count)
	check(found.deviation > DEVIATION, "deviation of frequencies is %f" % found.deviation)
	check(
		found.sum_decay > TIMES_FASTER * found.decay,
		"the sum decays at %f/s, a plant at %f/s" % [found.sum_decay, found.decay]
	)


func _field_of(species: PlantFunction) -> PlantField3D:
	var made := PlantField3D.from_species([species])
	made.size = Vector2(4, 4)
	made.density = 30.0
	return made


## Blows on all plants and returns their tips relative to their roots, frame by frame.
func _blow() -> Array[PackedFloat32Array]:
	var ids := field.get_plant_ids()
	var calm := field.get_tip_positions(ids)
	field.apply_impulse_in_sphere(Vector3.ZERO, 100.0, Vector3(BLOW, 0, 0))
	var frames_of: Array[PackedFloat32Array] = []
	for i in int(SECONDS / STEP):
		await process_frame
		var now := field.get_tip_positions(ids)
		var ways := PackedFloat32Array()
		for plant in ids.size():
			ways.append(now[plant].x - calm[plant].x)
		frames_of.append(ways)
	return frames_of


func _swings(tips: Array[PackedFloat32Array]) -> Dictionary:
	var count := tips[0].size()
	var frequencies: Array[float] = []
	var decay := 0.0
	for plant in count:
		var way := PackedFloat32Array()
		for frame in tips.size():
			way.append(tips[frame][plant])
		frequencies.append(_frequency(way))
		decay += _decay(way) / count
	var sum := PackedFloat32Array()
	for ways in tips:
		var total := 0.0
		for way in ways:
			total += way
		sum.append(total / count)
	var mean: float = frequencies.reduce(func(a: float, b: float) -> float: return a + b) / count
	var square := 0.0
	for one in frequencies:
		square += (one - mean) * (one - mean) / count
	return {
		"count": count,
		"mean": mean,
		"deviation": sqrt(square) / mean,
		"decay": decay,
		"sum_decay": _decay(sum)
	}


## Returns the frequency from upward crossings of the calm position.
func _frequency(way: PackedFloat32Array) -> float:
	var crossings: Array[float] = []
	for i in range(1, way.size()):
		if way[i - 1] < 0.0 and way[i] >= 0.0:
			crossings.append(i - way[i] / (way[i] - way[i - 1]))
	return (crossings.size() - 1) / ((crossings[-1] - crossings[0]) * STEP)


## Returns the rate (1/s) at which the energy of the first second falls to a tenth.
func _decay(way: PackedFloat32Array) -> float:
	var first := _strength(way, 0.0)
	var at := 0.0
	while at < SECONDS - 1.0 and _strength(way, at) > 0.1 * first:
		at += 0.05
	return log(10.0) / at if at > 0.0 else 0.0


## Returns the mean square over a second.
func _strength(way: PackedFloat32Array, from: float) -> float:
	var sum := 0.0
	var begin := int(from / STEP)
	for i in range(begin, begin + int(1.0 / STEP)):
		sum += way[i] * way[i]
	return sum
