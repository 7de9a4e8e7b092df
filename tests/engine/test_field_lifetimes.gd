## Fields and plants that are created, freed and changed while worker threads step them.
extends "res://tests/engine/settling_harness.gd"

var _field: PlantField3D


func before_each() -> void:
	_field = PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	_field.size = Vector2(60, 60)
	_field.density = 8.0
	_field.wind = PlantWind.new()
	root.add_child(_field)
	await _field.build_finished
	await frames(2)


func after_each() -> void:
	if is_instance_valid(_field):
		_field.free()


func test_freed_while_it_moves() -> void:
	await frames(3)
	_field.free()
	await frames(3)
	check(not is_instance_valid(_field), "it is gone")


func test_freed_during_a_build() -> void:
	for i in 5:
		var field: PlantField3D = _field.duplicate()
		root.add_child(field)
		await frames(i)
		field.free()
	await frames(3)
	check(_field.get_plant_count() > 0, "the other stays")


func test_removing_from_a_field_that_was_never_built() -> void:
	var field := PlantField3D.new()
	check_equal(field.remove_plants([12345]), 0, "plants of no such id")
	check_equal(field.remove_in_sphere(Vector3.ZERO, 1.0), 0, "plants where none are")
	check_equal(field.add_plants([], GrassFunction.new()).size(), 0, "plants of no transforms")
	field.free()


func test_all_plants_that_code_added_in_a_place_are_removed_at_once() -> void:
	for prototypes: int in [0, 4]:
		_field.prototypes = prototypes
		await settled(_field)
		var count := _field.get_plant_count()
		var places: Array[Transform3D] = []
		for i in 5:
			places.append(Transform3D(Basis.IDENTITY, Vector3(500.0 + i, 0, 0)))
		_field.add_plants(places, ReedFunction.new())
		await frames(2)
		check_equal(_field.remove_in_sphere(Vector3(502, 0, 0), 10.0), 5, "removed")
		await frames(2)
		check_equal(_field.get_plant_count(), count, "the others")


func test_a_species_that_is_planted_while_the_field_grows_stays_what_it_is() -> void:
	var reed := ReedFunction.new()
	for before: PlantField3D in [PlantField3D.new(), _field]:
		if before != _field:
			root.add_child(before)
		before.rebuild()
		var ids := before.add_plants([Transform3D(Basis.IDENTITY, Vector3(1, 0, 2))], reed)
		await before.build_finished
		check_equal(ids.size(), 1, "added plants")
		check(before.get_plant_species(ids[0]) == reed, "it is a reed")
		check(before.get_plant_count() > 1, "the field has filled")
		await frames(3)
		if before != _field:
			before.free()


func test_freed_by_a_handler_of_its_signals() -> void:
	var field: PlantField3D = _field.duplicate()
	field.build_progressed.connect(func(_ratio: float) -> void: field.queue_free())
	root.add_child(field)
	await frames(60)
	check(not is_instance_valid(field), "it is gone")


func test_moved_hidden_and_reparented_while_it_moves() -> void:
	var count := _field.get_plant_count()
	var id := _field.get_plant_ids()[3]
	var tip := _field.get_tip_position(id)
	var other := Node3D.new()
	root.add_child(other)
	for i in 40:
		_field.position.x += 0.5
		_field.rotation.y += 0.1
		_field.visible = i % 3 != 0
		_field.reparent(other if i % 2 == 0 else root as Node, false)
		await process_frame
	check_equal(_field.get_plant_count(), count)
	check(_field.get_tip_position(id) != tip, "it still moves")
	_field.reparent(root)
	other.free()


func test_out_of_the_tree_it_keeps_its_plants() -> void:
	var count := _field.get_plant_count()
	root.remove_child(_field)
	await frames(3)
	check_equal(_field.get_plant_count(), count)
	_field.density = 1.0
	root.add_child(_field)
	await _field.build_finished
	await frames(1)
	check(_field.get_plant_count() < count / 4.0, "what changed meanwhile counts")


