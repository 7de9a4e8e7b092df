## The wind at a plant: the delay by its position, and the strength in the middle of a step.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
## Metres. A field shows a step up to a few frames late. The remaining difference is less than the
## movement of a tip in a step.
const SAME_TIP := 0.01
const STEPS_LATE := 4.5
const HEIGHT := 1.0
const VARIANTS := 4  # Of an added species.
## Metres, for tips of one metre: the error by the wind's movement between steps.
const LATE_TIP := 2e-3

var _plants: Array[Plant3D] = []


func after_each() -> void:
	for plant in _plants:
		plant.free()
	_plants.clear()


func test_a_plant_and_a_fields_plant_at_one_place_move_as_one() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]:
		var plant := _add(Vector3(7, 0, -3), _species(law), _waves())
		# The order of their starts has no effect after some time.
		plant.species.damping_ratio = 0.7
		plant.species.inner_friction = 1.0
		plant.wind.strength = 3.0
		var field := PlantField3D.new()
		field.density = 0.0
		field.wind = plant.wind
		root.add_child(field)
		var id := field.add_plants([plant.transform], plant.species)[0]
		plant.height = field.get_plant_height(id)
		var times: PackedFloat64Array = []
		var tips := PackedVector3Array()
		var field_tips := PackedVector3Array()
		while plant.wind.get_time() < 8.0:
			await frames(1)
			times.append(plant.wind.get_time())
			tips.append(plant.get_tip_position())
			field_tips.append(field.get_tip_position(id) - plant.position)
		check(_min_apart(times, tips, tips, 1.0) > 5.0 * SAME_TIP, "law %d: it sways" % law)
		check_near(_min_apart(times, tips, field_tips, 0.0), 0.0, SAME_TIP, "law %d: apart" % law)
		field.free()


func test_a_field_that_comes_later_feels_the_air_of_its_wind() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.speed = 6.0
	var species := _species(PlantFunction.LAW_SPRING)
	species.damping_ratio = 0.7
	var fields: Array[PlantField3D] = []
	var ids: PackedInt64Array = []
	for begin: float in [0.0, 3.0]:
		while wind.get_time() < begin:
			await frames(1)
		var field := PlantField3D.new()
		field.density = 0.0
		field.wind = wind
		root.add_child(field)
		fields.append(field)
		ids.append(field.add_plants([Transform3D.IDENTITY], species)[0])
	while wind.get_time() < 6.0:
		await frames(1)
	var times: PackedFloat64Array = []
	var tips: Array[PackedVector3Array] = [PackedVector3Array(), PackedVector3Array()]
	while wind.get_time() < 9.0:
		await frames(1)
		times.append(wind.get_time())
		for i in 2:
			tips[i].append(fields[i].get_tip_position(ids[i]))
	check(_min_apart(times, tips[0], tips[0], 1.0) > 5.0 * SAME_TIP, "they sway")
	check_near(_min_apart(times, tips[0], tips[1], 0.0), 0.0, SAME_TIP, "tips apart")
	for field in fields:
		field.free()


func test_the_wind_of_a_step_is_that_of_its_middle() -> void:
	var wind := _waves()
	wind.frequency = 8.0
	var plant := _add(Vector3(1.5, 0, 0), _species(PlantFunction.LAW_SPRING), wind)
	plant.simulation_enabled = false
	plant.species.damping_ratio = 0.0
	plant.advance(STEP)
	var omega := TAU * plant.species.natural_frequency
	var strength := wind.sample(0.5 * STEP - 1.5 / wind.travel_speed).length()
	var bent := strength * plant.species.wind_weight / (plant.species.mass * omega * omega * HEIGHT)
	var tip := plant.get_tip_position()
	check_near(tip.x / tip.y, bent * (1.0 - cos(omega * STEP)), 1e-6, "bend after one step")


func test_the_wind_reaches_a_downwind_plant_later() -> void:
	var wind := _waves()
	wind.travel_speed = 4.0
	var near := _add(Vector3.ZERO, _species(PlantFunction.LAW_SPRING), wind)
	var far := _add(Vector3(4.0, 0, 0), near.species, wind)
	var aside := _add(Vector3(0, 0, 9.0), near.species, wind)
	for plant in _plants:
		plant.simulation_enabled = false
	var tips := PackedVector3Array()
	for i in 1800:
		for plant in _plants:
			plant.advance(STEP)
		tips.append(near.get_tip_position())
		if i > 900:
			check_near(far.get_tip_position(), tips[i - 60], LATE_TIP, "a second later")
			check_near(aside.get_tip_position(), tips[i], LATE_TIP, "at once across the wind")


