## Measures fields of plants and alternatives with as many bodies; prints a JSON list of rows.
##
## Run with --fixed-fps 60, so that each frame is one step, headless or with a renderer. With a
## renderer the rows contain its name, and alternatives, field_fill and a million plants are not
## measured. For fields, median_ms is the processor time of a frame for simulation and upload in all
## threads. main_ms is the main thread's part without waits, step_ms the remaining part, and
## frame_ms the increase of the frame time. Rows of field_frame_main are the main thread's part and
## its share. For field_fill, median_ms is the time from fill() to the signal with consecutive
## frames. processor_ms is the processor time in that period, frames included: the minimum time on
## an idle machine. workers_ms is the part of all threads but the main one. main_ms is the main
## thread's work for the build at 60 frames per second, and main_frame_ms the maximum in one of
## these frames. Only Linux reports such times. Without a screen the main thread makes the meshes of
## plants that workers built. For jolt and gdscript it is the increase of the frame or step time.
extends "res://tests/bench/field_peers.gd"

const ProcessorTime := preload("res://tests/bench/processor_time.gd")
const FIELD_COUNTS: Array[int] = [1000, 10000, 100000, 1000000]
const LADDER_COUNT := 100000
const DENSITY := 10.0
const FAR_DISTANCE := 25.0  # The default of a new field.
const FILLS := 5
const BUILD_COUNT := 1_000_000
const BUILD_DENSITY := 13.0
const BUILD_DISTANCE := 150.0  # m: includes about a million plants.
const FILL_FRAME_RATE := 60
const FRAMES_BETWEEN_PUSHES := 90
const PARTS: Array[String] = [
	"meadow_grass", "garden_tulip", "oxeye_daisy", "meadow_grass", "oxeye_daisy"
]
## Five ready species, all tufts of leaves.
const TUFTS: Array[String] = ["meadow_grass", "oxeye_daisy", "red_clover", "buttercup", "male_fern"]
## Ready species, simulated one by one, all with one law.
const LAWS: Dictionary = {
	PlantFunction.LAW_SPRING: "field_frame_spring", PlantFunction.LAW_STEM: "field_frame_stems"
}

var _renderer := "headless"
var _pushed: PlantField3D
var _frame := 0


func _initialize() -> void:
	_run()


func _run() -> void:
	if DisplayServer.get_name() != "headless":
		_renderer = RenderingServer.get_current_rendering_method()
	for count: int in FIELD_COUNTS.filter(_can_be_drawn):
		await _measure_field("field_frame", count, {})
		await _measure_field("field_frame_interval_4", count, {"update_interval": 4})
		await _measure_field("field_frame_prototypes_64", count, {"prototypes": 64})
	var breeze: PlantWind = load("res://addons/undergrowth/winds/fresh.tres")
	await _measure_field("field_frame_air", LADDER_COUNT, {"wind": breeze})
	for count: int in [LADDER_COUNT, LADDER_COUNT * 10].filter(_can_be_drawn):
		await _measure_field("field_frame_far", count, {"far_distance": FAR_DISTANCE})
	for law: PlantFunction.MotionLaw in LAWS:
		var field := _make_field_of_parts(law)
		field.simulation_enabled = true
		await _measure(LAWS[law], field)
		field = _make_field_of_parts(law)
		field.simulation_enabled = true
		field.wind = breeze
		await _measure(LAWS[law] + "_air", field)
	for title: String in ["field_frame_stems_asleep", "field_frame_stems_two_modes"]:
		var field := _make_field_of_parts()
		for entry in field.species:
			var stem: PlantStem = entry.species.stem
			entry.species.stem = stem.duplicate() if stem else PlantStem.new()
			entry.species.stem.modes = 2
		field.simulation_enabled = true
		_pushed = field if title == "field_frame_stems_two_modes" else null
		await _measure(title, field)
	_pushed = null
	if _renderer == "headless":
		await _measure_fill("field_fill", _make_field(LADDER_COUNT, {"simulation_enabled": false}))
		await _measure_fill("field_fill_of_parts", _make_field_of_parts())
		await _measure_fill(
			"field_fill_of_tufts", _make_field_of_parts(PlantFunction.LAW_STEM, TUFTS)
		)
		for streams: bool in [true, false]:
			await _measure_build(streams)
		_measure_meshes_of_parts()
		await _measure_peers()
	print(JSON.stringify(_rows))
	quit()


