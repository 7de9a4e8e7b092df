## Plants and fields that move through the air.
extends "res://tests/engine/air_harness.gd"

const SPEED := 5.0  # m/s
const HEIGHT := 0.8  # m
const SETTLING := 300  # Frames.
const TOLERANCE := 0.02  # Of the movement of a tip.


func test_a_plant_that_is_carried_leans_as_one_in_wind_of_that_speed() -> void:
	var moved := _add_plant(Vector3(0, 0, 50))
	moved.wind = _even_wind(Vector3(0, HEIGHT, 50))
	var carried := _add_plant(Vector3.ZERO)
	await _carry(carried, SETTLING)
	var expected := moved.get_tip_position()
	check(expected.x > 0.05, "the wind bends it: %s" % expected)
	expected.x = -expected.x
	check_near(carried.get_tip_position(), expected, TOLERANCE * absf(expected.x), "carried")
	carried.position.x += 300.0  # Set to another position: it stops moving.
	await frames(900)
	check(carried.get_deflection() < 0.002, "upright: %f" % carried.get_deflection())


func test_a_field_on_a_ship_leans_as_a_plant_that_is_carried() -> void:
	var ship := Node3D.new()
	_add(ship)
	ship.rotation.y = 0.7
	var field := PlantField3D.new()
	field.density = 0.0
	ship.add_child(field)
	var followers := PlantField3D.new()
	followers.density = 0.0
	followers.prototypes = 4
	ship.add_child(followers)
	await frames(2)
	# The end of a build sets prototypes to rest in the wind, without apparent wind.
	await until(func() -> bool: return not followers.is_building(), "it is built")
	var id := field.add_plants([Transform3D.IDENTITY], _species())[0]
	var other := followers.add_plants([Transform3D.IDENTITY], _species())[0]
	var plant := _add_plant(Vector3.ZERO, ship)
	plant.height = field.get_tip_position(id).length()
	await _carry(ship, SETTLING)
	var expected := ship.basis * _lean(plant.get_tip_position())
	check(expected.x < -0.05, "the plant leans back: %s" % expected)
	var of_field := ship.basis * _lean(field.get_tip_position(id))
	check_near(of_field, expected, TOLERANCE, "direction of the field's plant")
	# Prototypes and their instances differ in height.
	var of_follower := ship.basis * _lean(followers.get_tip_position(other))
	check_near(of_follower, expected, 0.1, "direction of the follower")
	field.apparent_wind = 0.0
	plant.apparent_wind = 0.0
	await _carry(ship, 900)
	check(plant.get_deflection() < 0.002, "the plant is upright without apparent wind")
	check_near(_lean(field.get_tip_position(id)), Vector3.UP, 0.002, "the field without it")


func test_a_field_that_turns_leans_by_the_speed_of_each_place() -> void:
	var field := PlantField3D.new()
	field.density = 0.0
	_add(field)
	await frames(2)
	var places: Array[Transform3D] = []
	for x: float in [0.0, 3.0, 6.0]:
		places.append(Transform3D(Basis.IDENTITY, Vector3(x, 0, 0)))
	for z: float in [3.0, 6.0]:
		places.append(Transform3D(Basis.IDENTITY, Vector3(0, 0, z)))
	var ids := field.add_plants(places, _species())
	for i in SETTLING:
		field.rotation.y += 1.0 / 60.0
		await frames(1)
	var leans: Array[float] = []
	for i in 3:
		leans.append(field.get_tip_position(ids[i]).z - places[i].origin.z)
	check_near(leans[0], 0.0, 1e-3, "in the middle")
	check(leans[1] > 0.002, "farther out it leans back: %s" % str(leans))
	check(leans[2] > 2.0 * leans[1], "the more the farther: %s" % str(leans))
	for i: int in [1, 2]:  # The field turns these a quarter later through the same place.
		var lean := places[i + 2].origin.x - field.get_tip_position(ids[i + 2]).x
		check_near(lean, leans[i], 0.05 * leans[i], "%d m along z" % (3 * i))


func test_what_is_set_down_elsewhere_feels_no_wind() -> void:
	var plant := _add_plant(Vector3.ZERO)
	await frames(3)
	for i in 10:
		plant.position.x += 5.0
		await frames(1)
		check_equal(plant.get_deflection(), 0.0, "bend")


func test_a_plant_that_leaves_a_ship_moves_no_other() -> void:
	var ship := Node3D.new()
	_add(ship)
	var plants: Array[Plant3D] = []
	for x in 4:
		plants.append(_add_plant(Vector3(x, 0, 0), ship))
		plants[x].species = plants[0].species
	await _carry(ship, SETTLING)
	var before := plants[1].get_tip_position()
	check(before.x < -0.05, "it leans back: %s" % before)
	plants[0].free()
	for i in 6:
		await _carry(ship, 1)
		for plant: Plant3D in plants.slice(1):
			check_near(plant.get_tip_position(), before, 0.005, "tip in frame %d" % i)


func test_a_bad_share_gives_one_error() -> void:
	var plant := _add_plant(Vector3.ZERO)
	var field := PlantField3D.new()
	_add(field)
	for node: Node3D in [plant, field]:
		for bad: float in [-0.5, 11.0, NAN]:
			node.set("apparent_wind", bad)
			check_error("apparent_wind cannot be ")
			check_equal(node.get("apparent_wind"), 1.0, "apparent_wind")


## Moves a node along +x for that many frames.
func _carry(node: Node3D, count: int) -> void:
	for i in count:
		node.position.x += SPEED / 60.0
		await frames(1)


func _lean(tip: Vector3) -> Vector3:
	return tip.normalized()


func _add_plant(place: Vector3, to: Node = null) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = _species()
	plant.height = HEIGHT
	plant.position = place
	if to:
		to.add_child(plant)
	else:
		_add(plant)
	return plant


## Without gusts, along +x, with the speed SPEED at one position.
func _even_wind(place: Vector3) -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.direction = PI / 2
	wind.turbulence = 0.0
	wind.gustiness = 0.0
	wind.canopy_wave_amount = 0.0
	wind.speed = 10.0
	wind.speed *= SPEED / wind.sample_velocity(0.0, place).x
	return wind
