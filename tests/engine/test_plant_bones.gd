## The drawn motion of a Plant3D, with and without a reference to its skeleton.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
## Radians between the drawn pose, which is between two steps, and the tip after the last one.
const A_STEP := 0.1

var _plant: Plant3D
var _holder: Node3D


func before_each() -> void:
	_holder = Node3D.new()
	root.add_child(_holder)
	_plant = Plant3D.new()
	_plant.species = TulipFunction.new()
	_plant.species.natural_frequency = 0.5
	_plant.wind = PlantWind.new()
	_plant.wind.strength = 1.5
	_holder.add_child(_plant)


func after_each() -> void:
	_plant.free()
	_holder.free()


func test_a_plant_bends_on_the_screen_without_a_skeleton() -> void:
	await _bend()
	check(_node_direction().angle_to(_shown_direction()) > 0.05, "the node is not notified")
	_check_shown("in the wind")


func test_get_skeleton_returns_the_shown_pose() -> void:
	await _bend()
	var shown := _shown_direction()
	_plant.get_skeleton()
	check_near(_node_direction(), shown, 1e-4, "the bone at once")
	await _bend()
	check(_node_direction().angle_to(shown) > 0.01, "it goes on")
	check(_node_direction().angle_to(_shown_direction()) < A_STEP, "the bone later")
	_check_shown("held")


func test_a_plant_that_returns_to_the_tree_shows_its_present_bend() -> void:
	await _bend()
	_plant.simulation_enabled = false
	_holder.remove_child(_plant)
	_holder.add_child(_plant)
	await frames(4)
	_check_shown("back in the tree")
	_plant.simulation_enabled = true
	await _bend()
	_check_shown("and moving")


func test_a_plant_that_was_hidden_shows_its_present_bend() -> void:
	await frames(10)
	_holder.hide()
	await _bend()
	_holder.show()
	await frames(2)
	_check_shown("shown again")


func test_a_rebuilt_plant_continues_its_motion_on_the_screen() -> void:
	await _bend()
	_plant.height = 2.0
	await frames(3)
	_check_shown("higher")


func test_a_plant_without_its_skeleton_makes_another() -> void:
	await _bend()
	_plant.get_skeleton().free()
	await _bend()
	_check_shown("with another skeleton")


func test_a_plant_that_is_carried_about_bends_on_the_screen() -> void:
	for i in 30:
		_holder.rotate_y(0.05)
		_holder.position.x += 0.1
		await frames(1)
	await _bend()
	_check_shown("carried")


## Runs the wind until the plant is bent.
func _bend() -> void:
	for i in 2000:
		await frames(1)
		if _plant.get_deflection() > 0.15 and i > 20:
			return
	check(false, "it bends")


func _check_shown(label: String) -> void:
	var tip := _plant.get_tip_position().normalized()
	check(tip.angle_to(Vector3.UP) > 0.05, label + ": it is bent")
	check(_shown_direction().angle_to(tip) < A_STEP, label + ": it is shown so")


func _shown_direction() -> Vector3:
	var shown: MeshInstance3D = _plant.get_node("PlantSkeleton/PlantMesh")
	var skeleton := shown.get_skin_reference().get_skeleton()
	return RenderingServer.skeleton_bone_get_transform(skeleton, 1).basis * Vector3.UP


func _node_direction() -> Vector3:
	var skeleton: Skeleton3D = _plant.get_node("PlantSkeleton")
	return skeleton.get_bone_pose_rotation(1) * Vector3.UP