func test_properties_that_change_in_every_frame() -> void:
	for i in 40:
		_field.seed = i
		_field.update_interval = 1 + i % 4
		_field.prototypes = 16 if i % 10 == 5 else 0
		_field.contact_enabled = i % 7 == 3
		_field.max_threads = i % 5
		await process_frame
	_field.density = 2.0
	_field.prototypes = 0
	while _field.is_building():
		await process_frame
	check_near(_field.get_plant_count(), 2.0 * 3600.0, 300.0)


func test_fields_without_a_tree_report_nothing() -> void:
	var field := PlantField3D.from_species([GrassFunction.new()])
	field.rebuild()
	check_equal(field.get_plant_count(), 0)
	check_equal(field.is_point_in_plants(Vector3.ZERO), false)
	check_equal(field.remove_in_sphere(Vector3.ZERO, 1.0), 0)
	check_equal(field.get_statistics()["plants"], 0)
	field.free()


func test_unknown_ids_are_one_error() -> void:
	check_equal(_field.get_plant_transform(-1), Transform3D.IDENTITY)
	check_error("no plant -1")
	check_equal(_field.get_tip_position(100000000000), Vector3.ZERO)
	check_error("no plant 100000000000")
	var gone := _field.get_plant_ids()[4]
	check_equal(_field.remove_plant(gone), true)
	check_equal(_field.has_plant(gone), false)
	check_equal(_field.remove_plant(gone), false, "removing it again")
	check_error_count("no plant", 0)
	check_equal(_field.get_plant_height(gone), 0.0)
	check_error("no plant %d" % gone)


func test_removed_plants_are_gone_at_once() -> void:
	var count := _field.get_plant_count()
	var removed := _field.remove_in_sphere(Vector3(5, 0, 5), 3.0)
	check_near(removed, 8.0 * PI * 9.0, 40.0, "removed plants")
	check_equal(_field.get_plant_count(), count - removed)
	for transform in _field.get_plant_transforms(_field.get_plant_ids()):
		var away := transform.origin.distance_to(Vector3(5, 0, 5))
		check(away > 3.0, "a plant stays outside: %f m away" % away)
	check_equal(_field.remove_in_sphere(Vector3(5, 0, 5), 3.0), 0)
	check_equal(_field.is_point_in_plants(Vector3(5, 0.2, 5)), false)
	await frames(5)


func test_the_others_keep_their_own_motion_when_some_go() -> void:
	_field.simulation_enabled = false
	await frames(2)
	var ids := _field.get_plant_ids()
	var tips := _field.get_tip_positions(ids)
	var transforms := _field.get_plant_transforms(ids)
	var removed := _field.remove_in_sphere(Vector3(-9, 0, 4), 6.0)
	var left := 0
	for i in ids.size():
		if _field.has_plant(ids[i]):
			left += 1
			check_equal(_field.get_tip_position(ids[i]), tips[i], "tip %d" % i)
			check_equal(_field.get_plant_transform(ids[i]), transforms[i], "place %d" % i)
	check_equal(left, ids.size() - removed, "plants that keep their ids")


func test_all_plants_may_go_and_others_come() -> void:
	var count := _field.get_plant_count()
	check_equal(_field.remove_in_sphere(Vector3.ZERO, 1000.0), count)
	check_equal(_field.get_plant_count(), 0)
	await frames(3)
	_field.add_plants([Transform3D.IDENTITY], _field.species[0].species)
	await frames(3)
	check_equal(_field.get_plant_count(), 1)


func test_plants_that_are_added_in_every_frame() -> void:
	var count := _field.get_plant_count()
	var bell := BellflowerFunction.new()
	for i in 40:
		_field.add_plants(
			[Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 0.5), Vector3(100 + i, 0, 0))],
			bell if i % 2 == 0 else _field.species[1].species
		)
		await process_frame
	check_equal(_field.get_plant_count(), count + 40)
	for i in 40:
		check(
			_field.is_point_in_plants(Vector3(100 + i, 0.05, 0)), "plant at %d is there" % (100 + i)
		)
	check_equal(_field.remove_in_sphere(Vector3(110, 0, 0), 2.5), 5)
	check_equal(_field.get_plant_count(), count + 35)


