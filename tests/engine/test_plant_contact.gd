## Contact between the tips of single plants.
extends "res://tests/engine/plant_harness.gd"

const RADIUS := 0.1  # m.
const APART := 0.4  # m, of the roots.
## m. Contact is solved once per step, and fast tips overlap within one.
const CLEAR := 0.015

const SPRING := PlantFunction.LAW_SPRING
const ELASTIC := PlantFunction.LAW_ELASTICITY

var _has_reported := false


func test_two_tips_in_each_other_part_at_once_along_the_line_through_both() -> void:
	for law: PlantFunction.MotionLaw in [SPRING, ELASTIC]:
		var pair := _add_pair(make_species(law, RADIUS), make_species(law, RADIUS))
		_lean(pair[0], Vector3.RIGHT, 0.15)
		_lean(pair[1], Vector3.LEFT, 0.15)
		var before := _distance(pair)
		check(before < 1.1 * RADIUS, "in each other: %f m" % before)
		while _distance(pair) == before:
			await process_frame
		check_near(_distance(pair), 2.0 * RADIUS, CLEAR, "apart, law %d" % law)
		check_near(tip_of(pair[0]).x + tip_of(pair[1]).x, APART, 1e-3, "both move alike")
		await _check_apart(pair, 1.0)
		_free(pair)


func test_an_impulse_passes_between_species_and_laws_by_contact() -> void:
	for law: PlantFunction.MotionLaw in [SPRING, ELASTIC]:
		for other: PlantFunction.MotionLaw in [SPRING, ELASTIC]:
			var thick := make_species(other, 1.5 * RADIUS)
			thick.mass = 2.0
			var pair := _add_pair(make_species(law, 0.5 * RADIUS), thick)
			pair[0].apply_impulse(Vector3(2.0 * (pair[0].species as PlantFunction).mass, 0, 0))
			await _check_apart(pair, 1.0)
			check(pair[1].get_deflection() > 0.01, "the other swings, laws %d, %d" % [law, other])
			_free(pair)


func test_plants_that_are_moved_scaled_or_turned_touch_in_the_world() -> void:
	var wall := Basis(Vector3.FORWARD, 0.5 * PI)
	var ceiling := Basis(Vector3.RIGHT, PI)
	for basis: Basis in [wall, ceiling, Basis(Vector3.UP, 2.0), Basis(Vector3.RIGHT, 0.3)]:
		for scale: float in [1.0, 2.0]:
			var placed := Transform3D(basis.scaled(Vector3.ONE * scale), Vector3(7, 30, -4))
			var aside := basis * Vector3(APART, 0, 0)
			var species := make_species(SPRING, RADIUS)
			var pair: Array[Plant3D] = [
				_add_touching(species, placed),
				_add_touching(species, Transform3D(placed.basis, placed.origin + aside))
			]
			pair[0].apply_impulse(2.5 * species.mass * aside.normalized())
			await _check_apart(pair, 1.0)
			check(pair[1].get_deflection() > 0.01, "the other swings at %s" % placed)
			_free(pair)


func test_a_plant_on_a_wall_touches_one_on_the_ground_beside_it() -> void:
	var species := make_species(SPRING, RADIUS)
	var wall := Transform3D(Basis(Vector3.FORWARD, -0.5 * PI), Vector3(1.45, 1.1, 0))
	var pair: Array[Plant3D] = [_add_touching(species, Transform3D()), _add_touching(species, wall)]
	check(_distance(pair) > 2.0 * RADIUS and _distance(pair) < 0.4, "close together")
	pair[0].apply_impulse(2.0 * species.mass * Vector3.RIGHT)
	await _check_apart(pair, 1.0)
	check(pair[1].get_deflection() > 0.01, "the other swings: %f" % pair[1].get_deflection())
	check(tip_of(pair[0]).is_finite() and tip_of(pair[1]).is_finite(), "both are somewhere")


func test_two_plants_and_two_of_a_field_hold_each_other_alike() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	wind.strength = 8.0
	wind.direction = 0.5 * PI
	var soft := make_species(SPRING, RADIUS)
	var stiff := make_species(SPRING, RADIUS)
	stiff.natural_frequency = 3.0
	soft.damping_ratio = 1.0
	stiff.damping_ratio = 1.0
	var field := PlantField3D.new()
	field.density = 0.0
	field.contact_enabled = true
	field.wind = wind
	root.add_child(field)
	await field.build_finished
	await process_frame
	var ids := field.add_plants([Transform3D()], soft)
	ids.append_array(field.add_plants([Transform3D(Basis(), Vector3(APART, 0, 0))], stiff))
	var pair: Array[Plant3D] = []
	for i in 2:
		var placed := field.get_plant_transform(ids[i]).translated(Vector3(0, 0, 10))
		pair.append(make_plant([soft, stiff][i], placed, field.get_plant_height(ids[i])))
		pair[i].contact_enabled = true
		pair[i].wind = wind
		root.add_child(pair[i])
	await pass_time(3.0)  # Not forever, because one slips past the other.
	var aside := Vector3(0, 0, 10)
	for i in 2:
		var expected := field.get_tip_position(ids[i]) + aside
		check_near(tip_of(pair[i]), expected, 2e-3, "tip %d" % i)
	check_near(_distance(pair), 2.0 * RADIUS, CLEAR, "they lean on each other")
	pair[0].contact_enabled = false
	await pass_time(3.0)
	check(tip_of(pair[0]).x > tip_of(pair[1]).x, "and not without")


