@tool
extends "actions_test.gd"
## Ready species and mixes of the add-on in the list, and their use in a scene.

const ThumbnailPainter := preload("res://addons/undergrowth/editor/thumbnails/thumbnail_painter.gd")
const SCENE := "res://actions_ready.tscn"
const SPECIES := "res://addons/undergrowth/species"
const MIXES := "res://addons/undergrowth/mixes"
const TULIP := "res://addons/undergrowth/species/garden_tulip.tres"
const MEADOW := "res://addons/undergrowth/mixes/meadow.tscn"
const LANGUAGE := "hr"


func test_ready_mixes_and_species_come_first() -> void:
	await open_panel()
	var mixes := _list_files(MIXES, "tscn")
	var species := _list_files(SPECIES, "tres")
	var keys: Array[String] = []
	for i in tiles().item_count:
		keys.append(tile_key(i))
	check_equal(_sorted(keys.slice(0, mixes.size())), mixes, "mixes")
	var after := mixes.size() + species.size()
	check_equal(_sorted(keys.slice(mixes.size(), after)), species, "species")
	check_equal(tile_title(after), "Grass", "the thesis's species come after them")
	for i in range(after, keys.size()):
		check(not keys[i].begins_with("res://addons/"), keys[i] + " is not of the add-on")


func test_a_category_shows_only_its_tiles() -> void:
	await open_panel()
	for category: Array in [["Mixes", MIXES, "tscn"], ["Ready", SPECIES, "tres"]]:
		await click(part("Browser/List/" + category[0]) as Control)
		var keys: Array[String] = []
		for i in tiles().item_count:
			keys.append(tile_key(i))
		check_equal(_sorted(keys), _list_files(category[1], category[2]), category[0])
	await click(part("Browser/List/Simple") as Control)
	check_equal(tile_title(0), "Grass", "a simple stem")
	await click(part("Browser/List/All") as Control)
	check(find_tile("Meadow") >= 0 and find_tile("Grass") >= 0, "all are back")


func test_names_are_uncut_and_in_every_language() -> void:
	await open_panel()
	check(find_tile("Ox-eye Daisy") >= 0, "a file may say what it is called")
	check(find_tile("Garden Tulip") >= 0, "else its name is made readable")
	var font := tiles().get_theme_font(&"font")
	var font_size := tiles().get_theme_font_size(&"font_size")
	var known: PackedStringArray = []
	for translation in _domain().find_translations(LANGUAGE, false):
		known.append_array(translation.get_message_list())
	for i in tiles().item_count:
		for line in tiles().get_item_text(i).split("\n"):
			var width := font.get_string_size(line, 0, -1, font_size).x
			check(width <= tiles().fixed_column_width, "%s is cut: %d" % [line, width])
		if not tile_key(i).begins_with("res://") or tile_key(i).begins_with("res://addons/"):
			check(tile_title(i) in known, tile_title(i) + " is translated")


func test_files_of_plants_of_parts_are_painted() -> void:
	var picture := ThumbnailPainter.paint(load(TULIP) as PlantFunction, Vector2i(64, 64))
	var used := picture.get_used_rect()
	check(used.size.y > 55 and used.size.x > 8, "the plant fills it: %s" % used)
	var red := 0
	var green := 0
	for y in 64:
		for x in 64:
			var color := picture.get_pixel(x, y)
			if color.a > 0.5:
				red += 1 if color.r > 1.5 * color.g else 0
				green += 1 if color.g > color.r else 0
	check(red > 8 and green > 30, "red petals and green leaves: %d, %d" % [red, green])


func test_a_ready_species_stays_in_its_file() -> void:
	var root := await _open_garden()
	await _choose("Garden Tulip")
	await _use("Add")
	var plant := root.get_child(-1) as Plant3D
	check_equal(plant.species.resource_path, TULIP, "the scene names the file")
	check(plant.species != _state().function, "the dock shows a copy")
	var before := plant.species.natural_frequency
	_state().function.natural_frequency = before + 1.0
	check_equal(plant.species.natural_frequency, before, "frequency in the scene after an edit")
	await _use("Add")
	var changed := root.get_child(-1) as Plant3D
	check_equal(changed.species.natural_frequency, before + 1.0, "frequency of the second")
	check(changed.species.is_built_in(), "what was changed is saved with the scene")
	_state().function.natural_frequency = before
	await _use("Add")
	check_equal((root.get_child(-1) as Plant3D).species.resource_path, TULIP, "changed back")
	for i in 3:
		await undo()
	check_equal(root.get_child_count(), 0, "children after undo")


