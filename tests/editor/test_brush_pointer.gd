@tool
extends "brush_test.gd"
## The cost of the brush while the pointer moves, and strokes interrupted by another scene.

const BrushGround := preload("res://addons/undergrowth/editor/brush/brush_ground.gd")
const OTHER_FILE := "res://brush_other_scene.tscn"
## Rays of the circle, and one through the pointer.
const MAX_RAYS := 25
const MOVES := 60
const SERIES := 7
## Processor time of a move, in milliseconds.
const BRUSH_SCRIPT := "res://addons/undergrowth/editor/brush/field_brush.gd"


func test_a_frame_casts_one_set_of_rays_however_often_the_pointer_moves() -> void:
	var field := await _edited_field()
	await _choose_tool("Paint")
	var at := _in_window(_view(), _place_of(field, Vector3.ZERO))
	await _point(_view(), at)
	await frames(2)
	var before := BrushGround.ray_count
	for i in 10:
		_move(_view(), at + Vector2(i, 0), at + Vector2(i + 1, 0), 0)
	await frames(2)
	var rays := BrushGround.ray_count - before
	check(rays > 1 and rays <= MAX_RAYS, "%d rays of 10 moves in a frame" % rays)
	before = BrushGround.ray_count
	for i in 5:
		_move(_view(), at + Vector2(10, 0), at + Vector2(10, 0), 0)
		await frames(2)
	check_equal(BrushGround.ray_count - before, 0, "rays in the same pixel")
	(_settings().get_node("%Radius") as EditorSpinSlider).value = 1.0
	_move(_view(), at + Vector2(10, 0), at + Vector2(10, 0), 0)
	await frames(2)
	check_equal(BrushGround.ray_count - before, MAX_RAYS - 1, "rays of another radius")
	await _choose_tool("Paint")


func test_a_stroke_casts_one_set_of_rays_a_frame() -> void:
	var field := await _edited_field()
	await _choose_tool("Erase")
	var from := _in_window(_view(), _place_of(field, Vector3(0, 0, -1)))
	var to := _in_window(_view(), _place_of(field, Vector3(0, 0, 1)))
	await _point(_view(), from)
	_press(_view(), from, MOUSE_BUTTON_LEFT, true)
	await frames(2)
	var before := BrushGround.ray_count
	for i in 10:
		_move(_view(), from.lerp(to, 0.1 * i), from.lerp(to, 0.1 * i + 0.1), 1)
	await frames(1)
	var rays := BrushGround.ray_count - before
	check(rays > 1 and rays <= MAX_RAYS, "%d rays of 10 moves in a frame" % rays)
	check(field.map.get_density(Vector3(0, 0, 0.8), GRASS) < 0.9, "the stroke follows in a frame")
	_move(_view(), to, from, 1)
	_press(_view(), from, MOUSE_BUTTON_LEFT, false)
	check(field.map.get_density(Vector3.ZERO, GRASS) < 0.4, "the last move of a stroke counts")
	await frames(2)
	await _choose_tool("Erase")


func test_a_move_over_a_large_mesh_casts_few_rays() -> void:
	var field := await _edited_field()
	var hill := MeshInstance3D.new()
	hill.mesh = _make_hill()
	_put(field.get_parent(), hill)
	var at := _in_window(_view(), _place_of(field, Vector3.ZERO))
	await _point(_view(), at)
	await frames(5)
	var bare := await _measure_moves(at)
	await _choose_tool("Paint")
	await _point(_view(), at)
	await frames(5)
	var before := BrushGround.ray_count
	var taken := await _measure_moves(at)
	var rays := BrushGround.ray_count - before
	print("brush: %d moves, %d rays, %.2f ms a move" % [MOVES * SERIES, rays, taken])
	print("brush: %.2f ms a move without a tool" % bare)
	var moves := MOVES * SERIES
	check(rays > moves and rays <= MAX_RAYS * moves, "%d rays" % rays)
	await _choose_tool("Paint")


