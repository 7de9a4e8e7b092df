@tool
extends "editor_test.gd"
## Values that graphs, dials, curves and small cameras of the editor show, without a scene.

const DirectionDial := preload("res://addons/undergrowth/editor/widgets/direction_dial.gd")
const ForceGraph := preload("res://addons/undergrowth/editor/widgets/force_graph.gd")
const OrbitCamera := preload("res://addons/undergrowth/editor/inspector/orbit_camera.gd")
const PlantGroup := preload("res://addons/undergrowth/editor/widgets/plant_group.gd")
const PreviewOverlay := preload("res://addons/undergrowth/editor/inspector/preview_overlay.gd")
const ProfilePlot := preload("res://addons/undergrowth/editor/widgets/profile_plot.gd")
const ProfilePoints := preload("res://addons/undergrowth/editor/widgets/profile_points.gd")
const WindMap := preload("res://addons/undergrowth/editor/widgets/wind_map.gd")
const WindSpectrum := preload("res://addons/undergrowth/editor/widgets/wind_spectrum.gd")


func test_the_axis_of_a_graph_ends_at_a_round_number_above_the_wind() -> void:
	var graph := ForceGraph.new()
	graph.wind = PlantWind.new()
	graph.wind.kind = PlantWind.KIND_CONSTANT
	graph.wind.strength = 0.3
	check_near(graph._axis_end([]), 0.4, "a constant force of 0.3 N")
	check_near(graph._axis_end([0.1, 4.95]), 6.0, "a force above it")
	graph.wind.kind = PlantWind.KIND_WAVES
	check_near(graph._axis_end([0.3]), 0.8, "waves of 0.3 N, which reach twice as much")
	graph.wind.kind = PlantWind.KIND_AIR
	check_near(graph._axis_end([7.0, 9.0]), 10.0, "air of 9 m/s")
	check_near(graph._axis_end([10.0]), 12.5, "air of 10 m/s")
	graph.free()


func test_a_graph_shows_the_wind_at_its_time() -> void:
	var graph := ForceGraph.new()
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_WAVES
	wind.strength = 0.5
	graph.wind = wind
	check_near(graph._start, -1.2, "start of the first page")
	wind.advance(4.0)
	graph._turn_page()
	check_near(graph._start, -1.2, "the page at 4 s")
	wind.advance(0.5)
	graph._turn_page()
	check_near(graph._start, 4.5 - 1.2, "the page at 4.5 s")
	check_near(graph.get_now(), 4.5, "the mark")
	var forces: PackedFloat32Array = graph._sample()
	check_equal(forces.size(), 481, "samples")
	for i: int in [0, 100, 480]:
		var time: float = graph._start + 8.0 * i / 480.0
		check_near(forces[i], wind.sample(time).length(), "force at %f s" % time)
	wind.kind = PlantWind.KIND_AIR
	graph._turn_page()
	check_near(graph._start, 4.5 - 59.0, "a minute of air ends one second after the mark")
	forces = graph._sample()
	var speed := wind.sample_velocity(graph._start + 30.0, Vector3(0, 10, 0)).length()
	check_near(forces[80], speed, "speed in the middle")
	graph.free()


func test_the_map_of_a_wind_is_written_row_by_row() -> void:
	var map := WindMap.new()
	map.wind = PlantWind.new()
	check(map.get_speeds().is_empty(), "a force has no map")
	map.wind.kind = PlantWind.KIND_AIR
	map.wind.speed = 6.0
	var step := WindMap.SPAN / WindMap.SIDE
	var corner := -0.5 * (WindMap.SPAN - step)
	var places: PackedVector2Array = [
		Vector2(corner, corner), Vector2(corner + step, corner), Vector2(corner, corner + step)
	]
	var wanted := map.wind.sample_over_canopy(map.wind.get_time(), places)
	var speeds := map.get_speeds()
	for i in 3:
		var index: int = [0, 1, WindMap.SIDE][i]
		check_near(speeds[index], wanted[i].length(), "speed at %s" % places[i])
	map.free()


