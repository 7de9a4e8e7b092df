## Shelter from air: low plants among taller ones, and single plants in a field.
extends "res://tests/engine/harness.gd"

const CLOVER := "res://addons/undergrowth/species/white_clover.tres"
const WHEAT := "res://addons/undergrowth/species/wheat.tres"
const GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
## Degrees by which a single plant may differ from plants of a field around it.
const SAME_LEAN := 1.0
const SINGLES := 16

var _wind: PlantWind


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.speed = 9.0
	_wind.turbulence = 0.0


func after_each() -> void:
	_wind = null


func test_clover_in_wheat_feels_a_tenth_of_the_force_at_most() -> void:
	var open := await _clover_lean(0.0)
	var sheltered := await _clover_lean(90.0)
	check(open > 0.01, "clover leans by %.4f of its height in the open" % open)
	check(sheltered < 0.1 * open, "among wheat by %.4f" % sheltered)


func test_a_single_plant_in_a_field_leans_as_its_neighbours() -> void:
	var species: PlantFunction = load(GRASS)
	var field := _field([species], 40.0)
	await _settled(field)
	var ids: PackedInt64Array = field.find_plants_in_sphere(Vector3.ZERO, 6.0)
	var heights := Array(field.get_plant_heights(ids))
	heights.sort()
	var height: float = heights[heights.size() / 2]
	var singles: Array[Plant3D] = []
	for i in SINGLES:
		singles.append(_single(species, height, i, Vector3(0.3 * i, 0, 0)))
	var lone := _single(species, height, 0, Vector3(500, 0, 0))
	await frames(600)
	var near := _lean(_mean_of(singles))
	var sum := Vector3.ZERO
	var count := 0
	for id in ids:
		var scale := field.get_plant_transform(id).basis.get_scale().y
		var is_alike := absf(field.get_plant_height(id) - height) < 0.05 * height
		if is_alike and absf(scale - 1.0) < 0.05:  # Larger plants are thicker.
			sum += _direction(field.get_motion_state(PackedInt64Array([id])))
			count += 1
	check(count > 50, "%d plants of about its height" % count)
	var mean := _lean(sum)
	var open := _lean(_direction(lone.get_motion_state()))
	check(open > near + 5.0, "a plant in the open leans more: %.2f°" % open)
	var shown := "single %.2f°, %d of the field %.2f°" % [near, count, mean]
	check(absf(near - mean) < SAME_LEAN, shown)
	for single in singles:
		single.free()
	lone.free()
	field.free()


func test_a_scaled_plant_is_sheltered_by_its_height_in_the_world() -> void:
	var wheat := _field([load(WHEAT)], 90.0)
	await _settled(wheat)
	var species: PlantFunction = load(GRASS)
	var deflections: Array[float] = []
	for place: Vector3 in [Vector3.ZERO, Vector3(500, 0, 0)]:
		var single := _single(species, 0.6, 0, place)
		single.scale = Vector3.ONE * 0.25
		deflections.append(await _deflection_of(single))
	check(deflections[1] > 0.01, "in the open it bends by %f" % deflections[1])
	check(deflections[0] < 0.1 * deflections[1], "in wheat by %f" % deflections[0])
	wheat.free()


func test_a_single_plant_above_a_scaled_field_is_in_its_wind() -> void:
	var wheat := _field([load(WHEAT)], 90.0)
	wheat.scale = Vector3.ONE * 0.5
	wheat.size = Vector2(32, 32)
	await _settled(wheat)
	var species: PlantFunction = load(GRASS)
	var open := await _deflection_of(_single(species, 0.8, 0, Vector3(500, 0, 0)))
	var above := await _deflection_of(_single(species, 0.8, 0, Vector3.ZERO))
	var below := await _deflection_of(_single(species, 0.2, 0, Vector3.ZERO))
	check(above > 0.3 * open, "above the wheat it bends by %f, in the open by %f" % [above, open])
	check(below < 0.1 * open, "below the wheat by %f" % below)
	wheat.free()


func test_taller_plants_that_come_shelter_a_single_plant() -> void:
	var clover: PlantFunction = load(CLOVER)
	var field := _field([clover, load(WHEAT)], 40.0)
	field.species[1].weight = 0.0
	await _settled(field)
	var single := _single(clover, 0.2, 0, Vector3.ZERO)
	await frames(400)
	var open := single.get_deflection()
	check(open > 0.01, "among clover it bends by %f" % open)
	field.species[1].weight = 4.0
	field.density = 120.0
	await frames(2)
	await _settled(field)
	await frames(400)
	check(single.get_deflection() < 0.5 * open, "among wheat by %f" % single.get_deflection())
	single.free()
	field.free()


