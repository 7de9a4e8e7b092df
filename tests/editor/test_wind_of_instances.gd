@tool
extends "wind_test.gd"
## The wind panel writes only saved values to plants of instanced scenes.

const POT := "res://wind_pot.tscn"
const TULIP := "res://wind_tulip.tscn"
const YARD := "res://wind_yard.tscn"


func test_a_wind_inside_another_scene_stays_as_it_is() -> void:
	var yard := await _open_yard([TULIP, TULIP])
	var plants := yard.get_children()
	var foreign: PlantWind = plants[0].get(&"wind")
	var file := FileAccess.get_file_as_string(TULIP)
	await _press_button("Gale")
	await _press_button("SetForScene")
	check_equal(foreign.kind, PlantWind.KIND_CONSTANT, "kind of the wind in the other scene")
	for plant in plants:
		check_equal((plant as Plant3D).wind.kind, PlantWind.KIND_AIR, "kind of its own wind")
	check(plants[0].get(&"wind") == plants[1].get(&"wind"), "they share it")
	check(_wind() == plants[0].get(&"wind"), "the panel edits it now")
	check_equal(EditorInterface.save_scene(), OK, "saving")
	check_equal(_read_kind(), PlantWind.KIND_AIR, "kind in the saved scene")
	check_equal(FileAccess.get_file_as_string(TULIP), file, "file of the other scene")
	await undo()
	check(plants[0].get(&"wind") == foreign, "the other scene's wind blows again after undo")
	await redo()
	await _press_button("SetForScene")
	check_equal(_reported(), tr("The plants have this wind already."), "message when set again")
	await undo()


func test_a_plant_that_the_scene_does_not_save_is_reported() -> void:
	var yard := await _open_yard([POT])
	var plant := yard.get_child(0).get_child(0) as Plant3D
	await _press_button("Gale")
	await _press_button("SetForScene")
	check_equal(plant.wind.kind, PlantWind.KIND_CONSTANT, "its wind")
	check(_reported().contains("another scene"), "the status line: " + _reported())
	yard.set_editable_instance(yard.get_child(0), true)
	await _press_button("SetForScene")
	check_equal(plant.wind.kind, PlantWind.KIND_AIR, "its wind with editable children")
	await undo()


func _reported() -> String:
	return (part("Status/Text") as Label).text


## Returns the values of the saved scene's first plant, loaded again.
func _read_kind() -> PlantWind.Kind:
	var scene := ResourceLoader.load(YARD, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene
	var yard := scene.instantiate()
	var kind := (yard.get_child(0) as Plant3D).wind.kind
	yard.free()
	return kind


## Opens a scene with an instance of each of these, without a selection.
func _open_yard(parts: Array[String]) -> Node3D:
	_save(_make_plant(), TULIP)
	var pot := Node3D.new()
	pot.name = "Pot"
	var plant := _make_plant()
	pot.add_child(plant)
	plant.owner = pot
	_save(pot, POT)
	var yard := Node3D.new()
	yard.name = "Yard"
	for path in parts:
		var scene := load(path) as PackedScene
		var instance := scene.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE)
		yard.add_child(instance, true)
		instance.owner = yard
	_save(yard, YARD)
	if YARD in EditorInterface.get_open_scenes():
		EditorInterface.reload_scene_from_path(YARD)
	EditorInterface.open_scene_from_path(YARD)
	await frames(10)
	EditorInterface.get_selection().clear()
	return EditorInterface.get_edited_scene_root() as Node3D


func _make_plant() -> Plant3D:
	var plant := Plant3D.new()
	plant.name = "Tulip"
	plant.species = TulipFunction.new()
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_CONSTANT
	return plant


func _save(root: Node, path: String) -> void:
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	check_equal(ResourceSaver.save(scene, path), OK, "saving " + path)
