## Measures the graphics card's time for the scene of scene_bench.gd at 1920 x 1080; prints a JSON
## list of rows.
##
## The argument after `--` is the number of plants; 0 measures single meshes instead. With a
## software renderer it prints an empty list.
##
## gpu_ms and gpu_p99_ms are the card's time for a frame, and render_ms the main thread's for the
## viewport. frame_ms is the time of a frame on the clock. Rows named scene_card are of the scene.
## "drawn" is "full" (four shadow splits), "msaa" (full, MSAA 4x), "unshadowed", or "vertices"
## (full, at a tenth of the resolution, so that pixels cost little). Rows with 0 plants are of the
## empty scene. Rows named card_SHADER are of one mesh in many instances without shadows, at a
## tenth of the resolution.
extends "res://tests/bench/gpu_bench.gd"

const VERTICES := 4_000_000
const TIMED_FRAMES := 120
const FRAMES_WITHOUT_CHANGE := 60
const MAX_WAIT_MSEC := 15_000
const SHADOW_SIZE := 4096  # Pixels.


func _run() -> void:
	if RenderingServer.get_video_adapter_name().contains("llvmpipe"):
		print("[]")
		quit()
		return
	root.size = SCREEN
	RenderingServer.viewport_set_measure_render_time(root.get_viewport_rid(), true)
	_add_surroundings()
	RenderingServer.directional_shadow_atlas_set_size(SHADOW_SIZE, true)
	_camera.position = Vector3(0.0, EYE_HEIGHT, 10.0)
	var count := int(OS.get_cmdline_user_args()[0])
	if count == 0:
		await _measure_meshes()
	await _measure_scene(0)
	if count > 0:
		var field := _add_field(count)
		await _build(field)
		await _measure_scene(field.get_plant_count())
	print(JSON.stringify(_rows))
	quit()


func _measure_meshes() -> void:
	_sun.shadow_enabled = false
	var materials := _materials()
	for name in materials:
		await _measure_alone(name, materials[name])


func _measure_alone(name: String, material: Material) -> void:
	var mesh := (load(SPECIES) as PlantFunction).generate_mesh(0.0, SEGMENTS)
	var instances := ceili(float(VERTICES) / mesh.surface_get_array_len(0))
	var node := _add_alone(material, instances)
	var row := await _time()
	row["name"] = "card_" + name
	row["vertices"] = mesh.surface_get_array_len(0) * instances
	_rows.append(row)
	node.free()


## Adds a row for each way to draw the scene.
func _measure_scene(plants: int) -> void:
	for way: String in ["full", "msaa", "unshadowed", "vertices"]:
		_sun.shadow_enabled = way != "unshadowed"
		root.scaling_3d_scale = SCALE if way == "vertices" else 1.0
		root.msaa_3d = Viewport.MSAA_4X if way == "msaa" else Viewport.MSAA_DISABLED
		var row := await _time()
		row["name"] = "scene_card"
		row["plants"] = plants
		row["drawn"] = way
		row["primitives"] = _drawn(Viewport.RENDER_INFO_TYPE_VISIBLE, true)
		row["shadow_primitives"] = _drawn(Viewport.RENDER_INFO_TYPE_SHADOW, true)
		_rows.append(row)


## Returns the times of the present picture.
func _time() -> Dictionary:
	await _settle()
	var viewport := root.get_viewport_rid()
	var gpu: Array[float] = []
	var render: Array[float] = []
	var start := Time.get_ticks_usec()
	for frame in TIMED_FRAMES:
		await RenderingServer.frame_post_draw
		gpu.append(RenderingServer.viewport_get_measured_render_time_gpu(viewport))
		render.append(RenderingServer.viewport_get_measured_render_time_cpu(viewport))
	return {
		"renderer": RenderingServer.get_current_rendering_method(),
		"adapter": RenderingServer.get_video_adapter_name(),
		"pixels": "%dx%d" % [root.size.x, root.size.y],
		"gpu_ms": _percentile(gpu, 0.5),
		"gpu_p99_ms": _percentile(gpu, 0.99),
		"render_ms": _percentile(render, 0.5),
		"frame_ms": (Time.get_ticks_usec() - start) / 1000.0 / TIMED_FRAMES,
	}


func _settle() -> void:
	var steady := 0
	var last := -1
	var end := Time.get_ticks_msec() + MAX_WAIT_MSEC
	while steady < FRAMES_WITHOUT_CHANGE and Time.get_ticks_msec() < end:
		await process_frame
		var compiled := _compiled_pipelines()
		steady = steady + 1 if compiled == last else 0
		last = compiled