func test_the_air_in_a_field_is_what_plants_feel() -> void:
	var wheat := _field([load(WHEAT)], 90.0)
	wheat.rotation.y = 1.0
	await _settled(wheat)
	await frames(4)
	_wind.direction = 0.0
	await frames(4)
	var open := _wind.sample_velocity(wheat.get_motion_time(), Vector3(0, 0.2, 0))
	var within := wheat.sample_velocity(Vector3.ZERO, 0.2)
	var outside := wheat.sample_velocity(Vector3(300, 0, 0), 0.2)
	check(open.length() > 1.0, "wind of open ground: %s" % open)
	check_near(outside, open, 0.05 * open.length(), "outside of the field")
	check(within.length() < 0.4 * open.length(), "below the wheat: %s of %s" % [within, open])
	check(within.angle_to(open) < 0.02, "in the direction of the wind: %s and %s" % [within, open])
	var rotor := PlantWindSource3D.new()
	rotor.kind = PlantWindSource3D.KIND_FAN
	rotor.thrust = 20000.0
	rotor.position = Vector3(-4, 5, 0)
	root.add_child(rotor)
	await frames(4)
	var stirred := wheat.sample_velocity(Vector3.ZERO, 0.2)
	check(stirred.x > within.x + 5.0, "outward from a rotor: %s" % stirred)
	rotor.free()
	wheat.sample_velocity(Vector3.INF, 1.0)
	check_error("sample_velocity() needs a finite position and a height")
	wheat.sample_velocity(Vector3.ZERO, -1.0)
	check_error("sample_velocity() needs a finite position and a height")
	_wind.kind = PlantWind.KIND_CONSTANT
	wheat.sample_velocity(Vector3.ZERO, 1.0)
	check_error("sample_velocity() needs a wind of KIND_AIR")
	wheat.wind = null
	await frames(4)
	check_equal(wheat.sample_velocity(Vector3.ZERO, 1.0), Vector3.ZERO, "without wind")
	wheat.free()


## Returns how far the wind moves the tips of clover, in heights, with this density of wheat.
func _clover_lean(wheat: float) -> float:
	var clover: PlantFunction = load(CLOVER)
	var field := _field([clover, load(WHEAT)], 20.0 + wheat)
	field.species[0].weight = 20.0
	field.species[1].weight = maxf(wheat, 0.001)
	await _settled(field)
	var ids := PackedInt64Array()
	for id in field.find_plants_in_sphere(Vector3.ZERO, 3.0):
		if field.get_plant_species(id) == clover:
			ids.append(id)
	_wind.speed = 0.0
	await frames(400)
	var calm := field.get_tip_positions(ids)
	_wind.speed = 9.0
	await frames(400)
	var blown := field.get_tip_positions(ids)
	var sum := 0.0
	for i in ids.size():
		var away := blown[i] - calm[i]
		sum += Vector2(away.x, away.z).length() / field.get_plant_height(ids[i])
	field.free()
	check(ids.size() > 20, "%d clover plants" % ids.size())
	return sum / maxi(ids.size(), 1)


func _field(species: Array, density: float) -> PlantField3D:
	var field := PlantField3D.from_species(species)
	field.size = Vector2(16, 16)
	field.density = density
	field.wind = _wind
	field.combed = 0.0
	field.levels = [PlantFieldLevel.of(2)]  # The search for levels takes longer than the motion.
	root.add_child(field)
	return field


func _settled(field: PlantField3D) -> void:
	while field.is_building() or field.get_plant_count() == 0:
		await process_frame


func _single(species: PlantFunction, height: float, number: int, place: Vector3) -> Plant3D:
	var single := Plant3D.new()
	single.species = species
	single.wind = _wind
	single.height = height
	single.seed = number
	single.position = place
	root.add_child(single)
	return single


## Returns the deflection after some seconds of wind, and frees the plant.
func _deflection_of(single: Plant3D) -> float:
	await frames(400)
	var deflection := single.get_deflection()
	single.free()
	return deflection


func _mean_of(singles: Array[Plant3D]) -> Vector3:
	var sum := Vector3.ZERO
	for single in singles:
		sum += _direction(single.get_motion_state())
	return sum


func _direction(state: PackedFloat32Array) -> Vector3:
	return Vector3(state[0], state[1], state[2])


func _lean(direction: Vector3) -> float:
	return rad_to_deg(Vector3.UP.angle_to(direction))
