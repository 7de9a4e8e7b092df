@tool
extends "editor_test.gd"
## Values of the brush and of drawn paths, without a view.

const BrushDensity := preload("res://addons/undergrowth/editor/brush/brush_density.gd")
const BrushGround := preload("res://addons/undergrowth/editor/brush/brush_ground.gd")
const BrushOptions := preload("res://addons/undergrowth/editor/brush/brush_options.gd")
const BrushPointer := preload("res://addons/undergrowth/editor/brush/brush_pointer.gd")
const DrawnPath := preload("res://addons/undergrowth/editor/brush/drawn_path.gd")
const PenPressure := preload("res://addons/undergrowth/editor/brush/pen_pressure.gd")
const TransformGizmo := preload("res://addons/undergrowth/editor/brush/transform_gizmo.gd")


## Ground that rises to +x and has a hole beyond x = 4.
class Slope:
	extends RefCounted
	var lift := 0.0

	func get_height(place: Vector3) -> float:
		return place.x * 0.5 + lift if place.x < 4.0 else NAN


func test_options_stay_in_their_ranges_and_report_each_change() -> void:
	var options := BrushOptions.new()
	var changes: Array[int] = [0]
	options.changed.connect(func() -> void: changes[0] += 1)
	options.radius = 1000.0
	options.width = 0.0
	options.strength = 2.0
	options.falloff = -1.0
	options.height = 9.0
	options.density = 3.0
	options.scale_jitter = 2.0
	options.color_jitter = -1.0
	check_equal(changes[0], 8, "changes of numbers")
	check_equal([options.scale_jitter, options.color_jitter], [0.9, 0.0], "jitter")
	check_equal([options.radius, options.width], [100.0, 0.1], "radius and width")
	check_equal([options.strength, options.falloff], [1.0, 0.0], "strength and falloff")
	check_equal([options.height, options.density], [3.9, 3.0], "height and density")
	check(not options.is_as_mixed, "a density of its own")
	options.species = ["Grass"]
	options.tool = BrushOptions.Tool.PAINT
	options.is_as_mixed = true
	check_equal(changes[0], 11, "all changes")


func test_the_tool_decides_the_circle_and_ctrl_the_tool() -> void:
	var options := BrushOptions.new()
	options.radius = 3.0
	options.falloff = 0.25
	options.width = 0.5
	for tool: BrushOptions.Tool in BrushOptions.Tool.values():
		options.tool = tool
		var draws := tool == BrushOptions.Tool.TRAIL or tool == BrushOptions.Tool.PATH
		check_equal(options.draws_path(), draws, "tool %d draws a path" % tool)
		var circle := Vector2(0.25, 0.0) if draws else Vector2(3.0, 0.25)
		check_equal(options.get_circle(), circle, "circle of tool %d" % tool)
		check_equal(options.tool_with(false), tool, "tool %d" % tool)
		var paints := tool == BrushOptions.Tool.PAINT
		var with_ctrl := BrushOptions.Tool.ERASE if paints else tool
		check_equal(options.tool_with(true), with_ctrl, "tool %d with Ctrl" % tool)


func test_a_pen_is_recognized_by_its_moves() -> void:
	var pen := PenPressure.new()
	check(not pen.begin(), "a mouse does not wait")
	check_equal(pen.read(_motion(0.0)), 1.0, "a mouse without pressure")
	check_equal(pen.read(_motion(0.25)), 0.25, "a pen that is pressed")
	check_equal(pen.read(_motion(0.0)), 0.0, "a pen above the surface")
	check(pen.begin(), "a pen waits for its pressure")
	check(not pen.begin(), "the next stroke can be a mouse's")
	check_equal(pen.read(_motion(0.0, Vector2(0.2, 0.0))), 0.0, "a tilted pen above the surface")
	check(pen.begin(), "a tilted pen waits, too")