func test_a_field_is_as_dense_as_suits_its_plants() -> void:
	var root := await _open_garden()
	var densities: Array[float] = []
	for title: String in ["Common Reed", "Meadow Grass", "Lawn Grass", "Moss Cushion"]:
		await _choose(title)
		await _use("AddField")
		var field := root.get_child(-1) as PlantField3D
		densities.append(field.density)
		var count := field.density * field.size.x * field.size.y
		check(count < 15000.0, "%s: %d plants" % [title, count])
		check(field.species[0].species.resource_path.begins_with(SPECIES), "its file is named")
		await undo()
	check(densities[0] < 10.0, "reeds are sparse: %s" % [densities])
	check(densities[1] > densities[0], "grass is denser: %s" % [densities])
	check(densities[2] > 100.0, "a lawn is densest: %s" % [densities])
	check(densities[3] < 100.0, "cushions do not lie on each other: %s" % [densities])


func test_the_tile_of_a_mix_says_what_grows_in_it() -> void:
	await _open_garden()
	await _choose("Reed Bed")
	check(_state().mix != null and not _state().function, "a mix is chosen, no species")
	var tooltip := func() -> String: return tiles().get_item_tooltip(find_tile("Reed Bed"))
	var has_picture := func() -> bool: return tooltip.call().contains("\n")
	check(await until(has_picture), "the picture of the mix is taken")
	var text: String = tooltip.call()
	check(text.contains("Cattail · "), "its tooltip: " + text)
	for button: String in ["Add", "Assign", "Save", "Bake"]:
		check((part("Browser/Actions/" + button) as Button).disabled, button + " is off")
	await frames(10)
	await take_picture("mix")
	await _choose("Tulip")
	check(not _state().mix, "a species instead")
	check(not (part("Browser/Actions/Add") as Button).disabled, "a species can be added")


func test_a_mix_becomes_a_field_of_the_scene() -> void:
	var root := await _open_garden()
	await _choose("Meadow")
	await _use("AddField")
	var field := root.get_child(-1) as PlantField3D
	check_equal(field.name, &"Meadow", "its name")
	check(field.owner == root, "it is saved with the scene")
	check_equal(field.scene_file_path, "", "it is no instance of the file")
	check_equal(
		EditorInterface.get_selection().get_selected_nodes(), [field] as Array[Node], "selected"
	)
	check_equal(field.wind.strength, _state().wind.strength, "the dock's wind blows on it")
	_select([])
	await _use("AddField")
	var second := root.get_child(-1) as PlantField3D
	second.species[0].weight = 7.0
	check(field.species[0].weight != 7.0, "what is changed on one reaches no other")
	await undo()
	check_equal(root.get_child_count(), 1, "children after undo")
	await undo()
	check_equal(root.get_child_count(), 0, "after another")
	await redo()
	check(root.get_child(-1) == field and field.owner == root, "redo brings it back")
	check_equal(EditorInterface.save_scene(), OK, "saving")
	var saved := FileAccess.get_file_as_string(SCENE)
	check(not saved.contains(MEADOW), "the saved scene has not the mix's file")
	check(saved.contains(SPECIES), "but the files of the species")
	await undo()


func _list_files(folder: String, ending: String) -> Array[String]:
	var files: Array[String] = []
	for file in DirAccess.get_files_at(folder):
		if file.get_extension() == ending:
			files.append(folder.path_join(file))
	check(files.size() > 4, "%s has %d" % [folder, files.size()])
	return _sorted(files)


static func _sorted(texts: Array[String]) -> Array[String]:
	texts.sort()
	return texts


func _domain() -> TranslationDomain:
	return TranslationServer.get_or_add_domain(Translations.DOMAIN)


func _open_garden() -> Node3D:
	var root := Node3D.new()
	root.name = "Patch"
	await _close_all_scenes()
	await _open_scene(SCENE, root)
	_select([])
	return EditorInterface.get_edited_scene_root() as Node3D
