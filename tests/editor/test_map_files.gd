@tool
extends "brush_test.gd"
## A painted map in files of one tile each: the brush bar writes them, and saving the scene the
## changed ones.

const FILE := "res://maps/yard.plantmap"
const FOLDER := "res://maps/yard_tiles"
const FROM := Vector3(-0.5, 0, 1)
const TO := Vector3(0.5, 0, 1)
## Within the tile at column 3, row -3.
const FAR := Vector3(100, 0, -70)


func test_the_bar_saves_a_map_in_tiles_and_the_scene_its_changes() -> void:
	var field := await _edited_field()
	var button := _bar().get_node("%SaveMap") as Button
	check(not button.visible, "no map, no button")
	await _paint(field)
	check(button.visible, "a map in the scene can be saved")
	await click(button)
	await _save_in_dialog()
	check_equal(field.map.resource_path, FILE, "file of the map")
	check(not button.visible, "it is in tiles")
	var first := _tiles()
	check(first.size() > 0 and first.size() <= 4, "tiles: %s" % first)
	field.map.paint(FAR, 3.0, GRASS)
	await _paint(field)
	check_equal(EditorInterface.save_scene(), OK, "saving the scene")
	check_equal(_tiles().size(), first.size() + 1, "tiles after a stroke elsewhere: %s" % _tiles())
	var scene := FileAccess.get_file_as_string(FIELD_FILE)
	check(scene.contains(FILE) and not scene.contains("PackedByteArray"), "the scene refers to it")
	var read := ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE) as PlantMap
	check(read.get_density(FAR, GRASS) > 0.9, "what was painted elsewhere is read")
	await _close_and_open(read)


# The saved scene shows the map of the files. A step of undo on it is saved by Ctrl+S.
func _close_and_open(read: PlantMap) -> void:
	var field := await _reload(FIELD_FILE) as PlantField3D
	await _choose_only(field)
	await _rested(field)
	check_equal(field.map.resource_path, FILE, "file of the map of the opened scene")
	check_equal(field.map.data, read.data, "its content")
	var before := field.map.get_density(FROM, GRASS)
	await _choose_tool("Erase")
	_sharpen(1.0)
	await drag(_view(), _place_of(field, FROM), _place_of(field, TO))
	await _choose_tool("Erase")
	EditorInterface.save_scene()
	check(_read_density() < before, "erased in the file")
	await undo()
	EditorInterface.save_scene()
	check_equal(_read_density(), before, "density in the file after undo")


func test_undo_puts_the_map_back_into_the_scene() -> void:
	var field := await _edited_field()
	await _paint(field)
	var path := field.map.resource_path
	await click(_bar().get_node("%SaveMap") as Button)
	await _save_in_dialog()
	await undo()
	check_equal(field.map.resource_path, path, "path after undo")
	check((_bar().get_node("%SaveMap") as Button).visible, "it is offered again")
	await redo()
	check_equal(field.map.resource_path, FILE, "path after redo")


func _paint(field: PlantField3D) -> void:
	await _choose_tool("Paint")
	await drag(_view(), _place_of(field, FROM), _place_of(field, TO))
	await _rested(field)
	await _choose_tool("Paint")


func _read_density() -> float:
	var read := ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE) as PlantMap
	return read.get_density(FROM, GRASS)


func _save_in_dialog() -> void:
	for file in _tiles():
		DirAccess.remove_absolute(FOLDER.path_join(file))
	DirAccess.remove_absolute(FILE)
	DirAccess.make_dir_recursive_absolute(FILE.get_base_dir())
	var dialog := _dialog()
	check(dialog != null, "the dialog opens")
	await click(dialog.get_line_edit())
	await press_key(dialog.get_line_edit(), KEY_A, 0, true)
	await type(dialog.get_line_edit(), FILE)
	await click(dialog.get_ok_button())
	await frames(3)
	check(FileAccess.file_exists(FILE), "the index exists")


func _dialog() -> EditorFileDialog:
	for child in EditorInterface.get_base_control().get_children():
		if child is EditorFileDialog and (child as Window).visible:
			return child
	return null


func _tiles() -> PackedStringArray:
	var exists := DirAccess.dir_exists_absolute(FOLDER)
	return DirAccess.get_files_at(FOLDER) if exists else PackedStringArray()
