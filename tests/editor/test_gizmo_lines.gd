@tool
extends "editor_test.gd"
## Lines and drags of gizmos, without a scene.

const DrapedBorder := preload("res://addons/undergrowth/editor/gizmo/draped_border.gd")
const FieldGizmos := preload("res://addons/undergrowth/editor/gizmo/field_gizmos.gd")
const GizmoShapes := preload("res://addons/undergrowth/editor/gizmo/gizmo_shapes.gd")
const PlantGizmos := preload("res://addons/undergrowth/editor/gizmo/plant_gizmos.gd")


func test_a_box_has_twelve_edges() -> void:
	var box := AABB(Vector3(1, 2, 3), Vector3(2, 3, 4))
	var lines := GizmoShapes.box(box)
	check_equal(lines.size(), 24, "ends")
	var length := 0.0
	var drawn := AABB(lines[0], Vector3.ZERO)
	for i in range(0, lines.size(), 2):
		length += lines[i].distance_to(lines[i + 1])
		drawn = drawn.expand(lines[i]).expand(lines[i + 1])
	check(is_equal_approx(length, 4.0 * (2 + 3 + 4)), "length of all edges: %f" % length)
	check(drawn.is_equal_approx(box), "drawn box: %s" % drawn)


func test_a_loop_returns_to_its_start() -> void:
	var points: PackedVector3Array = [Vector3.ZERO, Vector3.RIGHT, Vector3.BACK]
	var wanted: PackedVector3Array = [
		Vector3.ZERO, Vector3.RIGHT, Vector3.RIGHT, Vector3.BACK, Vector3.BACK, Vector3.ZERO
	]
	check_equal(GizmoShapes.loop(points), wanted, "lines")


func test_an_arrow_has_two_barbs_behind_its_tip() -> void:
	var lines := GizmoShapes.arrow(Vector3.UP, Vector3(2, 1, 0), Vector3.UP)
	check_equal(lines.size(), 6, "ends")
	check_equal([lines[0], lines[1]], [Vector3.UP, Vector3(2, 1, 0)], "the shaft")
	for i: int in [3, 5]:
		check_equal(lines[i - 1], Vector3(2, 1, 0), "a barb begins at the tip")
		check(lines[i].x < 1.9 and is_equal_approx(lines[i].y, 1.0), "it ends at %s" % lines[i])
	check(is_equal_approx(lines[3].z, -lines[5].z) and lines[3].z != 0.0, "on both sides")


func test_an_arc_goes_from_one_direction_to_the_other() -> void:
	var tip := Vector3(1, 1, 0).normalized()
	var lines := GizmoShapes.arc(Vector3.UP, tip, 2.0)
	check(lines[0].is_equal_approx(Vector3.UP * 2.0), "start: %s" % lines[0])
	check(lines[-1].is_equal_approx(tip * 2.0), "end: %s" % lines[-1])
	for i in range(1, lines.size()):
		check(is_equal_approx(lines[i].length(), 2.0), "radius at %d" % i)
		check(i % 2 == 1 or lines[i].is_equal_approx(lines[i - 1]), "no gap at %d" % i)
	check(GizmoShapes.arc(Vector3.UP, Vector3.UP, 2.0).is_empty(), "no arc without an angle")


func test_a_drag_is_measured_in_the_axes_of_the_node() -> void:
	var view := SubViewport.new()
	view.own_world_3d = true
	view.size = Vector2i(400, 300)
	var camera := Camera3D.new()
	var node := Node3D.new()
	EditorInterface.get_base_control().add_child(view)
	view.add_child(camera)
	view.add_child(node)
	camera.look_at_from_position(Vector3(3, 6, 9), Vector3.ZERO)
	node.transform = Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3.ONE * 2.0), Vector3(1, 0, 1))
	for projection: Camera3D.ProjectionType in [
		Camera3D.PROJECTION_PERSPECTIVE, Camera3D.PROJECTION_ORTHOGONAL
	]:
		camera.projection = projection
		camera.size = 12.0
		for way: Vector3 in [Vector3.RIGHT, Vector3.FORWARD, Vector3.UP]:
			var start := Vector3(0.0, 0.5, 0.0)
			var pixel := camera.unproject_position(node.to_global(start + way * 0.75))
			var reach := GizmoShapes.reach_along(node, way, 100.0, camera, pixel, start)
			check(absf(reach - 0.75) < 0.01, "%f along %s" % [reach, way])
			var back := camera.unproject_position(node.to_global(start - way * 0.5))
			reach = GizmoShapes.reach_along(node, way, 100.0, camera, back, start)
			check(absf(reach + 0.5) < 0.01, "%f against %s" % [reach, way])
	view.free()


func test_the_arrow_of_a_wind_points_where_the_wind_blows() -> void:
	var wind := PlantWind.new()
	for angle: float in [0.0, PI / 2.0, 2.0]:
		wind.direction = angle
		var blows := Vector3(sin(angle), 0.0, cos(angle))
		var shown: Vector3 = PlantGizmos._wind_direction(wind)
		check(shown.is_equal_approx(blows), "%s instead of %s" % [shown, blows])


func test_the_joints_of_a_plant_go_from_root_to_tip() -> void:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	EditorInterface.get_base_control().add_child(plant)
	plant.rebuild()
	var joints: PackedVector3Array = PlantGizmos.joints_of(plant)
	check_equal(joints.size(), plant.get_joint_count() + 1, "joints")
	check_equal(joints[0], Vector3.ZERO, "root")
	check(joints[-1].is_equal_approx(plant.get_tip_position()), "tip: %s" % joints[-1])
	plant.free()


func test_a_border_has_points_at_even_distances() -> void:
	var corners: PackedVector3Array = [
		Vector3.ZERO, Vector3(8, 0, 0), Vector3(8, 0, 2), Vector3(0, 0, 2)
	]
	var points: PackedVector3Array = DrapedBorder._subdivide(corners)
	for corner in corners:
		check(points.has(corner), "%s is a point" % corner)
	check(absi(points.size() - 64) < 8, "%d points" % points.size())
	for i in points.size():
		var step := points[i].distance_to(points[(i + 1) % points.size()])
		check(step > 0.2 and step < 0.5, "step of %f m at %d" % [step, i])


func test_a_click_beside_the_border_is_within_its_room() -> void:
	var corners: PackedVector3Array = [
		Vector3.ZERO, Vector3(8, 0, 0), Vector3(8, 0, 2), Vector3(0, 0, 2)
	]
	var room: PackedVector3Array = FieldGizmos._room_around(corners)
	var box := AABB(room[0], Vector3.ZERO).expand(room[2])
	check(box.is_equal_approx(AABB(Vector3(0, 0, 0), Vector3(8, 0, 2)).grow(0.16)), "%s" % box)


func test_a_field_without_plants_has_a_low_box() -> void:
	var field := PlantField3D.new()
	field.density = 0.0
	EditorInterface.get_base_control().add_child(field)
	var box: AABB = FieldGizmos._box_of(field, field.get_outline_points())
	check_equal(Vector2(box.size.x, box.size.z), field.size, "size")
	check(box.size.y >= 0.5 and box.size.y < 2.0, "height: %f" % box.size.y)
	check_equal(box.position.y, 0.0, "bottom")
	field.free()
