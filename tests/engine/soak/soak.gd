## Uses fields and plants at random for a given time, in rounds of one seed each, under sanitizers.
## Errors of the add-on are ignored, but it must not crash or access foreign memory.
##
## Run by tests/suites/soak.py; `-- --seconds=N --seed=S`. Prints each round before it starts.
extends SceneTree

const World := preload("res://tests/engine/soak/world.gd")
const FRAMES_OF_ROUND := 240
const MAX_ACTIONS_PER_FRAME := 6

var _action_count := 0
var _end := 0  # ms, by the clock of the engine.


func _initialize() -> void:
	_soak()


func _soak() -> void:
	await process_frame
	_end = Time.get_ticks_msec() + 1000 * _option("seconds", 600)
	var seed := _option("seed", 1)
	var count := 0
	while Time.get_ticks_msec() < _end:
		print("round %d seed %d" % [count, seed])
		await _run_round(seed)
		count += 1
		seed += 1
	# The engine can wait forever at its exit if threads of its pool worked just before.
	for i in 20:
		await process_frame
	OS.delay_msec(200)
	print("done: %d rounds, %d actions" % [count, _action_count])
	quit()


func _run_round(seed: int) -> void:
	var world := World.new(root, seed)
	for i in FRAMES_OF_ROUND:
		for j in world.rng.randi_range(0, MAX_ACTIONS_PER_FRAME):
			world.act()
			_action_count += 1
		await process_frame
		if Time.get_ticks_msec() > _end:
			break
	world.end()
	paused = false
	Engine.time_scale = 1.0
	await process_frame


func _option(title: String, default: int) -> int:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("--%s=" % title):
			return int(word.get_slice("=", 1))
	return default
