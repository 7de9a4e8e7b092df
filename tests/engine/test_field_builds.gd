## Order of the first build of a large field: nearest tiles first, then the remaining ones, over
## several frames or in one call.
extends "res://tests/engine/field_harness.gd"

const SIDE := 100.0  # m
const PLANTS_OF_FIRST_PART := 20000
const WORKERS_SETTING := "undergrowth/simulation/use_worker_threads"


class Slope:
	extends Node3D

	func get_height(place: Vector3) -> float:
		return 0.1 * place.x


var _camera: Camera3D
var _ratios: PackedFloat32Array
var _ends: PackedStringArray


func before_each() -> void:
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.position = Vector3(30, 2, -20)
	field = _make_field()
	_ratios = []
	_ends = []


func after_each() -> void:
	super()
	_camera.free()
	await process_frame


func test_plants_near_the_camera_come_first() -> void:
	for streams: bool in [false, true]:
		if streams:
			_stream(field)
		root.add_child(field)
		await until(_has_plants, "the first plants come")
		check(field.is_building(), "others follow")
		var first := field.get_plant_count()
		check(first < PLANTS_OF_FIRST_PART, "%d plants come first" % first)
		var near := field.find_plants_in_sphere(_middle(), 6.0).size()
		check_near(near, 8.0 * PI * 36.0, 120.0, "plants around the camera")
		await filled(field)
		check(field.get_plant_count() > 3 * first, "all %d" % field.get_plant_count())
		field.free()
		field = _make_field()


func test_a_small_field_across_many_tiles_is_built_in_one_part() -> void:
	field.size = Vector2.ONE * 49.0  # Its tiles would have room for 32,000 plants.
	root.add_child(field)
	await until(_has_plants, "the plants come")
	check_equal(field.is_building(), false, "others follow")
	var count := field.get_plant_count()
	check(count > 10000 and count < PLANTS_OF_FIRST_PART, "%d plants" % count)


func test_a_build_in_parts_gives_the_same_plants_as_one_in_one_part() -> void:
	var whole := _make_field()
	whole.density = 0.5
	root.add_child(whole)
	await whole.build_finished
	var others := _make_field()  # With other species all tiles are built together.
	whole.species = others.species
	whole.density = field.density
	await filled(whole)
	others.free()
	await start()
	check_equal(_places_of(field), _places_of(whole), "plants and places")
	whole.free()


func test_progress_rises_to_1_and_the_end_is_reported_once() -> void:
	for streams: bool in [false, true]:
		if streams:
			_stream(field)
		_ratios = []
		_ends = []
		field.build_progressed.connect(func(ratio: float) -> void: _ratios.append(ratio))
		field.build_finished.connect(
			func() -> void: _ends.append("filled %s" % field.is_building())
		)
		root.add_child(field)
		await filled(field)
		await frames(30)
		var sorted := _ratios.duplicate()
		sorted.sort()
		check_equal(_ratios, sorted, "progress")
		check_equal(_ratios[-1], 1.0, "the last of them")
		check(_ratios.size() > 5, "%d steps" % _ratios.size())
		check_equal(_ends, PackedStringArray(["filled false"]), "ends")
		field.free()
		field = _make_field()


func test_a_larger_budget_takes_fewer_frames() -> void:
	var counts: Array[int] = []
	for budget: float in [0.1, 200.0]:
		field.build_budget_msec = budget
		_stream(field)
		field.view_distance = 35.0
		root.add_child(field)
		await until(_has_plants, "the first plants come")
		var count := 0
		while field.is_building():
			OS.delay_usec(10000)  # Workers finish before this thread.
			await process_frame
			count += 1
		counts.append(count)
		field.free()
		field = _make_field()
	check(counts[1] < 0.7 * counts[0], "%d frames, then %d" % counts)
	field.build_budget_msec = 0.0
	check_error("build_budget_msec")
	check_equal(field.build_budget_msec, 1.5, "the budget stays")


