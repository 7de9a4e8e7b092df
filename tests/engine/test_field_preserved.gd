## Removed, added and mown plants of a field persist: they are saved and restored.
extends "res://tests/engine/field_harness.gd"

const REACH := 3.0


func before_each() -> void:
	field = _make_field()


func test_removed_plants_stay_removed_after_a_rebuild() -> void:
	await start()
	var count := field.get_plant_count()
	var cut := field.remove_in_sphere(field.global_position, REACH)
	check(cut > 100, "%d are cut" % cut)
	field.rebuild()
	await filled(field)
	check_equal(field.get_plant_count(), count - cut, "plants")
	field.slope_limits = Vector2(0.0, 1.0)
	await rested()
	check_equal(_count_near(), 0, "plants there after a change of the ground")
	field.density = 23.0
	await rested()
	check_equal(_count_near(REACH - 0.5), 0, "plants there at another density")
	check(field.get_plant_count() > count, "%d plants" % field.get_plant_count())


func test_plants_removed_during_a_build_stay_removed() -> void:
	await start()
	field.rebuild()
	var cut := field.remove_in_sphere(field.global_position, REACH)
	await filled(field)
	check_equal(_count_near(), 0, "plants there, %d are cut" % cut)
	field.rebuild()
	await filled(field)
	check_equal(_count_near(), 0, "plants there then")


func test_the_nearest_plant_and_its_species_are_found() -> void:
	field.scale = Vector3.ONE * 2.0
	await start()
	var point := field.to_global(Vector3(1.0, 0.0, 2.0))
	var best := INF
	var wanted := -1
	for id in field.get_plant_ids():
		var away := field.to_global(field.get_plant_transform(id).origin).distance_to(point)
		if away < best:
			best = away
			wanted = id
	check_equal(field.find_nearest_plant(point, 2.0), wanted, "nearest")
	check_equal(field.find_nearest_plant(point, best * 0.9), -1, "within less")
	check_equal(field.find_nearest_plant(point, INF), wanted, "however far")
	check_equal(field.get_species_at(point), field.get_plant_species(wanted), "species")
	check(field.get_species_at(Vector3(500, 0, 0)) == null, "no plant is there")
	field.find_nearest_plant(Vector3(NAN, 0, 0), 1.0)
	check_error("find_nearest_plant() needs a finite point")


func test_mown_plants_are_shortened_and_grow_back() -> void:
	await start()
	var ids := field.find_plants_in_sphere(field.global_position, REACH)
	var whole := field.get_plant_heights(ids)
	var mown := field.set_height_in_sphere(field.global_position, REACH, 0.1)
	check_equal(mown, ids.size(), "mown")
	await step(3)
	for i in ids.size():
		check_near(field.get_plant_height(ids[i]), 0.1, 0.001, "height")
		if i % 20 == 0:
			check_near(relative_tip(ids[i]).length(), 0.1, 0.002, "from root to tip")
	check_equal(field.set_height_in_sphere(field.global_position, REACH, 0.1), 0, "mown again")
	field.rebuild()
	await filled(field)
	await step(3)
	check_near(relative_tip(ids[7]).length(), 0.1, 0.002, "after a filling")
	field.regrowth_rate = 2.0
	await step(20)
	check(relative_tip(ids[7]).length() > 0.11, "it grows")
	await step(60)
	var now := field.get_plant_heights(ids)
	for i in ids.size():
		check_near(now[i], whole[i], 1e-4, "height then")
	check_near(
		relative_tip(ids[7]).length(), field.get_plant_height(ids[7]), 0.01, "from root to tip then"
	)


func test_plants_that_are_mown_again_grow_from_their_last_height() -> void:
	await start()
	field.regrowth_rate = 0.05
	field.set_height_in_sphere(field.global_position, 1.0, 0.2)
	await step(3)
	field.set_height_in_sphere(field.global_position, 1.0, 0.1)
	var id := field.find_nearest_plant(field.global_position, 1.0)
	for i in 8:
		await frames(1)
		check_near(relative_tip(id).length(), 0.1, 0.02, "from root to tip in frame %d" % i)


func test_a_height_above_their_own_makes_plants_whole_again() -> void:
	await start()
	var id := field.find_nearest_plant(field.global_position, 2.0)
	var whole := field.get_plant_height(id)
	field.set_height_in_sphere(field.global_position, REACH, 0.0)
	check(field.get_plant_height(id) < 0.05 * whole, "mown to the ground")
	check(field.get_plant_height(id) > 0.0, "it exists")
	check(field.set_height_in_sphere(field.global_position, REACH, 50.0) > 100, "raised")
	check_near(field.get_plant_height(id), whole, 1e-5, "height")
	for height: float in [NAN, -0.1]:
		check_equal(field.set_height_in_sphere(field.global_position, REACH, height), 0)
		check_error("set_height_in_sphere() needs a height")


