@tool
extends "actions_test.gd"
## Ground, sun and sky that *Add as Field* adds to a scene without them.

const SCENE := "res://surroundings.tscn"
const GROUNDS := "res://addons/undergrowth/grounds/"


func test_a_field_in_an_empty_scene_comes_with_ground_sun_and_sky() -> void:
	var root := await _open_garden()
	await _choose("Fern Floor")
	_offer(true)
	await _use("AddField")
	var field := root.get_child(-1) as PlantField3D
	check(field != null, "the field is added")
	check_equal(root.get_child_count(), 4, "children: %s" % [root.get_children()])
	var ground := root.get_node_or_null(^"Ground") as MeshInstance3D
	var sun := root.find_children("*", "DirectionalLight3D", false)[0] as DirectionalLight3D
	var sky := root.find_children("*", "WorldEnvironment", false)[0] as WorldEnvironment
	check(ground.owner == root and sun.owner == root and sky.owner == root, "saved with the scene")
	check(sun.shadow_enabled and sun.light_energy > 1.0, "the sun shines")
	check(sky.environment.background_mode == Environment.BG_SKY, "the sky is one")
	check_equal(ground.get(&"field"), field, "the field of the ground")
	check(ground.global_position.is_equal_approx(field.global_position), "it is below the field")
	_check_ground(ground)
	await undo()
	check_equal(root.get_child_count(), 0, "children after one undo")
	await redo()
	check_equal(root.get_child_count(), 4, "children after redo")
	check_equal(EditorInterface.save_scene(), OK, "saving")
	var text := FileAccess.get_file_as_string(SCENE)
	check(text.contains("environments/day.tres"), "the scene uses the add-on's environment")
	check(text.contains('field = NodePath("../'), "the scene says the field of the ground")
	await _use("AddField")
	check_equal(root.get_child_count(), 5, "a second field comes alone")
	await undo()
	await undo()


func test_what_a_scene_has_is_not_added() -> void:
	var root := await _open_garden()
	var sun := DirectionalLight3D.new()
	root.add_child(sun)
	sun.owner = root
	var box := CSGBox3D.new()
	box.size = Vector3(4000.0, 0.1, 4000.0)
	root.add_child(box)
	box.owner = root
	await frames(5)
	await _choose("Meadow Grass")
	_offer(true)
	await _use("AddField")
	check_equal(root.find_children("*", "DirectionalLight3D").size(), 1, "suns")
	check_equal(root.find_children("*", "WorldEnvironment").size(), 1, "skies")
	check(root.get_node_or_null(^"Ground") == null, "no ground on a ground")
	await undo()
	_offer(false)
	await _use("AddField")
	check_equal(root.find_children("*", "WorldEnvironment").size(), 0, "skies without the offer")
	await undo()


func _offer(on: bool) -> void:
	(part("Browser/Actions/Surroundings") as CheckBox).button_pressed = on


func _check_ground(ground: MeshInstance3D) -> void:
	var material := ground.get_active_material(0) as ShaderMaterial
	var ready := load(GROUNDS + "forest_floor.tres") as ShaderMaterial
	check(material.is_built_in(), "the material belongs to the scene")
	check_equal(
		material.get_shader_parameter(&"litter"), ready.get_shader_parameter(&"litter"), "litter"
	)
	check(
		material.get_shader_parameter(&"field_color") != ready.get_shader_parameter(&"field_color"),
		"the colour of the field"
	)


func _open_garden() -> Node3D:
	var root := Node3D.new()
	root.name = "Garden"
	await _close_all_scenes()
	await _open_scene(SCENE, root)
	_select([])
	return EditorInterface.get_edited_scene_root() as Node3D
