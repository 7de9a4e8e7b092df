## PlantWindSource3D: local movement of the air.
extends "res://tests/engine/air_harness.gd"


func test_an_explosion_bends_plants_away_and_is_over() -> void:
	var near := _add_plant(Vector3(3, 0, 0))
	var far := _add_plant(Vector3(0, 0, -200))
	var field := PlantField3D.new()
	field.density = 0.0
	_add(field)
	var id := field.add_plants([Transform3D(Basis.IDENTITY, Vector3(0, 0, 4))], _species())[0]
	var blast := _add_source(PlantWindSource3D.KIND_EXPLOSION, Vector3(0, 0.5, 0))
	await frames(20)
	check_equal(near.get_deflection(), 0.0, "bend before it")
	blast.explode()
	var maximum := 0.0
	var max_in_field := 0.0
	for i in 60:
		await frames(1)
		maximum = maxf(maximum, near.get_tip_position().x)
		max_in_field = maxf(max_in_field, field.get_tip_position(id).z - 4.0)
	check(maximum > 0.02, "the plant near it bends away: %f m" % maximum)
	check(max_in_field > 0.02, "the field's plant bends away: %f m" % max_in_field)
	check_equal(far.get_deflection(), 0.0, "bend out of reach")
	await frames(900)
	check(near.get_deflection() < 0.002, "it comes to rest: %f" % near.get_deflection())


func test_a_rotor_makes_an_outward_wind_while_it_is_active() -> void:
	var rotor := _add_source(PlantWindSource3D.KIND_FAN, Vector3(0, 5, 0))
	rotor.thrust = 3000.0
	var plants := [_add_plant(Vector3(5, 0, 0)), _add_plant(Vector3(-5, 0, 0))]
	await frames(240)
	var tips: Array[Vector3] = []
	for plant: Plant3D in plants:
		tips.append(plant.get_tip_position())
	check(tips[0].x > 0.02 and tips[1].x < -0.02, "both lean outward: %s" % str(tips))
	rotor.active = false
	await frames(900)
	check((plants[0] as Plant3D).get_deflection() < 0.002, "upright when it is off")


func test_a_rotor_moves_plants_that_follow_prototypes() -> void:
	var field := PlantField3D.new()
	field.density = 0.0
	field.prototypes = 16
	_add(field)
	var places: Array[Transform3D] = []
	for x: float in [5.0, -5.0, 200.0]:
		places.append(Transform3D(Basis.IDENTITY, Vector3(x, 0, 0)))
	var ids := field.add_plants(places, _species())
	var rotor := _add_source(PlantWindSource3D.KIND_FAN, Vector3(0, 5, 0))
	rotor.thrust = 3000.0
	await frames(240)
	var bends: Array[float] = []
	for i in 3:
		bends.append(field.get_tip_position(ids[i]).x - places[i].origin.x)
	check(bends[0] > 0.02 and bends[1] < -0.02, "both lean outward: %s" % str(bends))
	check_near(bends[2], 0.0, 1e-4, "out of reach")
	rotor.active = false
	await frames(900)
	check(absf(field.get_tip_position(ids[0]).x - 5.0) < 0.002, "upright when it is off")


func test_plants_below_a_rotor_keep_moving() -> void:
	var rotor := _add_source(PlantWindSource3D.KIND_FAN, Vector3(0, 5, 0))
	rotor.thrust = 3000.0
	var plant := _add_plant(Vector3.ZERO)
	await frames(240)
	var low := plant.get_tip_position()
	var high := low
	for i in 240:
		await frames(1)
		low = low.min(plant.get_tip_position())
		high = high.max(plant.get_tip_position())
	check(high.x - low.x > 0.02 and high.z - low.z > 0.02, "its tip moves by %s" % (high - low))


func test_the_air_of_a_rotor_presses_stems_down() -> void:
	var rotor := _add_source(PlantWindSource3D.KIND_FAN, Vector3(0, 5, 0))
	rotor.thrust = 200.0
	var grass: PlantFunction = load("res://addons/undergrowth/species/meadow_grass.tres")
	var plants: Array[Plant3D] = []
	for i in 8:
		plants.append(_add_plant(Vector3(0.3, 0, 0).rotated(Vector3.UP, i * TAU / 8.0)))
		plants[-1].species = grass
	await frames(240)
	var lowest := INF
	var sum := 0.0
	for i in 240:
		await frames(1)
		for plant in plants:
			sum += plant.get_tip_position().y / (240.0 * plants.size())
			lowest = minf(lowest, plant.get_tip_position().y)
	check(sum < 0.4, "mean height of the tips of plants of 0.8 m: %.2f" % sum)
	check(lowest > -0.01, "no tip is below the ground: %.3f" % lowest)


