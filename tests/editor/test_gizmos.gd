@tool
extends "viewport_test.gd"
## Gizmos are created and freed with their nodes, also while the viewport references them.

const GizmoShapes := preload("res://addons/undergrowth/editor/gizmo/gizmo_shapes.gd")
const PLUGIN := "undergrowth"


func test_gizmos_return_with_the_plugin() -> void:
	var plant := await _open_plant()
	check_equal(plant.get_gizmos().size(), 1, "gizmos")
	await _switch(false)
	check_equal(plant.get_gizmos().size(), 0, "gizmos without the plugin")
	await _switch(true)
	check_equal(plant.get_gizmos().size(), 1, "gizmos with the plugin again")


func test_gizmos_return_with_a_node_that_is_moved_in_the_tree() -> void:
	var plant := await _open_plant()
	var bed := Node3D.new()
	_put(EditorInterface.get_edited_scene_root(), bed)
	plant.reparent(bed)
	plant.owner = EditorInterface.get_edited_scene_root()
	await frames(5)
	check_equal(plant.get_gizmos().size(), 1, "gizmos")
	check(_gizmo_of(plant).get_node_3d() == plant, "it is of that plant")


func test_the_plugin_is_removed_after_a_scene_with_a_dragged_handle_was_reloaded() -> void:
	var held := await _drag_height_and_reload()
	check_nobodys(held)
	await _switch(false)
	await _switch(true)
	check_equal(_plant().get_gizmos().size(), 1, "gizmos of the new plant")
	await _choose_only(_plant())
	await click(_view(), Vector2(20, _view().size.y - 20))
	await frames(2)


func test_a_scene_that_is_reloaded_while_a_handle_is_dragged() -> void:
	var plant := await _open_plant()
	await _choose_only(plant)
	var held := weakref(_gizmo_of(plant))
	var from := _in_window(_view(), _tip_of(plant))
	await _point(_view(), from)
	_press(_view(), from, MOUSE_BUTTON_LEFT, true)
	_move(_view(), from, from - Vector2(0, 20), MOUSE_BUTTON_MASK_LEFT)
	await frames(2)
	check(plant.height > 0.0, "the height follows the pointer")
	plant = null
	await _reload(SCENE_FILE)
	check_nobodys(held)
	var version := _history().get_version()
	_move(_view(), from, from - Vector2(0, 40), MOUSE_BUTTON_MASK_LEFT)
	await frames(2)
	_press(_view(), from - Vector2(0, 40), MOUSE_BUTTON_LEFT, false)
	await frames(2)
	check_equal(_plant().height, 0.0, "height of the new plant")
	check_equal(_history().get_version(), version, "version of the scene")


## The viewport still references its gizmo. The editor once crashed when the plugin was removed.
func test_a_plant_that_is_removed_while_its_handle_is_under_the_pointer() -> void:
	var plant := await _open_plant()
	await _choose_only(plant)
	await _point(_view(), _in_window(_view(), _tip_of(plant)))
	await frames(2)
	var held := weakref(_gizmo_of(plant))
	plant.free()
	await frames(5)
	check(held.get_ref() != null, "the viewport holds the gizmo under the pointer")
	check_nobodys(held)
	await _switch(false)
	await _switch(true)
	check(dock() != null, "the dock is back")


func test_a_stem_shows_its_joints() -> void:
	var plant := await _open_plant()
	await _choose_only(plant)
	plant.species.law = PlantFunction.LAW_STEM
	plant.apply_impulse(Vector3(60, 0, 0))
	for i in 10:
		plant.advance(1.0 / 60.0)
	await frames(5)
	var plugin := _gizmo_of(plant).get_plugin()
	var joints: PackedVector3Array = plugin.get_script().joints_of(plant)
	check_equal(joints.size(), 5, "root, joints and tip")
	check(joints[4].is_equal_approx(plant.get_tip_position()), "the last is the tip")
	check(joints[4].x > maxf(0.1, 2.5 * joints[2].x), "it bends: %s" % joints)
	var lines := GizmoShapes.chain(joints)
	check_equal(lines.size(), 5 * 6 + 4 * 2, "ends of lines")
	await take_picture("stem_gizmo")


func test_two_heights_in_a_moment_are_two_steps() -> void:
	var first := await _open_plant(1)
	var second := EditorInterface.get_edited_scene_root().get_child(1) as Plant3D
	var version := _history().get_version()
	EditorInterface.get_selection().clear()
	for plant: Plant3D in [first, second]:
		plant.height = 2.0
		var gizmo := _gizmo_of(plant)
		gizmo.get_plugin().call(&"_commit_handle", gizmo, 0, false, 0.0, false)
	check_equal(_history().get_version(), version + 2, "two steps")
	await undo()
	check_equal(first.height, 2.0, "height of the first after one undo")
	check_equal(second.height, 0.0, "height of the second after one undo")


## Fails the test unless a remaining gizmo belongs to a valid node outside of the scene.
## scene.
func check_nobodys(held: WeakRef) -> void:
	var gizmo := held.get_ref() as EditorNode3DGizmo
	if gizmo:
		var node: Variant = gizmo.get_node_3d()
		check(is_instance_valid(node) and not (node as Node).is_inside_tree(), "it has no parent")


# The gizmo of the freed plant.
func _drag_height_and_reload() -> WeakRef:
	var plant := await _open_plant()
	await _choose_only(plant)
	var from := _tip_of(plant)
	await drag(_view(), from, from + Vector2(0, -40))
	check(plant.height > 0.0, "the handle was dragged")
	var held := weakref(_gizmo_of(plant))
	plant = null
	await _reload(SCENE_FILE)
	return held


func _plant() -> Plant3D:
	return EditorInterface.get_edited_scene_root().get_child(0) as Plant3D


func _gizmo_of(plant: Plant3D) -> EditorNode3DGizmo:
	return plant.get_gizmos()[0]


func _switch(on: bool) -> void:
	EditorInterface.set_plugin_enabled(PLUGIN, on)
	await frames(5)
