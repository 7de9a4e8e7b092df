@tool
extends "wind_test.gd"
## Effects of the wind page on the edited scene.

const SCENE_FILES := "res://wind_page_%d.tscn"
const FIELD_FILE := "res://wind_page_field.tscn"
const EMPTY_FILE := "res://wind_page_empty.tscn"
const SHARED_FILE := "res://wind_page_shared.tres"

var _scene_file := ""
var _scene_count := 0


func test_scene_moves_and_is_not_changed() -> void:
	var plants := await _open_scene()
	await _choose_kind(PlantWind.KIND_CONSTANT)
	var version := _history().get_version()
	var file := FileAccess.get_file_as_string(_scene_file)
	await _press_button("OnScene")
	var moves := func() -> bool: return plants[0].get_deflection() > 0.01
	check(await until(moves), "the plants move")
	check_equal(_history().get_version(), version, "version of the scene")
	await take_picture("wind")
	EditorInterface.save_scene()
	check_equal(FileAccess.get_file_as_string(_scene_file), file, "the saved scene")
	await _press_button("OnScene")
	for plant in plants:
		check_equal(plant.get_deflection(), 0.0, "deflection after the end")


func test_apply_is_one_step() -> void:
	var plants := await _open_scene()
	await _choose_kind(PlantWind.KIND_WAVES)
	EditorInterface.get_selection().clear()
	var version := _history().get_version()
	await _press_button("Apply")
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(_history().get_current_action_name(), tr("Apply Wind to Plants"), "its name")
	check_equal(plants[0].wind.kind, PlantWind.KIND_WAVES, "kind of the wind that was there")
	check(plants[1].wind and plants[1].wind == plants[2].wind, "a new wind, shared")
	await undo()
	check_equal(plants[0].wind.kind, PlantWind.KIND_CONSTANT, "kind after undo")
	check(not plants[1].wind, "no wind after undo")
	await redo()
	check_equal(plants[2].wind.kind, PlantWind.KIND_WAVES, "kind after redo")
	EditorInterface.save_scene()
	var scene: PackedScene = ResourceLoader.load(
		_scene_file, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP
	)
	var saved := scene.instantiate()
	check_equal((saved.get_child(1) as Plant3D).wind.strength, _wind().strength, "saved strength")
	saved.free()


func test_apply_to_selected_only() -> void:
	var plants := await _open_scene()
	await _choose_kind(PlantWind.KIND_BURSTS)
	await _type_number("Strength", "3")
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(plants[1])
	await _press_button("Apply")
	check_equal(plants[1].wind.kind, PlantWind.KIND_BURSTS, "the selected plant")
	check_equal(plants[0].wind.kind, PlantWind.KIND_CONSTANT, "another plant")
	await _type_number("Strength", "7")
	await _press_button("Take")
	check_equal(_wind().strength, 3.0, "strength taken from the scene")
	await undo()


func test_apply_changes_a_wind_of_its_own_file() -> void:
	check_equal(ResourceSaver.save(_make_constant_wind(), SHARED_FILE), OK, "saving")
	var plants := await _open_scene()
	for plant in plants:
		plant.wind = load(SHARED_FILE)
	await _choose_kind(PlantWind.KIND_WAVES)
	await _press_button("Apply")
	check_equal(plants[2].wind.resource_path, SHARED_FILE, "the file stays shared")
	EditorInterface.save_scene()
	check_equal(_read_kind(SHARED_FILE), PlantWind.KIND_WAVES, "kind in the file")
	await undo()
	EditorInterface.save_scene()
	check_equal(_read_kind(SHARED_FILE), PlantWind.KIND_CONSTANT, "kind in the file after undo")


func test_plants_of_a_closed_scene_do_not_move() -> void:
	var plants := await _open_scene()
	await _choose_kind(PlantWind.KIND_CONSTANT)
	await _press_button("OnScene")
	check(await until(func() -> bool: return plants[0].get_deflection() > 0.01), "the plants move")
	EditorInterface.open_scene_from_path(_make_empty_scene())
	await frames(5)
	check_equal(plants[0].get_deflection(), 0.0, "deflection in the scene that was left")
	EditorInterface.open_scene_from_path(_scene_file)
	check(await until(func() -> bool: return plants[0].get_deflection() > 0.01), "they move again")
	await _press_button("OnScene")


func test_field_takes_part() -> void:
	var field := await _open_field()
	var pages := func() -> bool: return field.get_plant_count() > 0
	check(await until(pages), "the field is filled")
	await _choose_kind(PlantWind.KIND_CONSTANT)
	var id := field.get_plant_ids()[0]
	var rest := field.get_tip_position(id)
	await _press_button("OnScene")
	var moves := func() -> bool: return field.get_tip_position(id).distance_to(rest) > 0.01
	check(await until(moves), "the plants of the field move")
	await _press_button("OnScene")
	check(field.get_tip_position(id).is_equal_approx(rest), "they are at rest after the end")
	check(not field.wind, "the field has no wind of its own yet")
	await _press_button("Apply")
	check(field.wind and field.wind.kind == PlantWind.KIND_CONSTANT, "the field has this wind")
	await undo()
	check(not field.wind, "no wind after undo")


func test_a_scene_without_plants_is_reported() -> void:
	EditorInterface.open_scene_from_path(_make_empty_scene())
	await frames(5)
	await _press_button("Apply")
	var reported := (part("Status/Text") as Label).text
	check(reported.contains(tr("no plants")), "the status line: " + reported)


func _make_constant_wind() -> PlantWind:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	return wind


func _read_kind(path: String) -> PlantWind.Kind:
	var wind: PlantWind = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	return wind.kind


func _make_empty_scene() -> String:
	var root := Node3D.new()
	root.name = "Nothing"
	_save_scene(root, EMPTY_FILE)
	return EMPTY_FILE


func _save_scene(root: Node, path: String) -> void:
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, path)


func _history() -> UndoRedo:
	var manager := EditorInterface.get_editor_undo_redo()
	var id := manager.get_object_history_id(EditorInterface.get_edited_scene_root())
	return manager.get_history_undo_redo(id)


## Opens a scene with a small field.
func _open_field() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Field"
	var field := PlantField3D.new()
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(2, 2)
	root.add_child(field)
	field.owner = root
	_save_scene(root, FIELD_FILE)
	EditorInterface.open_scene_from_path(FIELD_FILE)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	return EditorInterface.get_edited_scene_root().get_child(0) as PlantField3D


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
	EditorInterface.open_scene_from_path(_scene_file)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	EditorInterface.save_scene()
	var plants: Array[Plant3D] = []
	plants.assign(EditorInterface.get_edited_scene_root().get_children())
	return plants
