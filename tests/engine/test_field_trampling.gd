## Trodden plants of fields and single plants: how they keep a bend, recover and are saved.
extends "res://tests/engine/field_stem_harness.gd"

const BENT := 0.15  ## m from upright: a tip of a trodden plant.
const UPRIGHT := 0.03  ## m.
const LOST := 0.03  ## m: by rounding and recovery while a field is built.
const BYTES_OF_A_PLANT := 4.0


func before_each() -> void:
	super()
	field.wind.strength = 0.0
	field.species[0].species.trampling = 0.6
	field.species[0].species.recovery_time = 3000.0
	field.species[0].species.damping_ratio = 0.3


func test_a_body_leaves_a_path_that_recovers() -> void:
	field.species[0].species.recovery_time = 6.0
	await start()
	await _walk_along(0.0)
	await step(30)
	for id in field.get_plant_ids():
		var away := absf(field.get_plant_transform(id).origin.z)
		var bend := _bend(id)
		if away < 0.25 and absf(field.get_plant_transform(id).origin.x) < 3.0:
			check(bend > UPRIGHT, "a plant on the path is bent by %.3f m" % bend)
		elif away > 1.5:
			check(bend < UPRIGHT, "a plant beside the path is bent by %.3f m" % bend)
	var bent := _count_bent(UPRIGHT)
	check(bent > 20, "%d plants are trodden" % bent)
	await step(2000)
	check_equal(_count_bent(UPRIGHT), 0, "plants that are still bent")


func test_species_without_trampling_leave_no_path() -> void:
	field.species[0].species.trampling = 0.0
	await start()
	await _walk_along(0.0)
	await step(900)
	check_equal(_count_bent(UPRIGHT), 0, "bent plants")


func test_trodden_plants_are_saved_in_few_bytes() -> void:
	field.density = 40.0
	await start()
	var before := field.get_changes()
	await _walk_along(0.0)
	await _walk_along(0.3)
	await step(180)
	var bends := _bends()
	var trodden := 0
	for id: int in bends:
		trodden += 1 if bends[id] > 0.004 else 0
	var changes := field.get_changes()
	var share := float(changes.size() - before.size()) / trodden
	check(trodden > 300, "%d plants are trodden" % trodden)
	check(share <= BYTES_OF_A_PLANT, "a trodden plant takes %.2f bytes" % share)

	field.reset_motion()
	check_equal(_count_bent(UPRIGHT), 0, "bent plants after the reset")
	check(field.apply_changes(changes), "the changes are valid")
	await step(300)
	_check_same(bends, "after apply_changes()")
	check(field.apply_changes(before), "the earlier changes are valid")
	await step(300)
	check_equal(_count_bent(UPRIGHT), 0, "bent plants after the earlier state")


func test_trodden_plants_survive_a_rebuild_and_a_new_tile() -> void:
	await start()
	check(field.trample_in_sphere(Vector3.ZERO, 3.0) > 50, "plants are trodden")
	await step(240)
	var bends := _bends()
	field.rebuild()
	await rested()
	await step(60)
	_check_same(bends, "after a rebuild")
	field.density = 1.0  # Most plants leave, and return with the former density.
	await rested()
	field.density = 4.0
	await rested()
	await step(240)
	_check_same(bends, "after other densities")


func test_trodden_plants_survive_their_tile() -> void:
	_camera = Camera3D.new()
	root.add_child(_camera)
	field.size = Vector2(120, 120)
	field.tile_size = 8.0
	field.view_distance = 25.0
	await start()
	await rested()
	field.trample_in_sphere(Vector3.ZERO, 3.0)
	await step(240)
	var bends := {}
	for id in field.find_plants_in_sphere(Vector3.ZERO, 3.0):
		bends[id] = _bend(id)
	var changes := field.get_changes()
	_camera.position.x = 50.0
	await until(
		func() -> bool: return field.find_plants_in_sphere(Vector3.ZERO, 3.0).is_empty(),
		"the tiles are unloaded"
	)
	check(absi(field.get_changes().size() - changes.size()) < 8, "absent plants are saved")
	_camera.position.x = 0.0
	await until(
		func() -> bool:
			return field.find_plants_in_sphere(Vector3.ZERO, 3.0).size() == bends.size(),
		"the tiles return"
	)
	await rested()
	await step(240)
	_check_same(bends, "after the tile returned")


