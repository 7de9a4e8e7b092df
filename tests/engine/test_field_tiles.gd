## A field whose tiles are loaded and unloaded around cameras.
extends "res://tests/engine/field_harness.gd"

const DISTANCE := 30.0
const TILE := 8.0

var _camera: Camera3D


func before_each() -> void:
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.position = Vector3(0, 2, 0)
	field = _make_field()


func after_each() -> void:
	super()
	_camera.free()
	await process_frame


func test_near_plants_equal_those_of_a_whole_build() -> void:
	var whole := _make_field()
	whole.view_distance = 0.0
	root.add_child(whole)
	await whole.build_finished
	await start()
	await _streamed()
	check(field.get_plant_count() < whole.get_plant_count() / 2, "not all exist")
	_check_same_around(whole)
	_camera.position.x = 45.0
	await _streamed()
	_check_same_around(whole)
	var far := field.find_plants_in_sphere(Vector3(-5, 0, 0), 5.0)
	check_equal(far.size(), 0, "plants that are left behind")
	_camera.position.x = 0.0
	await _streamed()
	_check_same_around(whole)
	whole.free()


func test_changes_are_applied_outside_the_tree_while_the_field_is_built() -> void:
	await start()
	await _streamed()
	var cut := field.remove_in_sphere(Vector3.ZERO, 3.0)
	var changes := field.get_changes()
	field.apply_changes(PackedByteArray())
	field.rebuild()
	await frames(1)
	root.remove_child(field)
	check(field.apply_changes(changes), "applied")
	await frames(3)
	root.add_child(field)
	await rested()
	await _streamed()
	check(cut > 50, "%d plants are removed" % cut)
	check_equal(field.find_plants_in_sphere(Vector3.ZERO, 3.0).size(), 0, "plants there")


func test_tiles_wait_for_a_build_where_the_last_one_failed() -> void:
	var map := PlantMap.new()
	field.map = map
	var title := field.species[0].get_layer_name()
	map.fill_polygon(
		PackedVector3Array(
			[Vector3(-80, 0, -9), Vector3(80, 0, -9), Vector3(80, 0, 9), Vector3(-80, 0, 9)]
		),
		title
	)
	await start()
	await _streamed()
	var count := field.get_plant_count()
	check(count > 0, "plants exist")
	field.levels = [PlantFieldLevel.of(4, 9.0), PlantFieldLevel.of(4, 3.0)]
	var others: Array[PlantFieldSpecies] = []
	for i in 7:
		others.append(PlantFieldSpecies.of(GrassFunction.new()))
		others[i].layer = title
	field.species = others
	await frames(3)
	check_error("levels[1] ends at 3.0 m")
	_camera.position.x = 45.0
	await frames(60)
	field.levels = [PlantFieldLevel.of(4, 0.0)]
	await rested()
	await _streamed()
	check(field.get_plant_count() > 0, "plants exist again")


func test_tiles_suit_the_motion_where_a_build_with_other_prototypes_failed() -> void:
	for prototypes: int in [16, 0]:
		field.free()
		field = _make_field()
		field.prototypes = 16 - prototypes
		await start()
		await _streamed()
		field.levels = [PlantFieldLevel.of(4, 9.0), PlantFieldLevel.of(4, 3.0)]
		field.prototypes = prototypes
		await frames(3)
		check_error("levels[1] ends at 3.0 m")
		_camera.position.x = 45.0
		await frames(60)
		check(all_tips().size() > 0, "plants exist")
		field.levels = [PlantFieldLevel.of(4, 0.0)]
		await rested()
		_camera.position.x = 0.0
		await _streamed()
		check(all_tips().size() > 0, "plants exist again")


func test_what_is_left_behind_is_in_nobodys_way() -> void:
	await start()
	await _streamed()
	var middles: PackedVector3Array = []
	for id in field.find_plants_in_sphere(Vector3(-8, 0, 0), 5.0):
		var height := field.get_plant_height(id)
		middles.append(field.get_plant_transform(id).origin + 0.5 * height * Vector3.UP)
	check_equal(_count_in_the_way(middles), middles.size(), "plants in the way")
	_camera.position.x = 45.0
	await _streamed()
	check_equal(_count_in_the_way(middles), 0, "of %d plants" % middles.size())


func test_edits_are_restored_when_a_tile_returns() -> void:
	await start()
	await _streamed()
	var cut := field.remove_in_sphere(Vector3(3, 0, 0), 3.0)
	check(field.set_height_in_sphere(Vector3(-3, 0, 0), 2.0, 0.1) > 20, "mown")
	var id := field.find_nearest_plant(Vector3(-3, 0, 0), 1.0)
	check(cut > 50, "%d are cut" % cut)
	_camera.position.x = 60.0
	await _streamed()
	check(not field.has_plant(id), "it is far away")
	_camera.position.x = 0.0
	await _streamed()
	check_equal(
		field.find_plants_in_sphere(Vector3(3, 0, 0), 3.0).size(), 0, "plants that come back"
	)
	check(field.has_plant(id), "the mown one exists again")
	await step(2)
	check_near(relative_tip(id).length(), 0.1, 0.002, "as high as it was mown")


func test_an_endless_field_has_plants_around_every_camera() -> void:
	field.endless = true
	field.streaming_targets = [NodePath("Target")]
	var target := Node3D.new()
	target.name = "Target"
	field.add_child(target)
	target.position = Vector3(5000, 0, -3000)
	await start()
	await _streamed()
	for place: Vector3 in [_camera.position, target.position]:
		var near := field.find_plants_in_sphere(Vector3(place.x, 0, place.z), DISTANCE - 2.0).size()
		var area := PI * (DISTANCE - 2.0) ** 2
		check_near(near, area * field.density, 0.05 * area * field.density, "plants around it")
	target.position = Vector3(-90000, 0, 90000)
	await _streamed()
	check(field.find_nearest_plant(target.position, 1.0) >= 0, "there, too")
	check_equal(field.find_plants_in_sphere(Vector3(5000, 0, -3000), 20.0).size(), 0, "left behind")