func test_build_now_returns_when_all_is_there() -> void:
	var twin := _make_field()
	root.add_child(twin)
	await filled(twin)
	root.add_child(field)
	field.build_finished.connect(func() -> void: _ends.append("filled"))
	check(field.build_now(), "it can be built")
	check(not field.is_building(), "nothing is missing")
	check_equal(_ends, PackedStringArray(["filled"]), "signals")
	check_equal(_places_of(field), _places_of(twin), "plants and places")
	twin.free()
	field.density = 2.0
	check(field.build_now(), "after a change, too")
	check_near(field.get_plant_count(), 2.0 * SIDE * SIDE, 600.0, "plants")
	check(field.build_now(), "where nothing is to be done")
	await frames(5)


func test_build_now_builds_all_tiles_around_cameras_on_their_ground() -> void:
	var slope := Slope.new()
	slope.name = "Slope"
	root.add_child(slope)
	_stream(field)
	field.density = 3.0
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = NodePath("../Slope")
	root.add_child(field)
	check(field.build_now(), "it can be built")
	check_equal(field.get_statistics()["tiles_waiting"], 0, "tiles that are missing")
	var place := Vector3(60, 6, 10)
	var plants := field.find_plants_in_sphere(place, 5.0)
	check(plants.size() > 100, "%d plants on the slope" % plants.size())
	slope.free()


func test_build_now_casts_rays_at_once() -> void:
	var plate := add_plate(2.0 * SIDE, 3.0)
	await physics_frames(2)
	field.density = 3.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	root.add_child(field)
	check(field.build_now(), "it can be built")
	check_near(field.get_plant_count(), 3.0 * SIDE * SIDE, 700.0, "plants")
	var one := field.get_plant_transform(field.get_plant_ids()[500]).origin
	check_near(one.y, 3.0, 0.01, "on the plate")
	plate.free()


func test_build_now_is_false_where_nothing_can_be_built() -> void:
	check_equal(field.build_now(), false, "outside of the tree")
	check_error("needs the field in the tree")
	field.build_failed.connect(func(why: String) -> void: _ends.append(why))
	field.species = [PlantFieldSpecies.new()]
	root.add_child(field)
	check_equal(field.build_now(), false, "an empty species")
	check_error("species[0] is empty")
	check_equal(_ends.size(), 1, "signals")
	check(_ends[0].contains("species[0] is empty"), "it says why: %s" % _ends)
	check_equal(field.is_building(), false, "nothing is on its way")
	field.species[0].species = GrassFunction.new()
	_camera.free()
	_camera = Camera3D.new()
	_stream(field)
	check_equal(field.build_now(), false, "nothing is near a camera")


func test_a_build_that_cannot_begin_or_end_is_reported() -> void:
	field.build_failed.connect(func(why: String) -> void: _ends.append(why))
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = NodePath("../Slope")
	root.add_child(field)
	check(field.is_building(), "it is queued")
	await until(func() -> bool: return _ends.size() == 1, "it is reported")
	check_error("ground_object")
	check_equal(field.is_building(), false, "then")
	var terrain := Node3D.new()
	terrain.name = "Slope"
	terrain.set_script(_script_of_bad_ground())
	root.add_child(terrain)
	field.rebuild()
	await until(func() -> bool: return _ends.size() == 2, "it is reported again")
	check_error("did not return a float")
	check_equal(field.is_building(), false, "in the end")
	check_equal(_ends.size(), 2, "signals")
	terrain.free()


func test_edits_before_the_first_build_ends_hold() -> void:
	var twin := _make_field()
	root.add_child(twin)
	await filled(twin)
	for streams: bool in [false, true]:
		if streams:
			_stream(field)
		root.add_child(field)
		_edit(field)
		if streams:
			await until(_has_plants, "the first plants come")
			_edit(field)
		await filled(field)
		_check_edited(twin)
		var count := field.get_plant_count()
		var far := Vector3(-20, 0, -20)
		check_equal(
			field.find_plants_in_sphere(far, 4.0).size(),
			twin.find_plants_in_sphere(far, 4.0).size(),
			"plants beside them"
		)
		field.rebuild()
		await filled(field)
		check_equal(field.get_plant_count(), count, "plants that are built again")
		_check_edited(twin)
		field.free()
		field = _make_field()
	twin.free()