## A renderer without a graphics card maps each buffer, and Linux limits a process to 65,530
## mappings.
func _can_be_drawn(count: int) -> bool:
	return _renderer == "headless" or count <= LADDER_COUNT


## Stems step a second mode for some seconds after a push.
func _process(_delta: float) -> bool:
	_frame += 1
	if _pushed and _frame % FRAMES_BETWEEN_PUSHES == 0:
		_pushed.apply_impulse_in_sphere(Vector3.ZERO, 1e4, Vector3(1e-6, 0.0, 0.0))
	return false


func _make_field(count: int, settings: Dictionary) -> PlantField3D:
	var kinds: Array[PlantFunction] = [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new()
	]
	var field := PlantField3D.from_species(kinds)
	for entry in field.species:
		entry.variants = 8
	field.density = DENSITY
	field.size = Vector2.ONE * sqrt(count / DENSITY)
	field.far_distance = 0.0
	_make_waves(field)
	for property: String in settings:
		field.set(property, settings[property])
	return field


func _make_waves(field: PlantField3D) -> void:
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES
	field.wind.strength = 10.0
	field.wind.frequency = 0.5


func _measure_field(title: String, count: int, settings: Dictionary) -> void:
	await _measure(title, _make_field(count, settings))


func _measure(title: String, field: PlantField3D) -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position.y = 5.0  # It looks up, because the cost of drawing plants is not measured.
	camera.rotation.x = PI / 2.0
	root.add_child(field)
	await field.build_finished
	field.simulation_enabled = false
	var idle := await _median_frame_usec()
	field.simulation_enabled = true
	var frame := await _median_frame_usec() - idle
	var main: Array[float] = []
	var step: Array[float] = []
	for i in BLOCKS * FRAMES_PER_BLOCK:
		await process_frame
		var reported := field.get_statistics()
		main.append(reported["main_usec"])
		step.append(reported["step_usec"])
	# Mean over frames: with an interval, frames step different numbers of plants.
	var main_usec := _mean_without_outliers(main)
	var step_usec := _mean_without_outliers(step)
	if title == "field_frame":
		_add_row(
			"field_frame_main",
			field.get_plant_count(),
			main_usec,
			{"threads": 1, "renderer": _renderer, "share": main_usec / (main_usec + step_usec)}
		)
	_add_row(
		title,
		field.get_plant_count(),
		main_usec + step_usec,
		{
			"renderer": _renderer,
			"threads": OS.get_processor_count(),
			"main_ms": main_usec / 1000.0,
			"step_ms": step_usec / 1000.0,
			"frame_ms": frame / 1000.0,
			"bytes_per_plant": field.get_statistics()["bytes_per_plant"]
		}
	)
	field.free()
	camera.free()
	await process_frame


func _measure_fill(title: String, field: PlantField3D) -> void:
	root.add_child(field)
	await field.build_finished
	var times: Array[float] = []
	var workers: Array[float] = []
	var processors: Array[float] = []
	for i in FILLS:
		var before := ProcessorTime.spent()
		var start := Time.get_ticks_usec()
		field.seed += 1  # New seeds, so that no mesh exists.
		await field.build_finished
		times.append(Time.get_ticks_usec() - start)
		var spent := ProcessorTime.spent() - before
		workers.append(spent.y)
		processors.append(spent.x + spent.y)
		await process_frame
	var more := {"threads": 1, "bytes_per_plant": field.get_statistics()["bytes_per_plant"]}
	if ProcessorTime.spent() != Vector2.ZERO:
		more["workers_ms"] = _median(workers) / 1000.0
		more["processor_ms"] = _median(processors) / 1000.0
		more.merge(await _main_thread_of_fills(field))
	_add_row(title, field.get_plant_count(), _median(times), more)
	field.free()
	await process_frame


