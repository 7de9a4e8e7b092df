## Fields that move: when, how far, in which wind, and by the ladder of what saves time.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0

var _field: PlantField3D


func before_each() -> void:
	_field = PlantField3D.new()
	_field.species = [TulipFunction.new()]
	_field.size = Vector2(30, 30)
	_field.density = 3.0
	_field.wind = PlantWind.new()
	_field.wind.kind = PlantWind.KIND_WAVES
	_field.wind.strength = 2.0


func after_each() -> void:
	_field.free()
	Engine.time_scale = 1.0
	paused = false


func test_plants_move_in_wind() -> void:
	await _start()
	var before := _field.get_tip_position(7)
	await _step(30)
	check(_field.get_tip_position(7).distance_to(before) > 0.001, "plant 7 moved")


func test_plants_keep_their_length() -> void:
	await _start()
	await _step(40)
	for i: int in range(0, _field.get_plant_count(), 50):
		var place := _field.get_plant_transform(i)
		var length := _field.get_plant_height(i) * place.basis.y.length()
		check_near(_field.get_tip_position(i).distance_to(place.origin), length, 1e-4)


func test_still_air_leaves_plants_at_rest() -> void:
	_field.wind = null
	await _start()
	var before := _tips()
	await _step(30)
	check_equal(_tips(), before, "tips")


func test_a_paused_tree_and_a_disabled_node_stand_still() -> void:
	await _start()
	await _step(10)
	paused = true
	await frames(2)
	var before := _tips()
	await frames(8)
	check_equal(_tips(), before, "tips while paused")
	paused = false
	_field.process_mode = Node.PROCESS_MODE_DISABLED
	await frames(2)
	before = _tips()
	await frames(8)
	check_equal(_tips(), before, "tips while disabled")
	_field.process_mode = Node.PROCESS_MODE_INHERIT
	await _step(8)
	check(_tips() != before, "they move again")


func test_a_field_that_does_not_simulate_stands_still() -> void:
	await _start()
	await _step(10)
	_field.simulating = false
	await frames(2)
	var before := _tips()
	await frames(8)
	check_equal(_tips(), before, "tips")


func test_time_scale_0_stands_still() -> void:
	await _start()
	await _step(10)
	Engine.time_scale = 0.0
	await frames(2)
	var before := _tips()
	await frames(8)
	check_equal(_tips(), before, "tips")


func test_the_number_of_threads_does_not_change_the_motion() -> void:
	# Both share one wind and the frames, so both take the same steps.
	_field.size = Vector2(80, 80)
	var other: PlantField3D = _field.duplicate()
	other.wind = _field.wind
	_field.threads = 1
	other.threads = 4
	await _start()
	root.add_child(other)
	await other.filled
	await frames(2)
	other.simulating = false
	_field.simulating = false
	_field.fill()
	other.fill()
	while _field.is_filling() or other.is_filling():
		await process_frame
	_field.wind_speed = 0.0
	other.wind_speed = 0.0
	_field.simulating = true
	other.simulating = true
	await frames(40)
	_field.simulating = false
	other.simulating = false
	await frames(1)
	check_equal(_tips(other), _tips(), "tips")
	other.free()


func test_changing_the_motion_keeps_the_state() -> void:
	await _start()
	await _step(30)
	_field.simulating = false
	await frames(2)
	var before := _tips()
	_field.species[0].mass = 3.0
	_field.wind.strength = 9.0
	_field.wind_speed = 2.0
	_field.update_interval = 3
	check_equal(_tips(), before, "tips")
	check(not _field.is_filling(), "the field is not filled anew")


func test_an_interval_stays_near_the_full_rate() -> void:
	await _start()
	var other := await _add_twin({"update_interval": 4})
	var largest := 0.0
	for i in 30:
		await frames(4)
		for plant: int in range(0, _field.get_plant_count(), 100):
			largest = maxf(
				largest, _field.get_tip_position(plant).distance_to(other.get_tip_position(plant))
			)
	# Up to four steps apart in time; in these, a tip goes 0.1 m at most.
	check(largest < 0.25, "tips are near those of the full rate: %f m" % largest)
	other.free()


