## Plants that code adds while a field is busy, and queries of plants by their ids.
extends "res://tests/engine/field_harness.gd"

const SPECIES := "res://addons/undergrowth/species/"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(20, 20)
	field.density = 3.0


func test_plants_that_are_added_after_variants_were_raised() -> void:
	field.species[0].variants = 2
	await start()
	var count := field.get_plant_count()
	field.species[0].variants = 64
	var places: Array[Transform3D] = []
	for i in 300:
		places.append(Transform3D(Basis.IDENTITY, Vector3(0.05 * i, 0, 30)))
	var ids := field.add_plants(places, field.species[0].species)
	check_equal(ids.size(), 300, "ids")
	_check_sound(ids)
	await rested()
	check_equal(field.get_plant_count(), count + 300, "plants")
	_check_sound(ids)
	var heights := {}
	for id in ids:
		heights[field.get_plant_height(id)] = true
	field.add_plants(places, field.species[0].species)
	await frames(3)
	check_equal(field.get_plant_count(), count + 600, "plants")


func test_plants_that_are_added_outside_the_tree() -> void:
	await start()
	var count := field.get_plant_count()
	root.remove_child(field)
	var ids := field.add_plants([Transform3D.IDENTITY], load(SPECIES + "dandelion.tres"))
	_check_sound(ids)
	root.add_child(field)
	await rested()
	check_equal(field.get_plant_count(), count + 1, "plants")


func test_plants_of_extreme_size_are_refused_and_those_far_away_exist() -> void:
	await start()
	var places: Array[Transform3D] = []
	for size: float in [1e-30, 1e-20, 1e-7, 1.0, 1e7, 1e18, 3e38]:
		places.append(Transform3D(Basis.from_scale(Vector3.ONE * size), Vector3(0, 0, 30)))
	var ids := field.add_plants(places, field.species[0].species)
	check_error("6 transforms of add_plants() are not finite, or of a scale below 1e-6")
	check_equal(ids.size(), 1, "ids")
	_check_sound(ids)
	var far := Vector3(1e31, 0, -1e31)
	ids = field.add_plants([Transform3D(Basis.IDENTITY, far)], field.species[0].species)
	await frames(5)
	check(field.get_plant_transform(ids[0]).origin.is_equal_approx(far), "it exists there")


func test_a_camera_that_is_nowhere_harms_nothing() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position = Vector3(NAN, NAN, NAN)
	field.skeleton_distance = 10.0
	await start()
	await frames(10)
	_check_sound(field.get_plant_ids())
	camera.position = Vector3(1e31, 0, 1e31)
	await frames(10)
	_check_sound(field.get_plant_ids())
	camera.free()


func test_preview_after_a_species_came_that_follows_prototypes() -> void:
	field.prototypes = 8
	field.simulation_enabled = false
	await start()
	var wind := PlantWind.new()
	for i in 6:
		field.add_plants([Transform3D(Basis.IDENTITY, Vector3(i, 0, 15))], ReedFunction.new())
		for j in 4:
			wind.advance(STEP)
			field._preview(STEP, wind)
	await frames(3)
	check(field.get_plant_count() > 6, "all goes on")
	_check_sound(field.get_plant_ids())


func test_plants_added_before_the_first_build_preserve_their_height() -> void:
	field.species.append(PlantFieldSpecies.of(ReedFunction.new()))
	field.species[1].variants = 3
	var places: Array[Transform3D] = []
	for i in 20:
		places.append(Transform3D(Basis.IDENTITY, Vector3(i, 0, 30)))
	root.add_child(field)
	var ids: Array[PackedInt64Array] = []
	var heights: Array[PackedFloat32Array] = []
	for species: PlantFunction in [
		field.species[1].species, BellflowerFunction.new(), field.species[0].species
	]:
		ids.append(field.add_plants(places, species))
		heights.append(field.get_plant_heights(ids[-1]))
	await field.build_finished
	await frames(3)
	for kind in ids.size():
		check_equal(field.get_plant_heights(ids[kind]), heights[kind], "heights of kind %d" % kind)


