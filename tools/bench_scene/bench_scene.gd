## Draws one scene along one camera path and writes figures as JSON, and one picture.
##
## Arguments after `--`: --out=FILE.json, --picture=FILE.png, --plants=N, --frames=N, --size=WxH,
## and --other=NAME for the plants of another add-on (other_plants.gd).
##
## The scene is what ships: the mix meadow.tscn on its ground, with sun and sky, in a wind of
## 9.3 m/s. The path depends on the number of plants only, since the field's side does. README.md
## lists the figures. A figure that the machine does not have is null.
extends SceneTree

const OtherPlants := preload("other_plants.gd")
const MIX := "res://addons/undergrowth/mixes/meadow.tscn"
const WIND := "res://addons/undergrowth/winds/fresh.tres"
const DAY := "res://addons/undergrowth/environments/day.tscn"
const GROUND_MATERIAL := "res://addons/undergrowth/grounds/meadow.tres"
const GROUND_SCRIPT := "res://addons/undergrowth/grounds/ground_3d.gd"
const GROUND_SIDE := 2000.0  # m
## Camera positions: x and z in sides of the field, y in metres.
const PLACES: Array[Vector3] = [
	Vector3(0.0, 1.6, 0.55),
	Vector3(0.0, 1.6, 0.25),
	Vector3(0.1, 0.5, 0.1),
	Vector3(0.3, 2.0, -0.05),
	Vector3(0.2, 9.0, -0.4),
	Vector3(-0.3, 3.0, -0.2),
	Vector3(-0.35, 1.6, 0.3),
]
## Points that the camera looks at, in the same units.
const TARGETS: Array[Vector3] = [
	Vector3(0.0, 0.8, 0.0),
	Vector3(0.0, 0.6, -0.1),
	Vector3(0.2, 0.4, -0.1),
	Vector3(0.2, 0.3, -0.4),
	Vector3(0.0, 0.3, 0.0),
	Vector3(0.0, 0.3, 0.1),
	Vector3(0.3, 0.8, 0.0),
]
const WARM_UP_PLACES := 12
const SETTLING_FRAMES := 12
const MAX_FRAMES := 100_000
const FILL_SCALE := 0.1
const BYTES_PER_PAGE := 4096
const MSEC_PER_TICK := 10.0  # Of /proc/self/stat.

var _options := {
	"out": "", "picture": "", "plants": "20000", "frames": "600", "size": "1920x1080", "other": ""
}
var _camera: Camera3D
var _field: PlantField3D
var _side := 0.0
var _process_start := 0
var _main_usec := 0


func _initialize() -> void:
	for argument in OS.get_cmdline_user_args():
		var words := argument.trim_prefix("--").split("=", true, 1)
		if words.size() != 2 or not words[0] in _options:
			printerr("bench_scene.gd does not have the option %s" % argument)
			quit(1)
			return
		_options[words[0]] = words[1]
	_run.call_deferred()


func _run() -> void:
	var size: PackedStringArray = _options["size"].split("x")
	root.size = Vector2i(int(size[0]), int(size[-1]))
	RenderingServer.viewport_set_measure_render_time(root.get_viewport_rid(), true)
	_add_surroundings()
	await _draw(SETTLING_FRAMES)
	var resident := _resident_bytes()
	var video := _video_bytes()
	var start := Time.get_ticks_usec()
	var plants := await _add_plants()
	var build_ms := (Time.get_ticks_usec() - start) / 1000.0
	# After the field's own connection, so that its work before the drawing counts.
	process_frame.connect(func() -> void: _process_start = Time.get_ticks_usec())
	RenderingServer.frame_pre_draw.connect(
		func() -> void: _main_usec = Time.get_ticks_usec() - _process_start
	)
	await _warm_up()
	var figures := await _measure()
	figures["build_ms"] = build_ms
	figures["video_mb"] = _video_bytes() / 1e6
	figures["plants_video_mb"] = (_video_bytes() - video) / 1e6
	figures["resident_mb"] = _resident_bytes() / 1e6 if resident > 0.0 else null
	figures["plants_resident_mb"] = (
		(_resident_bytes() - resident) / 1e6 if resident > 0.0 else null
	)
	figures["fill_ms"] = await _measure_fill(figures)
	if not await _take_picture() or not _write(plants, figures):
		quit(1)
		return
	quit()