func test_plants_that_come_and_go_take_no_more_room_each_time() -> void:
	const ROOM := 1_000_000.0  # Bytes. Repeated allocations of these plants' poses would take 6 MB.
	var rows := PackedFloat32Array()
	for i in 4000:
		rows.append_array([1, 0, 0, 300 + i % 60, 0, 1, 0, 0, 0, 0, 1, floori(i / 60.0)])
	var grass := GrassFunction.new()
	var taken := 0.0
	for round in 220:
		if round == 20:  # Later allocations are not caused by first use.
			taken = Performance.get_monitor(Performance.MEMORY_STATIC)
		var ids := _field.add_plants(rows, grass)
		await frames(1)
		_field.remove_plants(ids)
		await frames(1)
	check_near(Performance.get_monitor(Performance.MEMORY_STATIC), taken, ROOM, "bytes")


func test_added_plants_survive_a_rebuild() -> void:
	var place := Transform3D(Basis.IDENTITY, Vector3(200, 0, 0))
	var id := _field.add_plants([place], TulipFunction.new())[0]
	await frames(2)
	_field.density = 1.0
	await _field.build_finished
	await frames(2)
	check_equal(_field.get_plant_transform(id).origin, Vector3(200, 0, 0), "by its id")
	check(_field.is_point_in_plants(Vector3(200, 0.1, 0)), "it is still there")


func test_many_plants_are_added_fast() -> void:
	var rows := PackedFloat32Array()
	for i in 20000:
		rows.append_array([1, 0, 0, 300 + i % 100, 0, 1, 0, 0, 0, 0, 1, floori(i / 100.0)])
	var count := _field.get_plant_count()
	var ids := _field.add_plants(rows, GrassFunction.new())
	await frames(2)
	check_equal(ids.size(), 20000, "ids")
	check_equal(_field.get_plant_count(), count + 20000)
	check_equal(_field.get_plant_transform(ids[0]).basis, Basis.IDENTITY)
	var place := _field.get_plant_transform(ids[-1]).origin
	check(place.x >= 300 and place.z >= 0, "it is where it should be: %s" % place)


func test_transforms_that_are_none_are_left_out_with_one_error() -> void:
	var count := _field.get_plant_count()
	(
		_field
		. add_plants(
			[
				Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0)),
				Transform3D(Basis.IDENTITY.scaled(Vector3.ZERO), Vector3.ZERO),
				Transform3D.IDENTITY,
			],
			_field.species[0].species
		)
	)
	check_error("2 transforms")
	check_equal(_field.get_plant_count(), count + 1)
	_field.add_plants([Transform3D.IDENTITY], null)
	check_error("needs a PlantFunction")
	_field.add_plants("here", _field.species[0].species)
	check_error("needs an Array")
	_field.add_plants(PackedFloat32Array([1, 2, 3]), _field.species[0].species)
	check_error("needs an Array")
	_field.remove_in_sphere(Vector3(INF, 0, 0), 1.0)
	check_error("remove_in_sphere")
	check_equal(_field.get_plant_count(), count + 1)


func test_a_point_at_a_plant_is_in_plants() -> void:
	var place := _field.get_plant_transform(_field.get_plant_ids()[20]).origin
	check(_field.is_point_in_plants(place + Vector3(0, 0.1, 0)), "at a plant")
	check(not _field.is_point_in_plants(place + Vector3(0, 30, 0)), "above it")
	check(not _field.is_point_in_plants(Vector3(500, 0, 0)), "far away")
	check(not _field.is_point_in_plants(Vector3(NAN, 0, 0)), "nowhere")
	_field.position.x = 500.0
	check(_field.is_point_in_plants(place + Vector3(500, 0.1, 0)), "at a plant of a moved field")


func test_a_material_that_does_not_bend_is_reported_once() -> void:
	var shader := Shader.new()
	shader.code = "shader_type spatial;"
	var material := ShaderMaterial.new()
	material.shader = shader
	_field.species[0].species.material = material
	await settled(_field)
	check_error("does not bend")


func test_freed_fields_free_their_functions() -> void:
	var weak: WeakRef = weakref(_field.species[0].species)
	_field.free()
	await frames(2)
	check(weak.get_ref() == null, "the function goes")
