@tool
extends "actions_test.gd"
## The tree of parts in the inspector of a species, and the first own species made with it.

const FERN := "res://addons/undergrowth/species/male_fern.tres"
const OWN := "res://own_fern.tres"
const NAME := 0
const COUNT := 1
const COLOR := 2
const EYE := 3
const MAX_CLICKS := 6

var _clicks := 0


func test_rows_are_the_parts_of_the_species() -> void:
	var fern := await _open_fern()
	check_equal(
		_rows(),
		(
			[["Plant", ""], ["Fronds", "7–9"], ["Leaflets", "46–50"], ["Scales", "8"]]
			+ [["Fiddleheads", "0–2"], ["Dead fronds", "0–2"]]
		),
		"rows"
	)
	check(_find_property(&"arrangements").is_empty(), "no nested arrays")
	check(fern.find_problem(0.0, 12, 1).is_empty(), "the species has no problem")
	await take_picture("parts")


func test_no_name_of_a_ready_species_is_cut() -> void:
	var folder := FERN.get_base_dir()
	var count := 0
	for file in DirAccess.get_files_at(folder):
		var species := load(folder.path_join(file)) as PlantFunction
		if not species or not species.arrangements:
			continue
		EditorInterface.edit_resource(species)
		await open_inspector()
		await frames(6)
		var tree := _tree_in(EditorInterface.get_inspector())
		var item := tree.get_root()
		while item:
			_check_seen(tree, item, file)
			count += 1
			item = item.get_next_in_tree()
	check(count > 50, "%d names" % count)


func _check_seen(tree: Tree, item: TreeItem, file: String) -> void:
	var depth := 1
	var above := item.get_parent()
	while above:
		depth += 1
		above = above.get_parent()
	var indent := tree.get_theme_constant(&"item_margin") + tree.get_theme_constant(&"h_separation")
	var font := tree.get_theme_font(&"font")
	var font_size := tree.get_theme_font_size(&"font_size")
	var text := item.get_text(NAME)
	var size := font.get_multiline_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size)
	var room := tree.get_column_width(NAME) - depth * indent
	check(size.x <= room, "%s: %s needs %.0f of %d" % [file, text, size.x, room])
	var rect := tree.get_item_area_rect(item)
	check(rect.size.y >= size.y, "%s: %s is %.0f of %.0f high" % [file, text, rect.size.y, size.y])
	check(rect.end.y <= tree.size.y, "%s: %s is below the tree" % [file, text])


func test_a_count_is_typed_into_its_cell() -> void:
	var fern := await _open_fern()
	await _type_count("Fronds", "9")
	check_equal(fern.arrangements[0].count, Vector2i(9, 9), "count as typed")
	check_equal(_row("Fronds").get_text(COUNT), "9", "text of the cell")
	await _type_count("Fronds", "5-12")
	check_equal(fern.arrangements[0].count, Vector2i(5, 12), "a range")
	await _type_count("Fronds", "many")
	check_equal(fern.arrangements[0].count, Vector2i(5, 12), "what is no count changes nothing")
	check_equal(_row("Fronds").get_text(COUNT), "5–12", "text of the cell")
	await _undo(fern)
	await _undo(fern)
	check_equal(fern.arrangements[0].count, Vector2i(7, 9), "count after undo")


func test_the_eye_hides_parts() -> void:
	var fern := await _open_fern()
	var before := _count_triangles(fern)
	await _click_cell("Fronds", EYE)
	check(not fern.arrangements[0].visible, "the eye hides the fronds")
	check(_count_triangles(fern) < before * 0.5, "the plant has fewer triangles")
	await _undo(fern)
	check(fern.arrangements[0].visible, "visible after undo")
	check_equal(_count_triangles(fern), before, "triangles after undo")


