## Properties that change between the snapshot that a build works from and the frame that adopts it.
extends "res://tests/engine/field_stem_harness.gd"

const PROTOTYPE_COUNTS: Array[int] = [0, 16]
const LAWS: Array[int] = [
	PlantFunction.LAW_STEM, PlantFunction.LAW_SPRING, PlantFunction.LAW_ELASTICITY
]
const MIN_MOTION := 1e-4  # m.


func test_the_stem_changes() -> void:
	await _check_each([{"stem:modes": 2}, {"stem:joints": 7}, {"stem:taper": 0.1}])
	await _check_each([{"stem:diameter": 0.006, "stem:youngs_modulus": 2e9}])
	await _check_each([{"stem:head_mass": 0.01}])
	await _check_each([{"stem:wind_weights": PackedFloat32Array([0, 1, 0, 2])}])
	await _check_each([{"species:stem": PlantStem.new()}, {"species:stem": null}])


func test_a_stem_of_two_modes_changes_to_one() -> void:
	var changes: Array[Dictionary] = [{"stem:modes": 1}]
	for law in LAWS:
		changes.append({"species:law": law})
	await _check_each(changes, {"stem:modes": 2})


func test_the_law_changes() -> void:
	for before in LAWS:
		var changes: Array[Dictionary] = []
		for law in LAWS:
			changes.append({"species:law": law, "species:mass": 0.9})
		changes.append({"species:law": PlantFunction.LAW_STEM, "stem:modes": 2})
		await _check_each(changes, {"species:law": before})


func test_the_species_has_another_motion() -> void:
	await _check_each([{"species:lean": 0.4}, {"species:mass": 0.01}])
	await _check_each([{"species:natural_frequency": 3.0}, {"species:damping_ratio": 0.8}])
	await _check_each([{"species:wind_weight": 0.7}, {"species:drag_area": 0.01}])
	await _check_each([{"species:collision_radius": 0.2}, {"species:stays_above_ground": false}])
	await _check_each([{"species:material": StandardMaterial3D.new()}])


func test_the_species_has_another_appearance() -> void:
	var leaves := PlantArrangement.new()
	leaves.part = PlantBlade.new()
	var arrangements: Array[PlantArrangement] = [leaves]
	var others: Array[PlantFieldSpecies] = [PlantFieldSpecies.of(GrassFunction.new())]
	await _check_each([{"species:height_max": 2.0, "species:height_min": 1.5}])
	await _check_each([{"species:radius": 0.01}, {"species:arrangements": arrangements}])
	await _check_each([{"entry:variants": 2}, {"field:species": others}])


func test_the_field_and_its_wind_change() -> void:
	var air := PlantWind.new()
	air.kind = PlantWind.KIND_AIR
	air.speed = 6.0
	var levels: Array[PlantFieldLevel] = [PlantFieldLevel.of(4, 0.0)]
	await _check_each([{"wind:kind": PlantWind.KIND_AIR, "wind:speed": 6.0}, {"field:wind": air}])
	await _check_each([{"field:wind": air, "stem:modes": 2}, {"field:wind": null}])
	await _check_each([{"field:prototypes": 16}, {"field:prototypes": 0}])
	await _check_each([{"field:update_interval": 4}, {"field:max_threads": 1}])
	await _check_each([{"field:contact_enabled": true}, {"field:skeleton_distance": 5.0}])
	await _check_each([{"field:levels": levels}, {"field:tile_size": 5.0}])
	await _check_each([{"field:density": 2.0}])


## Each change of [param changes], values by `OBJECT:PROPERTY`, with prototypes and without, of a
## field that [param before] sets up. It comes in the frame after the field entered the tree, in
## which the field's worker is busy.
func _check_each(changes: Array[Dictionary], before := {}) -> void:
	for change in changes:
		for prototypes in PROTOTYPE_COUNTS:
			after_each()
			before_each()
			field.prototypes = prototypes
			_set_all(before)
			root.add_child(field)
			await frames(1)
			await _check_change(change, "%s, %d prototypes" % [change, prototypes])


func _check_change(change: Dictionary, what: String) -> void:
	check(field.is_building(), what + ": it is being built")
	_set_all(change)
	await settled(field)
	var ids := field.get_plant_ids()
	check(ids.size() > 0, what + ": plants exist")
	var before := all_tips()
	await step(12)
	field.apply_impulse_in_sphere(Vector3.ZERO, 3.0, Vector3(0.002, 0, 0))
	await step(12)
	check(_are_finite(field.get_motion_state(ids)), what + ": states are finite")
	var tips := all_tips()
	var farthest := 0.0
	for i in tips.size():
		farthest = maxf(farthest, before[i].distance_to(tips[i]))
	check(farthest > MIN_MOTION and is_finite(farthest), what + ": plants move by %f m" % farthest)


func _set_all(values: Dictionary) -> void:
	for path: String in values:
		_object(path.get_slice(":", 0)).set(path.get_slice(":", 1), values[path])


func _object(title: String) -> Object:
	match title:
		"entry":
			return field.species[0]
		"species":
			return field.species[0].species
		"stem":
			return field.species[0].species.stem
		"wind":
			return field.wind
	return field


func _are_finite(numbers: PackedFloat32Array) -> bool:
	for number in numbers:
		if not is_finite(number):
			return false
	return not numbers.is_empty()