func test_prototypes_do_not_move_in_unison() -> void:
	_field.prototypes = 8
	await _start()
	check_equal(_field.get_statistics()["simulated"], 8)
	await _step(60)
	var tips := _relative_tips()
	await _step(20)
	var later := _relative_tips()
	var moved := 0
	var same := 0
	for i in range(1, tips.size()):
		moved += 1 if tips[i].distance_to(later[i]) > 1e-4 else 0
		same += 1 if tips[i].distance_to(tips[0]) < 1e-4 else 0
	check(moved > tips.size() * 0.9, "%d of %d plants moved" % [moved, tips.size()])
	check(same < tips.size() * 0.2, "%d of %d plants are as the first" % [same, tips.size()])


func test_far_plants_are_stepped_less_often_and_still_move() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 2, 500)
	root.add_child(camera)
	_field.far_distance = 10.0
	await _start()
	var before := _tips()
	await _step(30)
	check(_tips() != before, "they move")
	camera.free()


func test_the_wind_comes_to_plants_downwind_later() -> void:
	_field.species = [] as Array[PlantFunction]
	_field.wind.kind = PlantWind.KIND_GUST
	_field.wind.gust_duration = 0.3
	_field.wind.direction_degrees = 90.0
	_field.wind_speed = 10.0
	root.add_child(_field)
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean_degrees = 0.0
	function.damping_ratio = 1.0
	(
		_field
		. add_plants(
			[
				Transform3D(Basis.IDENTITY, Vector3(0, 0, 0)),
				Transform3D(Basis.IDENTITY, Vector3(5, 0, 0)),
			],
			function
		)
	)
	await frames(5)
	await _step(240)
	var rest := [_relative_tip(0), _relative_tip(1)]
	_field.wind.trigger_gust()
	var first: Array[int] = [-1, -1]
	for i in 120:
		await _step(1)
		for plant in 2:
			if first[plant] < 0 and _relative_tip(plant).distance_to(rest[plant]) > 1e-4:
				first[plant] = i
	check(first[0] >= 0 and first[1] > first[0], "the gust comes to both: %s" % [first])
	# 5 m at 10 m/s are half a second.
	check_near((first[1] - first[0]) * STEP, 0.5, 0.1, "seconds of delay")


func test_wind_goes_on_where_plants_share_it() -> void:
	var plant := Plant3D.new()
	plant.function = TulipFunction.new()
	plant.wind = _field.wind
	root.add_child(plant)
	await _start()
	var before := _field.wind.get_time()
	await _step(60)
	# One of both moves the wind's clock on, never both.
	check_near(_field.wind.get_time() - before, 1.0, 0.2, "seconds of wind")
	plant.free()
	before = _field.wind.get_time()
	await _step(60)
	check_near(_field.wind.get_time() - before, 1.0, 0.2, "seconds of wind")


func test_a_moved_field_keeps_the_winds_direction() -> void:
	_field.species = [] as Array[PlantFunction]
	_field.wind.kind = PlantWind.KIND_CONSTANT
	_field.wind.direction_degrees = 90.0
	_field.rotation.y = 1.1
	root.add_child(_field)
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await frames(5)
	await _step(200)
	var tip := _field.global_basis * _field.get_tip_position(0)
	check(tip.x > 0.01, "it bends to +x: %s" % tip)
	check_near(tip.z, 0.0, 0.02, "z")


func test_impulses_move_plants_in_reach_only() -> void:
	_field.wind = null
	await _start()
	var before := _tips()
	var count := _field.apply_impulse_in_sphere(Vector3(3, 0, 3), 2.0, Vector3(1, 0, 0))
	check(count > 10, "%d plants are hit" % count)
	await _step(4)
	for i in _field.get_plant_count():
		var is_near := _field.get_plant_transform(i).origin.distance_to(Vector3(3, 0, 3)) <= 2.0
		var has_moved := _field.get_tip_position(i).distance_to(before[i]) > 1e-5
		check(is_near == has_moved, "plant %d moves where it was hit" % i)
	_field.apply_impulse_in_sphere(Vector3.ZERO, 1.0, Vector3(NAN, 0, 0))
	check_error("apply_impulse_in_sphere")


func test_contact_keeps_running() -> void:
	_field.density = 20.0
	_field.contact = true
	await _start()
	await _step(30)
	for i: int in range(0, _field.get_plant_count(), 97):
		check(_field.get_tip_position(i).is_finite(), "tip %d is finite" % i)