func test_a_body_above_the_roots_stirs_tall_plants() -> void:
	var plant := _add_plant(Vector3(0.5, 0, 0))
	var tips: Array[float] = []
	for height: float in [0.0, 0.75, 2.5]:
		var body := _add_source(PlantWindSource3D.KIND_WAKE, Vector3(0, height, -8))
		body.radius = 0.3
		var maximum := 0.0
		for i in 120:
			body.position.z += 0.2
			await frames(1)
			maximum = maxf(maximum, plant.get_tip_position().z)
		body.active = false
		await frames(600)
		tips.append(maximum)
	check_near(tips[1], tips[0], 0.1 * tips[0], "at the height of the plant as at its root")
	check(tips[2] < 0.2 * tips[1], "little high above it: %s" % [tips])


func test_a_body_draws_a_wake_along() -> void:
	var plant := _add_plant(Vector3(1.5, 0, 0))
	var body := _add_source(PlantWindSource3D.KIND_WAKE, Vector3(0, 0.5, -8))
	body.radius = 1.0
	var maximum := 0.0
	for i in 120:
		body.position.z += 0.2
		await frames(1)
		maximum = maxf(maximum, plant.get_tip_position().z)
	check(maximum > 0.01, "the plant leans after it: %f m" % maximum)


func test_a_wake_goes_the_way_of_its_body_in_a_field_that_is_turned_or_scaled() -> void:
	var ids: PackedInt64Array = []
	var fields: Array[PlantField3D] = []
	for axes: Vector2 in [Vector2(0.0, 1.0), Vector2(1.2, 1.0), Vector2(0.0, 4.0)]:
		var field := PlantField3D.new()
		field.density = 0.0
		field.transform = Transform3D(Basis(Vector3.UP, axes.x).scaled(Vector3.ONE * axes.y))
		_add(field)
		await frames(2)
		var at := field.transform.affine_inverse() * Vector3(1.5, 0, 0)
		ids.append(field.add_plants([Transform3D(Basis.IDENTITY, at)], _species())[0])
		fields.append(field)
	var body := _add_source(PlantWindSource3D.KIND_WAKE, Vector3(0, 0.5, -8))
	body.radius = 1.0
	var maximum := 0.0
	for i in 120:
		body.position.z += 0.2
		await frames(1)
		var leans: Array[Vector3] = []
		for k in 3:
			var tip := fields[k].to_global(fields[k].get_tip_position(ids[k]))
			leans.append((tip - Vector3(1.5, 0, 0)).normalized())
		maximum = maxf(maximum, leans[0].z)
		check_near(leans[1], leans[0], 1e-3, "lean in the turned field in frame %d" % i)
		check_near(leans[2], leans[0], 1e-3, "lean in the scaled field in frame %d" % i)
	check(maximum > 0.01, "it leans after the body: %f" % maximum)


func test_forces_continue_where_a_source_reaches() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	wind.strength = 3.0
	var plants := [_add_plant(Vector3(3, 0, 0)), _add_plant(Vector3(3, 0, 90))]
	for plant: Plant3D in plants:
		plant.wind = wind
	var rotor := _add_source(PlantWindSource3D.KIND_FAN, Vector3(3, 2, 0))
	rotor.thrust = 0.0
	await frames(600)
	var near := (plants[0] as Plant3D).get_tip_position()
	check(near.z > 0.02, "it bends: %f m" % near.z)
	check_near(near, (plants[1] as Plant3D).get_tip_position(), 1e-4, "under newtons as air")


func test_bad_values_give_one_error_each() -> void:
	var source := _add_source(PlantWindSource3D.KIND_FAN, Vector3.ZERO)
	var bad := {
		"radius": [0.0, -1.0, INF, NAN],
		"speed": [-1.0, 1000.0, NAN],
		"thrust": [-1.0, 1e9, NAN],
		"duration": [0.0, INF, NAN],
	}
	for property: String in bad:
		var before: float = source.get(property)
		for value: float in bad[property]:
			source.set(property, value)
			check_error(property + " cannot be ")
			check_equal(source.get(property), before, property)
	source.explode()
	check_error("explode() needs KIND_EXPLOSION")
	source.set("kind", 7)
	check_error("kind 7 does not exist")


func test_ten_thousand_sources_out_of_reach_leave_plants_alone() -> void:
	var plant := _add_plant(Vector3.ZERO)
	var crowd := Node3D.new()
	for i in 10000:
		var source := PlantWindSource3D.new()
		source.kind = PlantWindSource3D.KIND_FAN
		source.position = Vector3(1000 + i, 0, 0)
		crowd.add_child(source)
	_add(crowd)
	await frames(5)
	check_equal(plant.get_deflection(), 0.0, "bend")


func _add_plant(place: Vector3) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = _species()
	plant.height = 0.8
	plant.position = place
	_add(plant)
	return plant


func _add_source(kind: PlantWindSource3D.Kind, place: Vector3) -> PlantWindSource3D:
	var source := PlantWindSource3D.new()
	source.kind = kind
	source.position = place
	_add(source)
	return source
