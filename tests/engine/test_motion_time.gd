## The time of the tips: PlantField3D.get_motion_time().
extends "res://tests/engine/field_harness.gd"

var _single: PlantField3D
var _id := 0
var _plant: Plant3D


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(5, 5)
	field.density = 3.0
	field.wind = PlantWind.new()


func after_each() -> void:
	super()
	if is_instance_valid(_single):
		_single.free()
		_plant.free()


func test_it_is_the_clock_of_the_wind_from_the_first_step_on() -> void:
	await start()
	for i in 10:
		await processed()
		check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "motion time")
	check(field.get_motion_time() > 0.1, "it advances")


func test_a_field_that_comes_late_belongs_to_the_clock_at_once() -> void:
	field.wind.advance(20.0)
	await start()
	await frames(5)
	await processed()
	check(field.get_motion_time() > 20.0, "motion time is %f" % field.get_motion_time())
	check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "motion time")
	field.wind.advance(5.0)
	await frames(2)
	await processed()
	check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "after a correction")


func test_a_field_that_comes_a_step_or_two_late_belongs_to_the_clock() -> void:
	for late: int in [1, 2]:
		field.wind = PlantWind.new()
		field.wind.advance(late * STEP)
		await start()
		for i in 5:
			await processed()
			check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "motion time")
		field.free()
		before_each()


func test_fields_of_one_wind_belong_to_its_clock_in_every_order() -> void:
	await start()
	for index: int in [0, -1]:
		var other := PlantField3D.from_species([TulipFunction.new()])
		other.size = Vector2(5, 5)
		other.wind = field.wind
		root.add_child(other)
		root.move_child(other, index)
		await filled(other)
		await frames(1)  # It moves from the frame after its build on.
		for i in 5:
			await processed()
			check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "motion time")
			check_near(other.get_motion_time(), field.wind.get_time(), 1e-6, "of child %d" % index)
		other.free()


func test_fields_and_plants_of_one_wind_have_exactly_one_time() -> void:
	await start()
	Engine.time_scale = 0.37  # No step in most frames.
	await frames(4)
	_add_single_field()
	await frames(2)
	_add_plant()
	for rate: float in [0.37, 1.0, 2.3]:
		Engine.time_scale = rate
		await _check_equal_steps(30)


func test_the_wind_goes_on_for_one_field_while_the_other_is_paused() -> void:
	await start()
	var other := PlantField3D.from_species([TulipFunction.new()])
	other.size = Vector2(5, 5)
	other.wind = field.wind
	root.add_child(other)
	await filled(other)
	other.process_mode = Node.PROCESS_MODE_DISABLED
	await processed()
	var rest := other.get_motion_time()
	await step(10)
	await processed()
	check_equal(other.get_motion_time(), rest, "time of the paused field")
	check_equal(field.get_motion_time(), field.wind.get_time(), "time of the field")
	other.process_mode = Node.PROCESS_MODE_INHERIT
	await step(2)
	await processed()
	check_equal(other.get_motion_time(), field.wind.get_time(), "time after the pause")
	other.free()


func test_a_wind_stops_while_all_its_fields_are_paused() -> void:
	await start()
	await step(5)
	paused = true
	await processed()
	var time := field.wind.get_time()
	await frames(50)
	check_equal(field.wind.get_time(), time, "the clock in a pause")
	paused = false
	await step(5)
	check(field.wind.get_time() > time, "it goes on")


func test_fields_and_plants_have_one_time_after_a_change_of_the_step_length() -> void:
	var usual := PlantSimulation.step_length
	await start()
	_add_single_field()
	_add_plant()
	await frames(5)
	PlantSimulation.step_length = 0.05
	await frames(1)
	await until(func() -> bool: return _is_built(field) and _is_built(_single), "both are built")
	await _check_equal_steps(20)
	PlantSimulation.step_length = usual