func test_a_field_is_found_as_it_was_left() -> void:
	await start()
	field.remove_in_sphere(field.to_global(Vector3(5, 0, 0)), REACH)
	field.set_height_in_sphere(field.to_global(Vector3(-5, 0, 0)), REACH, 0.1)
	var places: Array[Transform3D] = [Transform3D(Basis(), Vector3(1, 0, 1)), Transform3D.IDENTITY]
	field.add_plants(places, field.species[0].species)
	var reed := ReedFunction.new()
	reed.resource_name = "Our reed"
	var others := field.add_plants(places, reed)
	field.remove_plant(others[0])
	var bytes := field.get_changes()
	var ids := sorted_ids()
	var heights := field.get_plant_heights(ids)
	field.free()
	field = _make_field()
	field.species = field.species + [PlantFieldSpecies.of(reed, 0.0)]
	check(field.apply_changes(bytes), "before it is built")
	await start()
	_check_as_left(ids, heights)
	field.remove_in_sphere(field.global_position, 50.0)
	await frames(2)
	check_equal(field.get_plant_count(), 0, "plants")
	check(field.apply_changes(bytes), "after all was cut")
	await rested()
	_check_as_left(ids, heights)
	check(field.get_changes() == bytes, "its changes are the same bytes")


func test_the_default_grass_is_available_before_a_build() -> void:
	field.free()
	field = PlantField3D.new()
	field.size = Vector2(6, 6)
	await start()
	var grass: PlantFunction = load("res://addons/undergrowth/species/meadow_grass.tres")
	field.add_plants([Transform3D.IDENTITY], grass)
	var bytes := field.get_changes()
	var count := field.get_plant_count()
	field.free()
	field = PlantField3D.new()
	field.size = Vector2(6, 6)
	check(field.apply_changes(bytes), "before it is built")
	await start()
	check_equal(field.get_plant_count(), count, "plants")


func test_no_bytes_are_no_changes() -> void:
	await start()
	var ids := sorted_ids()
	field.remove_in_sphere(field.global_position, REACH)
	field.set_height_in_sphere(field.global_position, 2.0 * REACH, 0.1)
	field.add_plants([Transform3D.IDENTITY], field.species[0].species)
	check(field.apply_changes(PackedByteArray()), "applied")
	await rested()
	check_equal(sorted_ids(), ids, "plants")
	for id in ids:
		check(field.get_plant_height(id) > 0.11, "height")


func test_bytes_that_are_not_sound_are_one_error_and_change_nothing() -> void:
	await start()
	field.remove_in_sphere(field.global_position, REACH)
	var species := GrassFunction.new()
	species.resource_name = "Nobody's"
	field.add_plants([Transform3D.IDENTITY], species)
	var bytes := field.get_changes()
	var count := field.get_plant_count()
	check(not field.apply_changes(bytes.slice(0, bytes.size() - 3)), "cut off")
	check_error("apply_changes(): They are incomplete or damaged")
	check(not field.apply_changes("something else".to_utf8_buffer()), "of another kind")
	check_error("apply_changes(): These bytes are no edits of a field")
	var later := bytes.duplicate()
	later[4] = 9
	check(not field.apply_changes(later), "of a later release")
	check_error("apply_changes(): They were saved by a later release")
	check_equal(field.get_plant_count(), count, "plants")
	check(field.get_changes() == bytes, "its changes are the same bytes")
	field.free()
	field = _make_field()
	await start()
	check(not field.apply_changes(bytes), "of an unknown species")
	check_error("plants of 'Nobody's' were added, but the field has no species of that name")


func test_changes_of_a_field_of_another_seed_are_reported() -> void:
	await start()
	field.remove_in_sphere(field.global_position, REACH)
	var bytes := field.get_changes()
	for other in [false, true]:
		field.free()
		field = _make_field()
		field.size = Vector2(30, 20)
		field.seed = 7 if other else 0
		await start()
		check(field.apply_changes(bytes), "applied")
		check_error_count(
			"these edits were recorded with seed 0, but the field has seed 7", int(other)
		)
		check_equal(
			field.find_plants_in_sphere(field.global_position, REACH - 0.5).size(), 0, "there"
		)


func test_heights_are_those_of_the_world() -> void:
	field.scale = Vector3.ONE * 2.0
	await start()
	var ids := field.add_plants(
		[Transform3D(Basis().scaled(Vector3.ONE * 0.5), Vector3.ZERO)], field.species[0].species
	)
	await frames(3)
	var tip := field.to_global(field.get_tip_position(ids[0]))
	var height := tip.distance_to(field.global_position)
	check_near(field.get_plant_height(ids[0]), height, 1e-3, "height")
	check_near(field.get_plant_heights(ids)[0], height, 1e-3, "one of heights")
	field.set_height_in_sphere(field.global_position, 0.5, 0.1)
	check_near(field.get_plant_height(ids[0]), 0.1, 1e-3, "height of what is mown")


func _check_as_left(ids: PackedInt64Array, heights: PackedFloat32Array) -> void:
	check_equal(sorted_ids(), ids, "plants")
	if field.get_plant_count() == ids.size():
		var now := field.get_plant_heights(ids)
		for i in ids.size():
			check_near(now[i], heights[i], 1e-3, "height")


func _make_field() -> PlantField3D:
	var made := PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	made.size = Vector2(20, 20)
	made.density = 10.0
	made.wind = PlantWind.new()
	made.wind.strength = 0.0
	made.position = Vector3(5, 1, -3)
	made.rotation.y = 0.4
	return made


func _count_near(radius := REACH) -> int:
	return field.find_plants_in_sphere(field.global_position, radius).size()