func test_the_line_of_a_spectrum_is_kaimals() -> void:
	var graph := WindSpectrum.new()
	graph.wind = PlantWind.new()
	graph.wind.kind = PlantWind.KIND_AIR
	graph.wind.speed = 8.0
	graph.wind.roughness = 0.03
	var carried := 8.0 * log(1.0 / 0.03) / log(10.0 / 0.03)
	var peak := 0.0
	var highest := 0.0
	for i in 400:
		var hertz := 0.01 * pow(1.02, i)
		if graph.kaimal(hertz) > highest:
			highest = graph.kaimal(hertz)
			peak = hertz
	# The derivative of f / (1 + 33 f)^(5/3) is zero at f = 1 / 22.
	check(absf(peak / (carried / 22.0) - 1.0) < 0.03, "frequency of the peak: %f" % peak)
	var wanted := 105.0 / 22.0 / pow(2.5, 5.0 / 3.0) / (2.185 * 2.185)
	check(absf(highest / wanted - 1.0) < 0.01, "its height: %f" % highest)
	graph.free()


func test_a_dial_describes_its_direction() -> void:
	var dial := DirectionDial.new()
	var wanted: Dictionary[float, String] = {
		0.0: "+z", 46.0: "+x +z", 90.0: "+x", 180.0: "−z", 270.0: "−x", 338.0: "+z"
	}
	for angle in wanted:
		dial.degrees = angle
		check(dial.describe().ends_with(" " + wanted[angle]), dial.describe())
	dial.degrees = -90.0
	check_equal(dial.degrees, 270.0, "a negative direction")
	dial.free()


func test_points_of_a_width_curve_are_where_they_are_drawn() -> void:
	var points := ProfilePoints.new()
	points.size = Vector2(200, 80)
	var function := CurvePlantFunction.new()
	function.width_curve = Curve.new()
	function.width_curve.max_value = 0.02
	function.width_curve.add_point(Vector2(0.25, 0.005))
	function.width_curve.add_point(Vector2(1.0, 0.0))
	points.edit(function)
	check_equal(points._to_place(Vector2(0.25, 0.005)), Vector2(50, 30), "place of a point")
	check(points._to_point(Vector2(50, 30)).is_equal_approx(Vector2(0.25, 0.005)), "and back")
	check(points._to_point(Vector2(300, -10)).is_equal_approx(Vector2(1.0, 0.02)), "beyond the end")
	check(points._to_point(Vector2(-5, 70)).is_equal_approx(Vector2(0.0, 0.0)), "below the middle")
	check_equal(points._find_point(Vector2(52, 31)), 0, "the point under the pointer")
	check_equal(points._find_point(Vector2(100, 20)), -1, "no point there")
	points.free()


func test_an_outline_has_the_widths_of_its_species_without_steps() -> void:
	var plot := ProfilePlot.new()
	var function := CurvePlantFunction.new()
	function.width_curve = Curve.new()
	function.width_curve.add_point(Vector2(0.0, 1.0))
	function.width_curve.add_point(Vector2(1.0, 0.0))
	plot.setup(function, EditorInterface.get_editor_undo_redo())
	var area := Rect2(10, 20, 128, 40)
	for i in ProfilePlot.SAMPLES:
		var piece := plot.get_piece(i, area)
		check_near(piece[0].x, 10.0 + 2.0 * i, "left end")
		var width := function.calculate_curve_point(float(i) / ProfilePlot.SAMPLES)
		check_near(piece[3].y - piece[0].y, 40.0 * width, "width at %d" % i)
		check_near(piece[0].y + piece[3].y, 80.0, "about the middle")
		if i + 1 < ProfilePlot.SAMPLES:
			var next := plot.get_piece(i + 1, area)
			check_equal([piece[1], piece[2]], [next[0], next[3]], "no step at %d" % (i + 1))
	plot.free()


func test_an_orbit_camera_turns_with_the_pointer_and_zooms_with_the_wheel() -> void:
	var camera := OrbitCamera.new()
	var motion := InputEventMouseMotion.new()
	motion.relative = Vector2(20, 10)
	check(not camera.handle(motion, 2.0), "a move without a button")
	motion.button_mask = MOUSE_BUTTON_MASK_LEFT
	check(camera.handle(motion, 2.0), "a drag")
	check_near(camera.get_turn(), OrbitCamera.START_TURN - 0.1, "turn")
	check_near(camera.get_tilt(), OrbitCamera.START_TILT + 0.05, "tilt")
	motion.relative = Vector2(0, 10000)
	camera.handle(motion, 1.0)
	check_near(camera.get_tilt(), OrbitCamera.STEEPEST, "highest tilt")
	motion.relative = Vector2(0, -10000)
	camera.handle(motion, 1.0)
	check_near(camera.get_tilt(), -0.2, "lowest tilt")
	camera.handle(_button(MOUSE_BUTTON_WHEEL_UP), 1.0)
	check_near(camera.get_zoom(), 1.0 / 1.12, "the wheel up is nearer")
	camera.handle(_button(MOUSE_BUTTON_WHEEL_DOWN), 1.0)
	camera.handle(_button(MOUSE_BUTTON_WHEEL_DOWN), 1.0)
	check_near(camera.get_zoom(), 1.12, "the wheel down is farther")
	var pinch := InputEventMagnifyGesture.new()
	pinch.factor = 1.12
	camera.handle(pinch, 1.0)
	check_near(camera.get_zoom(), 1.0, "fingers that part are nearer")
	check(not camera.handle(_button(MOUSE_BUTTON_LEFT), 1.0), "a click")
	check(camera.handle(_button(MOUSE_BUTTON_LEFT, true), 1.0), "a double-click")
	check_near(camera.get_tilt(), OrbitCamera.START_TILT, "tilt after a double-click")
	camera.free()


