## Properties that change between the snapshot that a build works from and the frame that adopts it.
extends "res://tests/engine/field_stem_harness.gd"

const PROTOTYPE_COUNTS: Array[int] = [0, 16]
const LAWS: Array[int] = [
	PlantFunction.LAW_STEM, PlantFunction.LAW_SPRING, PlantFunction.LAW_ELASTICITY
]
const MIN_MOTION := 1e-4  # m.


func test_the_stem_changes() -> void:
	await _check_each(
		{
			"modes": func() -> void: _stem().modes = 3 - _stem().modes,
			"joints": func() -> void: _stem().joints = 7,
			"taper": func() -> void: _stem().taper = 0.1,
			"stiffness":
			func() -> void:
## Properties that change between the snapshot that a build works from and the frame that adopts it.

				_stem().diameter = 0.006
				_stem().youngs_modulus = 2e9,
			"loads": func() -> void: _stem().head_mass = 0.01,
			"wind_weights": func() -> void: _stem().wind_weights = PackedFloat32Array([0, 1, 0, 2]),
			"another stem": func() -> void: _species().stem = PlantStem.new(),
			"no stem": func() -> void: _species().stem = null,
		}
	)


func test_a_stem_of_two_modes_changes_to_one() -> void:
	await _check_each(
		{
			"modes": func() -> void: _stem().modes = 1,
			"law": func() -> void: _species().law = PlantFunction.LAW_SPRING,
		},
		func() -> void: _stem().modes = 2
	)


func test_the_law_changes() -> void:
	for before in LAWS:
		var changes: Dictionary[String, Callable] = {}
		for law in LAWS:
			changes["law %d to %d" % [before, law]] = func() -> void: _species().law = law
		changes["law %d to a stem of two modes" % before] = func() -> void:
			_species().law = PlantFunction.LAW_STEM
			_stem().modes = 2
		await _check_each(changes, func() -> void: _species().law = before)


func test_the_species_moves_otherwise() -> void:
	await _check_each(
		{
			"lean": func() -> void: _species().lean = 0.4,
			"mass": func() -> void: _species().mass = 0.01,
			"natural_frequency": func() -> void: _species().natural_frequency = 3.0,
			"damping_ratio": func() -> void: _species().damping_ratio = 0.8,
			"wind_weight": func() -> void: _species().wind_weight = 0.7,
			"drag_area": func() -> void: _species().drag_area = 0.01,
			"collision_radius": func() -> void: _species().collision_radius = 0.2,
			"stays_above_ground": func() -> void: _species().stays_above_ground = false,
			"material": func() -> void: _species().material = StandardMaterial3D.new(),
		}
	)


func test_the_species_looks_otherwise() -> void:
	await _check_each(
		{
			"height":
			func() -> void:
## Properties that change between the snapshot that a build works from and the frame that adopts it.

				_species().height_max = 2.0
				_species().height_min = 1.5,
			"radius": func() -> void: (_species() as CurvePlantFunction).radius = 0.01,
			"arrangements":
			func() -> void:
## Properties that change between the snapshot that a build works from and the frame that adopts it.

				var leaves := PlantArrangement.new()
				leaves.part = PlantBlade.new()
				_species().arrangements = [leaves],
			"another species":
			func() -> void: field.species = [PlantFieldSpecies.of(GrassFunction.new())],
			"one species more":
			func() -> void: field.species += [PlantFieldSpecies.of(TulipFunction.new())],
			"variants": func() -> void: field.species[0].variants = 2,
		}
	)


func test_the_field_and_its_wind_change() -> void:
	await _check_each(
		{
			"still air": func() -> void: field.wind.strength = 0.0,
			"air": _blow_air,
			"waves and two modes":
			func() -> void:
## Properties that change between the snapshot that a build works from and the frame that adopts it.

				_blow_air()
				_stem().modes = 2,
			"another wind":
			func() -> void:
## Properties that change between the snapshot that a build works from and the frame that adopts it.

				field.wind = PlantWind.new()
				field.wind.strength = 0.02,
			"prototypes": func() -> void: field.prototypes = 16 - field.prototypes,
			"update_interval": func() -> void: field.update_interval = 4,
			"max_threads": func() -> void: field.max_threads = 1,
			"contact_enabled": func() -> void: field.contact_enabled = true,
			"skeleton_distance": func() -> void: field.skeleton_distance = 5.0,
			"levels": func() -> void: field.levels = [PlantFieldLevel.of(4, 0.0)],
			"tile_size": func() -> void: field.tile_size = 5.0,
			"density": func() -> void: field.density = 2.0,
			"removed plants": func() -> void: field.remove_in_sphere(Vector3.ZERO, 2.0),
			"added plants":
			func() -> void: field.add_plants([Transform3D.IDENTITY], ReedFunction.new()),
		}
	)


## Runs each change of [param changes], by its name, with prototypes and without, on a field that
## [param prepare] sets up. The change happens in the frame after the field entered the tree, while
## the field's worker is busy.
func _check_each(changes: Dictionary, prepare := func() -> void: pass) -> void:
	for title: String in changes:
		for prototypes in PROTOTYPE_COUNTS:
			after_each()
			before_each()
			field.prototypes = prototypes
			prepare.call()
			root.add_child(field)
			await frames(1)
			await _check_change(changes[title], "%s, %d prototypes" % [title, prototypes])


func _check_change(change: Callable, what: String) -> void:
	check(field.is_building(), what + ": it is being built")
	change.call()
	await settled(field)
	var ids := field.get_plant_ids()
	check(ids.size() > 0, what + ": plants exist")
	check_equal(field.get_motion_state(ids).is_empty(), false, what + ": states")
	var before := all_tips()
	await step(12)
	field.apply_impulse_in_sphere(Vector3.ZERO, 3.0, Vector3(0.002, 0, 0))
	await step(12)
	check(_are_finite(field.get_motion_state(ids)), what + ": states are finite")
	var tips := all_tips()
	var farthest := 0.0
	for i in mini(tips.size(), before.size()):
		farthest = maxf(farthest, before[i].distance_to(tips[i]))
		if not tips[i].is_finite():
			check(false, what + ": tips are finite")
			return
	check(farthest > MIN_MOTION, what + ": plants move by %f m" % farthest)


func _are_finite(numbers: PackedFloat32Array) -> bool:
	for number in numbers:
		if not is_finite(number):
			return false
	return true


func _blow_air() -> void:
	field.wind.kind = PlantWind.KIND_AIR
	field.wind.speed = 6.0


func _species() -> PlantFunction:
	return field.species[0].species


func _stem() -> PlantStem:
	return _species().stem