func test_plants_added_before_the_default_grass_preserve_their_height() -> void:
	field.species = []
	root.add_child(field)
	var ids := PackedInt64Array()
	var species := TulipFunction.new()
	for i in 8:
		ids.append_array(
			field.add_plants([Transform3D(Basis.IDENTITY, Vector3(i, 0, 30))], species)
		)
	var heights := field.get_plant_heights(ids)
	await field.build_finished
	await frames(3)
	check_equal(field.get_plant_heights(ids), heights, "heights")
	var later := field.add_plants([Transform3D(Basis.IDENTITY, Vector3(0, 0, 31))], species)
	check(field.get_plant_height(later[0]) > 0.0, "more of them can be added")


func test_a_species_is_added_during_a_build() -> void:
	field.size = Vector2(100, 100)
	await start()
	for round in 4:
		field.rebuild()
		await frames(round)
		var ids := PackedInt64Array()
		for function: PlantFunction in [ReedFunction.new(), GrassFunction.new()]:
			var place := Transform3D(Basis.IDENTITY, Vector3(60 + ids.size(), 0, round))
			ids.append_array(field.add_plants([place], function))
		if field.is_building():
			await filled(field)
		await frames(2)
		for i in 2:
			var place := field.get_plant_transform(ids[i]).origin
			check_equal(place, Vector3(60 + i, 0, round), "place")
			var function := field.get_plant_species(ids[i])
			check_equal(function.get_class(), ["ReedFunction", "GrassFunction"][i], "species")
		_check_sound(ids)


func test_plants_of_a_species_are_removed_and_return_during_a_build() -> void:
	await start()
	var reed := ReedFunction.new()
	var id := field.add_plants([Transform3D(Basis.IDENTITY, Vector3(30, 0, 0))], reed)[0]
	field.remove_plant(id)
	field.rebuild()
	var again := field.add_plants([Transform3D(Basis.IDENTITY, Vector3(31, 0, 0))], reed)
	await filled(field)
	await frames(2)
	check_equal(field.get_plant_species(again[0]), reed as PlantFunction, "species")
	check_equal(field.has_plant(id), false, "the removed plant")
	_check_sound(again)


func test_plants_mown_during_a_mesh_rebuild_stay_mown() -> void:
	await start()
	field.tile_size = 7.0
	await frames(1)
	check(field.remove_in_sphere(Vector3.ZERO, 3.0) > 10, "plants are mown")
	var count := field.get_plant_count()
	field.tile_size = 8.0
	await rested()
	check_equal(field.get_plant_count(), count, "plants")
	check_equal(field.find_plants_in_sphere(Vector3.ZERO, 3.0).size(), 0, "plants in the middle")


func test_bulk_answers_are_the_single_ones() -> void:
	await start()
	field.add_plants([Transform3D(Basis.IDENTITY, Vector3(30, 0, 0))], ReedFunction.new())
	field.remove_in_sphere(Vector3(3, 0, 3), 2.0)
	field.apply_impulse_in_sphere(Vector3.ZERO, 100.0, Vector3(0.2, 0, 0))
	await frames(10)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.get_plant_ids()
	check_equal(ids.size(), field.get_plant_count(), "ids")
	var transforms := field.get_plant_transforms(ids)
	var heights := field.get_plant_heights(ids)
	var tips := field.get_tip_positions(ids)
	for i in ids.size():
		check_equal(field.get_plant_transform(ids[i]), transforms[i], "transform %d" % i)
		check_near(field.get_plant_height(ids[i]), heights[i], 1e-6, "height %d" % i)
		check_equal(field.get_tip_position(ids[i]), tips[i], "tip %d" % i)
		check_equal(field.has_plant(ids[i]), true, "plant %d" % i)
	check_equal(field.get_plant_transforms([]).size(), 0, "of no ids")


func test_a_state_that_was_kept_comes_back() -> void:
	field.wind = PlantWind.new()
	await start()
	await step(30)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.get_plant_ids()
	var state := field.get_motion_state(ids)
	check_equal(state.size(), 12 * ids.size(), "numbers")
	var tips := field.get_tip_positions(ids)
	field.reset_motion()
	check(field.get_tip_positions(ids) != tips, "they go back to rest")
	field.set_motion_state(ids, state)
	var back := field.get_motion_state(ids)
	var again := field.get_tip_positions(ids)
	for i in ids.size():
		check_near(again[i], tips[i], 1e-3, "tip %d" % i)
		for j in 12:
			check_near(back[12 * i + j], state[12 * i + j], 5e-3, "number %d of plant %d" % [j, i])
	field.set_motion_state(ids, PackedFloat32Array([1, 2, 3]))
	check_error("twelve numbers")
	field.set_motion_state(ids.slice(0, 1), PackedFloat32Array([NAN, 0, 0, INF, 0, 0]))
	check(field.get_tip_position(ids[0]).is_finite(), "no number that is none is taken")