func test_many_rays_find_the_ground_of_single_ones() -> void:
	var field := await _edited_field()
	var hill := MeshInstance3D.new()
	hill.mesh = _make_hill()
	hill.position.y = 0.3
	_put(field.get_parent(), hill)
	await frames(2)
	var tops := PackedVector3Array(
		[Vector3(0.3, 2, 0.4), Vector3(5.1, 2, -3.7), Vector3(300, 2, 0), Vector3(1, -1, 0)]
	)
	var places := BrushGround.find_below(field, tops, 4.0)
	for i in 2:
		var single: Vector3 = BrushGround.find(
			field, tops[i], Vector3.DOWN, Plane(Vector3.UP, -9.0)
		)
		check(places[i].is_equal_approx(single), "%s and %s" % [places[i], single])
		check(absf(places[i].y) > 0.01, "on the hill: %s" % places[i])
	check_equal(places[2], Vector3.INF, "beside all meshes")
	check_equal(places[3], Vector3.INF, "below all meshes")


func test_a_stroke_that_another_scene_interrupts_is_one_step_of_undo() -> void:
	var other := Node3D.new()
	other.name = "Other"
	_put(other, Node3D.new())
	await _open(OTHER_FILE, other)
	var field := await _edited_field()
	await _choose_tool("Erase")
	var count := field.get_plant_count()
	var version := _history().get_version()
	var from := _in_window(_view(), _place_of(field, Vector3(0, 0, -1)))
	var to := _in_window(_view(), _place_of(field, Vector3(0, 0, 1)))
	await _point(_view(), from)
	_press(_view(), from, MOUSE_BUTTON_LEFT, true)
	_move(_view(), from, to, MOUSE_BUTTON_MASK_LEFT)
	await frames(2)
	check(field.map != null, "the stroke has begun")
	EditorInterface.open_scene_from_path(OTHER_FILE)
	await frames(10)
	check_equal(EditorInterface.get_edited_scene_root().name, &"Other", "the scene that is open")
	_press(_view(), to, MOUSE_BUTTON_LEFT, false)
	EditorInterface.open_scene_from_path(FIELD_FILE)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	check_equal(_history().get_version(), version + 1, "steps of undo")
	check_equal(_history().get_current_action_name(), tr("Erase Plants"), "its name")
	await _choose_only(field)
	await _rested(field)
	check(field.get_plant_count() < count, "%d of %d plants" % [field.get_plant_count(), count])
	await undo()
	await _rested(field)
	check(field.map == null, "it has no map after undo")
	check_equal(field.get_plant_count(), count, "plants after undo")


# 12,800 triangles.
func _make_hill() -> ArrayMesh:
	var plane := PlaneMesh.new()
	plane.size = Vector2(80, 80)
	plane.subdivide_width = 79
	plane.subdivide_depth = 79
	var arrays := plane.get_mesh_arrays()
	var corners: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	for i in corners.size():
		corners[i].y = 0.2 * sin(0.3 * corners[i].x) * cos(0.25 * corners[i].z) - 0.2
	arrays[Mesh.ARRAY_VERTEX] = corners
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


# Returns the median of several series: processor time of a move in milliseconds, which is its event
# and what the brush does in the next frame because of it. The system counts that time in steps of
# some milliseconds, so that a single move is too short to be measured.
func _measure_moves(at: Vector2) -> float:
	var times: Array[float] = []
	for series in SERIES:
		var begin := _processor_msec()
		for i in MOVES:
			_move(_view(), at + Vector2(i, 0), at + Vector2(i + 1, 0), 0)
			_run_frame_of_brush()
		times.append((_processor_msec() - begin) / MOVES)
		await frames(1)
	times.sort()
	return times[SERIES / 2]


func _run_frame_of_brush() -> void:
	var signal_of_frame := EditorInterface.get_base_control().get_tree().process_frame
	for connection in signal_of_frame.get_connections():
		var due: Callable = connection["callable"]
		var object := due.get_object()
		var script := object.get_script() as Script if object else null
		if script and script.resource_path == BRUSH_SCRIPT:
			signal_of_frame.disconnect(due)
			due.call()


# Processor time of this thread. Other systems than Linux have no such file; the clock serves there.
static func _processor_msec() -> float:
	var file := FileAccess.open("/proc/thread-self/schedstat", FileAccess.READ)
	return file.get_line().to_float() * 1e-6 if file else Time.get_ticks_usec() * 1e-3