func test_added_duplicated_and_removed_parts() -> void:
	var fern := await _open_fern()
	var before := _count_triangles(fern)
	await _click_cell("Fronds", NAME)
	await click(_button("Add"))
	await frames(5)
	check_equal(fern.arrangements[0].carries.size(), 3, "arrangements on a frond")
	check_equal(fern.find_problem(0.0, 24, 1), "", "problem of the species with a new part")
	check(_count_triangles(fern) > before, "the new part is visible")
	check_equal(_chosen_title(), "Leaves", "the new part is selected")
	await click(_button("Duplicate"))
	await frames(5)
	check_equal(fern.arrangements[0].carries.size(), 4, "arrangements after a duplicate")
	var copies := fern.arrangements[0].carries
	check(copies[2] != copies[3] and copies[2].part != copies[3].part, "the copy shares nothing")
	await click(_button("Remove"))
	await frames(5)
	check_equal(fern.arrangements[0].carries.size(), 3, "arrangements after removal")
	for i in 3:
		await _undo(fern)
	check_equal(fern.arrangements[0].carries.size(), 2, "arrangements after undo")
	check_equal(_count_triangles(fern), before, "triangles after undo")


func test_an_empty_species_begins_with_leaves() -> void:
	var plain := PlantFunction.new()
	plain.has_stem = false
	await _open(plain)
	await click(_button("Add"))
	await frames(5)
	check_equal(plain.arrangements.size(), 1, "arrangements")
	check_equal(plain.find_problem(0.0, 24, 1), "", "problem")
	check(_count_triangles(plain) > 10, "it is visible")


func test_a_drag_changes_the_order_and_the_carrier() -> void:
	var fern := await _open_fern()
	await _drag_row("Dead fronds", "Fronds", 0.05)
	check_equal(_titles(fern), ["Dead fronds", "Fronds", "Fiddleheads"], "order after a drag")
	await _drag_row("Fronds", "Dead fronds", 0.95)
	check_equal(_titles(fern), ["Dead fronds", "Fronds", "Fiddleheads"], "dropped at its place")
	await _drag_row("Scales", "Dead fronds", 0.5)
	check_equal(fern.arrangements[0].carries.size(), 1, "arrangements on a dead frond")
	await _drag_row("Fronds", "Leaflets", 0.5)
	check_equal(_titles(fern), ["Dead fronds", "Fronds", "Fiddleheads"], "none carries itself")
	await _undo(fern)
	await _undo(fern)
	check_equal(_titles(fern), ["Fronds", "Fiddleheads", "Dead fronds"], "order after undo")


func test_a_color_is_changed() -> void:
	var fern := await _open_fern()
	var part := fern.arrangements[0].carries[0].part as PlantPart
	var before := part.base_color
	await _click_cell("Leaflets", COLOR)
	await frames(3)
	var pickers := _parts().find_children("*", "ColorPicker", true, false)
	check(pickers.size() == 1, "a colour picker opens")
	if pickers.is_empty():
		return
	var picker := pickers[0] as ColorPicker
	picker.color_changed.emit(picker.color + Color(0.2, 0.0, 0.0, 0.0))
	(picker.get_parent() as Window).hide()
	await frames(3)
	check(absf(part.base_color.r - before.r - 0.2) < 0.01, "it is redder: %s" % part.base_color)
	check(is_equal_approx(part.base_color.g, before.g), "its green stays")
	await _undo(fern)
	check(part.base_color.is_equal_approx(before), "colour after undo")


func test_the_selected_part_is_edited_below() -> void:
	await _open_fern()
	await _click_cell("Leaflets", NAME)
	await frames(5)
	check(_find_property(&"teeth").size() == 1, "a property of its blade")
	check(_find_property(&"turn").size() == 1, "a property of its arrangement")
	check(_find_property(&"carries").is_empty(), "no nested array")
	var count := _find_property(&"count")[0] as EditorProperty
	var sliders := count.find_children("*", "EditorSpinSlider", true, false)
	check_equal(sliders.size(), 2, "a range is two numbers in one line")
	check_equal(sliders[0].global_position.y, sliders[1].global_position.y, "their line")
	check_equal([sliders[0].value, sliders[1].value], [46.0, 50.0], "the numbers")
	sliders[0].value = 60.0
	await frames(3)
	check_equal([sliders[0].value, sliders[1].value], [60.0, 60.0], "the other end moves along")
	var angle := _find_property(&"angle", false)[0] as EditorProperty
	sliders = angle.find_children("*", "EditorSpinSlider", true, false)
	var last: float = sliders[1].value
	sliders[0].value = last - 5.0
	await frames(3)
	check(absf(sliders[0].value - last + 5.0) < 0.1, "the first angle: %s°" % sliders[0].value)
	check(absf(sliders[1].value - last) < 0.1, "the last angle: %s°" % sliders[1].value)


