## A changed property rebuilds a field tile by tile, nearest first.
extends "res://tests/engine/field_harness.gd"

const TILE := 8.0
const NEAR := Vector3(-52, 0, -52)  # The middle of a tile in a corner.
const FAR := Vector3(52, 0, 52)
const REACH := 3.5  # m: within a tile.
const BLOW := Vector3(0.004, 0.0, 0.001)
const ROUNDING := 1e-4
const DENSITY := 8.0

var _camera: Camera3D


func before_each() -> void:
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.position = NEAR + Vector3.UP
	field = _make_field()


func after_each() -> void:
	super()
	_camera.free()
	await process_frame


## Tests the whole field and a streaming one.
func test_near_tiles_are_rebuilt_before_far_ones() -> void:
	for distance: float in [0.0, 400.0]:
		field.free()
		field = _make_field()
		field.view_distance = distance
		await start()
		for density: float in [2.0 * DENSITY, DENSITY]:
			await _check_near_first(density)


func _check_near_first(density: float) -> void:
	var near := _count(NEAR)
	var far := _count(FAR)
	field.density = density
	var is_seen := false
	await frames(1)
	while field.is_building():
		var has_come := _count(NEAR) != near
		var far_has_come := _count(FAR) != far
		check(has_come or not far_has_come, "the far one waits for the near one")
		is_seen = is_seen or (has_come and not far_has_come)
		await process_frame
	check(is_seen, "the near one is built before the far one")
	check(_count(NEAR) != near and _count(FAR) != far, "both have come")


func test_progress_goes_up_to_the_end() -> void:
	for distance: float in [0.0, 400.0]:
		field.free()
		field = _make_field()
		field.view_distance = distance
		await start()
		var reported: Array[float] = []
		field.build_progressed.connect(func(ratio: float) -> void: reported.append(ratio))
		field.density = 1.2 * DENSITY
		await filled(field)
		check(reported.size() > 5, "%d signals" % reported.size())
		for i in range(1, reported.size()):
			check(reported[i] > reported[i - 1], "%f after %f" % [reported[i], reported[i - 1]])
		check_equal(reported[-1], 1.0, "the last one")


func test_ids_are_unique_while_tiles_of_two_densities_exist() -> void:
	await start()
	field.density = 1.1 * DENSITY
	await frames(1)
	var looks := 0
	while field.is_building():
		if looks % 7 == 0:
			_check_ids()
		looks += 1
		await process_frame
	check(looks > 20, "it takes %d frames" % looks)
	_check_ids()


func _check_ids() -> void:
	var ids := field.get_plant_ids()
	check_equal(ids.size(), field.get_plant_count(), "ids")
	var different := {}
	for id in ids:
		different[id] = true
	check_equal(different.size(), ids.size(), "different ids")
	for place: Vector3 in [NEAR, FAR, Vector3.ZERO]:
		for id in field.find_plants_in_sphere(place, REACH):
			var root_place := field.get_plant_transform(id).origin
			check(root_place.distance_to(place) <= REACH + 0.01, "%d is there" % id)
		check(field.find_nearest_plant(place, 5.0) >= 0, "a plant is there")


func test_remaining_plants_preserve_id_and_motion() -> void:
	field.simulation_enabled = false
	await start()
	field.apply_impulse_in_sphere(Vector3.ZERO, 200.0, BLOW)
	var ids := field.get_plant_ids()
	var before := field.get_motion_state(ids)
	field.clump_size += 0.5
	await frames(1)
	var looks := 0
	while field.is_building():
		if looks % 7 == 0:
			check_near(_max_apart(field.get_motion_state(ids), before), 0.0, ROUNDING, "motion")
		looks += 1
		await process_frame
	check(looks > 20, "it takes %d frames" % looks)
	check_near(_max_apart(field.get_motion_state(ids), before), 0.0, ROUNDING, "motion then")


func test_plants_removed_during_a_rebuild_stay_removed() -> void:
	await start()
	field.density = 1.3 * DENSITY
	await frames(1)
	var cut := 0
	var places: Array[Vector3] = []
	var i := 0
	while field.is_building():
		var place := Vector3(8.0 * (i % 14) - 52.0, 0, 8.0 * (i / 14 % 14) - 52.0)
		cut += field.remove_in_sphere(place, 1.5)
		places.append(place)
		for old in places.slice(-12):
			check_equal(field.find_plants_in_sphere(old, 0.9).size(), 0, "plants at %s" % old)
		i += 1
		await process_frame
	await rested()
	check(cut > 100, "%d are cut" % cut)
	for old in places:
		check_equal(field.find_plants_in_sphere(old, 0.9).size(), 0, "plants at %s then" % old)


