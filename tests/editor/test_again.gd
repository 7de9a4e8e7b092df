@tool
extends "style_checks.gd"
## The project saved by all other tests, opened again in an editor at 200 %.

const SCENE := "res://actions_scene.tscn"
const SPECIES := "res://my species/Ševar vlažni.tres"
const OWN_SCRIPT := "res://sas_uz_rijeku.gd"


func test_the_project_opens_with_its_species() -> void:
	check_equal(EditorInterface.get_editor_scale(), 2.0, "scale")
	await open_panel()
	for path: String in [SPECIES, OWN_SCRIPT]:
		check(await until(func() -> bool: return find_key(path) >= 0), path + " is listed")


func test_icons_follow_the_scale() -> void:
	var icon := load("res://addons/undergrowth/icons/Plant3D.svg") as Texture2D
	check(await until(func() -> bool: return icon.get_height() == 32), "the icon has 32 pixels")


func test_the_saved_scene_opens_with_its_plants() -> void:
	EditorInterface.open_scene_from_path(SCENE)
	EditorInterface.set_main_screen_editor("3D")
	await frames(5)
	var root := EditorInterface.get_edited_scene_root()
	check(root != null and root.scene_file_path == SCENE, "the scene is open")
	var plants := root.find_children("*", "Plant3D", true, false)
	check(plants.size() > 1, "%d plants" % plants.size())
	for plant: Plant3D in plants:
		check(plant.get_mesh() != null, plant.name + " has a mesh")


func test_picture_at_200_percent() -> void:
	await _choose("Bellflower")
	var height := EditorInterface.get_base_control().size.y
	check(dock().size.y <= height * 0.5, "the panel leaves room: %s" % dock().size)
	await _take_both("200")


func test_picture_at_200_percent_in_light() -> void:
	var before := used_theme()
	await use_theme(LIGHT)
	await _take_both("200_light")
	await use_theme(before)


func _take_both(name: String) -> void:
	await _choose("Bellflower")
	check_nothing_is_cut(dock(), "panel")
	await take_picture(name)
	EditorInterface.open_scene_from_path(SCENE)
	await open_wind()
	check_nothing_is_cut(wind_panel(), "wind")
	await take_picture(name + "_wind")
	await close_wind()
