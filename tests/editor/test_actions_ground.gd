@tool
extends "actions_test.gd"
## The ground for new plants of the dock: colliders, meshes, planes.

const NewPlace := preload("res://addons/undergrowth/editor/actions/new_place.gd")
const SCENE := "res://actions_ground_scene.tscn"


func test_ground_is_whatever_a_ray_meets() -> void:
	var root := await _open_garden()
	var away := Vector3(500.0, 0.0, 0.0)
	var things: Dictionary[String, Node3D] = {
		"plane": _with_mesh(PlaneMesh.new()),
		"sphere": _with_mesh(SphereMesh.new()),
		"geometry": CSGBox3D.new(),
		"collider": _make_collider(),
	}
	var tops: Dictionary[String, float] = {
		"plane": 3.0, "sphere": 3.5, "geometry": 3.5, "collider": 3.5
	}
	for kind in things:
		root.add_child(things[kind])
		things[kind].global_position = away + Vector3.UP * 3.0
		await frames(10)
		check_near_ground(away + Vector3.UP * 9.0, Vector3.DOWN, tops[kind], kind)
		things[kind].free()
		await frames(2)
	check_near_ground(away + Vector3.UP * 9.0, Vector3.DOWN, 0.0, "nothing")
	check_near_ground(away + Vector3.UP * 9.0, Vector3.UP, 0.0, "the sky")


func test_before_a_wall_the_ground_is_at_its_foot() -> void:
	var root := await _open_garden()
	var wall := CSGBox3D.new()
	wall.size = Vector3(0.2, 10.0, 10.0)
	root.add_child(wall)
	await frames(5)
	var along := Vector3(1.0, -0.1, 0.0).normalized()
	var point := _find_ground(Vector3(-4.0, 2.0, 0.0), along)
	check(point.is_equal_approx(Vector3(-0.15, 0.0, 0.0)), "foot of the wall: %s" % point)
	wall.free()


func _open_garden() -> Node3D:
	var garden := Node3D.new()
	garden.name = "Garden"
	await _open_scene(SCENE, garden)
	return EditorInterface.get_edited_scene_root() as Node3D


## Fails the test unless the ground along that ray is at [param height].
func check_near_ground(from: Vector3, along: Vector3, height: float, what: String) -> void:
	var point := _find_ground(from, along)
	check(absf(point.y - height) < 0.02, "%s: %s, not at %f" % [what, point, height])


func _find_ground(from: Vector3, along: Vector3) -> Vector3:
	var root := EditorInterface.get_edited_scene_root() as Node3D
	var place: NewPlace = NewPlace.find_along(root.get_world_3d(), root, from, along)
	return place.point


func _with_mesh(mesh: Mesh) -> MeshInstance3D:
	var shown := MeshInstance3D.new()
	shown.mesh = mesh
	return shown


func _make_collider() -> StaticBody3D:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	body.add_child(shape)
	return body


func test_a_field_that_finds_no_ground_warns_in_the_scene_dock() -> void:
	var root := await _open_garden()
	var reported: Array[Node] = []
	var listener := func(node: Node) -> void: reported.append(node)
	root.get_tree().node_configuration_warning_changed.connect(listener)
	var field := PlantField3D.new()
	field.size = Vector2(4, 4)
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	field.position = Vector3(900, 0, 0)
	root.add_child(field)
	field.owner = root
	reported.clear()
	check(
		await until(func() -> bool: return reported.has(field)), "it warns where there is no ground"
	)
	check_error("no collider is below or above the field")
	var ground := _make_collider()
	root.add_child(ground)
	ground.global_position = field.global_position
	await frames(3)
	reported.clear()
	field.rebuild()
	check(await until(func() -> bool: return reported.has(field)), "and no more where there is one")
	root.get_tree().node_configuration_warning_changed.disconnect(listener)
	ground.free()
	field.free()
