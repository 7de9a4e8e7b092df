## Measures the mix mixes/meadow.tscn with its default levels; prints a JSON list of rows.
##
## The argument after `--` is the number of plants. The scene is a square field, a sun with four
## shadow splits to 60 m, and a camera 1.6 m above the middle of an edge that looks over the field;
## 1080 lines.
##
## Headless rows measure time and memory. median_ms, p99_ms and worst_ms are the main thread's
## processor time per frame at 60 frames per second, less the median of an empty scene. They contain
## the engine's work for the field, but no culling and no drawing. first_plant_ms and all_plants_ms
## are the times from the frame in which the field enters the tree to its first and to its last
## plants. In this period, build_frame_ms is the main thread's maximum per frame, and processor_ms
## the processor time of all threads. resident_mb is the increase of the process's resident memory
## since its start, and counted_bytes the simulation's memory per plant. Rows of scene_still are
## those of a field that is not simulated.
##
## Rows with a renderer contain counts: the draw calls and primitives of the colour and shadow
## passes, and the increase of the video memory (video_mb). A software renderer gives the same
## counts as a graphics card.
extends SceneTree

const ProcessorTime := preload("res://tests/bench/processor_time.gd")
const MIX := "res://addons/undergrowth/mixes/meadow.tscn"
const WIND := "res://addons/undergrowth/winds/fresh.tres"
const SCREEN := Vector2i(1920, 1080)
const EYE_HEIGHT := 1.6  # m
const SHADOW_DISTANCE := 60.0  # m
const SCALE := 0.1  # Of the drawn resolution, which counts do not depend on.
const FRAME_USEC := 16667
const MIN_SLEEP_USEC := 100
const FRAMES := 600
const DRAWN_FRAMES := 4
const SETTLING_FRAMES := 200
const MAX_FRAMES := 20_000
const BYTES_PER_PAGE := 4096

var _rows: Array[Dictionary] = []
var _camera: Camera3D
var _sun: DirectionalLight3D
var _first_resident := 0.0
var _is_drawn := DisplayServer.get_name() != "headless"


func _initialize() -> void:
	_run()


func _run() -> void:
	root.size = SCREEN
	root.scaling_3d_scale = SCALE
	_add_surroundings()
	_first_resident = _resident_bytes()
	var idle: float = _percentile(await _main_usec(FRAMES), 0.5) if not _is_drawn else 0.0
	var count := int(OS.get_cmdline_user_args()[0])
	if _is_drawn:
		await _count_drawn(count)
	else:
		await _measure(count, true, idle)
		await _measure(count, false, idle)
	print(JSON.stringify(_rows))
	quit()


func _add_surroundings() -> void:
	_sun = DirectionalLight3D.new()
	_sun.rotation = Vector3(-0.6, 0.5, 0.0)
	_sun.shadow_enabled = true
	_sun.directional_shadow_mode = DirectionalLight3D.SHADOW_PARALLEL_4_SPLITS
	_sun.directional_shadow_max_distance = SHADOW_DISTANCE
	root.add_child(_sun)
	_camera = Camera3D.new()
	_camera.far = 4000.0
	root.add_child(_camera)
	RenderingServer.directional_shadow_atlas_set_size(256, true)


## Adds the field to the tree, with the camera at its edge.
func _add_field(count: int) -> PlantField3D:
	var field: PlantField3D = (load(MIX) as PackedScene).instantiate()
	field.size = Vector2.ONE * sqrt(count / field.density)
	field.wind = load(WIND)
	_camera.position = Vector3(0.0, EYE_HEIGHT, 0.5 * field.size.y)
	root.add_child(field)
	return field