func test_minus_one_reads_as_what_it_means() -> void:
	var stem := PlantStem.new()
	EditorInterface.edit_resource(stem)
	await open_inspector()
	await frames(5)
	for property: StringName in [&"taper", &"head_mass", &"leaf_drag_area"]:
		var found := _find_property(property, false)
		check_equal(found.size(), 1, property)
		if found:
			var slider: EditorSpinSlider = (
				found[0].find_children("*", "EditorSpinSlider", true, false)[0]
			)
			check_equal(slider.call(&"get_shown"), "as drawn", property)
	EditorInterface.edit_node(null)


func test_an_own_fern_with_nine_leaves_in_six_clicks_and_one_number() -> void:
	DirAccess.remove_absolute(ProjectSettings.globalize_path(OWN))
	var scene := Node3D.new()
	scene.name = "Land"
	await _open_alone("res://parts_land.tscn", scene)
	await open_panel()
	var index := find_tile("Male Fern")
	await reveal_tile(index)
	_clicks = 0
	await _click_visible(tiles(), place_of_tile(index))
	check_equal(_state().title, "Male Fern", "chosen species")
	await _click_visible(part("Browser/Actions/Save") as Control)
	await frames(3)
	var dialog := _dialog("EditorFileDialog") as EditorFileDialog
	check(dialog != null, "the file dialog opens")
	if not dialog:
		return
	await type(dialog.get_line_edit(), "own_fern")
	await _click_visible(dialog.get_ok_button())
	await frames(10)
	check(FileAccess.file_exists(OWN), "the file is there: " + _message())
	var tree := _tree_in(EditorInterface.get_inspector())
	check(tree != null, "the inspector shows the tree of parts")
	var row := _row("Fronds", tree)
	await _click_visible(tree, _middle_of(tree, row, COUNT))
	await frames(3)
	await type(tree, "9")
	await press_key(tree, KEY_ENTER)
	await frames(5)
	print("clicks to an own fern: %d" % _clicks)
	check(_clicks <= MAX_CLICKS, "%d clicks" % _clicks)
	var own := load(OWN) as PlantFunction
	check(own == _state().function, "the inspector edits the file's species")
	check_equal(own.arrangements[0].count, Vector2i(9, 9), "leaves")
	await undo()
	DirAccess.remove_absolute(ProjectSettings.globalize_path(OWN))
	EditorInterface.get_resource_filesystem().scan()


func test_seeds_are_shown_side_by_side() -> void:
	await inspect("Poppy")
	await click(preview_part("Seeds") as Control)
	await frames(3)
	var shown := preview_part("Plants").get_children()
	check_equal(shown.size(), 4, "plants")
	var seeds := shown.map(func(plant: Plant3D) -> int: return plant.seed)
	check_equal(seeds, [1, 2, 3, 4], "their seeds")
	for plant: Plant3D in shown:
		check_equal(plant.segments, 24, "detail of a near plant")
	await take_picture("seeds")
	await click(preview_part("Seeds") as Control)
	await frames(3)
	check_equal(preview_part("Plants").get_child_count(), 1, "plants after switching back")


func _open_fern() -> PlantFunction:
	var fern := (load(FERN) as PlantFunction).duplicate(true) as PlantFunction
	await _open(fern)
	return fern


func _open(function: PlantFunction) -> void:
	EditorInterface.edit_resource(function)
	await open_inspector()
	await frames(10)


func _parts() -> Control:
	return _tree_in(EditorInterface.get_inspector()).get_parent() as Control


func _tree_in(above: Node) -> Tree:
	for tree: Tree in above.find_children("Tree", "Tree", true, false):
		if tree.is_visible_in_tree():
			return tree
	return null


func _button(name: String) -> Button:
	return _parts().find_child(name, true, false) as Button


func _row(title: String, tree: Tree = null) -> TreeItem:
	var item := (tree if tree else _tree_in(EditorInterface.get_inspector())).get_root()
	while item and item.get_text(NAME) != title:
		item = item.get_next_in_tree()
	return item


