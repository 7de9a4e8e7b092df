## Motion through the air at frame rates that divide the physics rate, and at other rates.
extends "res://tests/engine/harness.gd"

const RATES: Array[int] = [30, 75, 120, 144, 240]
const TOLERANCE := 0.03  # Of the mean bend at 60 frames per second.


func test_a_wake_and_what_is_carried_bend_plants_alike_at_every_frame_rate() -> void:
	for moved: String in ["physics", "drawn"]:
		var expected := _bends_at(60, moved)
		check(expected.size() == 3, "it prints three numbers")
		for bend in expected:
			check(bend > 0.005, "plants bend: %s" % str(expected))
		for rate in RATES:
			var bends := _bends_at(rate, moved)
			for i in 3:
				var what := "bend %d at %d frames, %s" % [i, rate, moved]
				check_near(bends[i], expected[i], TOLERANCE * expected[i], what)


## Returns the output (m) of tests/engine/driven/move_through_air.gd in a process of its own.
func _bends_at(rate: int, moved: String) -> PackedFloat64Array:
	var script := "res://tests/engine/driven/move_through_air.gd"
	var words := [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", script
	]
	words += ["--fixed-fps", str(rate), "--", moved]
	var output := []
	OS.execute(engine_path(), words, output, true)
	var said := (output[0] as String).get_slice("bends ", 1).get_slice("\n", 0)
	return said.split_floats(" ")