func test_bodies_push_plants_and_are_told_of() -> void:
	_field.wind = null
	_field.bodies_group = &"walkers"
	await _start()
	var walker := _add_walker()
	walker.position = Vector3(0, 0.5, 50)
	var told: Array[String] = []
	_field.body_entered_plants.connect(
		func(body: Node3D) -> void: told.append("in" if body == walker else "?")
	)
	_field.body_exited_plants.connect(
		func(body: Node3D) -> void: told.append("out" if body == walker else "?")
	)
	await _step(3)
	check_equal(told, [] as Array[String], "told outside")
	var rest := _tips()
	walker.position = Vector3(0, 0.5, 0)
	await _step(5)
	check_equal(told, ["in"] as Array[String], "told inside")
	check(_count_moved(rest, 0.05) > 0, "plants are pushed")
	walker.position = Vector3(0, 0.5, 50)
	await _step(3)
	check_equal(told, ["in", "out"] as Array[String], "told outside again")
	walker.position = Vector3(0, 0.5, 0)
	await _step(3)
	walker.remove_from_group(&"walkers")
	await _step(3)
	check_equal(
		told, ["in", "out", "in", "out"] as Array[String], "told of one that left the group"
	)
	await _step(1500)
	check_equal(_count_moved(rest, 0.02), 0, "plants that have not come back")
	walker.free()


func test_bodies_push_plants_that_follow_prototypes_for_a_while() -> void:
	_field.prototypes = 8
	_field.wind = null
	_field.bodies_group = &"walkers"
	var walker := _add_walker()
	await _start()
	var rest := _tips()
	walker.position = Vector3(0, 0.5, 0)
	await _step(5)
	var pushed := _count_moved(rest, 0.05)
	check(pushed > 0, "plants are pushed")
	check(pushed < rest.size(), "not all of them")
	var simulated: int = _field.get_statistics()["simulated"]
	check(simulated > 8, "they swing by themselves")
	walker.position = Vector3(0, 0.5, 50)
	await _step(400)
	check_equal(_count_moved(rest, 0.02), 0, "plants that have not come back")
	check_equal(
		_field.get_statistics()["simulated"], 8 * _field.species.size(), "they follow again"
	)
	walker.free()


func test_a_body_that_is_freed_among_plants_is_forgotten() -> void:
	_field.bodies_group = &"walkers"
	await _start()
	var walker := _add_walker()
	await _step(3)
	walker.free()
	await _step(3)
	check(_field.get_plant_count() > 0, "all goes on")


func test_monitors_tell_of_all_fields() -> void:
	await _start()
	check_equal(
		int(Performance.get_custom_monitor("undergrowth/field_plants")), _field.get_plant_count()
	)
	root.remove_child(_field)
	check(not Performance.has_custom_monitor("undergrowth/field_plants"), "no monitor is left")


func _start() -> void:
	root.add_child(_field)
	await _field.filled
	await frames(2)


## Waits until the simulation took at least [param count] steps more, by the wind's clock.
func _step(count: int) -> void:
	if _field.wind == null:
		await frames(count * 3)
		return
	var end := _field.wind.get_time() + (count - 0.5) * STEP
	while _field.wind.get_time() < end:
		await process_frame


func _add_twin(settings: Dictionary) -> PlantField3D:
	var twin: PlantField3D = _field.duplicate()
	twin.wind = _field.wind
	twin.species = _field.species
	for property: String in settings:
		twin.set(property, settings[property])
	root.add_child(twin)
	await twin.filled
	await frames(200)
	return twin


func _add_walker() -> StaticBody3D:
	var walker := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = CapsuleShape3D.new()
	walker.add_child(shape)
	walker.add_to_group(&"walkers")
	root.add_child(walker)
	return walker


func _tips(field := _field) -> PackedVector3Array:
	var tips := PackedVector3Array()
	for i in field.get_plant_count():
		tips.append(field.get_tip_position(i))
	return tips


func _relative_tip(index: int) -> Vector3:
	return _field.get_tip_position(index) - _field.get_plant_transform(index).origin


func _relative_tips() -> PackedVector3Array:
	var tips := PackedVector3Array()
	for i: int in range(0, _field.get_plant_count(), 20):
		tips.append(_relative_tip(i).normalized())
	return tips


func _count_moved(from: PackedVector3Array, distance: float) -> int:
	var count := 0
	for i in from.size():
		count += 1 if _field.get_tip_position(i).distance_to(from[i]) > distance else 0
	return count
