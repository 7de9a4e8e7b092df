## The time of the tips: PlantField3D.get_motion_time().
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(5, 5)
	field.density = 3.0
	field.wind = PlantWind.new()


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
		for i in 5:
			await processed()
			check_near(field.get_motion_time(), field.wind.get_time(), 1e-6, "motion time")
			check_near(other.get_motion_time(), field.wind.get_time(), 1e-6, "of child %d" % index)
		other.free()


func test_fields_and_plants_of_one_wind_have_exactly_one_time() -> void:
	await start()
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.wind = field.wind
	await processed()
	root.add_child(plant)
	var other := PlantField3D.new()
	other.density = 0.0
	other.wind = field.wind
	var id := other.add_plants([Transform3D.IDENTITY], plant.species)[0]
	plant.height = other.get_plant_height(id)
	await processed()
	root.add_child(other)
	# Both begin again, so that they move alike.
	await frames(5)
	await processed()
	plant.reset_motion()
	other.reset_motion()
	var steps := 0
	while steps < 60:
		var before := field.get_motion_time()
		await process_frame
		var time := field.wind.get_time()
		await processed()
		steps += 1 if field.get_motion_time() > before else 0
		check_equal(field.wind.get_time(), time, "the clock within a frame")
		check_equal(field.get_motion_time(), time, "time of the field")
		check_equal(other.get_motion_time(), time, "time of the other")
		# A step moves a tip by far more.
		check_near(other.get_tip_position(id), plant.get_tip_position(), 1e-5, "tip")
	check(plant.get_deflection() > 0.01, "they move")
	plant.free()
	other.free()


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


func test_a_field_takes_another_step_length() -> void:
	var usual := PlantSimulation.step_length
	await start()
	PlantSimulation.step_length = 0.05
	await frames(2)
	await until(
		func() -> bool: return not field.get_statistics()["is_rebuilding_meshes"], "it is built"
	)
	await frames(2)
	var time := field.get_motion_time()
	while field.get_motion_time() < time + 0.5:
		await processed()
		check_equal(field.get_motion_time(), field.wind.get_time(), "motion time")
	PlantSimulation.step_length = usual


func test_equal_motion_time_is_equal_motion_to_the_bit_at_every_frame_rate() -> void:
	for kind: String in ["waves", "air"]:
		var expected := _steps_at(60, kind)
		check(expected.size() > 100, "%d steps at 60" % expected.size())
		for rate: int in [37, 144]:
			var steps := _steps_at(rate, kind)
			var compared := 0
			for number: String in steps:
				if expected.has(number):
					compared += 1
					check_equal(steps[number], expected[number], "step %s, %s" % [number, kind])
			check(compared > 50, "%d steps at %d frames, %s" % [compared, rate, kind])


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
