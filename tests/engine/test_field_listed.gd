## Species that are added to a field's list, changed and removed in a built field.
extends "res://tests/engine/field_harness.gd"

var _tulip: TulipFunction
var _added: PackedInt64Array


func before_each() -> void:
	_tulip = TulipFunction.new()
	_tulip.law = PlantFunction.LAW_SPRING
	_tulip.lean = 0.0
	field = PlantField3D.from_species([_tulip, GrassFunction.new()])
	field.size = Vector2(10, 10)
	field.density = 4.0


## Returns a field with three tulips added by code, whose species is no longer on the list.
func _delist(fills := true) -> void:
	await start()
	var places: Array[Transform3D] = []
	for i in 3:
		places.append(Transform3D(Basis.IDENTITY, Vector3(20 + i, 0, 0)))
	_added = field.add_plants(places, _tulip)
	field.species = [field.species[1]]
	if fills:
		await filled(field)
		await frames(2)


func test_plants_that_code_added_keep_their_species_when_it_leaves_the_list() -> void:
	await _delist()
	for id in field.get_plant_ids():
		var is_added := id in _added
		var function := field.get_plant_species(id)
		check_equal(function == _tulip, is_added, "plant %d is a tulip" % id)
	check_equal(field.get_plant_count() > 300, true, "grass exists")


func test_a_law_that_changes_after_its_species_left_the_list_reaches_added_plants() -> void:
	await _delist()
	Engine.time_scale = 8.0
	_tulip.damping_ratio = 1.0
	_tulip.lean = deg_to_rad(40.0)
	await step(240)
	for id in _added:
		check_near(relative_tip(id).angle_to(Vector3.UP), deg_to_rad(40.0), 0.03, "lean")


func test_a_law_that_changes_during_a_build_without_it_reaches_added_plants() -> void:
	await _delist(false)
	_tulip.damping_ratio = 1.0
	_tulip.lean = deg_to_rad(40.0)
	await filled(field)
	Engine.time_scale = 8.0
	await step(240)
	for id in _added:
		check_near(relative_tip(id).angle_to(Vector3.UP), deg_to_rad(40.0), 0.03, "lean")


func test_colours_that_change_after_a_species_left_the_list_reach_added_plants() -> void:
	await _delist()
	await _check_recoloured()


func test_a_species_of_another_entry_is_followed_where_code_added_plants() -> void:
	await start()
	_added = field.add_plants([Transform3D(Basis.IDENTITY, Vector3(20, 0, 0))], _tulip)
	field.species[0].species = ReedFunction.new()
	await filled(field)
	await frames(2)
	await _check_recoloured()


func test_a_list_that_is_set_repeatedly_rebuilds_the_field_once_each() -> void:
	await start()
	var fills := [0]
	field.build_finished.connect(func() -> void: fills[0] += 1)
	for i in 3:
		var list := field.species.duplicate()
		list[0] = list[0].duplicate()  # The same list again would change nothing.
		field.species = list
		await filled(field)
		await frames(30)
		check_equal(fills[0], i + 1, "fills")
	check(not field.is_building(), "it rests")


func test_more_variants_keep_plants_and_their_motion() -> void:
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_CONSTANT
	field.wind.strength = 3.0
	await start()
	await step(40)
	field.simulation_enabled = false
	await frames(2)
	var ids := sorted_ids()
	var bends := _directions(ids)
	var kinds := _kinds(ids)
	for count: int in [16, 2, 64]:
		field.species[0].variants = count
		await filled(field)
		await frames(2)
		check_equal(sorted_ids(), ids, "plants with %d variants" % count)
		check_equal(_kinds(ids), kinds, "species with %d variants" % count)
		var now := _directions(ids)
		var maximum := 0.0
		for i in ids.size():
			maximum = maxf(maximum, now[i].angle_to(bends[i]))
		check(maximum < 2e-3, "plants turn %f rad with %d variants" % [maximum, count])
	var leaning := 0
	for bend in bends:
		leaning += 1 if bend.angle_to(Vector3.UP) > 0.05 else 0
	check(leaning > 0.9 * ids.size(), "%d of %d plants lean" % [leaning, ids.size()])


func test_more_variants_keep_the_rate_at_which_plants_move() -> void:
	await start()
	field.apply_impulse_in_sphere(Vector3.ZERO, 100.0, Vector3(0.3, 0, 0.1))
	await step(5)
	field.simulation_enabled = false
	await frames(2)
	var ids := sorted_ids()
	var before := field.get_motion_state(ids)
	field.species[0].variants = 32
	await filled(field)
	await frames(2)
	var now := field.get_motion_state(ids)
	check_equal(now.size(), before.size(), "numbers")
	var fastest := 0.0
	for i in now.size():
		check_near(now[i], before[i], 5e-3 + 0.02 * absf(before[i]), "number %d" % i)
		fastest = maxf(fastest, absf(before[i]))
	check(fastest > 0.5, "plants move at %f" % fastest)


## Compares pictures of the first added plant from near while the colour of its species changes.
func _check_recoloured() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position = Vector3(20, 1, 2)
	field.skeleton_distance = 5.0
	for color: Color in [Color.BLUE, Color.RED]:
		_tulip.flower_color = color
		check(not field.is_building(), "it is not rebuilt")
		await rested()
		await frames(30)
		var colors := _colors_of(field.get_skeleton(_added[0]))
		check(color in colors, "%s is not among %s" % [color, colors])
	camera.free()


func _colors_of(skeleton: Skeleton3D) -> Array:
	if skeleton == null:
		return []
	var mesh: Mesh = (skeleton.get_child(0, true) as MeshInstance3D).mesh
	var colors := {}
	for color: Color in mesh.surface_get_arrays(0)[Mesh.ARRAY_COLOR]:
		colors[color] = true
	return colors.keys()


func _directions(ids: PackedInt64Array) -> PackedVector3Array:
	var found := PackedVector3Array()
	for id in ids:
		found.append(relative_tip(id).normalized())
	return found


func _kinds(ids: PackedInt64Array) -> PackedStringArray:
	var kinds := PackedStringArray()
	for id in ids:
		kinds.append(field.get_plant_species(id).get_class())
	return kinds