func test_slow_frames_drop_the_same_steps_of_winds_fields_and_plants() -> void:
	await start()
	_add_single_field()
	_add_plant()
	await frames(5)
	Engine.time_scale = 8.0
	var counts: Array[int] = []
	for i in 6:
		var before := field.wind.get_time()
		await process_frame
		var time := field.wind.get_time()
		counts.append(roundi((time - before) / STEP))
		await processed()
		check_equal(field.get_motion_time(), time, "time of the field")
		check_near(_single.get_tip_position(_id), _plant.get_tip_position(), 1e-5, "tip")
		PlantSimulation._add_field_time(1e5)
	check(counts[0] > 3 and counts[1] > 3, "a single slow frame drops nothing: %s" % [counts])
	check(counts.slice(3).max() <= 3, "later frames drop steps: %s" % [counts])
	check(counts.min() >= 1, "each frame has a step: %s" % [counts])


func test_equal_motion_time_is_equal_motion_to_the_bit_at_every_frame_rate() -> void:
	for kind: String in ["waves", "air", "blend"]:
		var expected := _steps_at(60, kind)
		check(expected.size() > 100, "%d steps at 60" % expected.size())
		for rate: int in [30, 37, 144]:
			var steps := _steps_at(rate, kind)
			var compared := 0
			for number: String in steps:
				if expected.has(number):
					compared += 1
					check_equal(steps[number], expected[number], "step %s, %s" % [number, kind])
			check(compared > 50, "%d steps at %d frames, %s" % [compared, rate, kind])


func _is_built(built: PlantField3D) -> bool:
	return not built.is_building() and not built.get_statistics()["is_rebuilding_meshes"]


## Adds a field with one plant in the same wind, at the origin.
func _add_single_field() -> void:
	_single = PlantField3D.new()
	_single.density = 0.0
	_single.wind = field.wind
	_id = _single.add_plants([Transform3D.IDENTITY], field.species[0].species)[0]
	root.add_child(_single)


## Adds a [Plant3D] that is equal to that plant.
func _add_plant() -> void:
	_plant = Plant3D.new()
	_plant.species = field.species[0].species
	_plant.height = _single.get_plant_height(_id)
	_plant.wind = field.wind
	root.add_child(_plant)


## Checks in each frame of [param count] steps that both fields and the plant have the time of the
## wind, and that the plant and that of the field move alike.
func _check_equal_steps(count: int) -> void:
	await frames(5)
	await processed()
	_plant.reset_motion()
	_single.reset_motion()
	var steps := 0
	var bend := 0.0  # At the end it may be upright for a moment.
	while steps < count:
		var before := field.get_motion_time()
		await process_frame
		var time := field.wind.get_time()
		await processed()
		steps += 1 if field.get_motion_time() > before else 0
		check_equal(field.wind.get_time(), time, "the clock within a frame")
		check_equal(field.get_motion_time(), time, "time of the field")
		check_equal(_single.get_motion_time(), time, "time of the other")
		# A step moves a tip by far more.
		check_near(_single.get_tip_position(_id), _plant.get_tip_position(), 1e-5, "tip")
		bend = maxf(bend, _plant.get_deflection())
	check(bend > 0.01, "they move")


## Returns the output of tests/engine/driven/print_motion_time.gd in a process of its own: a hash by
## step.
func _steps_at(rate: int, kind: String) -> Dictionary:
	var script := "res://tests/engine/driven/print_motion_time.gd"
	var words := [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", script
	]
	words += ["--fixed-fps", str(rate), "--", kind]
	var output := []
	OS.execute(engine_path(), words, output, true)
	var steps := {}
	for line in (output[0] as String).split("\n"):
		var reported := line.split(" ")
		if reported.size() == 4 and reported[0] == "step":
			steps[reported[1]] = reported[2]
			check(
				reported[3].to_float() < 1e-6,
				"the wind's clock is %s s off at %d" % [reported[3], rate]
			)
	return steps
