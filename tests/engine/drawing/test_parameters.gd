## How often a field sends the parameters of its materials.
extends "res://tests/engine/drawing/drawing_harness.gd"

const FRAMES := 64
const FRAMES_BETWEEN_LEANS := 16


func test_a_rising_mean_lean_is_sent_in_few_frames() -> void:
	field = make_field(16.0, 4.0)
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_CONSTANT
	field.wind.strength = 10.0
	await start()
	field.simulation_enabled = true
	var frames_with_calls := 0
	var before := DrawingRecord.count_parameter("undergrowth_mean_lean")
	for i in FRAMES:
		await step(1)
		var now := DrawingRecord.count_parameter("undergrowth_mean_lean")
		frames_with_calls += 1 if now > before else 0
		before = now
	check(frames_with_calls > 1, "sent in %d frames" % frames_with_calls)
	check(
		frames_with_calls <= FRAMES / FRAMES_BETWEEN_LEANS + 1,
		"sent in %d frames" % frames_with_calls
	)


func test_without_motion_vectors_nothing_of_the_previous_frame_is_sent() -> void:
	field = make_field(16.0, 4.0)
	await start()
	field.simulation_enabled = true
	var before := DrawingRecord.count_parameter("undergrowth_before")
	for i in 8:
		await step(1)
		field._on_frame_drawn()  # A headless engine draws no frames.
	check_equal(DrawingRecord.count_parameter("undergrowth_before"), before, "times sent")