func test_a_scaled_field_has_the_winds_way_in_metres_of_the_world() -> void:
	var wind := _waves()
	wind.strength = 3.0
	wind.travel_speed = 4.0
	var species := _species(PlantFunction.LAW_SPRING)
	species.damping_ratio = 0.7
	var field := PlantField3D.new()
	field.density = 0.0
	field.wind = wind
	field.scale = Vector3.ONE * 2.0
	root.add_child(field)
	var places := [Vector3.ZERO, Vector3(2.0, 0, 0)]  # Four metres, and a second, from each other.
	var transforms: Array[Transform3D] = []
	for i in VARIANTS + 1:  # The first and the last are equal.
		transforms.append(Transform3D(Basis.IDENTITY, places[i / VARIANTS]))
	var ids := field.add_plants(transforms, species)
	ids = [ids[0], ids[-1]]
	check_equal(field.get_plant_height(ids[1]), field.get_plant_height(ids[0]), "height")
	var times: PackedFloat64Array = []
	var tips: Array[PackedVector3Array] = [PackedVector3Array(), PackedVector3Array()]
	while wind.get_time() < 8.0:
		await frames(1)
		times.append(wind.get_time())
		for i in 2:
			tips[i].append((field.get_tip_position(ids[i]) - places[i]).normalized())
	check(_min_apart(times, tips[0], tips[1], 0.5) > 5.0 * SAME_TIP, "they sway")
	check_near(_min_apart(times, tips[0], tips[1], 1.0), 0.0, SAME_TIP, "apart a second later")
	field.free()


func test_a_wind_without_a_travel_speed_is_the_same_everywhere() -> void:
	var wind := _waves()
	wind.travel_speed = 0.0
	var near := _add(Vector3.ZERO, _species(PlantFunction.LAW_SPRING), wind)
	var far := _add(Vector3(4.0, 0, 0), near.species, wind)
	for plant in _plants:
		plant.simulation_enabled = false
	for i in 200:
		near.advance(STEP)
		far.advance(STEP)
		check_equal(far.get_tip_position(), near.get_tip_position(), "tip")


func test_a_plant_that_is_carried_feels_the_wind_of_its_new_place() -> void:
	var wind := _waves()
	wind.travel_speed = 4.0
	var carried := _add(Vector3.ZERO, _species(PlantFunction.LAW_SPRING), wind)
	var standing := _add(Vector3(2.0, 0, 0), carried.species, wind)
	await frames(2)
	carried.position = Vector3(2.0, 0, 0)
	carried.set_motion_state(standing.get_motion_state())
	await frames(60)
	check_near(carried.get_tip_position(), standing.get_tip_position(), 1e-6, "tip")


func _waves() -> PlantWind:
	var wind := PlantWind.new()
	wind.strength = 1.0
	wind.frequency = 0.7
	wind.direction = PI / 2.0
	return wind


func _species(law: PlantFunction.MotionLaw) -> PlantFunction:
	var species := TulipFunction.new()
	species.law = law
	return species


func _add(place: Vector3, species: PlantFunction, wind: PlantWind) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.height = HEIGHT
	plant.wind = wind
	plant.position = place
	root.add_child(plant)
	_plants.append(plant)
	return plant


## Returns the maximum distance of a tip, after the decay of the start, from the path of another one
## within a few steps of a time that differs by [param shift] seconds. Frames may be longer than
## that.
func _min_apart(
	times: PackedFloat64Array, some: PackedVector3Array, others: PackedVector3Array, shift: float
) -> float:
	var maximum := 0.0
	for i in times.size():
		if times[i] < 5.0 or times[i] > 7.5 - shift:
			continue
		var minimum := INF
		var begin := times[i] + shift - STEPS_LATE * STEP
		var end := times[i] + shift + STEPS_LATE * STEP
		for k in range(1, times.size()):
			if times[k] > begin and times[k - 1] < end:
				var way := [others[k - 1], others[k]]
				var nearest := Geometry3D.get_closest_point_to_segment(some[i], way[0], way[1])
				minimum = minf(minimum, some[i].distance_to(nearest))
		maximum = maxf(maximum, minimum)
	return maximum