func test_plants_without_contact_or_simulation_touch_nothing() -> void:
	var species := make_species(SPRING, RADIUS)
	for switch: String in ["contact_enabled", "simulation_enabled"]:
		var pair := _add_pair(species, species)
		pair[1].set(switch, false)
		pair[0].apply_impulse(Vector3(2.0 * species.mass, 0, 0))
		var minimum := 1.0
		for i in 60:
			await process_frame
			minimum = minf(minimum, _distance(pair))
		check(minimum < RADIUS, "it goes through where %s is off: %f m" % [switch, minimum])
		check_near(pair[1].get_deflection(), 0.0, 1e-6, "the other is upright")
		pair[1].set(switch, true)
		pair[0].reset_motion()
		pair[1].reset_motion()
		pair[0].apply_impulse(Vector3(2.0 * species.mass, 0, 0))
		await _check_apart(pair, 0.5)
		_free(pair)


func test_a_plant_that_stops_simulating_is_no_longer_touched() -> void:
	var species := make_species(SPRING, RADIUS)
	var pair := _add_pair(species, species)
	await frames(2)
	pair[1].simulation_enabled = false
	pair[0].apply_impulse(Vector3(2.0 * species.mass, 0, 0))
	var nearest := 1.0
	for i in 60:
		await process_frame
		nearest = minf(nearest, _distance(pair))
	check(nearest < RADIUS, "the other passes through it: %f m" % nearest)


func test_plants_of_other_worlds_and_of_fields_are_not_touched() -> void:
	var species := make_species(SPRING, RADIUS)
	var plant := _add_touching(species, Transform3D())
	var viewport := SubViewport.new()
	viewport.world_3d = World3D.new()
	root.add_child(viewport)
	var other := make_plant(species, Transform3D(Basis(), Vector3(APART, 0, 0)))
	other.contact_enabled = true
	viewport.add_child(other)
	var field := PlantField3D.new()
	field.density = 0.0
	field.contact_enabled = true
	root.add_child(field)
	await field.build_finished
	await process_frame
	var id := field.add_plants([Transform3D(Basis(), Vector3(APART, 0, 0))], species)[0]
	var rest := field.get_tip_position(id)
	plant.apply_impulse(Vector3(2.0 * species.mass, 0, 0))
	await pass_time(0.5)
	check_near(other.get_deflection(), 0.0, 1e-6, "the plant of another world")
	check_near(field.get_tip_position(id), rest, 1e-6, "the plant of a field")
	viewport.world_3d = root.find_world_3d()
	check_error('Parameter "scenario" is null')  # The engine's error for any such viewport.
	plant.reset_motion()
	plant.apply_impulse(Vector3(2.0 * species.mass, 0, 0))
	await pass_time(0.5)
	check(other.get_deflection() > 0.01, "it is touched once both are in one world")


func test_plants_added_or_removed_during_contact_count() -> void:
	var species := make_species(SPRING, RADIUS)
	var row: Array[Plant3D] = []
	for i in 6:
		row.append(_add_touching(species, Transform3D(Basis(), Vector3(APART * i, 0, 0))))
	for i in 5:
		row[0].apply_impulse(Vector3(3.0 * species.mass, 0, 0))
		await frames(10)
		var gone: Plant3D = row.pop_at(1)
		gone.free()
		var place := Vector3(APART * (6 + i), 0, 0)
		row.append(_add_touching(make_species(SPRING, RADIUS), Transform3D(Basis(), place)))
		row.back().species.collision_radius = 0.08
	await pass_time(0.3)
	for plant in row:
		check(tip_of(plant).is_finite(), "all goes on")


func test_a_crowd_of_tips_is_reported_once_per_engine() -> void:
	var species := make_species(SPRING, 20.0)
	for i in 200:
		_add_touching(species, Transform3D(Basis(), Vector3(0.3 * i, 0, 0)))
	await pass_time(0.3)
	check_error_count(
		"PlantSimulation: some contacts between plants are skipped", 0 if _has_reported else 1
	)
	_has_reported = true


func test_usual_plants_report_no_crowd() -> void:
	for i in 100:
		_add_touching(TulipFunction.new(), Transform3D(Basis(), Vector3(0.5 * i, 0, 0)))
	await pass_time(0.3)
	check_equal(PlantSimulation.get_plant_count(), 100, "plants")


func _add_touching(species: PlantFunction, placed: Transform3D) -> Plant3D:
	var plant := make_plant(species, placed)
	plant.contact_enabled = true
	root.add_child(plant)
	return plant


func _add_pair(one: PlantFunction, other: PlantFunction) -> Array[Plant3D]:
	var aside := Transform3D(Basis(), Vector3(APART, 0, 0))
	return [_add_touching(one, Transform3D()), _add_touching(other, aside)]


## Bends an upright plant by that many metres at its tip.
func _lean(plant: Plant3D, way: Vector3, metres: float) -> void:
	var direction := (Vector3.UP * 1.2 + way * metres).normalized()
	plant.set_motion_state([direction.x, direction.y, direction.z, 0, 0, 0])


func _distance(pair: Array[Plant3D]) -> float:
	return tip_of(pair[0]).distance_to(tip_of(pair[1]))


## Checks that the distance of the two is the sum of their spheres' radii.
func _check_apart(pair: Array[Plant3D], seconds: float) -> void:
	var sum: float = pair[0].species.collision_radius + pair[1].species.collision_radius
	var minimum := 10.0
	var passed := 0.0
	while passed < seconds:
		await process_frame
		passed += root.get_process_delta_time()
		minimum = minf(minimum, _distance(pair))
	check_near(minimum, sum, 2.0 * CLEAR, "nearest")


func _free(pair: Array[Plant3D]) -> void:
	for plant in pair:
		plant.free()