func test_densities_are_shares_of_the_mix() -> void:
	var field := PlantField3D.new()
	field.size = Vector2(4, 4)
	field.density = 8.0
	var sparse := PlantFieldSpecies.of(GrassFunction.new(), 1.0)
	sparse.density_factor = 0.5
	field.species = [sparse, PlantFieldSpecies.of(ReedFunction.new(), 3.0)]
	var both: PackedStringArray = ["Grass", "Reed"]
	check_near(BrushDensity.of_mix(field, "Grass"), 1.0, "a species with a density factor")
	check_near(BrushDensity.of_mix(field, "Reed"), 6.0, "another one")
	check_near(BrushDensity.sum_of_mix(field, both), 7.0, "both")
	var parts := BrushDensity.divide(field, both, 14.0)
	check_near(parts[0], 2.0, "part of the first")
	check_near(parts[1], 12.0, "part of the second")
	var other := BrushDensity.divide(field, ["Tulip", "Cattail"], 3.0)
	check_equal(other, PackedFloat64Array([1.5, 1.5]), "parts of species beside the mix")
	check_near(BrushDensity.at(field, "Reed", Vector3(1.9, 5.0, -1.9)), 6.0, "inside, any height")
	check_near(BrushDensity.at(field, "Reed", Vector3(0.0, 0.0, 2.1)), 0.0, "outside")
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 1.0, "Reed", 0.5, 0.0)
	field.map.paint_plants(Vector3.ZERO, 1.0, "Reed", 2.0, 1.0, 0.0)
	var share := field.map.get_density(Vector3.ZERO, "Reed")
	var painted := field.map.get_plant_density(Vector3.ZERO, "Reed")
	check(absf(painted - 2.0) < 0.01, "painted: %f" % painted)
	check_near(BrushDensity.at(field, "Reed", Vector3.ZERO), painted + 6.0 * share, "of a map")
	field.free()


func test_a_ray_meets_the_ground_of_an_object() -> void:
	var slope := Slope.new()
	var way := Vector3(1.0, -0.6, 0.3).normalized()
	var met: Variant = BrushGround.find_on(slope, Vector3(-5.0, 2.0, 1.0), way)
	check(met is Vector3, "a ray from the side meets it")
	var place: Vector3 = met
	check(absf(place.y - place.x * 0.5) < 0.01, "on the ground: %s" % place)
	check((place - Vector3(-5.0, 2.0, 1.0)).cross(way).length() < 1e-3, "on the ray: %s" % place)
	var below: Variant = BrushGround.find_on(slope, Vector3(2.0, -3.0, 7.0), Vector3.DOWN)
	check_equal(below, Vector3(2.0, 1.0, 7.0), "a vertical ray, also from below")
	check_equal(BrushGround.find_on(slope, Vector3(5, 9, 0), Vector3.DOWN), null, "over a hole")
	check_equal(BrushGround.find_on(slope, Vector3(0, 9, 0), Vector3.UP), null, "into the sky")


func test_a_stroke_begins_on_ground_that_has_moved() -> void:
	var root := Node3D.new()
	var terrain := Node3D.new()
	terrain.name = "Terrain"
	terrain.set_script(_terrain_script())
	var field := PlantField3D.new()
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = ^"../Terrain"
	var view := SubViewport.new()
	view.own_world_3d = true
	view.size = Vector2i(100, 100)
	var camera := Camera3D.new()
	camera.position = Vector3(0, 10, 0)
	camera.rotation.x = -PI / 2.0
	EditorInterface.get_base_control().add_child(view)
	for node: Node3D in [terrain, field]:
		root.add_child(node)
	view.add_child(root)
	view.add_child(camera)
	var pointer := BrushPointer.new()
	pointer.move_to(camera, _moved_to(Vector2(50, 50)))
	check_near((pointer.find_place(field) as Vector3).y, 0.0, "at first")
	terrain.set(&"height", 2.0)
	pointer.move_to(camera, _moved_to(Vector2(50, 50)))
	check_near((pointer.find_place(field) as Vector3).y, 0.0, "a pointer at rest casts no ray")
	var press := InputEventMouseButton.new()
	press.position = Vector2(50, 50)
	press.pressed = true
	press.button_mask = MOUSE_BUTTON_MASK_LEFT
	press.ctrl_pressed = true
	pointer.move_to(camera, press)
	check_near((pointer.find_place(field) as Vector3).y, 2.0, "a press casts one")
	check(pointer.is_pressed and pointer.is_ctrl_pressed, "the button and Ctrl")
	pointer.move_to(camera, _moved_to(Vector2(60, 50)))
	check((pointer.find_place(field) as Vector3).x > 0.1, "another pixel")
	check(not pointer.is_pressed and not pointer.is_ctrl_pressed, "neither of them")
	view.free()


