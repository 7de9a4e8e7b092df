## PlantClimber3D: growth on nodes, its settings, its motion, and walls that move.
extends "res://tests/engine/harness.gd"

const LEAF := "res://addons/undergrowth/climbers/ivy_leaf.tres"

var _wall: MeshInstance3D
var _climber: PlantClimber3D


func before_each() -> void:
	_wall = MeshInstance3D.new()
	_wall.mesh = BoxMesh.new()
	(_wall.mesh as BoxMesh).size = Vector3(8.0, 6.0, 0.4)
	_wall.position = Vector3(0.0, 3.0, 0.0)
	root.add_child(_wall)
	_climber = PlantClimber3D.new()
	_climber.position = Vector3(0.0, -2.9, 0.2)
	_climber.length = 2.0
	_climber.seed = 5


func after_each() -> void:
	_wall.free()
	if is_instance_valid(_climber):
		_climber.free()
	_climber = null


func test_it_grows_on_its_parent() -> void:
	await _grow_on_wall()
	check(_climber.get_leaf_count() > 60, "%d leaves" % _climber.get_leaf_count())
	check(_climber.get_stem_length() > 6.0, "%.1f m of stems" % _climber.get_stem_length())
	for i in _climber.get_leaf_count():
		var leaf := _climber.get_leaf_transform(i)
		check(leaf.origin.z > 0.2 and leaf.origin.z < 0.3, "leaf %d is on the wall" % i)
		check(leaf.basis.y.normalized().z > 0.8, "leaf %d faces away from the wall" % i)


func test_it_grows_on_every_kind_of_support() -> void:
	var shapes: Array[Shape3D] = [
		BoxShape3D.new(),
		SphereShape3D.new(),
		CapsuleShape3D.new(),
		CylinderShape3D.new(),
		_wall.mesh.create_trimesh_shape(),
	]
	(shapes[0] as BoxShape3D).size = Vector3.ONE
	for shape in shapes:
		var body := StaticBody3D.new()
		var collision := CollisionShape3D.new()
		collision.shape = shape
		body.add_child(collision)
		root.add_child(body)
		var climber := PlantClimber3D.new()
		var is_wall := shape is ConcavePolygonShape3D
		climber.position = Vector3(0.0, 0.0, 0.2 if is_wall else 0.5)
		climber.length = 0.6
		body.add_child(climber)
		await until(func() -> bool: return climber.get_leaf_count() > 0, "%s" % shape.get_class())
		body.free()
	var box := CSGBox3D.new()
	root.add_child(box)
	await frames(2)
	var on_box := PlantClimber3D.new()
	on_box.position = Vector3(0.0, -0.4, 0.5)
	on_box.length = 0.6
	box.add_child(on_box)
	await until(func() -> bool: return on_box.get_leaf_count() > 0, "CSGBox3D")
	box.free()


func test_the_same_seed_gives_the_same_plant() -> void:
	await _grow_on_wall()
	var first := _climber.get_leaf_transform(40)
	var count := _climber.get_leaf_count()
	_climber.seed = 6
	await _grown()
	check(_climber.get_leaf_transform(40) != first, "another seed gives another plant")
	_climber.seed = 5
	await _grown()
	check_equal(_climber.get_leaf_count(), count, "leaves")
	check_equal(_climber.get_leaf_transform(40), first, "leaf 40")


func test_a_scene_saves_settings_and_no_mesh() -> void:
	_climber.path = PackedVector3Array([Vector3(1.0, 1.0, 0.0)])
	await _grow_on_wall()
	var first := _climber.get_leaf_transform(40)
	_climber.owner = _wall
	var scene := PackedScene.new()
	check_equal(scene.pack(_wall), OK)
	var bytes := var_to_bytes_with_objects(scene).size()
	check(bytes < 6000, "the scene has %d bytes" % bytes)
	var other := scene.instantiate() as Node3D
	root.add_child(other)
	var copy := other.get_child(0) as PlantClimber3D
	await until(func() -> bool: return copy.get_leaf_count() > 0, "the copy grows")
	check_equal(copy.get_leaf_transform(40), first, "leaf 40 of the copy")
	other.free()


func test_it_follows_a_wall_of_which_it_is_a_child() -> void:
	await _grow_on_wall()
	await _check_that_it_follows()


func test_it_follows_a_wall_beside_it() -> void:
	root.add_child(_climber)
	_climber.position = Vector3(0.0, 0.1, 0.2)
	_climber.supports = [_climber.get_path_to(_wall)]
	await _grown()
	await _check_that_it_follows()
	check_near(_climber.global_position, _wall.to_global(Vector3(0, -2.9, 0.2)), 1e-3, "root")