func test_an_orbit_camera_sees_all_of_its_subject() -> void:
	var view := SubViewport.new()
	view.own_world_3d = true
	var camera := OrbitCamera.new()
	EditorInterface.get_base_control().add_child(view)
	view.add_child(camera)
	for extent: Vector2i in [Vector2i(400, 200), Vector2i(150, 400)]:
		view.size = extent
		for size: Vector2 in [Vector2(0.5, 2.0), Vector2(3.0, 1.0)]:
			camera.restart()
			camera.frame(Vector3(0, 0.5 * size.y, 0), size)
			camera.turn_to(OrbitCamera.START_TURN, 0.0, 1.0)
			var middle := camera.unproject_position(Vector3(0, 0.5 * size.y, 0))
			check(middle.distance_to(0.5 * Vector2(extent)) < 1.0, "middle: %s" % middle)
			var side := OrbitCamera.get_start_side() * 0.5 * size.x
			var right := camera.unproject_position(side + Vector3.UP * size.y)
			check(right.x > middle.x, "the start side is on the right")
			var room := Rect2(Vector2.ZERO, extent).grow(1.0)
			check(room.has_point(right), "a corner is in view: %s of %s" % [right, extent])
			check(camera.near < camera.position.length(), "near plane")
	view.free()


func test_a_picture_of_a_mix_has_plants_by_their_weights() -> void:
	var listed: Array[PlantFieldSpecies] = [
		PlantFieldSpecies.of(GrassFunction.new(), 30.0),
		PlantFieldSpecies.of(ReedFunction.new(), 10.0),
		PlantFieldSpecies.of(TulipFunction.new(), 0.1),
	]
	listed[1].density_factor = 0.5
	var order: PackedInt32Array = PlantGroup._draw_order(listed)
	check_equal(order.size(), PlantGroup.COUNT, "plants")
	var counts: Array[int] = [order.count(0), order.count(1), order.count(2)]
	check(counts[2] >= 1 and counts[2] <= 2, "a rare species is there: %s" % [counts])
	check(absf(counts[0] - 6.0 * counts[1]) < 5.0, "six to one: %s" % [counts])
	listed[0].scale_range = Vector2(0.5, 1.5)
	check_near(PlantGroup._scale_of(listed[0]), 1.0, "size")


func test_bones_of_a_preview_share_the_joints_of_the_stem() -> void:
	var bones := PreviewOverlay.make_bones(2.0, 4)
	var arrays := bones.surface_get_arrays(0)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var joints: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
	var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
	check(absf(bones.get_aabb().size.y - 2.0) < 1e-4, "as high as the plant")
	for i in points.size():
		var mean := joints[4 * i] * weights[4 * i] + joints[4 * i + 1] * weights[4 * i + 1]
		var place := clampf(points[i].y / 2.0 * 4.0 - 0.5, 0.0, 3.0)
		check(absf(mean - (2.0 + place)) < 1e-3, "joint %f at %f m" % [mean, points[i].y])
	var simple := PreviewOverlay.make_bones(2.0).surface_get_arrays(0)
	var tips: PackedFloat32Array = simple[Mesh.ARRAY_WEIGHTS]
	var heights: PackedVector3Array = simple[Mesh.ARRAY_VERTEX]
	for i in heights.size():
		check(absf(tips[4 * i + 1] - heights[i].y / 2.0) < 1e-3, "weight of the tip")


func check_near(value: float, wanted: float, text: String) -> void:
	check(absf(value - wanted) < 1e-4, "%s: %f instead of %f" % [text, value, wanted])


func _button(index: MouseButton, is_double := false) -> InputEventMouseButton:
	var button := InputEventMouseButton.new()
	button.button_index = index
	button.pressed = true
	button.double_click = is_double
	return button