func test_a_scaled_field_has_plants_up_to_the_world_distance() -> void:
	field.endless = true
	for scale_of_field: Vector3 in [Vector3.ONE * 0.5, Vector3(2.0, 1.0, 0.4)]:
		field.rotation.y = 0.7
		field.scale = scale_of_field
		if not field.is_inside_tree():
			await start()
		field.rebuild()
		await filled(field)
		await _streamed()
		var radius := DISTANCE - 2.0
		var near := field.find_plants_in_sphere(Vector3.ZERO, radius).size()
		var area := PI * radius * radius / (scale_of_field.x * scale_of_field.z)
		check_near(near, area * field.density, 0.05 * area * field.density, "plants around it")


func test_endless_without_a_view_distance_is_reported() -> void:
	field.view_distance = 0.0
	field.endless = true
	root.add_child(field)
	await rested()
	check_error("endless needs a view_distance above 0")
	field.view_distance = DISTANCE
	await filled(field)
	await _streamed()
	check(field.get_plant_count() > 1000, "%d plants" % field.get_plant_count())


func test_changed_plants_appear_around_the_camera_first() -> void:
	await start()
	await _streamed()
	field.density = 4.0
	await rested()
	await _streamed()
	var near := field.find_plants_in_sphere(Vector3.ZERO, DISTANCE - 2.0).size()
	check_near(near, PI * 28.0 * 28.0 * 4.0, 500.0, "plants")
	field.tile_size = 11.0
	await rested()
	await _streamed()
	check_near(
		field.find_plants_in_sphere(Vector3.ZERO, DISTANCE - 2.0).size(),
		near,
		0.0,
		"in other tiles"
	)
	_camera.position.z = 50.0
	await _streamed()
	_camera.position.z = 0.0
	await _streamed()
	check_near(field.find_plants_in_sphere(Vector3.ZERO, 28.0).size(), near, 0.0, "then")
	field.view_distance = 0.0
	await rested()
	check_near(field.get_plant_count(), 4.0 * 120.0 * 120.0, 1500.0, "all exist")


func test_painted_plants_appear_in_present_and_future_tiles() -> void:
	field.map = PlantMap.new()
	field.map.paint(Vector3(0, 0, 0), 100.0, field.species[0].get_layer_name(), 1.0)
	await start()
	await _streamed()
	var count := field.find_plants_in_sphere(Vector3(8, 0, 8), 4.0).size()
	check(count > 20, "%d exist" % count)
	field.map.erase(Vector3(8, 0, 8), 6.0, "", 1.0, 0.0)
	field.map.erase(Vector3(60, 0, 0), 6.0, "", 1.0, 0.0)
	await rested()
	await _streamed()
	check_equal(field.find_plants_in_sphere(Vector3(8, 0, 8), 4.0).size(), 0, "erased where it is")
	_camera.position.x = 60.0
	await _streamed()
	check_equal(field.find_plants_in_sphere(Vector3(60, 0, 0), 4.0).size(), 0, "and where it comes")
	check(field.find_plants_in_sphere(Vector3(70, 0, 0), 3.0).size() > 10, "plants exist beside it")


func test_a_walk_over_ground_in_wind_leaves_nothing_behind() -> void:
	var ground := add_plate(400.0, 3.0)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.endless = true
	field.wind.strength = 5.0
	await frames(2)
	await start()
	await _streamed()
	var maximum := field.get_plant_count()
	for i in 60:
		_camera.position.x += 2.0
		await frames(4)
		maximum = maxi(maximum, field.get_plant_count())
		if i % 10 == 5:
			field.remove_in_sphere(_camera.position, 4.0)
		if i == 20:
			field.species[0].species.natural_frequency *= 1.1
	await _streamed()
	var area := PI * (DISTANCE + 3.0 * TILE) ** 2
	check(maximum < area * field.density, "at most %d exist" % maximum)
	var nearest := field.find_nearest_plant(_camera.position + Vector3(9, 1, 0), 5.0)
	check(nearest >= 0, "a plant is there")
	check_near(field.get_plant_transform(nearest).origin.y, 3.0, 0.01, "on the ground")
	ground.free()


func _check_same_around(whole: PlantField3D) -> void:
	var middle := Vector3(_camera.position.x, 0, 0)
	var here := field.find_plants_in_sphere(middle, DISTANCE - 0.5)
	var there := whole.find_plants_in_sphere(middle, DISTANCE - 0.5)
	here.sort()
	there.sort()
	check_equal(here, there, "names")
	if here == there:
		var transforms := field.get_plant_transforms(here)
		check(transforms == whole.get_plant_transforms(there), "places")
		check(field.get_plant_heights(here) == whole.get_plant_heights(there), "heights")


## Waits until all expected tiles are built.
func _streamed() -> void:
	await frames(20)
	while field.is_building() or field.get_statistics()["tiles_waiting"] > 0:
		await process_frame
	await frames(20)
	while field.get_statistics()["tiles_waiting"] > 0:
		await process_frame


func _count_in_the_way(places: PackedVector3Array) -> int:
	var count := 0
	for place in places:
		count += 1 if field.is_point_in_plants(place) else 0
	return count


func _make_field() -> PlantField3D:
	var made := PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	made.size = Vector2(120, 120)
	made.density = 6.0
	made.tile_size = TILE
	made.view_distance = DISTANCE
	made.wind = PlantWind.new()
	made.wind.strength = 0.0
	return made
