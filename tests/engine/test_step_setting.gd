## A different step length, 0.025 s by the suite's project settings.
extends "res://tests/engine/harness.gd"

const STEP := 0.025


func test_the_simulation_begins_with_the_projects_step() -> void:
	check_near(PlantSimulation.step_length, STEP, 1e-9, "step")


func test_plants_and_fields_move_by_the_projects_step() -> void:
	var wind := PlantWind.new()
	var field := PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(4, 4)
	field.wind = wind
	root.add_child(field)
	await field.build_finished
	var before := wind.get_time()
	while wind.get_time() == before:
		await process_frame
	var steps := (wind.get_time() - before) / STEP
	check_near(steps, roundf(steps), 1e-4, "steps of the field")
	field.free()
