@tool
extends "actions_test.gd"
## Fields of the dock lie on the ground below them.

const NewPlace := preload("res://addons/undergrowth/editor/actions/new_place.gd")
const SCENE := "res://new_fields_scene.tscn"
const AWAY := Vector3(600.0, 0.0, 0.0)
## Metres.
const TOLERANCE := 0.05

var _root: Node3D


## A terrain with heights and without a collider.
class Hills:
	extends RefCounted

	func get_height(at: Vector3) -> float:
		return 0.3 * at.z


func test_a_field_lies_on_a_collider() -> void:
	await _open_garden()
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(20.0, 1.0, 20.0)
	body.add_child(shape)
	body.collision_layer = 4
	_add(body, Basis(Vector3.RIGHT, 0.3))
	var field := await _add_field()
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	check_equal(field.ground_collision_mask, 4, "layers of the collider")
	await _check_slope(field, -tan(0.3))


func test_a_field_lies_on_a_mesh() -> void:
	await _open_garden()
	var ramp := MeshInstance3D.new()
	ramp.name = "Ramp"
	ramp.mesh = BoxMesh.new()
	(ramp.mesh as BoxMesh).size = Vector3(20.0, 1.0, 20.0)
	_add(ramp, Basis(Vector3.RIGHT, 0.3))
	var field := await _add_field()
	check_equal(field.ground_mode, PlantField3D.GROUND_MESH, "ground mode")
	check_equal(field.get_node(field.ground_mesh), ramp, "its mesh")
	await _check_slope(field, -tan(0.3))


func test_a_mesh_with_a_collider_is_a_collider() -> void:
	await _open_garden()
	var floor_box := CSGBox3D.new()
	floor_box.size = Vector3(20.0, 1.0, 20.0)
	floor_box.use_collision = true
	_add(floor_box, Basis(Vector3.RIGHT, 0.3))
	var field := await _add_field()
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	await _check_slope(field, -tan(0.3))


func test_a_level_plane_needs_no_ground() -> void:
	await _open_garden()
	var plane := MeshInstance3D.new()
	plane.mesh = PlaneMesh.new()
	(plane.mesh as PlaneMesh).size = Vector2(20.0, 20.0)
	_add(plane, Basis.IDENTITY)
	var field := await _add_field()
	check_equal(field.ground_mode, PlantField3D.GROUND_NONE, "ground mode")
	check(absf(field.global_position.y - 3.0) < TOLERANCE, "at %s" % field.global_position)


func test_a_field_lies_on_a_terrain_without_a_collider() -> void:
	await _open_garden()
	var script := GDScript.new()
	script.source_code = "@tool\nextends Node3D\nvar data: Object\n"
	script.reload()
	var terrain := Node3D.new()
	terrain.name = "Terrain"
	terrain.set_script(script)
	terrain.set(&"data", Hills.new())
	_add(terrain, Basis.IDENTITY)
	var field := await _add_field()
	check_equal(field.ground_mode, PlantField3D.GROUND_OBJECT, "ground mode")
	check_equal(field.ground_object, ^"../Terrain:data", "ground object")
	await _check_slope(field, 0.3)


func test_add_as_field_uses_the_ground_in_view() -> void:
	await _open_garden()
	var floor_box := CSGBox3D.new()
	floor_box.size = Vector3(20.0, 1.0, 20.0)
	floor_box.use_collision = true
	_add(floor_box, Basis(Vector3.RIGHT, 0.3))
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var before := camera.global_transform
	camera.look_at_from_position(AWAY + Vector3(0.0, 9.0, 5.0), AWAY + Vector3.UP * 3.0)
	await frames(10)
	await _choose("Tulip")
	await _use("AddField")
	var field := _root.get_child(-1) as PlantField3D
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	check_equal(_message(), "Added Tulip to the scene.", "the message")
	camera.global_transform = before
	await undo()


func test_without_ground_the_message_says_that_the_field_is_flat() -> void:
	await _open_garden()
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var before := camera.global_transform
	camera.look_at_from_position(AWAY + Vector3(0.0, 5.0, 5.0), AWAY)
	await _choose("Tulip")
	await _use("AddField")
	check(_message().contains("no ground"), "the message: " + _message())
	camera.global_transform = before
	await undo()


func test_place_on_ground_moves_a_field_to_the_ground_in_one_step() -> void:
	await _open_garden()
	var ramp := MeshInstance3D.new()
	ramp.mesh = BoxMesh.new()
	(ramp.mesh as BoxMesh).size = Vector3(20.0, 1.0, 20.0)
	_add(ramp, Basis(Vector3.RIGHT, 0.3))
	for height: float in [9.0, -5.0]:
		var field := PlantField3D.new()
		field.size = Vector2(4.0, 4.0)
		field.density = 2.0
		_root.add_child(field)
		field.owner = _root
		field.global_position = AWAY + Vector3.UP * height
		EditorInterface.edit_node(field)
		await frames(5)
		var bar := _find_bar()
		await click(bar.get_node(^"%Place") as Control)
		await frames(3)
		check_equal(field.get_node(field.ground_mesh), ramp, "its mesh")
		check(absf(field.global_position.y - 3.52) < TOLERANCE, "at %s" % field.global_position)
		await _check_slope(field, -tan(0.3))
		await undo()
		check_equal(field.ground_mode, PlantField3D.GROUND_NONE, "ground mode after undo")
		check(absf(field.global_position.y - height) < TOLERANCE, "its height after undo")
		field.free()


func _find_bar() -> Control:
	var bars := EditorInterface.get_base_control().find_children("BrushBar", "", true, false)
	return bars[0]


func _open_garden() -> void:
	var garden := Node3D.new()
	garden.name = "Garden"
	await _open_scene(SCENE, garden)
	_root = EditorInterface.get_edited_scene_root() as Node3D
	for node in _root.get_children():
		node.free()


func _add(node: Node3D, basis: Basis) -> void:
	_root.add_child(node)
	node.owner = _root
	node.global_transform = Transform3D(basis, AWAY + Vector3.UP * 3.0)
	await frames(5)


## Returns a new field at the place that a ray from above finds.
func _add_field() -> PlantField3D:
	await frames(10)
	var place: NewPlace = NewPlace.find_along(
		_root.get_world_3d(), _root, AWAY + Vector3.UP * 20.0, Vector3.DOWN
	)
	check(place.has_ground, "it finds the ground")
	var field := PlantField3D.new()
	field.size = Vector2(4.0, 4.0)
	field.density = 2.0
	place.lay(field, _root)
	_root.add_child(field)
	field.owner = _root
	field.global_position = place.point
	return field


## Fails the test unless the plants lie on a plane with this slope along z.
func _check_slope(field: PlantField3D, slope: float) -> void:
	var is_built := func() -> bool: return field.get_plant_count() > 0 and not field.is_building()
	check(await until(is_built), "plants exist")
	var worst := 0.0
	for id in field.get_plant_ids():
		var at := field.get_plant_transform(id).origin
		worst = maxf(worst, absf(at.y - slope * at.z))
	check(worst < TOLERANCE, "%f m beside the ground" % worst)
