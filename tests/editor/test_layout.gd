@tool
extends "actions_test.gd"
## The dock on screens of 1600 × 900 and 1920 × 1080, where it has no column of its own.

const Dock := preload("res://addons/undergrowth/editor/dock.gd")
const SCENE := "res://layout.tscn"
const READY := "res://addons/undergrowth/species/poppy.tres"
const LONG := "res://foxtail.gd: its base shape runs clockwise as seen from above. Reverse it."


func test_it_is_a_panel_below_the_view() -> void:
	await open_panel()
	var rect := dock().get_global_rect()
	var view := EditorInterface.get_editor_viewport_3d(0).get_parent() as Control
	check(rect.position.y >= view.get_global_rect().end.y, "it is below the 3D view: %s" % rect)
	check(rect.size.x > rect.size.y * 2.0, "it is wide: %s" % rect.size)
	var window := EditorInterface.get_base_control().size
	check(rect.end.y <= window.y, "it ends at %f of %f" % [rect.end.y, window.y])
	check(rect.size.y < 0.4 * window.y, "it leaves room: %f" % rect.size.y)


func test_every_tab_beside_the_inspector_stays_visible() -> void:
	await open_panel()
	var inspector: Node = EditorInterface.get_inspector()
	while inspector is not EditorDock:
		inspector = inspector.get_parent()
	var bar := (inspector.get_parent() as TabContainer).get_tab_bar()
	for i in bar.tab_count:
		check(bar.get_tab_title(i) != "Undergrowth", "it takes no tab from the inspector")


func test_two_rows_of_tiles_are_seen() -> void:
	await open_panel()
	tiles().get_v_scroll_bar().value = 0
	await frames(2)
	var columns := 1
	while tiles().get_item_rect(columns).position.y == tiles().get_item_rect(0).position.y:
		columns += 1
	check(columns >= 7, "%d columns" % columns)
	var end := tiles().get_item_rect(columns).end.y
	check(end <= tiles().size.y, "the second row ends at %f of %f" % [end, tiles().size.y])


func test_one_row_of_tiles_leaves_room_in_a_low_window() -> void:
	var low := Dock.height_in(1080.0, 2.0)
	check_equal(low, 392.0, "height at 200 % on 1080 pixels")
	check_equal(Dock.height_in(900.0, 1.0), 296.0, "two rows on 900")
	check_equal(Dock.height_in(2160.0, 2.0), 592.0, "two rows at 200 % on 2160")


func test_categories_are_in_one_line_in_each_language() -> void:
	await open_panel()
	for locale: String in ["hr", "en"]:
		TranslationServer.get_or_add_domain(Translations.DOMAIN).set_locale_override(locale)
		dock().propagate_notification(Node.NOTIFICATION_TRANSLATION_CHANGED)
		await frames(4)
		var last := part("Browser/List/Project") as Control
		check_equal(last.position.y, (part("Browser/List/All") as Control).position.y, locale)


func test_actions_are_below_the_tiles_in_a_narrow_dock() -> void:
	await open_panel()
	var browser := part("Browser") as BoxContainer
	check(not browser.vertical, "beside the tiles in the panel")
	var tab := dock().get_parent() as Control
	var width := 320.0 * EditorInterface.get_editor_scale()
	browser.size.x = width
	check(browser.vertical, "below them if it is narrow")
	(browser.get_parent() as Container).queue_sort()
	await frames(3)
	check(not browser.vertical and tab.is_visible_in_tree(), "beside them again")


