@tool
extends "brush_test.gd"
## One name for one thing: a species in the list, the status line, the brush, and as a node.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const Translations := preload("res://addons/undergrowth/editor/translations/translations.gd")
const GRASS_FILE := "res://addons/undergrowth/species/meadow_grass.tres"
const TITLE := "Meadow Grass"
const NODE := &"MeadowGrass"
## Of the density in the inspector.
const UNIT := "plants/m²"


func test_a_species_has_one_name_in_each_language() -> void:
	for locale: String in ["en", "hr"]:
		_speak(locale)
		var title := Translations.text(TITLE)
		var field := await _open_grass()
		await open_panel()
		await _click_in_list(Translations.text("Wheat"))
		EditorInterface.get_selection().clear()
		await frames(2)
		await _choose_only(field)
		await _rested(field)
		check(_message().contains(title), "status: " + _message())
		check_equal(_find_marked(), title, "title in the list")
		await _choose_tool("Paint")
		check(_species_tile(title) >= 0, "tile of the brush: " + title)
		await _choose_tool("Paint")
	_speak("en")


func test_new_nodes_have_names_as_in_the_editor() -> void:
	_speak("en")
	var field := await _open_grass()
	var root := field.get_parent()
	await open_panel()
	await _click_in_list(TITLE)
	for button: String in ["AddField", "Add"]:
		EditorInterface.get_selection().clear()
		await click(part("Browser/Actions/" + button) as Control)
		await frames(3)
		var added := root.get_child(-1)
		check_equal(added.name, NODE, "name of the new node")
		check(_message().contains(NODE), "the message: " + _message())
		await undo()
	check_equal(root.get_child_count(), 1, "nodes after undo")


func test_buttons_say_what_they_do() -> void:
	_speak("en")
	await open_panel()
	var button := part("Browser/Actions/Assign") as Button
	check_equal(button.text, "Use for Selected", "text")
	var font := button.get_theme_font(&"font")
	var font_size := button.get_theme_font_size(&"font_size")
	var width := font.get_string_size(button.text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	check(button.size.x >= width, "it is not cut: %f of %f" % [button.size.x, width])


func test_density_is_in_plants_per_square_metre() -> void:
	var field := await _open_grass()
	EditorInterface.edit_node(field)
	await open_inspector()
	await frames(5)
	var units: PackedStringArray = []
	var inspector := EditorInterface.get_inspector()
	for property: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if property.get_edited_property() == &"density":
			units.append(
				property.find_children("*", "EditorSpinSlider", true, false)[0].suffix.strip_edges()
			)
	check_equal(units, PackedStringArray([UNIT]), "unit in the inspector")


func _click_in_list(title: String) -> void:
	await choose_tile(title)


func _find_marked() -> String:
	for i in tiles().get_selected_items():
		return tile_title(i)
	return ""


func _message() -> String:
	return (part("Status/Text") as Label).text


func _speak(locale: String) -> void:
	TranslationServer.get_or_add_domain(Translations.DOMAIN).set_locale_override(locale)
	dock().propagate_notification(Node.NOTIFICATION_TRANSLATION_CHANGED)


func _open_grass() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Yard"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [PlantFieldSpecies.of(load(GRASS_FILE))]
	field.size = Vector2(2, 4)
	_put(root, field)
	return await _open("res://words.tscn", root) as PlantField3D