func _add_surroundings() -> void:
	root.add_child((load(DAY) as PackedScene).instantiate())
	_camera = Camera3D.new()
	_camera.far = 4000.0
	root.add_child(_camera)
	_field = (load(MIX) as PackedScene).instantiate()
	_side = sqrt(int(_options["plants"]) / _field.density)
	_field.size = Vector2.ONE * _side
	_field.wind = load(WIND)
	var plane := PlaneMesh.new()
	plane.size = Vector2.ONE * GROUND_SIDE
	plane.material = load(GROUND_MATERIAL)
	var ground := MeshInstance3D.new()
	ground.mesh = plane
	ground.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	ground.set_script(load(GROUND_SCRIPT))
	ground.set(&"field", _field)
	root.add_child(ground)
	_place(0.0)


## Adds the field, or in its place plants of another add-on; returns their number.
func _add_plants() -> int:
	if _options["other"]:
		var others := OtherPlants.make(_options["other"], int(_options["plants"]), _side)
		root.add_child(others)
		_field.free()
		await _draw(SETTLING_FRAMES)
		return int(_options["plants"])
	root.disable_3d = not _has_card()  # A software renderer would delay the build.
	root.add_child(_field)
	for frame in MAX_FRAMES:
		await process_frame
		if _field.get_plant_count() > 0 and not _field.is_building():
			break
	root.disable_3d = false
	return _field.get_plant_count()


## Draws views of the whole path until their shaders are compiled.
func _warm_up() -> void:
	for i in WARM_UP_PLACES:
		_place(float(i) / (WARM_UP_PLACES - 1))
		await _draw(1)
	_place(0.0)
	await _draw(SETTLING_FRAMES)


func _measure() -> Dictionary:
	var viewport := root.get_viewport_rid()
	var times: Dictionary[String, Array] = {}
	for name: String in [
		"frame",
		"main",
		"render",
		"gpu",
		"draw_calls",
		"shadow_draw_calls",
		"primitives",
		"shadow_primitives"
	]:
		times[name] = []
	var processor := _processor_msec()
	var last := Time.get_ticks_usec()
	var frames := int(_options["frames"])
	for frame in frames:
		_place(float(frame) / maxi(frames - 1, 1))
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		times["frame"].append((now - last) / 1000.0)
		last = now
		times["main"].append(_main_usec / 1000.0)
		times["render"].append(
			(
				RenderingServer.viewport_get_measured_render_time_cpu(viewport)
				+ RenderingServer.get_frame_setup_time_cpu()
			)
		)
		times["gpu"].append(RenderingServer.viewport_get_measured_render_time_gpu(viewport))
		times["draw_calls"].append(_drawn(Viewport.RENDER_INFO_TYPE_VISIBLE, false))
		times["shadow_draw_calls"].append(_drawn(Viewport.RENDER_INFO_TYPE_SHADOW, false))
		times["primitives"].append(_drawn(Viewport.RENDER_INFO_TYPE_VISIBLE, true))
		times["shadow_primitives"].append(_drawn(Viewport.RENDER_INFO_TYPE_SHADOW, true))
	var figures := {}
	for name: String in ["frame", "main", "render", "gpu"]:
		var is_measured := name != "gpu" or _has_card()
		figures[name + "_p50_ms"] = _percentile(times[name], 0.5) if is_measured else null
		figures[name + "_p99_ms"] = _percentile(times[name], 0.99) if is_measured else null
		figures[name + "_worst_ms"] = _percentile(times[name], 1.0) if is_measured else null
	for name: String in ["draw_calls", "shadow_draw_calls", "primitives", "shadow_primitives"]:
		figures[name] = _percentile(times[name], 0.5)
		figures["max_" + name] = _percentile(times[name], 1.0)
	var spent := _processor_msec() - processor
	figures["processor_ms"] = spent / frames if processor > 0.0 else null
	return figures


