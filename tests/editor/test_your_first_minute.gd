@tool
extends "actions_test.gd"
## The first steps of a new user: a new species, drawn with the mouse, sways in the viewport.

const SCENE := "res://first_minute.tscn"
const SWAY_SCRIPT := "res://addons/undergrowth/editor/wind/sway_button.gd"
const SPECIES := "res://first_minute.tres"


func test_a_species_of_ones_own_sways_in_the_viewport() -> void:
	await _open_scene(SCENE, _make_garden())
	EditorInterface.set_main_screen_editor("3D")
	_use_a_first_users_wind()
	await inspect("Own Drawing")
	await _draw_a_bulb()
	await _save()
	_select([])
	await _use("Add")
	var plant := EditorInterface.get_edited_scene_root().get_child(-1) as Plant3D
	check(plant and plant.species.resource_path == SPECIES, "the scene has the saved species")
	check(await until(func() -> bool: return plant.get_deflection() > 0.01), "it sways at once")
	await take_picture("first_minute")
	await click(find_by_script(SWAY_SCRIPT))
	check_equal(plant.get_deflection(), 0.0, "deflection after the end")
	check_equal(EditorInterface.save_scene(), OK, "saving")
	var text := FileAccess.get_file_as_string(SCENE)
	check(text.contains(SPECIES), "the scene names the species' file")


## Restores the initial state of the dock after any test.
func _use_a_first_users_wind() -> void:
	_state().wind.kind = PlantWind.KIND_WAVES
	_state().wind.strength = 5.0
	_state().wind.frequency = 0.4


## Narrow in the middle, wide at the top.
func _draw_a_bulb() -> void:
	var curve := (_state().function as CurvePlantFunction).width_curve
	var points := plot_points() as Control
	await frames(2)
	var grip := Vector2(points.size.x * curve.get_point_position(1).x, 0.0)
	await drag(points, grip, Vector2(points.size.x * 0.8, 2.0))
	check(curve.get_point_position(1).x > 0.7, "the widest place is near the top")
	await double_click(points, Vector2(points.size.x * 0.5, points.size.y * 0.4))
	check_equal(curve.point_count, 4, "points")


func _save() -> void:
	await _use("Save")
	var dialog := _dialog("EditorFileDialog") as EditorFileDialog
	check(dialog != null, "the file dialog opens")
	await _type_into(dialog, dialog.get_line_edit(), SPECIES)
	await click(dialog.get_ok_button())
	await frames(3)
	check(FileAccess.file_exists(SPECIES), "the file is there: " + _message())


func _make_garden() -> Node3D:
	var root := Node3D.new()
	root.name = "FirstMinute"
	return root