func test_a_field_that_moves_while_it_is_built_takes_its_edits_along() -> void:
	root.add_child(field)
	field.remove_in_sphere(Vector3(10, 0, 10), 5.0)
	field.position.x = 7.0
	await filled(field)
	check_equal(field.find_plants_in_sphere(Vector3(17, 0, 10), 4.9).size(), 0, "plants")
	check(field.find_plants_in_sphere(Vector3(3, 0, 10), 1.0).size() > 5, "where it was")


func test_strokes_and_changes_during_the_first_build_hold() -> void:
	for streams: bool in [false, true]:
		field.map = PlantMap.new()
		field.map.paint(Vector3.ZERO, 80.0, field.species[0].get_layer_name(), 1.0)
		if streams:
			_stream(field)
		root.add_child(field)
		await until(_has_plants, "the first plants come")
		field.map.erase(_middle(), 5.0, "", 1.0, 0.0)
		field.map.erase(Vector3(-20, 0, 20), 5.0, "", 1.0, 0.0)
		await rested()
		for place: Vector3 in [_middle(), Vector3(-20, 0, 20)]:
			check_equal(field.find_plants_in_sphere(place, 4.0).size(), 0, "erased at %s" % place)
		field.free()
		field = _make_field()
	root.add_child(field)
	await until(_has_plants, "the first plants come")
	field.density = 3.0
	await rested()
	check_near(field.get_plant_count(), 3.0 * SIDE * SIDE, 700.0, "at the density that was set")


func test_a_streaming_field_of_other_tiles_is_building_at_once() -> void:
	_stream(field)
	field.density = 1.0
	await start()
	field.tile_size = 11.0
	check(field.is_building(), "right after it was set")
	await filled(field)
	check_equal(field.is_building(), false, "then")


func test_a_material_that_changes_while_a_field_is_built_again_is_drawn() -> void:
	await start()
	var bark := StandardMaterial3D.new()
	for i in 20:
		field.seed = i % 3
		field.species[0].species.material = bark if i % 2 == 0 else null
		await frames(1 + i % 4)
	await rested()
	check_near(field.get_plant_count(), 8.0 * SIDE * SIDE, 1500.0, "plants")


func test_a_field_that_leaves_the_tree_has_no_worker_left() -> void:
	for i in 6:
		var other := _make_field()
		root.add_child(other)
		await frames(i)
		root.remove_child(other)
		await frames(2)
		root.add_child(other)
		await filled(other)
		check_near(other.get_plant_count(), 8.0 * SIDE * SIDE, 1500.0, "plants of %d" % i)
		other.free()


func test_a_field_that_leaves_the_tree_waits_for_its_workers() -> void:
	var blockers: PackedInt64Array = []
	for i in OS.get_processor_count() + 2:  # The field's job queues behind them.
		blockers.append(WorkerThreadPool.add_task(OS.delay_msec.bind(300)))
	root.add_child(field)
	await field.build_progressed
	await frames(1)
	var before := _count_completed(blockers)
	root.remove_child(field)
	var has_workers: bool = ProjectSettings.get_setting(WORKERS_SETTING, true)
	check_equal(_count_completed(blockers) > before, has_workers, "it waits for its job")
	for task in blockers:
		WorkerThreadPool.wait_for_task_completion(task)


func test_ground_that_fails_after_the_first_part_is_reported() -> void:
	field.build_failed.connect(func(why: String) -> void: _ends.append(why))
	field.build_finished.connect(func() -> void: _ends.append("finished"))
	var terrain := Node3D.new()
	terrain.name = "Slope"
	terrain.set_script(_script_of_ground_near(_middle(), 35.0))
	root.add_child(terrain)
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = NodePath("../Slope")
	for streams: bool in [false, true]:
		if streams:
			_stream(field)
		_ends = []
		root.add_child(field)
		await until(func() -> bool: return not _ends.is_empty(), "it ends")
		await rested()
		check_error("did not return a float")
		check(field.get_plant_count() > 0, "the first part is built")
		check_equal(_ends.size(), 1, "signals: %s" % _ends)
		check(str(_ends).contains("did not return a float"), "it says why: %s" % _ends)
		root.remove_child(field)
	terrain.free()