func test_a_drag_adds_points_in_proportion_to_the_width() -> void:
	var drawn := DrawnPath.new()
	drawn.width = 2.0
	drawn.press(Vector3.ZERO)
	check(not drawn.release(), "a click does not end it")
	drawn.drag(Vector3(0.9, 0, 0))
	check_equal(drawn.points.size(), 1, "points after a short move")
	drawn.drag(Vector3(1.1, 0, 0))
	check_equal(drawn.points.size(), 2, "points after a longer one")
	check(drawn.release(), "a drag ends it")
	drawn.press(Vector3(5, 0, 0))
	check(not drawn.release(), "the next click does not")
	check_near(drawn.get_length(), 5.0, "length")
	var narrow := DrawnPath.new()
	narrow.width = 0.1
	narrow.press(Vector3.ZERO)
	narrow.drag(Vector3(0, 0, 0.2))
	check_equal(narrow.points.size(), 1, "points of a narrow path after a short move")
	check(not narrow.is_complete(), "one point is no path")
	narrow.drag(Vector3(0, 0, 0.3))
	check(narrow.is_complete(), "two are")


func test_ends_that_meet_close_a_path() -> void:
	var drawn := DrawnPath.new()
	drawn.width = 0.6
	for corner: Vector2 in [Vector2(0, 0), Vector2(2, 0), Vector2(2, 2), Vector2(0, 2)]:
		drawn.press(Vector3(corner.x, 0, corner.y))
	check(not drawn.is_closed(), "its ends are apart")
	check_equal(drawn.make_curve().point_count, 4, "points of the open curve")
	drawn.press(Vector3(0, 0, 0.5))
	check(drawn.is_closed() and drawn.release(), "a click at its start closes it")
	drawn.press(Vector3(0, 0, 0.4))
	check_equal(drawn.points.size(), 5, "a closed path takes no more points")
	var curve := drawn.make_curve()
	check(curve.closed, "the curve is closed")
	check_equal(curve.point_count, 4, "points of the closed curve")
	var handle := (Vector3(2, 0, 0) - Vector3(0, 0, 2)) / 6.0
	check(curve.get_point_out(0).is_equal_approx(handle), "way out: %s" % curve.get_point_out(0))
	check(curve.get_point_in(0).is_equal_approx(-handle), "way in: %s" % curve.get_point_in(0))
	var small := DrawnPath.new()
	for x: float in [0.0, 0.3, 0.1]:
		small.press(Vector3(x, 0, 0))
	check(not small.is_closed(), "a scribble within the gap is no loop")


func test_the_ends_of_an_open_path_point_at_their_neighbours() -> void:
	var drawn := DrawnPath.new()
	for place: Vector3 in [Vector3.ZERO, Vector3(3, 0, 0), Vector3(3, 0, 3)]:
		drawn.press(place)
	var curve := drawn.make_curve()
	check(curve.get_point_out(0).is_equal_approx(Vector3(0.5, 0, 0)), "at the start")
	check(curve.get_point_in(2).is_equal_approx(Vector3(0, 0, -0.5)), "at the end")
	check(curve.get_point_out(1).is_equal_approx(Vector3(0.5, 0, 0.5)), "in between")


func test_the_transform_gizmo_is_hidden_in_all_views() -> void:
	var layers: Array[int] = []
	TransformGizmo.set_visible(false)
	for i in TransformGizmo.VIEWS:
		layers.append(EditorInterface.get_editor_viewport_3d(i).get_camera_3d().cull_mask)
	TransformGizmo.set_visible(true)
	for i in TransformGizmo.VIEWS:
		var shown := EditorInterface.get_editor_viewport_3d(i).get_camera_3d().cull_mask
		check_equal(shown ^ layers[i], 1 << (27 + i), "hidden layers of view %d" % i)
		check(shown & 1 << (27 + i) != 0, "shown again in view %d" % i)


func check_near(value: float, wanted: float, text: String) -> void:
	check(absf(value - wanted) < 1e-4, "%s: %f instead of %f" % [text, value, wanted])


func _motion(pressure: float, tilt := Vector2.ZERO) -> InputEventMouseMotion:
	var motion := InputEventMouseMotion.new()
	motion.pressure = pressure
	motion.tilt = tilt
	return motion


func _moved_to(pixel: Vector2) -> InputEventMouseMotion:
	var motion := InputEventMouseMotion.new()
	motion.position = pixel
	return motion


func _terrain_script() -> GDScript:
	var script := GDScript.new()
	script.source_code = (
		"@tool\nextends Node3D\nvar height := 0.0\n"
		+ "func get_height(_place: Vector3) -> float:\n\treturn height\n"
	)
	script.reload()
	return script
