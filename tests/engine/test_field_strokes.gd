## Strokes on the map of a built field.
extends "res://tests/engine/field_map_harness.gd"


func test_strokes_touch_what_they_change_and_nothing_else() -> void:
	_fill_all(0.6)
	field.map = map
	field.wind = PlantWind.new()
	await start()
	await step(30)
	field.simulation_enabled = false
	await frames(2)
	var fills := [0]
	field.build_finished.connect(func() -> void: fills[0] += 1)
	var ids := sorted_ids()
	var states := field.get_motion_state(ids)
	map.paint(Vector3(3, 0, 3), 3.0, TULIP, 1.0, 0.5)
	map.erase(Vector3(-3, 0, -3), 3.0, "", 1.0, 0.5)
	await rested()
	check_equal(fills[0], 0, "fills")
	var came := 0
	for id in field.get_plant_ids():
		came += 0 if ids.has(id) else 1
	check(came > 20, "%d plants came" % came)
	var stayed := 0
	for i in ids.size():
		if field.has_plant(ids[i]):
			stayed += 1
			var state := field.get_motion_state([ids[i]])
			check_equal(state, states.slice(12 * i, 12 * i + 12), "motion of plant %d" % ids[i])
	check(stayed < ids.size() - 40, "%d of %d stay" % [stayed, ids.size()])


## The work of a game in a frame.
class Game:
	extends Node

	func _process(_delta: float) -> void:
		OS.delay_msec(2)


## At least one of many strokes starts with idle threads, also on a busy machine.
func test_a_stroke_is_placed_and_shown_in_one_frame() -> void:
	var game := Game.new()
	root.add_child(game)
	_fill_all(0.6)
	field.map = map
	await start()
	var seen_at_once := 0
	for i in 30:
		map.erase(Vector3(3, 0, 3), 2.0, TULIP, 1.0, 0.0)
		await rested()
		map.paint(Vector3(3, 0, 3), 2.0, TULIP, 1.0, 0.0)
		await physics_frame
		seen_at_once += 0 if field.is_building() else 1
	check(seen_at_once > 0, "some of the strokes are seen in the frame in which they are painted")
	game.free()


func test_erased_new_plants_are_not_drawn() -> void:
	field.map = map
	root.add_child(field)
	await rested()
	map.paint(Vector3(3, 0, 3), 3.0, TULIP, 1.0, 0.0)
	await rested()
	check_equal(_drawn(), field.get_plant_count(), "new plants are drawn")
	check(field.get_plant_count() > 50, "%d new plants" % field.get_plant_count())
	map.erase(Vector3(3, 0, 3), 4.0, TULIP, 1.0, 0.0)
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	check_equal(_drawn(), 0, "plants that are drawn")


func test_strokes_give_the_same_plants_as_one_build() -> void:
	_fill_all(0.5)
	field.map = map
	await start()
	var rng := RandomNumberGenerator.new()
	rng.seed = 11
	for i in 40:
		var place := Vector3(rng.randf_range(-14, 14), 0, rng.randf_range(-14, 14))
		var title := TULIP if i % 2 == 0 else GRASS
		match i % 4:
			0, 1:
				map.paint(place, rng.randf_range(1, 4), title, 0.7)
			2:
				map.erase(place, rng.randf_range(1, 4), title, 0.7)
			3:
				map.paint_height(place, rng.randf_range(1, 4), title, 1.4)
		await frames(i % 3)
	await rested()
	var edited := all_plants()
	field.rebuild()
	await filled(field)
	check_equal(all_plants().size(), edited.size(), "number of plants")
	check_equal(all_plants(), edited, "its plants")


func test_a_plant_that_becomes_higher_goes_on_with_its_motion() -> void:
	_fill_all(1.0)
	field.map = map
	await start()
	field.simulation_enabled = false
	field.apply_impulse_in_sphere(Vector3.ZERO, 2.0, Vector3(0.2, 0, 0))
	field.simulation_enabled = true
	await frames(4)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.find_plants_in_sphere(Vector3.ZERO, 1.5)
	var before := field.get_motion_state(ids)
	var height := field.get_plant_height(ids[0])
	for title: String in [TULIP, GRASS]:
		map.paint_height(Vector3.ZERO, 3.0, title, 1.5, 1.0, 0.0)
	await rested()
	check_near(field.get_plant_height(ids[0]), height * 1.5, 1e-3, "height")
	var after := field.get_motion_state(ids)
	var bent := 0
	for i in ids.size():
		var was := Vector3(before[12 * i], before[12 * i + 1], before[12 * i + 2])
		var now := Vector3(after[12 * i], after[12 * i + 1], after[12 * i + 2])
		check_near(now, was, 1e-3, "direction of plant %d" % i)
		bent += 1 if was.angle_to(Vector3.UP) > 0.02 else 0
	check(bent > 5, "%d are bent" % bent)


func test_what_was_mown_stays_so_beside_a_stroke() -> void:
	_fill_all(1.0)
	field.map = map
	await start()
	var mown := field.remove_in_sphere(Vector3(-6, 0, 0), 2.0)
	check(mown > 50, "%d are mown" % mown)
	map.erase(Vector3(6, 0, 0), 2.0, "", 1.0, 0.0)
	await rested()
	check_equal(field.find_plants_in_sphere(Vector3(-6, 0, 0), 2.0).size(), 0, "plants there")
	check_equal(field.find_plants_in_sphere(Vector3(6, 0, 0), 1.6).size(), 0, "plants erased")


func test_strokes_during_a_build_are_not_lost() -> void:
	_fill_all(0.3)
	field.map = map
	root.add_child(field)
	for i in 30:
		map.paint(Vector3(i - 15, 0, 0), 2.0, TULIP, 0.5)
		if i % 7 == 3:
			field.rebuild()
		if i % 11 == 5:
			field.tile_size = 8.0 + i
		if i % 5 == 2:
			field.remove_plants(field.get_plant_ids().slice(0, 3))
		await frames(1)
	await rested()
	var edited := all_plants()
	field.rebuild()
	await filled(field)
	check(all_plants().size() - edited.size() <= 3 * 6, "only what was removed is missing")
	var plants := all_plants()
	for id: int in edited:
		check_equal(plants.get(id), edited[id], "plant %d" % id)


func test_new_plants_follow_colliders() -> void:
	var ground := add_plate(100.0, 2.5)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.map = map
	root.add_child(field)
	await rested()
	map.paint(Vector3(3, 0, 3), 4.0, GRASS, 1.0, 0.0)
	await rested()
	check(field.get_plant_count() > 150, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		check_near(field.get_plant_transform(id).origin.y, 2.5, 1e-3, "ground")
	ground.free()


func test_a_stroke_over_all_of_a_large_field_fills_it() -> void:
	field.map = map
	root.add_child(field)
	await rested()
	var corners := PackedVector3Array(
		[Vector3(-90, 0, -90), Vector3(90, 0, -90), Vector3(90, 0, 90)]
	)
	map.fill_polygon(corners, GRASS, 0.1)
	await rested()
	check_near(field.get_plant_count(), 90 * 180 * 0.5, 400.0, "plants")


func _fill_all(density: float) -> void:
	for title: String in [TULIP, GRASS]:
		map.fill_polygon(field.get_outline_points(), title, density)


func _drawn() -> int:
	var count := 0
	for at_level: int in field.get_statistics()["drawn_by_level"]:
		count = maxi(count, at_level)
	return count