func test_a_second_change_restarts_with_all_properties() -> void:
	await start()
	for i in 12:
		field.density = DENSITY * (1.0 + 0.05 * (i % 5))
		if i % 3 == 0:
			field.size = Vector2(120 - 4 * i, 120)
		await frames(1 + i * 2)
	field.clumping = 0.4
	await rested()
	var other := _make_field()
	for property: String in ["density", "size", "clumping"]:
		other.set(property, field.get(property))
	root.add_child(other)
	await filled(other)
	var ids := field.get_plant_ids()
	var other_ids := other.get_plant_ids()
	ids.sort()
	other_ids.sort()
	check_equal(ids, other_ids, "plants")
	check(field.get_plant_transforms(ids) == other.get_plant_transforms(ids), "their places")
	await frames(40)
	check_equal(
		field.get_statistics()["drawn_by_level"],
		other.get_statistics()["drawn_by_level"],
		"what is drawn"
	)
	other.free()


func test_strokes_during_a_rebuild_appear_after_it() -> void:
	field.map = PlantMap.new()
	for entry: PlantFieldSpecies in field.species:
		field.map.paint(Vector3.ZERO, 100.0, entry.get_layer_name(), 1.0)
	await start()
	field.density = 1.4 * DENSITY
	await frames(1)
	var bare: Array[Vector3] = []
	while field.is_building() and bare.size() < 20:
		var place := Vector3(5.0 * bare.size() - 52.0, 0, 4.0 * bare.size() - 50.0)
		field.map.erase(place, 2.0, "", 1.0, 0.0)
		bare.append(place)
		await frames(2)
	await rested()
	for place in bare:
		check_equal(field.find_plants_in_sphere(place, 1.0).size(), 0, "plants at %s" % place)
	check(field.find_plants_in_sphere(Vector3(-30, 0, 40), 3.0).size() > 50, "they exist elsewhere")


func test_added_and_mown_ones_outlive_it() -> void:
	await start()
	var added := field.add_plants([Transform3D(Basis(), NEAR)], field.species[0].species)[0]
	check(field.set_height_in_sphere(FAR, 3.0, 0.2) > 20, "mown")
	var mown := field.find_nearest_plant(FAR, 2.0)
	await frames(10)
	var height := relative_tip(mown).length()
	field.clump_size += 1.0
	await frames(1)
	while field.is_building():
		check(field.has_plant(added), "the added one exists")
		check_near(relative_tip(mown).length(), height, 0.01, "the mown one is low")
		await process_frame
	check(field.has_plant(added) and field.has_plant(mown), "both exist")


func test_a_streaming_field_leaves_nothing_behind_of_sparse_species() -> void:
	field.species[1].weight = 0.004  # Few per tile: elsewhere they would share wide squares.
	field.view_distance = 25.0
	_camera.position = Vector3(-40, 1, 0)
	await start()
	await _streamed()
	_camera.position = Vector3(40, 1, 0)
	await _streamed()
	var drawn: PackedInt32Array = field.get_statistics()["drawn_by_level"]
	var other := _make_field()
	other.species = field.species
	other.view_distance = 25.0
	root.add_child(other)
	await filled(other)
	await frames(20)
	check_equal(drawn, other.get_statistics()["drawn_by_level"], "what is drawn")
	other.free()


func test_leaving_the_tree_during_it() -> void:
	await start()
	for i in 12:
		field.density = DENSITY * (1.0 + 0.05 * (i % 5))
		await frames(2 * i)
		root.remove_child(field)
		await frames(1)
		root.add_child(field)
		field.visible = i % 2 == 0
		await frames(i)
	field.visible = true
	await rested()
	check_near(field.get_plant_count(), field.density * 120.0 * 120.0, 1500.0, "plants")


func _count(place: Vector3) -> int:
	return field.find_plants_in_sphere(place, REACH).size()


func _max_apart(some: PackedFloat32Array, others: PackedFloat32Array) -> float:
	var maximum := 0.0 if some.size() == others.size() else INF
	for i in mini(some.size(), others.size()):
		maximum = maxf(maximum, absf(some[i] - others[i]))
	return maximum


## Waits until all expected tiles are built.
func _streamed() -> void:
	await frames(20)
	while field.is_building() or field.get_statistics()["tiles_waiting"] > 0:
		await process_frame
	await frames(60)


func _make_field() -> PlantField3D:
	var made := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()], [3, 1])
	made.size = Vector2(120, 120)
	made.density = DENSITY
	made.tile_size = TILE
	return made