func _count_completed(tasks: PackedInt64Array) -> int:
	var count := 0
	for task in tasks:
		count += 1 if WorkerThreadPool.is_task_completed(task) else 0
	return count


func _edit(of: PlantField3D) -> void:
	of.remove_in_sphere(Vector3(10, 0, 10), 5.0)
	of.remove_in_box(AABB(Vector3(-12, -5, 8), Vector3(6, 10, 6)))
	of.remove_in_polygon([Vector3(20, 0, 20), Vector3(28, 0, 20), Vector3(20, 0, 28)])
	of.remove_along([Vector3(-40, 0, -5), Vector3(40, 0, -5)], 2.0)
	of.set_height_in_sphere(Vector3(-10, 0, -25), 4.0, 0.05)


func _check_edited(twin: PlantField3D) -> void:
	check_equal(field.find_plants_in_sphere(Vector3(10, 0, 10), 5.0).size(), 0, "in the sphere")
	var box := AABB(Vector3(-12, -5, 8), Vector3(6, 10, 6))
	check_equal(field.find_plants_in_box(box).size(), 0, "in the box")
	check_equal(field.find_plants_in_sphere(Vector3(22, 0, 22), 1.5).size(), 0, "in the polygon")
	check_equal(field.find_plants_in_sphere(Vector3(-30, 0, -5), 1.0).size(), 0, "in the line")
	check_equal(field.find_plants_in_sphere(Vector3(30, 0, -5), 1.0).size(), 0, "at its end")
	var mown := field.find_plants_in_sphere(Vector3(-10, 0, -25), 3.9)
	check_equal(mown.size(), twin.find_plants_in_sphere(Vector3(-10, 0, -25), 3.9).size(), "mown")
	for height in field.get_plant_heights(mown):
		check(height < 0.1, "%.2f m" % height)


func _script_of_bad_ground() -> GDScript:
	var made := GDScript.new()
	made.source_code = 'extends Node3D\nfunc get_height(_place: Vector3) -> Variant: return ""'
	made.reload()
	return made


## Returns the script of ground that answers heights only within some metres of a position.
func _script_of_ground_near(place: Vector3, reach: float) -> GDScript:
	var made := GDScript.new()
	made.source_code = (
		"extends Node3D\nfunc get_height(place: Vector3) -> Variant:\n"
		+ '\treturn 0.0 if place.distance_to(Vector3%s) < %f else ""' % [place, reach]
	)
	made.reload()
	return made


func _has_plants() -> bool:
	return field.get_plant_count() > 0


func _middle() -> Vector3:
	return Vector3(_camera.position.x, 0, _camera.position.z)


## By id, because the order of chunks is arbitrary.
func _places_of(of: PlantField3D) -> Dictionary:
	var places := {}
	var ids := of.get_plant_ids()
	ids.sort()
	for i in range(0, ids.size(), 7):
		places[ids[i]] = of.get_plant_transform(ids[i])
	places[-1] = ids.size()
	return places


func _stream(of: PlantField3D) -> void:
	of.view_distance = 60.0
	of.endless = true


func _make_field() -> PlantField3D:
	var made := PlantField3D.from_species(
		[TulipFunction.new(), GrassFunction.new(), ReedFunction.new()]
	)
	made.size = Vector2(SIDE, SIDE)
	made.density = 8.0
	made.tile_size = 8.0
	made.simulation_enabled = false
	return made


func test_a_fault_during_a_build_in_parts_ends_it() -> void:
	for streams: bool in [false, true]:
		field.map = PlantMap.new()
		for title: String in ["Tulip", "Grass", "Reed"]:
			field.map.fill_polygon(field.get_outline_points(), title)
		if streams:
			_stream(field)
		root.add_child(field)
		await until(_has_plants, "the first plants come")
		check(field.is_building(), "others follow")
		field.exclusions = [NodePath("../Nothing")] as Array[NodePath]
		check(not field.build_now(), "built")
		check(not field.is_building(), "builds")
		await process_frame
		check(not field.is_building(), "builds later")
		check_error("exclusions[0]")
		field.free()
		field = _make_field()