## The first build of a million plants of six species in tiles of 16 m, at 60 frames per second:
## time until some and until all exist, and the main thread's additional work compared with later
## frames.
func _measure_build(streams: bool) -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	var kinds: Array[PlantFunction] = [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new(),
		GrassFunction.new()
	]
	var field := PlantField3D.from_species(kinds)
	field.density = BUILD_DENSITY
	field.size = Vector2.ONE * sqrt(BUILD_COUNT / BUILD_DENSITY)
	field.view_distance = BUILD_DISTANCE if streams else 0.0
	field.endless = streams
	field.simulation_enabled = false
	var usual_rate := Engine.max_fps
	Engine.max_fps = FILL_FRAME_RATE
	await _main_thread_usec(func(frame: int) -> bool: return frame < WARM_UP_FRAMES)
	var start := Time.get_ticks_usec()
	var first := {}
	root.add_child(field)
	var goes_on := func(frame: int) -> bool:
		if first.is_empty() and field.get_plant_count() > 0:
			first["first_frames"] = frame
			first["first_ms"] = (Time.get_ticks_usec() - start) / 1000.0
		return field.is_building()
	var spent := await _main_thread_usec(goes_on)
	var total := Time.get_ticks_usec() - start
	var usual := _median(
		await _main_thread_usec(func(frame: int) -> bool: return frame < WARM_UP_FRAMES)
	)
	Engine.max_fps = usual_rate
	var more := func(sum: float, usec: float) -> float: return sum + maxf(usec - usual, 0.0)
	first.merge(
		{
			"threads": OS.get_processor_count(),
			"all_frames": spent.size(),
			"main_ms": spent.reduce(more, 0.0) / 1000.0,
			"main_frame_ms": (spent.max() - usual) / 1000.0
		}
	)
	var title := "field_build_streaming" if streams else "field_build"
	_add_row(title, field.get_plant_count(), total, first)
	field.free()
	camera.free()
	await process_frame


## The main thread's work for a build, in addition to its work in each frame of a game.
func _main_thread_of_fills(field: PlantField3D) -> Dictionary:
	var usual_rate := Engine.max_fps
	Engine.max_fps = FILL_FRAME_RATE
	var idle := await _main_thread_usec(func(frame: int) -> bool: return frame < WARM_UP_FRAMES)
	var usual := _median(idle)
	var sums: Array[float] = []
	var longest: Array[float] = []
	for i in FILLS:
		field.seed += 1
		var goes_on := func(_frame: int) -> bool: return field.is_building()
		var frames := await _main_thread_usec(goes_on)
		var more := func(sum: float, usec: float) -> float: return sum + maxf(usec - usual, 0.0)
		sums.append(frames.reduce(more, 0.0))
		longest.append(frames.max() - usual)
	Engine.max_fps = usual_rate
	return {"main_ms": _median(sums) / 1000.0, "main_frame_ms": _median(longest) / 1000.0}


## The main thread's work in each frame while `goes_on` is true.
func _main_thread_usec(goes_on: Callable) -> Array[float]:
	var spent: Array[float] = []
	while spent.is_empty() or goes_on.call(spent.size()):
		var before := ProcessorTime.spent().x
		await process_frame
		spent.append(ProcessorTime.spent().x - before)
	return spent


## Ready species of parts.
func _make_field_of_parts(
	law := PlantFunction.LAW_STEM, names: Array[String] = PARTS
) -> PlantField3D:
	var kinds: Array[PlantFunction] = []
	for name in names:
		kinds.append(load("res://addons/undergrowth/species/%s.tres" % name).duplicate())
		kinds.back().law = law
	var field := PlantField3D.from_species(kinds)
	field.density = DENSITY
	field.size = Vector2.ONE * sqrt(LADDER_COUNT / DENSITY)
	field.far_distance = 0.0
	_make_waves(field)
	field.simulation_enabled = false
	return field


## Time of a seed's first mesh and of its further levels.
func _measure_meshes_of_parts() -> void:
	for name in PARTS.slice(0, 3):
		var species: PlantFunction = load("res://addons/undergrowth/species/%s.tres" % name)
		var first: Array[float] = []
		var further: Array[float] = []
		for seed_value in BLOCKS:
			for segments: int in [12, 6, 3, 2]:
				var start := Time.get_ticks_usec()
				species.generate_mesh(0.0, segments, 1000 + seed_value)
				var usec := float(Time.get_ticks_usec() - start)
				(first if segments == 12 else further).append(usec)
		_add_row("first_mesh_" + name, 1, _median(first), {"threads": 1})
		_add_row("further_mesh_" + name, 1, _median(further), {"threads": 1})