func _measure(count: int, simulates: bool, idle: float) -> void:
	var before := ProcessorTime.spent()
	var start := Time.get_ticks_usec()
	var field := _add_field(count)
	field.simulation_enabled = simulates
	var first := 0
	var worst := 0.0
	for frame in MAX_FRAMES:
		if not field.is_building():
			break
		worst = maxf(worst, (await _main_usec(1))[0])
		if first == 0 and field.get_plant_count() > 0:
			first = Time.get_ticks_usec() - start
	var all := Time.get_ticks_usec() - start
	var spent := ProcessorTime.spent() - before
	var times := await _main_usec(FRAMES)
	var plants := field.get_plant_count()
	_rows.append(
		{
			"name": "scene" if simulates else "scene_still",
			"plants": plants,
			"threads": 1,
			"renderer": "headless",
			"median_ms": (_percentile(times, 0.5) - idle) / 1000.0,
			"p99_ms": (_percentile(times, 0.99) - idle) / 1000.0,
			"worst_ms": (_percentile(times, 1.0) - idle) / 1000.0,
			"build_frame_ms": (worst - idle) / 1000.0,
			"first_plant_ms": first / 1000.0,
			"all_plants_ms": all / 1000.0,
			"processor_ms": (spent.x + spent.y) / 1000.0,
			"resident_mb": (_resident_bytes() - _first_resident) / 1e6,
			"counted_bytes": field.get_statistics()["bytes_per_plant"]
		}
	)
	await _remove(field)


func _count_drawn(count: int) -> void:
	# A software renderer would draw the field for minutes during the build. The render loop goes on,
	# since without it the renderer keeps the staging memory of all uploads.
	root.disable_3d = true
	var before := await _video_bytes()
	var field := _add_field(count)
	await _build(field)
	root.disable_3d = false
	for frame in DRAWN_FRAMES:
		await RenderingServer.frame_post_draw
	var row := _counts_of(field)
	row["name"] = "scene"
	row["renderer"] = RenderingServer.get_current_rendering_method()
	row["video_mb"] = (await _video_bytes() - before) / 1e6
	_rows.append(row)
	await _remove(field)


func _build(field: PlantField3D) -> void:
	for frame in MAX_FRAMES:
		if field.get_plant_count() > 0 and not field.is_building():
			break
		await process_frame
		OS.delay_usec(FRAME_USEC)  # Workers need the time that frames without drawing do not take.
	for frame in SETTLING_FRAMES:
		await process_frame


## The number of plants, and what the last frame drew.
func _counts_of(field: PlantField3D) -> Dictionary:
	return {
		"plants": field.get_plant_count(),
		"draw_calls": _drawn(Viewport.RENDER_INFO_TYPE_VISIBLE, false),
		"shadow_draw_calls": _drawn(Viewport.RENDER_INFO_TYPE_SHADOW, false),
		"primitives": _drawn(Viewport.RENDER_INFO_TYPE_VISIBLE, true),
		"shadow_primitives": _drawn(Viewport.RENDER_INFO_TYPE_SHADOW, true)
	}


func _drawn(pass_type: Viewport.RenderInfoType, primitives: bool) -> int:
	var what := Viewport.RENDER_INFO_DRAW_CALLS_IN_FRAME
	if primitives:
		what = Viewport.RENDER_INFO_PRIMITIVES_IN_FRAME
	return root.get_render_info(pass_type, what)


func _video_bytes() -> float:
	await RenderingServer.frame_post_draw
	return RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_VIDEO_MEM_USED)


func _remove(field: PlantField3D) -> void:
	field.free()
	for frame in DRAWN_FRAMES:
		await process_frame


## Resident memory of this process; only Linux reports it.
func _resident_bytes() -> float:
	var file := FileAccess.open("/proc/self/statm", FileAccess.READ)
	return float(file.get_line().get_slice(" ", 1)) * BYTES_PER_PAGE if file else 0.0


## Returns the main thread's processor time (µs) of each of the next frames.
func _main_usec(count: int) -> Array[float]:
	var times: Array[float] = []
	for i in count:
		var before := ProcessorTime.of_main_thread()
		var start := Time.get_ticks_usec()
		await process_frame
		# The kernel counts a thread's time when the thread sleeps.
		OS.delay_usec(maxi(start + FRAME_USEC - Time.get_ticks_usec(), MIN_SLEEP_USEC))
		times.append(ProcessorTime.of_main_thread() - before)
	return times


func _percentile(times: Array[float], part: float) -> float:
	var sorted := times.duplicate()
	sorted.sort()
	return sorted[mini(int(part * sorted.size()), sorted.size() - 1)]
