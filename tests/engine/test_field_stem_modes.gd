## Stems of a field swing in one mode or two, by their own height.
extends "res://tests/engine/field_stem_harness.gd"


func test_an_impulse_starts_the_second_mode_and_its_state_is_restored() -> void:
	field.species[0].species.stem.modes = 2
	await start()
	await step(20)
	var id := field.get_plant_ids()[7]
	check_equal(_second_of(id), 0.0, "second mode of a field without a push")
	var place := field.get_plant_transform(id).origin
	field.apply_impulse_in_sphere(place, 0.01, Vector3(0.003, 0, 0))
	await step(4)
	field.simulation_enabled = false
	await frames(2)
	check(_second_of(id) > 1e-4, "it is bent by %f" % _second_of(id))
	var state := field.get_motion_state([id])
	check_equal(state.size(), 12, "numbers")
	var tip := field.get_tip_position(id)
	field.reset_motion()
	check_equal(_second_of(id), 0.0, "second mode at rest")
	field.set_motion_state([id], state)
	var back := field.get_motion_state([id])
	for i in 12:
		check_near(back[i], state[i], 2e-3 * maxf(1.0, absf(state[i])), "number %d" % i)
	check_near(field.get_tip_position(id), tip, TIP_TOLERANCE, "tip")


func test_a_camera_wakes_the_second_mode_only_where_distance_matters() -> void:
	field.species[0].species.stem.modes = 2
	field.far_distance = 0.0
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.position = Vector3(0, 1.7, 0)
	await start()
	await step(40)
	var id := field.get_plant_ids()[7]
	check_equal(_second_of(id), 0.0, "second mode where the distance does not matter")
	field.far_distance = 25.0
	await step(40)
	check(_second_of(id) > 0.0, "second mode near a camera")


func test_followers_get_a_second_mode_and_lose_it_again() -> void:
	field.prototypes = 8
	await start()
	await step(60)
	var id := field.get_plant_ids()[7]
	check_equal(_second_of(id), 0.0, "second mode of stems that have one")
	for modes: int in [2, 1, 2]:
		var tip := field.get_tip_position(id)
		field.species[0].species.stem.modes = modes
		await step(1)
		check_near(field.get_tip_position(id), tip, 0.05, "tip with %d modes" % modes)
		await step(60)
		check_equal(_second_of(id) > 0.0, modes == 2, "second mode of %d" % modes)


func test_stems_of_one_material_swing_by_their_own_size_as_plants_alone_do() -> void:
	var species := field.species[0].species
	species.height_min = 1.0
	species.height_max = 1.0
	species.damping_ratio = 0.02
	species.stem.youngs_modulus = 4e9
	species.stem.diameter = 0.008
	field.wind = null
	field.density = 0.1
	await start()
	var axes := [0.7, 1.0, 1.3].map(
		func(size: float) -> Transform3D:
			return Transform3D(Basis().scaled(Vector3.ONE * size), Vector3(size, 0, 0))
	)
	field.simulation_enabled = false
	var ids := field.add_plants(axes, species)
	await frames(2)
	var frequencies: Array[float] = []
	for i in ids.size():
		var alone := Plant3D.new()
		alone.species = species
		alone.simulation_enabled = false
		alone.scale = Vector3.ONE * (0.7 + 0.3 * i)
		root.add_child(alone)
		await frames(1)
		var own := _frequency(
			alone.set_motion_state,
			func() -> float: return alone.get_motion_state()[0],
			alone.advance
		)
		var in_field := _frequency(
			func(state: PackedFloat32Array) -> void: field.set_motion_state([ids[i]], state),
			func() -> float: return field.get_motion_state([ids[i]])[0],
			func(delta: float) -> void: field._preview(delta, null)
		)
		check_near(in_field, own, 0.02 * own, "frequency at %.1f m" % (0.7 + 0.3 * i))
		frequencies.append(in_field)
		alone.free()
	check(frequencies[0] > 1.8 * frequencies[2], "small ones are fast: %s Hz" % [frequencies])


## Returns the frequency (Hz) of a released tip, by the times at which it passes the middle.
func _frequency(begin: Callable, at: Callable, advance: Callable) -> float:
	begin.call(PackedFloat32Array([0.05, 1, 0, 0, 0, 0]))
	var passed: Array[float] = []
	var before: float = at.call()
	for i in 600:
		advance.call(STEP)
		var now: float = at.call()
		if before > 0.0 and now <= 0.0:
			passed.append(STEP * (i - now / (now - before)))
		before = now
	return (passed.size() - 1) / (passed[-1] - passed[0])


func _second_of(id: int) -> float:
	var state := field.get_motion_state([id])
	return Vector3(state[6], state[7], state[8]).length()
