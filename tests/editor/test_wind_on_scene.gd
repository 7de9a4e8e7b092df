@tool
extends "wind_test.gd"
## Effects of the wind panel on the edited scene.

const FIELD_FILE := "res://wind_page_field.tscn"
const EMPTY_FILE := "res://wind_page_empty.tscn"
const SHIPPED := "res://addons/undergrowth/winds/breeze.tres"
const SHARED_FILE := "res://wind_page_shared.tres"


func test_a_change_is_seen_in_the_scene_and_undone() -> void:
	var plants := await _open_scene()
	await open_wind()
	check(_wind() == plants[0].wind, "the panel edits the wind of the scene")
	check_equal((wind_part("Shown") as Label).text, tr("Wind of the Scene"), "what is shown")
	var version := _history().get_version()
	await _press_button("Gale")
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(plants[0].wind.kind, PlantWind.KIND_AIR, "kind of a preset")
	check(is_equal_approx(plants[0].wind.speed, 19.0), "speed of a preset")
	await _type_number("Speed", "3")
	check_equal(plants[0].wind.speed, 3.0, "speed in the scene")
	await undo()
	check(is_equal_approx(plants[0].wind.speed, 19.0), "one step undoes a number")
	check_equal((wind_part("Speed") as EditorSpinSlider).value, 19.0, "in the panel")
	await undo()
	check_equal(plants[0].wind.kind, PlantWind.KIND_CONSTANT, "kind after undo")
	EditorInterface.save_scene()


func test_the_sway_shows_a_change_at_once() -> void:
	var plants := await _open_scene()
	var state: EditorState = dock().get("state")
	state.choose_sway(true)
	var moves := func() -> bool: return plants[0].get_deflection() > 0.01
	check(await until(moves), "a plant with wind moves")
	await take_picture("wind")
	await _press_button("Calm")
	var rests := func() -> bool: return plants[0].get_deflection() < 0.005
	check(await until(rests), "it rests in still air: %f" % plants[0].get_deflection())
	await undo()
	check(await until(moves), "it moves after undo")
	EditorInterface.open_scene_from_path(_make_empty_scene())
	await frames(5)
	check_equal(plants[0].get_deflection(), 0.0, "deflection in the scene that was left")
	state.choose_sway(false)
	state.choose_sway(true)
	state.sways = false


func test_set_as_scene_wind_is_one_step() -> void:
	var plants := await _open_scene()
	EditorInterface.get_selection().clear()
	var version := _history().get_version()
	await _press_button("SetForScene")
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(_history().get_current_action_name(), tr("Set Scene Wind"), "its name")
	for plant in plants:
		check(plant.wind == _wind(), "all share the wind of the panel")
	await undo()
	check(not plants[1].wind, "no wind after undo")
	await redo()
	check_equal(plants[2].wind.kind, PlantWind.KIND_CONSTANT, "kind after redo")
	EditorInterface.save_scene()
	var scene: PackedScene = ResourceLoader.load(
		_scene_file, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP
	)
	var saved := scene.instantiate()
	check_equal((saved.get_child(1) as Plant3D).wind.strength, _wind().strength, "saved strength")
	saved.free()


func test_the_popup_follows_the_selection() -> void:
	var plants := await _open_scene()
	plants[1].wind = PlantWind.new()
	plants[1].wind.strength = 7.0
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(plants[1])
	await frames(3)
	check(_wind() == plants[1].wind, "the wind of the selected plant")
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(plants[2])
	await frames(3)
	var state: EditorState = dock().get("state")
	check(_wind() == state.own_wind, "the selected plant has none: that of new plants")
	check_equal((wind_part("Shown") as Label).text, tr("Wind of New Plants"), "what is shown")
	EditorInterface.get_selection().clear()
	await frames(3)
	check(_wind() == plants[0].wind, "without a selection the first of the scene")


func test_a_wind_of_its_own_file_is_changed_there() -> void:
	check_equal(ResourceSaver.save(_make_constant_wind(), SHARED_FILE), OK, "saving")
	var plants := await _open_scene()
	for plant in plants:
		plant.wind = load(SHARED_FILE)
	EditorInterface.get_selection().add_node(plants[2])
	await frames(3)
	await _press_button("Gale")
	check_equal(plants[2].wind.resource_path, SHARED_FILE, "the file stays shared")
	EditorInterface.save_scene()
	check_equal(_read_kind(SHARED_FILE), PlantWind.KIND_AIR, "kind in the file")
	await undo()
	EditorInterface.save_scene()
	check_equal(_read_kind(SHARED_FILE), PlantWind.KIND_CONSTANT, "kind in the file after undo")


func test_a_wind_of_the_add_on_stays_as_it_is() -> void:
	var shipped: PlantWind = load(SHIPPED)
	var speed := shipped.speed
	var plants := await _open_scene()
	for plant in plants:
		plant.wind = shipped
	EditorInterface.get_selection().add_node(plants[2])
	await frames(3)
	await _press_button("Gale")
	check_equal(shipped.speed, speed, "speed in the file of the add-on")
	for plant in plants:
		check(is_equal_approx(plant.wind.speed, 19.0), "speed in the scene")
	check(plants[0].wind == plants[1].wind, "the plants still share one wind")
	check(_wind() == plants[0].wind, "the panel edits it")
	await undo()
	check(plants[0].wind == shipped, "the add-on's wind after undo")


func test_field_takes_part() -> void:
	var field := await _open_field()
	var pages := func() -> bool: return field.get_plant_count() > 0
	check(await until(pages), "the field is filled")
	check(not field.wind, "the field has no wind of its own yet")
	await _press_button("SetForScene")
	check(field.wind and field.wind.speed == _wind().speed, "the field has this wind")
	await undo()
	check(not field.wind, "no wind after undo")


func _read_kind(path: String) -> PlantWind.Kind:
	var wind: PlantWind = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	return wind.kind


func _make_empty_scene() -> String:
	var root := Node3D.new()
	root.name = "Nothing"
	_save_scene(root, EMPTY_FILE)
	return EMPTY_FILE


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
