## Measures scenes of many small fields, added in one frame, and prints a JSON list of rows. Rows of
## one_bed and one_mix are single fields with as many plants.
##
## Run headless with --fixed-fps 60. Frames last a sixtieth of a second. median_ms is the time from
## the frame in which all fields enter the tree until all are built. worst_frame_ms is the longest
## time that the main thread works in one of these frames, and frame_ms what it works in a frame
## afterwards, both less what it works in a frame without fields (by the processor's time).
## processor_ms is the work of all threads until all are built.
extends SceneTree

const ProcessorTime := preload("res://tests/bench/processor_time.gd")
const BEDS := 40
const BED_SIZE := Vector2(3.0, 0.8)
const BED_DENSITY := 28.4
const MEADOWS := 30
const MEADOW_SIZE := Vector2(8.0, 8.0)
const MEADOW_DENSITY := 50.0
const FRAME_USEC := 16667
const STILL_FRAMES := 240
const MAX_FRAMES := 1800

var _rows: Array[Dictionary] = []


func _initialize() -> void:
	_run()


func _run() -> void:
	var idle := await _median_frame(STILL_FRAMES)
	await _measure("many_beds", BEDS, _make_bed.bind(1), idle)
	await _measure("one_bed", 1, _make_bed.bind(BEDS), idle)
	await _measure("many_mixes", MEADOWS, _make_meadow.bind(1), idle)
	await _measure("one_mix", 1, _make_meadow.bind(MEADOWS), idle)
	print(JSON.stringify(_rows))
	quit()


func _make_bed(count: int) -> PlantField3D:
	var kinds: Array[PlantFunction] = []
	for title: String in ["garden_tulip", "poppy", "lavender"]:
		kinds.append(load("res://addons/undergrowth/species/%s.tres" % title))
	var bed := PlantField3D.from_species(kinds)
	bed.size = BED_SIZE * sqrt(count)
	bed.density = BED_DENSITY
	return bed


func _make_meadow(count: int) -> PlantField3D:
	var mix: PackedScene = load("res://addons/undergrowth/mixes/meadow.tscn")
	var meadow: PlantField3D = mix.instantiate()
	meadow.size = MEADOW_SIZE * sqrt(count)
	meadow.density = MEADOW_DENSITY
	return meadow


func _measure(title: String, count: int, make: Callable, idle: float) -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(20.0, 2.0, 20.0)
	root.add_child(camera)
	var wind := PlantWind.new()
	var fields: Array[PlantField3D] = []
	for i in count:
		var field: PlantField3D = make.call()
		field.wind = wind
		field.position = Vector3(i % 8, 0.0, i / 8) * 10.0
		fields.append(field)
	await process_frame
	var start := Time.get_ticks_usec()
	var before := ProcessorTime.spent()
	var last := before.x
	for field in fields:
		root.add_child(field)
	var worst := 0.0
	for frame in MAX_FRAMES:
		await _next_frame()
		var now := ProcessorTime.spent().x
		worst = maxf(worst, now - last)
		last = now
		if not fields.any(func(field: PlantField3D) -> bool: return field.is_building()):
			break
	var usec := Time.get_ticks_usec() - start
	var spent := ProcessorTime.spent() - before
	var still := await _median_frame(STILL_FRAMES)
	var plants := 0
	for field in fields:
		plants += field.get_plant_count()
	_rows.append(
		{
			"name": title,
			"plants": plants,
			"threads": OS.get_processor_count(),
			"median_ms": usec / 1000.0,
			"worst_frame_ms": (worst - idle) / 1000.0,
			"frame_ms": (still - idle) / 1000.0,
			"processor_ms": (spent.x + spent.y) / 1000.0
		}
	)
	for field in fields:
		field.free()
	camera.free()
	await process_frame


## Returns the main thread's work in a frame.
func _median_frame(count: int) -> float:
	var times: Array[float] = []
	for i in count:
		var before := ProcessorTime.of_main_thread()
		await _next_frame()
		times.append(ProcessorTime.of_main_thread() - before)
	times.sort()
	return times[times.size() / 2]


func _next_frame() -> void:
	var start := Time.get_ticks_usec()
	await process_frame
	OS.delay_usec(maxi(start + FRAME_USEC - Time.get_ticks_usec(), 0))
