## Measures the cost of changes to fields during a game, and prints a JSON list of rows.
##
## Run headless with --fixed-fps 60. Frames last a sixtieth of a second, with the wait at their end,
## so that worker threads have the same time as in a game. Changes happen between two frames, as by
## the mouse. median_ms and worst_ms are processor time of the main thread: that of the call, or
## that of the build in a frame. For strokes it is the larger one. For rows with the suffix _seen it
## is the time until the end of the frame that shows the change. For field_tiles it is the time
## until all tiles are built, and workers_us_per_plant is the processor time to place and build
## them.
extends SceneTree

signal frame_over

const ProcessorTime := preload("res://tests/bench/processor_time.gd")
const COUNT := 100000
const DENSITY := 10.0
const CUT_COUNT := 250000
const CUT_DENSITY := 25.0
const ROUNDS := 20
const FIELDS := 30
const WALK_DENSITY := 20.0
const WALK_DISTANCE := 100.0  # m, view distance.
const WALK_SPEED := 10.0  # m/s.
const WALK_FRAMES := 900
const FRAME_USEC := 16667

var _rows: Array[Dictionary] = []
var _last_frame := 0  # µs, start of the frame.


func _initialize() -> void:
	_run()


func _run() -> void:
	await _measure_strokes()
	await _measure_density()
	await _measure_cuts()
	await _measure_fields()
	await _measure_walk()
	print(JSON.stringify(_rows))
	quit()


func _make_field(count: int, density: float) -> PlantField3D:
	var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()], [9, 1])
	field.density = density
	field.size = Vector2.ONE * sqrt(count / density)
	field.wind = PlantWind.new()
	return field


func _physics_process(_delta: float) -> bool:
	OS.delay_usec(maxi(_last_frame + FRAME_USEC - Time.get_ticks_usec(), 0))
	_last_frame = Time.get_ticks_usec()
	frame_over.emit()
	return false


func _rest(frames := 60) -> void:
	for i in frames:
		await frame_over


func _measure_strokes() -> void:
	var field := _make_field(COUNT, DENSITY)
	var side := field.size.x
	var frame := PackedVector3Array(
		[
			Vector3(-side, 0, -side) / 2.0,
			Vector3(side, 0, -side) / 2.0,
			Vector3(side, 0, side) / 2.0,
			Vector3(-side, 0, side) / 2.0
		]
	)
	field.map = PlantMap.new()
	field.map.fill_polygon(frame, "Grass", 0.8)
	root.add_child(field)
	await field.build_finished
	await _rest()
	var main: Array[float] = []
	var seen: Array[float] = []
	for i in ROUNDS:
		var place := Vector3(i - 0.5 * ROUNDS, 0, 3.0)
		var start := Time.get_ticks_usec()
		field.map.paint(place, 3.0, "Grass", 1.0 if i % 2 == 0 else 0.5)
		var longest := float(Time.get_ticks_usec() - start)
		while field.is_building():
			await frame_over
			longest = maxf(longest, field.get_statistics()["build_usec"])
		seen.append(Time.get_ticks_usec() - start)
		main.append(longest)
	_add_row("field_stroke", field.get_plant_count(), main)
	_add_row("field_stroke_seen", field.get_plant_count(), seen)
	field.free()
	await frame_over


## Replaces all plants, or restores all of them.
func _measure_density() -> void:
	var field := _make_field(COUNT, DENSITY)
	root.add_child(field)
	await field.build_finished
	await _rest()
	var others: Array[float] = []
	var same: Array[float] = []
	for i in ROUNDS / 4:
		field.density = DENSITY * (1.0 if i % 2 == 1 else 0.98)
		others.append_array(await _filling(field))
		field.clump_size = 3.5 if i % 2 == 0 else 3.0
		same.append_array(await _filling(field))
	_add_row("field_density", field.get_plant_count(), others)
	_add_row("field_preserved", field.get_plant_count(), same)
	field.free()
	await frame_over


## Returns the time of the build in each frame, µs, until all old plants are replaced.
func _filling(field: PlantField3D) -> Array[float]:
	var usec: Array[float] = []
	await frame_over
	while field.is_building():
		usec.append(field.get_statistics()["build_usec"])
		await frame_over
	for i in 30:
		usec.append(field.get_statistics()["build_usec"])
		await frame_over
	return usec


func _measure_cuts() -> void:
	var field := _make_field(CUT_COUNT, CUT_DENSITY)
	root.add_child(field)
	await field.build_finished
	await _rest()
	var count := field.get_plant_count()
	var cut: Array[float] = []
	var mown: Array[float] = []
	for i in ROUNDS:
		var place := Vector3(9.0 * (i % 10) - 45.0, 0, 12.0 * (i / 10) - 40.0)
		var start := Time.get_ticks_usec()
		field.remove_in_sphere(place, 2.52)  # 500 plants.
		cut.append(Time.get_ticks_usec() - start)
		await frame_over
		start = Time.get_ticks_usec()
		field.set_height_in_sphere(place + Vector3(0, 0, 6), 2.52, 0.05)
		mown.append(Time.get_ticks_usec() - start)
		await frame_over
	_add_row("field_cut_500", count, cut)
	_add_row("field_mow_500", count, mown)
	field.free()
	await frame_over


func _measure_fields() -> void:
	var usec: Array[float] = []
	for i in FIELDS:
		var field := _make_field(1000, DENSITY)
		root.add_child(field)
		for j in 30:
			await frame_over
			usec.append(field.get_statistics()["build_usec"])
		var start := Time.get_ticks_usec()
		field.free()
		usec.append(Time.get_ticks_usec() - start)
		await frame_over
	_add_row("fields_added_and_removed", 1000, usec)


func _measure_walk() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	var field := _make_field(1, WALK_DENSITY)
	field.endless = true
	field.view_distance = WALK_DISTANCE
	root.add_child(field)
	await field.build_finished
	await _rest()
	var usec: Array[float] = []
	for i in WALK_FRAMES:
		camera.position.x += WALK_SPEED / 60.0
		await frame_over
		usec.append(field.get_statistics()["build_usec"])
	_add_row("field_walk", field.get_plant_count(), usec)
	field.simulation_enabled = false  # Without simulation, workers only place and build tiles.
	camera.position.x += 10.0 * WALK_DISTANCE
	await frame_over
	var start := Time.get_ticks_usec()
	var before := ProcessorTime.spent().y
	for i in 20:
		await frame_over
	while field.get_statistics()["tiles_waiting"] > 0:
		await frame_over
	var workers := ProcessorTime.spent().y - before
	_add_row("field_tiles", field.get_plant_count(), [float(Time.get_ticks_usec() - start)])
	if workers > 0.0:
		_rows[-1]["workers_us_per_plant"] = workers / field.get_plant_count()
	field.free()
	camera.free()
	await frame_over


func _add_row(title: String, count: int, usec: Array[float]) -> void:
	usec.sort()
	var median := usec[usec.size() / 2]
	_rows.append(
		{
			"name": title,
			"plants": count,
			"threads": OS.get_processor_count(),
			"median_ms": median / 1000.0,
			"worst_ms": usec[-1] / 1000.0,
			"us_per_plant": median / count,
			"renderer": "headless"
		}
	)