func test_its_parts_follow_their_own_bodies() -> void:
	var post := MeshInstance3D.new()
	post.mesh = BoxMesh.new()
	post.position = Vector3(0.0, 1.5, 0.5)
	(post.mesh as BoxMesh).size = Vector3(8.0, 0.6, 0.6)
	root.add_child(post)
	root.add_child(_climber)
	_climber.position = Vector3(0.0, 0.1, 0.2)
	_climber.length = 4.0
	_climber.supports = [_climber.get_path_to(_wall), _climber.get_path_to(post)]
	await _grown()
	var before: Array[Vector3] = []
	for i in _climber.get_leaf_count():
		before.append(_climber.get_leaf_transform(i).origin)
	post.position.x += 2.0
	await frames(2)
	var moved := 0
	for i in _climber.get_leaf_count():
		var way := _climber.get_leaf_transform(i).origin - before[i]
		check(way.length() < 1e-3 or way.distance_to(Vector3(2, 0, 0)) < 1e-3, "leaf %d" % i)
		moved += int(way.length() > 1.0)
	check(moved > 10 and moved < before.size() - 10, "%d leaves moved" % moved)
	post.free()


func test_the_path_leads_it() -> void:
	_climber.path = PackedVector3Array([Vector3(1.5, 0.3, 0.0), Vector3(3.0, 0.3, 0.0)])
	_climber.length = 3.2
	_climber.shoots = 1
	await _grow_on_wall()
	var reach := _climber.get_reach()
	check(reach.end.x > 2.9, "it reaches %.1f m to the right" % reach.end.x)


func test_a_part_moves_as_a_plant_at_its_place() -> void:
	_climber.wind = PlantWind.new()
	_climber.wind.kind = PlantWind.KIND_CONSTANT
	_climber.wind.strength = 0.8
	_climber.wind.direction = PI / 2.0
	await _grow_on_wall()
	var leaf := 30
	var plant := Plant3D.new()
	plant.species = load(LEAF)
	plant.wind = _climber.wind
	plant.transform = Transform3D(
		Basis(Vector3.RIGHT, Vector3.BACK, Vector3.DOWN), _climber.get_leaf_transform(leaf).origin
	)
	root.add_child(plant)
	_climber.reset_motion()
	var largest := 0.0
	for i in 40:
		await process_frame
		var own := _climber.get_leaf_deflection(leaf)
		largest = maxf(largest, own)
		check_near(own, plant.get_deflection(), 0.02, "deflection in frame %d" % i)
	check(largest > 0.05, "it bends by %.3f rad" % largest)
	plant.free()


func test_wind_does_not_grow_it_again() -> void:
	await _grow_on_wall()
	_climber.wind = PlantWind.new()
	_climber.wind.kind = PlantWind.KIND_AIR
	_climber.wind.speed = 9.0
	await frames(30)
	check(not _climber.is_growing(), "it does not grow")
	check(_climber.get_leaf_deflection(0) > 0.001, "air moves it")
	_climber.simulation_enabled = false
	await frames(2)
	var held := _climber.get_leaf_deflection(0)
	await frames(10)
	check_equal(_climber.get_leaf_deflection(0), held, "deflection without simulation")


func test_invalid_input_gives_one_error_and_leaves_the_plant() -> void:
	await _grow_on_wall()
	var count := _climber.get_leaf_count()
	_climber.length = -1.0
	check_error("length")
	check_equal(_climber.length, 2.0, "length")
	_climber.path = PackedVector3Array([Vector3(NAN, 0, 0)])
	check_error("path")
	_climber.supports = [NodePath("../Nothing")]
	await frames(3)
	check_error("supports[0]")
	check(_climber.get_leaf_count() == count, "the plant stays")
	_climber.supports = []
	_climber.position.z = 8.0
	_climber.rebuild()
	await _grown()
	check_error("Move the node")
	check_equal(_climber.get_leaf_count(), count, "leaves")
	_climber.get_leaf_transform(-1)
	check_error("get_leaf_transform(-1)")


func test_it_may_be_freed_while_it_grows() -> void:
	_climber.length = 20.0
	_climber.branching = 8.0
	_wall.add_child(_climber)
	await frames(2)
	_climber.free()
	await frames(2)
	check(not is_instance_valid(_climber), "it is freed")


func test_leaves_need_a_species_of_parts() -> void:
	_climber.species = GrassFunction.new()
	_wall.add_child(_climber)
	await frames(3)
	check_error("species of parts")
	check_equal(_climber.get_leaf_count(), 0, "leaves")


func _check_that_it_follows() -> void:
	var leaf := _wall.global_transform.affine_inverse() * _climber.get_leaf_transform(20)
	for i in 3:
		_wall.position += Vector3(0.5, 0.0, 1.0)
		_wall.rotate_y(0.5)
		await frames(2)
		var now := _wall.global_transform.affine_inverse() * _climber.get_leaf_transform(20)
		check_near(now.origin, leaf.origin, 1e-3, "leaf in the wall's axes")
		check_near(now.basis.y, leaf.basis.y, 1e-3, "its axis")
		check(not _climber.is_growing(), "it does not grow again")


func _grow_on_wall() -> void:
	_wall.add_child(_climber)
	await _grown()


func _grown() -> void:
	await frames(2)
	await until(func() -> bool: return not _climber.is_growing(), "it has grown")
