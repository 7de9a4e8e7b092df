## Stems in winds, in newtons and in air, compared with beams of constant length.
extends "res://tests/engine/stem_harness.gd"

## Fraction of the length, compared with a beam of constant length at any bend.
const ELASTICA_TOLERANCE := 0.012


func test_a_steady_wind_bends_by_its_force() -> void:
	reed.wind = PlantWind.new()
	reed.wind.kind = PlantWind.KIND_CONSTANT
	reed.species.damping_ratio = 0.5
	var weak := _calm_slope(1e-4)
	check(weak > 1e-4, "it bends, %f" % weak)
	for times: float in [2.0, 10.0]:
		check_near(_calm_slope(times * 1e-4) / weak, times, 1e-3 * times, "bend of %.0f" % times)
	reed.species.wind_weight = 0.5
	check_near(_calm_slope(1e-4) / weak, 0.5, 1e-3, "half the weight")
	reed.species.wind_weight = 1.0
	reed.species.mass = 7.0
	check_near(_calm_slope(1e-4) / weak, 1.0, 1e-4, "a mass that does not count")
	reed.species.stem.wind_weights = PackedFloat32Array([0, 0, 0, 1])
	var on_tip := _calm_slope(1e-4)
	reed.species.stem.wind_weights = PackedFloat32Array([1, 0, 0, 0])
	var below := _calm_slope(1e-4)
	check(on_tip > 3.0 * below, "at the tip %f, at the lowest joint %f" % [on_tip, below])


func test_a_stem_in_air_has_the_shape_of_drag() -> void:
	var stem := reed.species.stem
	reed.height = 1.2
	stem.diameter = 0.004
	stem.taper = 0.0
	stem.density = 1.0
	stem.youngs_modulus = 1.5e9
	for property: String in ["head_mass", "head_drag_area", "leaf_mass", "leaf_drag_area"]:
		stem.set(property, 0.0)
	var bending := 1.5e9 * PI * 0.004 ** 4 / 64.0
	var drag := 0.5 * 1.2 * 1.1 * 0.004 * 1.2 ** 3 / bending
	reed.wind = PlantWind.new()
	reed.wind.turbulence = 0.0
	for kind: PlantWind.Kind in [PlantWind.KIND_CONSTANT, PlantWind.KIND_AIR]:
		reed.wind.kind = kind
		for load: float in [6.0, 24.0]:
			reed.wind.strength = load * bending / 1.2 ** 2
			reed.wind.speed = sqrt(load / drag) * log(10.0 / 0.03) / log(1.2 / 0.03)
			reed.reset_motion()
			swing(reed, 600)
			var expected := _elastica_tip(load, kind == PlantWind.KIND_AIR) * 1.2
			var tip := Vector2(reed.get_tip_position().z, reed.get_tip_position().y)
			check_near(tip, expected, ELASTICA_TOLERANCE * 1.2, "load %f" % load)


func test_leaves_with_a_mass_catch_the_wind_as_drawn() -> void:
	var tulip: PlantFunction = load("res://addons/undergrowth/species/poppy.tres").duplicate()
	tulip.law = PlantFunction.LAW_STEM
	tulip.damping_ratio = 0.5
	tulip.stem = PlantStem.new()
	reed.species = tulip
	reed.wind = PlantWind.new()
	reed.wind.kind = PlantWind.KIND_CONSTANT
	await frames(2)
	tulip.stem.leaf_drag_area = 0.0
	var bare := _calm_slope(1e-4)
	tulip.stem.leaf_drag_area = -1.0
	var drawn := _calm_slope(1e-4)
	check(absf(drawn / bare - 1.0) > 0.01, "leaves catch the wind: %f, %f" % [bare, drawn])
	tulip.stem.leaf_mass = 1e-6
	tulip.stem.leaf_drag_area = 0.0
	var light_bare := _calm_slope(1e-4)
	tulip.stem.leaf_drag_area = -1.0
	var tolerance := 0.3 * absf(drawn / bare - 1.0)
	check_near(_calm_slope(1e-4) / light_bare, drawn / bare, tolerance, "so do light ones")


func test_a_new_species_is_a_stem_that_sways_in_a_new_wind_and_in_air() -> void:
	var breeze: PlantWind = load("res://addons/undergrowth/winds/breeze.tres").duplicate()
	for radius: float in [0.05, 0.02, 0.004]:
		var species := CurvePlantFunction.new()
		check_equal(species.law, PlantFunction.LAW_STEM, "law")
		species.radius = radius
		var plant := add_stem(species)
		await frames(1)
		for wind: PlantWind in [PlantWind.new(), breeze]:
			plant.wind = wind
			plant.reset_motion()
			var farthest := 0.0
			for i in 900:
				plant.advance(STEP)
				farthest = maxf(farthest, rad_to_deg(plant.get_deflection()))
			var what := "radius %.3f sways by %.1f degrees" % [radius, farthest]
			check(farthest > 3.0 and farthest < 60.0, what)
		plant.wind = null
		swing(plant, 3000)
		check_near(plant.get_deflection(), 0.0, 1e-3, "it is upright in calm")


func test_a_gale_lodges_a_plant_that_no_bodies_push() -> void:
	reed.wind = PlantWind.new()
	reed.wind.kind = PlantWind.KIND_CONSTANT
	reed.species.damping_ratio = 0.5
	reed.species.recovery_time = 1000.0
	for angle: float in [0.0, 0.2]:
		reed.species.lodging_angle = angle
		var light := _calm_slope(1e-4) / 1e-4
		_calm_slope(0.8 / light)
		reed.wind.strength = 0.0
		swing(reed, 900)
		var left := tan(reed.get_deflection())
		check(
			left > 0.1 if angle > 0.0 else left < 0.01, "%f after a gale, yield %f" % [left, angle]
		)


## Returns tan of the tip's angle in a constant wind of that many newtons.
func _calm_slope(newtons: float) -> float:
	reed.wind.strength = newtons
	reed.reset_motion()
	swing(reed, 900)
	return tan(reed.get_deflection())


## Returns the tip of a uniform stem of length 1 under a wind on the whole stem, with this ratio of
## total force to bending stiffness: across the stem as drag, or as newtons.
func _elastica_tip(load: float, drags: bool) -> Vector2:
	var low := 0.0
	var high := 0.5 * PI
	for i in 50:
		var middle := 0.5 * (low + high)
		if _elastica_root(middle, load, drags).z < 0.0:
			low = middle
		else:
			high = middle
	var found := _elastica_root(low, load, drags)
	return Vector2(found.x, found.y)


## Integrates from the tip down: the offset across and up, and the remaining angle at the root.
func _elastica_root(angle: float, load: float, drags: bool) -> Vector3:
	const PARTS := 400
	var way := Vector3(0, 0, angle)
	var force := Vector2.ZERO
	var moment := 0.0
	for i in PARTS:
		var share := cos(way.z) ** 2 if drags else 1.0
		var press := Vector2(cos(way.z), -sin(way.z)) if drags else Vector2.RIGHT
		force += press * (load * share / PARTS)
		moment += force.dot(Vector2(cos(way.z), -sin(way.z))) / PARTS
		way += Vector3(sin(way.z), cos(way.z), 0.0) / PARTS
		way.z -= moment / PARTS
	return way