func test_several_plants_are_removed_by_their_ids() -> void:
	await start()
	var ids := field.get_plant_ids()
	var gone := ids.slice(10, 40)
	gone.append_array([gone[0], -7])
	check_equal(field.remove_plants(gone), 30, "removed")
	check_equal(field.get_plant_count(), ids.size() - 30, "plants")
	for i in ids.size():
		check_equal(field.has_plant(ids[i]), i < 10 or i >= 40, "plant %d exists" % i)
	check_equal(field.remove_plants(gone), 0, "removed again")


func test_plants_that_code_adds_are_drawn_once_at_every_level() -> void:
	field.density = 0.0
	field.tile_size = 4.0
	root.add_child(field)
	var camera := Camera3D.new()
	root.add_child(camera)
	var count := 0
	for row in 6:
		var places: Array[Transform3D] = []
		for i in 12:
			var place := Vector3(-21.0 + 4.0 * i, 0, -13.0 + 5.0 * row)
			places.append(Transform3D(Basis.IDENTITY, place))
		count += field.add_plants(places, field.species[0].species).size()
		await frames(3)
		camera.position = Vector3(0, 2, 5000)
		var drawn: PackedInt32Array = field.get_statistics()["drawn_by_level"]
		check_equal(drawn[-1], count, "drawn of %d from far away" % count)
	var ids := field.get_plant_ids()
	for i in range(0, ids.size(), 2):
		count -= 1 if field.remove_plant(ids[i]) else 0
	await frames(3)
	var left: PackedInt32Array = field.get_statistics()["drawn_by_level"]
	check(left[-1] >= count, "%d are drawn, %d exist" % [left[-1], count])
	camera.free()


func test_plants_keep_their_ids_when_they_grow_again() -> void:
	await start()
	var ids := sorted_ids()
	var places := field.get_plant_transforms(ids)
	field.rebuild()
	await filled(field)
	check_equal(sorted_ids(), ids, "ids")
	check_equal(field.get_plant_transforms(ids), places, "their positions")
	field.size = Vector2(10, 20)
	await filled(field)
	for id in field.get_plant_ids():
		var i := ids.bsearch(id)
		check(ids[i] == id, "plant %d was there before" % id)
		check_equal(field.get_plant_transform(id), places[i], "where plant %d exists" % id)


func _check_sound(ids: PackedInt64Array) -> void:
	for id in ids:
		var height := field.get_plant_height(id)
		check(height > 0.05 and height < 20.0, "plant %d is %f m high" % [id, height])
		check(field.get_tip_position(id).is_finite(), "its tip is somewhere")


func test_the_257th_species_is_one_error_that_names_the_limit() -> void:
	field.free()
	field = PlantField3D.from_species([GrassFunction.new()])
	field.density = 1.0
	field.size = Vector2(3, 3)
	field.levels = [PlantFieldLevel.of(1)]
	await start()
	var place: Array[Transform3D] = [Transform3D()]
	for i in 255:
		var added := field.add_plants(place, GrassFunction.new())
		if added.size() != 1:
			check(false, "species %d is added" % (i + 2))
			return
	check_equal(field.add_plants(place, GrassFunction.new()).size(), 0, "plants of the 257th")
	check_error("256 species")


func test_a_species_without_room_beside_prototypes_is_one_error() -> void:
	field.free()
	field = PlantField3D.from_species([GrassFunction.new()])
	field.density = 1.0
	field.size = Vector2(3, 3)
	field.prototypes = 4
	field.levels = [PlantFieldLevel.of(1)]
	await start()
	var place: Array[Transform3D] = [Transform3D()]
	var count := 1
	while count < 256 and field.add_plants(place, GrassFunction.new()).size() == 1:
		count += 1
	check_error("prototypes")
	check(count > 40 and count < 256, "%d species have room" % count)
	check_equal(field.get_plant_ids().size(), field.get_plant_count(), "existing plants")
