@tool
extends "editor_test.gd"
## Base of the tests of the 3D viewport: scenes with a plant or a field, and positions in it.

const SCENE_FILE := "res://viewport.tscn"
const FIELD_FILE := "res://viewport_field.tscn"


## Opens a scene with a tulip in the middle and [param others] more to its right. Returns the first.
func _open_plant(others := 0) -> Plant3D:
	var root := Node3D.new()
	root.name = "Meadow"
	for i in 1 + others:
		var plant := Plant3D.new()
		plant.species = TulipFunction.new()
		plant.position.x = i * 0.5
		_put(root, plant)
	return await _open(SCENE_FILE, root) as Plant3D


## A scene with a field of 2 m by 4 m.
func _open_field() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Yard"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(2, 4)
	_put(root, field)
	return await _open(FIELD_FILE, root) as PlantField3D


func _put(root: Node3D, node: Node3D) -> void:
	root.add_child(node)
	node.owner = root


## Saves the scene, opens it again and returns its first node.
func _open(path: String, root: Node3D) -> Node:
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, path)
	if path in EditorInterface.get_open_scenes():
		EditorInterface.reload_scene_from_path(path)
	EditorInterface.open_scene_from_path(path)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	return EditorInterface.get_edited_scene_root().get_child(0)


## As the menu item "Reload Saved Scene".
func _reload(path: String) -> Node3D:
	EditorInterface.reload_scene_from_path(path)
	await frames(10)
	return EditorInterface.get_edited_scene_root().get_child(0)


func _choose_only(node: Node) -> void:
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(node)
	await frames(5)


## Returns the control over the first 3D viewport that receives the mouse.
func _view() -> Control:
	return EditorInterface.get_editor_viewport_3d(0).get_parent() as Control


## Returns the drawn position of [param point], in the axes of [param node].
func _place_of(node: Node3D, point: Vector3) -> Vector2:
	var viewport := EditorInterface.get_editor_viewport_3d(0)
	var pixel := viewport.get_camera_3d().unproject_position(node.to_global(point))
	return pixel * _view().size / Vector2(viewport.size)


## Returns the drawn position of the point at that share of the plant's height.
func _tip_of(plant: Plant3D, share := 1.0) -> Vector2:
	return _place_of(plant, Vector3.UP * plant.get_plant_height() * share)


## Returns the undo history of the edited scene.
func _history() -> UndoRedo:
	var manager := EditorInterface.get_editor_undo_redo()
	var id := manager.get_object_history_id(EditorInterface.get_edited_scene_root())
	return manager.get_history_undo_redo(id)
