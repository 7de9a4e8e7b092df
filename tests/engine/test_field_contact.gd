## Tips of a field's plants that push each other apart.
extends "res://tests/engine/field_harness.gd"

const MOST_MSEC := 300


func before_each() -> void:
	field = PlantField3D.new()
	field.species = [TulipFunction.new()]
	field.size = Vector2(30, 30)
	field.density = 2.0
	field.contact = true
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES


func test_an_absurd_collision_radius_keeps_frames_short_and_is_told_of() -> void:
	field.species[0].collision_radius = 50.0
	await start()
	check(field.get_plant_count() > 1500, "%d plants stand" % field.get_plant_count())
	var taken: Array[int] = []
	for i in 41:
		var before := Time.get_ticks_msec()
		await process_frame
		taken.append(Time.get_ticks_msec() - before)
	taken.sort()
	check(taken[20] < MOST_MSEC, "frames take %d ms" % taken[20])
	check_error("too many tips are near each other")


func test_usual_fields_are_not_told_of_a_crowd() -> void:
	field.density = 20.0
	await start()
	await step(30)
	check(field.get_plant_count() > 15000, "%d plants stand" % field.get_plant_count())