func test_code_tramples_plants_away_from_a_center() -> void:
	await start()
	var count := field.trample_in_sphere(Vector3(1, 0, 0), 2.5, 1.0)
	check_equal(count, field.find_plants_in_sphere(Vector3(1, 0, 0), 2.5).size(), "trodden plants")
	await step(300)
	for id in field.find_plants_in_sphere(Vector3(1, 0, 0), 2.5):
		var away := field.get_plant_transform(id).origin - Vector3(1, 0, 0)
		var tip := relative_tip(id)
		check(_bend(id) > BENT, "it is bent by %.3f m" % _bend(id))
		var angle := Vector2(away.x, away.z).angle_to(Vector2(tip.x, tip.z))
		check(absf(angle) < 0.1, "it lies away from the centre, %.2f rad beside" % angle)
	check(field.trample_in_sphere(Vector3(1, 0, 0), 2.5, 0.0) > 0, "plants rise")
	await step(500)
	check_equal(_count_bent(UPRIGHT), 0, "bent plants")
	for angle: float in [-0.1, 1.6, NAN]:
		check_equal(field.trample_in_sphere(Vector3.ZERO, 1.0, angle), 0, "at a wrong angle")
		check_error("trample_in_sphere() needs an angle from 0 to PI / 2")


func test_a_single_plant_keeps_its_bend_and_moves_to_another_page_with_it() -> void:
	var plant := Plant3D.new()
	plant.species = _reed()
	plant.species.trampling = 1.0
	plant.species.recovery_time = 1000.0
	plant.height = HEIGHT
	plant.bodies_group = &"walkers"
	root.add_child(plant)
	var ball := SphereShape3D.new()
	ball.radius = 0.3
	var body := add_body(ball, Vector3(-0.2, 0.8, 0))
	await frames(60)
	body.free()
	await frames(180)
	var bent := plant.get_tip_position()
	check(bent.x > BENT, "it stays bent: %s" % bent)
	plant.wind = PlantWind.new()
	plant.wind.strength = 0.0
	await frames(120)
	check_near(plant.get_tip_position(), bent, LOST, "tip in another wind")
	plant.reset_motion()
	await frames(120)
	check(plant.get_tip_position().x < UPRIGHT, "it rises at a reset")
	plant.free()


## Moves a body along the x axis through the field, 1.5 m/s.
func _walk_along(z: float) -> void:
	var walker := add_walker()
	field.bodies_group = &"walkers"
	walker.position = Vector3(-7, 0.9, z)
	while walker.position.x < 7.0:
		var time := field.wind.get_time()
		await process_frame
		walker.position.x += 1.5 * (field.wind.get_time() - time)
	field.bodies_group = &""
	walker.free()


## Returns the distance (m) of a tip from the line upright.
func _bend(id: int) -> float:
	var tip := relative_tip(id)
	return Vector2(tip.x, tip.z).length()


func _bends() -> Dictionary:
	var bends := {}
	for id in field.get_plant_ids():
		bends[id] = _bend(id)
	return bends


func _count_bent(distance: float) -> int:
	return _bends().values().filter(func(bend: float) -> bool: return bend > distance).size()


func _check_same(bends: Dictionary, when: String) -> void:
	var trodden := 0
	for id: int in bends:
		check_near(_bend(id), bends[id], LOST, "bend %s" % when)
		trodden += 1 if bends[id] > BENT else 0
	check(trodden > 10, "%d plants are bent" % trodden)
