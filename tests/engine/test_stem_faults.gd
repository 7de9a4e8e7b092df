## Errors of a stem are reported once, and it stays upright.
extends "res://tests/engine/stem_harness.gd"


class Hollow:
	extends PlantFunction
	var width := -1.0

	func _calculate_curve_point(_offset: float) -> float:
		return width


func test_a_missing_joint_is_reported() -> void:
	check_equal(reed.get_joint_position(5), Vector3.ZERO, "no joint")
	check_error("get_joint_position(5) needs a joint from 0, the root, to 4")
	for joint: int in [0, 5]:
		reed.apply_impulse(Vector3(0.001, 0, 0), joint)
		check_error("cannot reach joint %d. Use one from 1 to 4" % joint)
	check_near(reed.get_deflection(), 0.0, 1e-6, "bend")


func test_a_stem_that_buckles_is_reported_once_and_shown_upright() -> void:
	reed.species.resource_name = "Weak reed"
	reed.species.stem.youngs_modulus = 1e6
	await frames(2)
	check_error(
		"'Weak reed': The stem falls under its own weight: give it a larger Young's modulus"
	)
	reed.species.wind_weight = 0.5
	var twin := add_stem(reed.species)
	twin.height = 0.7
	await frames(2)
	reed.apply_impulse(Vector3(0.002, 0, 0))
	swing(reed, 10)
	check(reed.get_tip_position().is_finite(), "it has a tip")
	check(reed.get_deflection() > 0.001, "it swings")
	reed.species.stem.youngs_modulus = 1e11
	await frames(2)
	check_near(reed.get_tip_position().length(), reed.get_plant_height(), 0.1, "it exists")
	reed.species.stem.youngs_modulus = 1e6
	await frames(2)
	check_error("falls under its own weight")


func test_a_species_that_cannot_be_built_is_reported_once() -> void:
	var species := Hollow.new()
	var plant := add_stem(species)
	await frames(2)
	check_error("_calculate_curve_point")
	species.width = 0.1
	species.emit_changed()
	await frames(2)
	plant.apply_impulse(Vector3(0.01, 0, 0))
	swing(plant, 10)
	check(plant.get_deflection() > 1e-5, "it swings then, %f" % plant.get_deflection())


func test_wind_weights_need_one_for_each_joint() -> void:
	reed.species.stem.wind_weights = PackedFloat32Array([1, 1])
	await frames(2)
	check_error("wind weights do not fit: give one of 0 to 1000 for each joint, not all 0, or none")
	reed.species.stem.wind_weights = PackedFloat32Array([1, 1, 1, 1])
	await frames(2)
	check_equal(reed.get_joint_count(), 4, "joints")


func test_an_impossible_frequency_is_reported() -> void:
	reed.species.natural_frequency = 500.0
	await frames(2)
	check_error("natural frequency is out of range: use 0.02 to 100 Hz")
	reed.species.natural_frequency = 1.0
	reed.species.damping_ratio = 3.0
	await frames(2)
	check_error("damping ratio is out of range: use 0 to 1")


func test_a_bad_value_is_refused_once_and_the_old_one_stays() -> void:
	var bad := {
		"joints": [0, 9, -1],
		"modes": [0, 3],
		"youngs_modulus": [-1.0, 5.0, 2e12, NAN, INF],
		"density": [0.0, 3e4, NAN],
		"diameter": [-0.1, 1e-6, 2.0, NAN],
		"taper": [-1.1, 0.95, NAN],
		"head_mass": [-2.0, 101.0, NAN],
		"head_drag_area": [-2.0, 101.0, NAN],
		"leaf_mass": [-2.0, 101.0, INF],
		"leaf_drag_area": [-2.0, 101.0, NAN],
		"wind_weights":
		[PackedFloat32Array([1, -1]), PackedFloat32Array([2000]), PackedFloat32Array([NAN])],
	}
	var stem := PlantStem.new()
	stem.resource_name = "Straw"
	for property: String in bad:
		var before: Variant = stem.get(property)
		for value: Variant in bad[property]:
			stem.set(property, value)
			check_error("PlantStem 'Straw': " + property)
			check_equal(stem.get(property), before, property)


func test_values_are_signalled_only_where_they_change() -> void:
	var stem := PlantStem.new()
	var signals := [0]
	stem.changed.connect(func() -> void: signals[0] += 1)
	for times in 2:
		stem.joints = 5
		stem.taper = 0.3
		stem.wind_weights = PackedFloat32Array([1, 2])
	check_equal(signals[0], 3, "changes")