func test_no_name_is_cut() -> void:
	await open_panel()
	var font := tiles().get_theme_font(&"font")
	var font_size := tiles().get_theme_font_size(&"font_size")
	for i in tiles().item_count:
		var lines := tiles().get_item_text(i).split("\n")
		check(lines.size() <= 2, "two lines: " + tile_title(i))
		for line in lines:
			var width := font.get_string_size(line, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
			check(width <= tiles().get_item_rect(i).size.x, "%s is %f wide" % [line, width])


func test_it_follows_the_selection() -> void:
	await _open_garden()
	var root := EditorInterface.get_edited_scene_root()
	await open_panel()
	await _choose("Wheat")
	_select([root.get_node("Poppy")])
	await frames(2)
	check_equal(_state().title, "Poppy", "of a plant with a species of the add-on")
	var marked := tiles().get_selected_items()
	check(marked.size() == 1 and tile_title(marked[0]) == "Poppy", "it is marked in the list")
	_select([root.get_node("Field")])
	await frames(2)
	var field := root.get_node("Field") as PlantField3D
	check(_state().function == field.species[0].species, "of a field the scene's own species")
	check_equal(_state().title, "Reed", "its title")
	check(tiles().get_selected_items().is_empty(), "nothing is marked")
	_select([root])
	await frames(2)
	check_equal(_state().title, "Reed", "of what is no plant, nothing")


func test_it_catches_up_when_it_is_shown() -> void:
	await _open_garden()
	var tab := dock().get_parent() as EditorDock
	(tab.get_parent() as TabContainer).current_tab = -1
	_select([EditorInterface.get_edited_scene_root().get_node("Poppy")])
	await frames(2)
	await open_panel()
	await frames(2)
	check_equal(_state().title, "Poppy", "selected while the panel was hidden")


func test_a_filter_moves_nothing() -> void:
	await open_panel()
	var before := tiles().get_global_rect()
	var width := tiles().fixed_column_width
	var filter := part("Browser/List/Filter") as LineEdit
	filter.text = "tul"
	filter.text_changed.emit("tul")
	await frames(4)
	check_equal(tiles().get_global_rect(), before, "place of the tiles with two names")
	check_equal(tiles().fixed_column_width, width, "width of a tile")
	filter.text = ""
	filter.text_changed.emit("")
	await frames(4)
	check_equal(tiles().get_global_rect(), before, "place of the tiles with all names")


func test_messages_move_no_button() -> void:
	await open_panel()
	await _choose("Wheat")
	_state().report("")
	await frames(3)
	var before := (part("Browser/Actions/Add") as Control).global_position
	_state().report(LONG, EditorState.Severity.ERROR)
	await frames(3)
	check_equal(
		(part("Browser/Actions/Add") as Control).global_position, before, "a button's place"
	)
	check_equal((part("Status/Text") as Label).tooltip_text, LONG, "all of it is in the tooltip")
	var text := part("Status/Text") as Label
	check_equal(text.get_visible_line_count(), text.get_line_count(), "lines of it that are seen")
	await take_picture(str(int(EditorInterface.get_base_control().size.x)))
	_state().report("")


func test_warnings_of_a_hidden_panel_are_toasts() -> void:
	await open_panel()
	((dock().get_parent() as EditorDock).get_parent() as TabContainer).current_tab = -1
	await frames(3)
	_state().report(LONG, EditorState.Severity.WARNING)
	await frames(3)
	var toaster := EditorInterface.get_editor_toaster()
	var labels := toaster.find_children("*", "Label", true, false)
	var says_it := func(label: Label) -> bool: return label.text.contains(LONG)
	check(labels.any(says_it), "%d texts of toasts" % labels.size())
	await open_panel()
	_state().report("")


func test_a_plants_height_of_0_is_by_species() -> void:
	await _open_garden()
	var plant := EditorInterface.get_edited_scene_root().get_node("Poppy") as Plant3D
	EditorInterface.edit_node(plant)
	await open_inspector()
	var property := _find_property("height")
	check(property != null, "the inspector has the property")
	var slider := (
		property.find_children("*", "EditorSpinSlider", true, false)[0] as EditorSpinSlider
	)
	check_equal(slider.call(&"get_shown"), "by species", "at 0")
	slider.value = 1.5
	await frames(2)
	check_equal(plant.height, 1.5, "height as set")
	check_equal(slider.call(&"get_shown"), "", "at 1.5 the number is shown")
	await undo()
	check_equal(plant.height, 0.0, "height after undo")


func test_a_new_species_of_curves_may_begin_with_a_leaf() -> void:
	var curves := CurvePlantFunction.new()
	EditorInterface.edit_resource(curves)
	await open_inspector()
	var button: Button = null
	for found: Button in EditorInterface.get_inspector().find_children("*", "Button", true, false):
		if found.text == Translations.text("Begin with a Leaf"):
			button = found
	check(button != null, "the inspector offers it")
	if button:
		button.pressed.emit()
		await frames(2)
	check(curves.width_curve and curves.color_gradient, "it has a curve and colors")
	var undo_manager := EditorInterface.get_editor_undo_redo()
	undo_manager.get_history_undo_redo(undo_manager.get_object_history_id(curves)).undo()
	check(not curves.width_curve, "undo takes the curve away")
	EditorInterface.edit_node(null)


func _find_property(name: String) -> EditorProperty:
	var inspector := EditorInterface.get_inspector()
	for property: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if property.get_edited_property() == name:
			return property
	return null


func _open_garden() -> void:
	var root := Node3D.new()
	root.name = "Garden"
	var poppy := Plant3D.new()
	poppy.name = "Poppy"
	poppy.species = load(READY)
	var field := PlantField3D.from_species([ReedFunction.new()])
	field.name = "Field"
	field.size = Vector2(2, 2)
	field.density = 2.0
	for plant: Node in [poppy, field]:
		root.add_child(plant)
		plant.owner = root
	await _open_scene(SCENE, root)
	EditorInterface.set_main_screen_editor("3D")
