@tool
extends "viewport_test.gd"
## The border and the handles of a field lie on its ground.

const BrushGround := preload("res://addons/undergrowth/editor/brush/brush_ground.gd")
const DrapedBorder := preload("res://addons/undergrowth/editor/gizmo/draped_border.gd")
const FILE := "res://gizmo_ground.tscn"
const SLOPE := 0.3
## Of the ground mesh of the measurement: 12,800 triangles.
const SQUARES := 80


func test_the_handles_are_on_the_ground() -> void:
	var field := await _open_slope()
	await _choose_only(field)
	var top := Vector3(2, tan(SLOPE) * 2.0, 0)
	await drag(_view(), _place_of(field, top), _place_of(field, top + Vector3(1, 0, 0)))
	check(absf(field.size.x - 5.0) < 0.1, "size after a drag of the upper handle: %s" % field.size)
	await undo()
	check_equal(field.size, Vector2(4, 4), "size after undo")


func test_a_click_on_the_ground_selects_the_field() -> void:
	var field := await _open_slope()
	EditorInterface.get_selection().clear()
	await frames(5)
	var place := Vector3(1.9, tan(SLOPE) * 1.9, -1.9)
	await click(_view(), _place_of(field, place))
	await frames(3)
	check_equal(
		EditorInterface.get_selection().get_selected_nodes(), [field] as Array[Node], "selected"
	)


func test_the_border_follows_the_ground_and_costs_no_rays_while_it_rests() -> void:
	var field := await _open_slope()
	await _choose_only(field)
	await frames(10)
	var border := DrapedBorder.new()
	var line := border.drape_loop(field, field.get_outline_points())
	check(line.size() > 30, "%d points" % line.size())
	for point in line:
		check(absf(point.y - tan(SLOPE) * point.x) < 0.05, "on the ground: %s" % point)
	var rays := BrushGround.ray_count
	for i in 20:
		field.update_gizmos()
		await frames(1)
	check_equal(BrushGround.ray_count, rays, "rays after 20 redraws")
	field.position.z += 1.0
	await frames(5)
	check(BrushGround.ray_count > rays, "a move casts them again")
	rays = BrushGround.ray_count
	field.rebuild()
	check(await until(func() -> bool: return BrushGround.ray_count > rays), "a build, too")


func test_a_redraw_takes_little_of_the_main_thread() -> void:
	var field := await _open_slope(_make_hill())
	await _choose_only(field)
	await frames(10)
	var line := field.get_outline_points()
	var first: Array[float] = []
	var again: Array[float] = []
	for i in 15:
		var border := DrapedBorder.new()
		first.append(_time(border.drape_loop.bind(field, line)))
		again.append(_time(border.drape_loop.bind(field, line)))
	first.sort()
	again.sort()
	print("border: %.0f usec with rays, %.0f usec without" % [first[7], again[7]])
	check(again[7] * 5.0 < first[7], "the cache saves most of it")


func _time(work: Callable) -> float:
	var begin := Time.get_ticks_usec()
	work.call()
	return Time.get_ticks_usec() - begin


## A field of 4 m by 4 m on a box that is inclined along x, or on the mesh [param hill].
func _open_slope(hill: Mesh = null) -> PlantField3D:
	var root := Node3D.new()
	root.name = "Slope"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(4, 4)
	field.density = 4.0
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	_put(root, field)
	var body := StaticBody3D.new()
	body.name = "Ground"
	body.rotation.z = SLOPE
	_put(root, body)
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(30, 1, 30)
	shape.position.y = -0.5
	body.add_child(shape)
	shape.owner = root
	if hill:
		var seen := MeshInstance3D.new()
		seen.name = "Hill"
		seen.mesh = hill
		_put(root, seen)
	var opened := await _open(FILE, root) as PlantField3D
	check(await until(func() -> bool: return opened.get_plant_count() > 10), "plants exist")
	await frames(5)
	return opened


static func _make_hill() -> Mesh:
	var plane := PlaneMesh.new()
	plane.size = Vector2(60, 60)
	plane.subdivide_width = SQUARES - 1
	plane.subdivide_depth = SQUARES - 1
	var hill := ArrayMesh.new()
	hill.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, plane.get_mesh_arrays())
	return hill