func _rows() -> Array:
	var rows := []
	var item := _tree_in(EditorInterface.get_inspector()).get_root()
	while item:
		rows.append([item.get_text(NAME), item.get_text(COUNT)])
		item = item.get_next_in_tree()
	return rows


func _chosen_title() -> String:
	return _tree_in(EditorInterface.get_inspector()).get_selected().get_text(NAME)


func _titles(function: PlantFunction) -> Array:
	return function.arrangements.map(
		func(one: PlantArrangement) -> String: return one.resource_name
	)


## Clicks the middle of a cell.
func _click_cell(title: String, column: int) -> void:
	var tree := _tree_in(EditorInterface.get_inspector())
	await click(tree, _middle_of(tree, _row(title), column))
	await frames(3)


## The engine's rectangles of columns do not start where they are drawn.
func _middle_of(tree: Tree, row: TreeItem, column: int) -> Vector2:
	var at := Vector2(0.0, tree.get_item_area_rect(row, NAME).get_center().y)
	var span := Vector2(INF, 0.0)
	while at.x < tree.size.x:
		if tree.get_column_at_position(at) == column:
			span = Vector2(minf(span.x, at.x), at.x)
		at.x += 1.0
	return Vector2((span.x + span.y) * 0.5, at.y)


func _type_count(title: String, text: String) -> void:
	await _click_cell(title, COUNT)
	var tree := _tree_in(EditorInterface.get_inspector())
	await press_key(tree, KEY_A, 0, true)
	await type(tree, text)
	await press_key(tree, KEY_ENTER)
	await frames(5)


## Drags a row to [param share] of the height of another one. In the virtual display the engine
## finds no control below the pointer during a drag within a tree: the drop is called.
func _drag_row(title: String, to: String, share: float) -> void:
	var tree := _tree_in(EditorInterface.get_inspector())
	var from := _middle_of(tree, _row(title), NAME)
	await _point(tree, _in_window(tree, from))
	_press(tree, _in_window(tree, from), MOUSE_BUTTON_LEFT, true)
	await frames(1)
	var away := from + Vector2(0.0, 20.0 * EditorInterface.get_editor_scale())
	_move(tree, _in_window(tree, from), _in_window(tree, away), MOUSE_BUTTON_MASK_LEFT)
	await frames(1)
	var data: Variant = tree.get_viewport().gui_get_drag_data()
	check(data != null, "the mouse drags " + title)
	var goal := tree.get_item_area_rect(_row(to), NAME)
	var at := goal.position + goal.size * Vector2(0.5, share)
	if tree._can_drop_data(at, data):
		tree._drop_data(at, data)
	tree.get_viewport().gui_cancel_drag()
	_press(tree, _in_window(tree, from), MOUSE_BUTTON_LEFT, false)
	await frames(5)


func _find_property(name: StringName, is_visible := true) -> Array[EditorProperty]:
	var found: Array[EditorProperty] = []
	var inspector := EditorInterface.get_inspector()
	for property: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		var counts := property.is_visible_in_tree() or not is_visible
		if counts and property.get_edited_property() == name:
			found.append(property)
	return found


func _count_triangles(function: PlantFunction) -> int:
	return function.generate_mesh(0.0, 24, 1).surface_get_array_index_len(0) / 3


func _undo(object: Object) -> void:
	var manager := EditorInterface.get_editor_undo_redo()
	manager.get_history_undo_redo(manager.get_object_history_id(object)).undo()
	await frames(5)


## Clicks [param control] and counts the click. Fails the test unless it is visible.
func _click_visible(control: Control, at := Vector2.INF) -> void:
	var place := control.get_global_transform() * (control.size * 0.5 if at == Vector2.INF else at)
	check(control.is_visible_in_tree(), "%s is visible" % control.name)
	check(
		control.get_window().get_visible_rect().has_point(place),
		"%s is in the window" % control.name
	)
	await _point(control, _in_window(control, at))
	var met := control.get_viewport().gui_get_hovered_control()
	check(met == control, "%s is below the pointer, not %s" % [control.name, met])
	_clicks += 1
	await click(control, at)