## Returns the time that a tenth of the pixels in width and height saves in the median frame: of
## the card, or without one of the frame.
func _measure_fill(figures: Dictionary) -> float:
	var kind := "gpu_p50_ms" if _has_card() else "frame_p50_ms"
	root.scaling_3d_scale = FILL_SCALE
	await _draw(SETTLING_FRAMES)
	var coarse := await _measure()
	root.scaling_3d_scale = 1.0
	return figures[kind] - coarse[kind]


## Four views of the path in one picture.
func _take_picture() -> bool:
	var half := root.size / 2
	var picture := Image.create_empty(2 * half.x, 2 * half.y, false, Image.FORMAT_RGB8)
	for i in 4:
		_place(i / 3.0)
		await _draw(2)
		var view := root.get_texture().get_image()
		view.convert(Image.FORMAT_RGB8)
		view.resize(half.x, half.y, Image.INTERPOLATE_LANCZOS)
		picture.blit_rect(view, Rect2i(Vector2i.ZERO, half), Vector2i(i % 2, i / 2) * half)
	return picture.save_png(_options["picture"]) == OK


func _write(plants: int, figures: Dictionary) -> bool:
	var report := {
		"scene":
		{
			"plants": plants,
			"kind": _options["other"] if _options["other"] else "undergrowth",
			"side_m": _side,
			"frames": int(_options["frames"]),
			"pixels": "%dx%d" % [root.size.x, root.size.y],
		},
		"machine":
		{
			"engine": Engine.get_version_info()["string"],
			"is_debug": OS.is_debug_build(),
			"renderer": RenderingServer.get_current_rendering_method(),
			"driver": RenderingServer.get_current_rendering_driver_name(),
			"adapter": RenderingServer.get_video_adapter_name(),
			"api": RenderingServer.get_video_adapter_api_version(),
			"system": OS.get_name(),
			"processor": OS.get_processor_name(),
			"processors": OS.get_processor_count(),
		},
		"figures": figures,
	}
	var file := FileAccess.open(_options["out"], FileAccess.WRITE)
	return file != null and file.store_string(JSON.stringify(report, "\t") + "\n")


## Puts the camera at a part of the path, from 0 to 1.
func _place(part: float) -> void:
	_camera.look_at_from_position(_along(PLACES, part), _along(TARGETS, part))


func _along(points: Array[Vector3], part: float) -> Vector3:
	var at := part * (points.size() - 1)
	var i := mini(int(at), points.size() - 2)
	var before := points[maxi(i - 1, 0)]
	var after := points[mini(i + 2, points.size() - 1)]
	var place := points[i].cubic_interpolate(points[i + 1], before, after, at - i)
	return place * Vector3(_side, 1.0, _side)


func _draw(frames: int) -> void:
	for frame in frames:
		await RenderingServer.frame_post_draw


func _drawn(pass_type: Viewport.RenderInfoType, primitives: bool) -> int:
	var what := Viewport.RENDER_INFO_DRAW_CALLS_IN_FRAME
	if primitives:
		what = Viewport.RENDER_INFO_PRIMITIVES_IN_FRAME
	return root.get_render_info(pass_type, what)


func _has_card() -> bool:
	var adapter := RenderingServer.get_video_adapter_name().to_lower()
	return not (
		RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU
		or adapter.contains("llvmpipe")
		or adapter.contains("softpipe")
	)


func _video_bytes() -> float:
	return RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_VIDEO_MEM_USED)


## Resident memory of this process; only Linux reports it.
func _resident_bytes() -> float:
	var file := FileAccess.open("/proc/self/statm", FileAccess.READ)
	return float(file.get_line().get_slice(" ", 1)) * BYTES_PER_PAGE if file else 0.0


## Processor time of all threads of this process; only Linux reports it.
func _processor_msec() -> float:
	var file := FileAccess.open("/proc/self/stat", FileAccess.READ)
	if file == null:
		return 0.0
	var values := file.get_line().get_slice(") ", 1).split(" ")  # From the third value on.
	return (float(values[11]) + float(values[12])) * MSEC_PER_TICK


func _percentile(values: Array, part: float) -> float:
	var sorted := values.duplicate()
	sorted.sort()
	return sorted[mini(int(part * sorted.size()), sorted.size() - 1)]
