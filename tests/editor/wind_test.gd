@tool
extends "editor_test.gd"
## Base of the tests of the wind's panel: its controls, and a scene with plants.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const SCENE_FILES := "res://wind_page_%d.tscn"

var _scene_file := ""
var _scene_count := 0


func _wind() -> PlantWind:
	return (dock().get("state") as EditorState).wind


func _type_number(name: String, number: String) -> void:
	await open_wind()
	var slider := wind_part(name) as EditorSpinSlider
	await click(slider, Vector2(slider.size.x * 0.3, slider.size.y * 0.4))
	await frames(3)
	await press_key(slider, KEY_A, 0, true)
	await type(slider, number)
	await press_key(slider, KEY_ENTER)
	await frames(2)


func _press_button(name: String) -> void:
	await open_wind()
	await click(wind_part(name) as Control)
	await frames(2)


func _make_constant_wind() -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	return wind


func _save_scene(root: Node, path: String) -> void:
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, path)


## Opens a scene with three plants, of which the first has a wind.
func _open_scene() -> Array[Plant3D]:
	var root := Node3D.new()
	root.name = "Meadow"
	for i in 3:
		var plant := Plant3D.new()
		plant.species = TulipFunction.new()
		plant.position.x = i
		root.add_child(plant)
		plant.owner = root
	(root.get_child(0) as Plant3D).wind = _make_constant_wind()
	_scene_count += 1
	_scene_file = SCENE_FILES % _scene_count
	_save_scene(root, _scene_file)
	if _scene_file in EditorInterface.get_open_scenes():  # Of another script.
		EditorInterface.reload_scene_from_path(_scene_file)
	EditorInterface.open_scene_from_path(_scene_file)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	EditorInterface.save_scene()
	var plants: Array[Plant3D] = []
	plants.assign(EditorInterface.get_edited_scene_root().get_children())
	return plants
