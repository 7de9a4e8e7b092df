@tool
extends "brush_test.gd"
## The brush over the 3D view: strokes on a field's map, in progress and as steps of undo.


func test_the_toolbar_is_there_while_a_field_is_edited() -> void:
	var field := await _open_field()
	EditorInterface.get_selection().clear()
	await frames(5)
	check(not _bar().visible, "nothing is selected")
	await _choose_only(field)
	check(_bar().visible, "a field is selected")
	check(_species_tile(GRASS) >= 0, "its species")
	check(not _settings().visible, "no tool is chosen")
	await _choose_only(field.get_parent())
	check(not _bar().visible, "another node is selected")


func test_choosing_a_tool_moves_no_button() -> void:
	var field := await _open_field()
	await _choose_only(field)
	var button := _bar().get_node("%Paint") as Button
	var before := button.get_global_rect()
	await _choose_tool("Paint")
	await frames(5)
	check(_settings().visible, "what it is set to is there")
	check_equal(button.get_global_rect(), before, "the button's place")
	await _choose_tool("Paint")


func test_what_is_removed_of_a_painted_field_is_saved_with_its_scene() -> void:
	var field := await _open_field()
	await _rested(field)
	check_equal(field.remove_in_sphere(field.global_position, 0.3) > 0, true, "plants are removed")
	check(field.saved_changes.is_empty(), "nothing is kept of a field without a map")
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 1.5, GRASS, 1.0)
	await _rested(field)
	field.remove_in_sphere(field.global_position, 0.6)
	await _rested(field)
	var scene := PackedScene.new()
	check_equal(scene.pack(EditorInterface.get_edited_scene_root()), OK, "the scene is packed")
	var copy := scene.instantiate() as Node3D
	field.get_viewport().add_child(copy)
	var again := copy.get_node("Field") as PlantField3D
	await _rested(again)
	check_equal(again.get_plant_count(), field.get_plant_count(), "plants of the scene")
	check(again.find_plants_in_sphere(again.global_position, 0.5).is_empty(), "they stay away")
	copy.free()
	var own := field.saved_changes
	check(not own.is_empty(), "the field keeps its changes")
	field.apply_changes(PackedByteArray())
	check(field.saved_changes.is_empty(), "nothing is kept where nothing is changed")
	field.saved_changes = own.slice(0, own.size() - 1)
	check_error("incomplete")
	check_equal(
		field.saved_changes.size(), own.size() - 1, "what is torn is not lost with the next save"
	)


func test_a_first_stroke_makes_a_map_in_one_step() -> void:
	var field := await _edited_field()
	await _choose_tool("Erase")
	var version := _history().get_version()
	var count := field.get_plant_count()
	await drag(_view(), _place_of(field, Vector3.ZERO), _place_of(field, Vector3(0, 0, 1)))
	await _rested(field)
	check(field.map != null, "it has a map")
	check_equal(_history().get_version(), version + 1, "one step")
	check_equal(_history().get_current_action_name(), tr("Erase Plants"), "its name")
	check(field.map.get_density(Vector3(0, 0, 0.5), GRASS) < 0.2, "density in the stroke")
	check_equal(field.map.get_density(Vector3(0.7, 0, -1.5), GRASS), 1.0, "density beside it")
	check(field.get_plant_count() < count, "%d of %d" % [field.get_plant_count(), count])
	var painted := field.map.data
	await undo()
	check(field.map == null, "it has no map after undo")
	await _rested(field)
	check_equal(field.get_plant_count(), count, "plants after undo")
	await redo()
	check_equal(field.map.data, painted, "map after redo")
	await _rested(field)
	check(field.get_plant_count() < count, "plants after redo")


func test_jitter_of_scale_and_color_is_painted_in_one_step() -> void:
	var field := await _edited_field()
	_sharpen(1.0)
	await _choose_tool("Jitter")
	for title: String in ["%ScaleJitter", "%ColorJitter"]:
		check((_settings().get_node(title) as Control).visible, title + " is there")
	(_settings().get_node("%ScaleJitter") as EditorSpinSlider).value = 0.5
	(_settings().get_node("%ColorJitter") as EditorSpinSlider).value = 0.75
	var version := _history().get_version()
	var ids := field.get_plant_ids()
	var before := _transforms(field)
	await click(_view(), _place_of(field, Vector3.ZERO))
	await _rested(field)
	check_equal(_history().get_version(), version + 1, "steps of undo")
	check_equal(_history().get_current_action_name(), tr("Paint Plant Jitter"), "its name")
	check(absf(field.map.get_scale_jitter(Vector3.ZERO, GRASS) - 0.5) < 0.01, "jitter of scale")
	check(absf(field.map.get_color_jitter(Vector3.ZERO, GRASS) - 0.75) < 0.01, "jitter of color")
	check_equal(field.map.get_color_jitter(Vector3(0, 0, 1.6), GRASS), 0.0, "jitter beside it")
	var now := field.get_plant_ids()
	now.sort()
	ids.sort()
	check_equal(now, ids, "plants")
	check(_transforms(field) != before, "their scales differ")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(_history().get_version(), version + 1, "a second stroke changes nothing")
	await undo()
	await _rested(field)
	check(field.map == null, "it has no map after undo")
	check_equal(_transforms(field), before, "plants after undo")
	await redo()
	check(absf(field.map.get_scale_jitter(Vector3.ZERO, GRASS) - 0.5) < 0.01, "jitter after redo")
	await _choose_tool("Jitter")
	for title: String in ["%ScaleJitter", "%ColorJitter"]:
		check(not (_settings().get_node(title) as Control).is_visible_in_tree(), title + " is gone")


func _transforms(field: PlantField3D) -> Array[Transform3D]:
	var found: Array[Transform3D] = []
	var ids := field.get_plant_ids()
	ids.sort()
	for id in ids:
		found.append(field.get_plant_transform(id))
	return found


func test_a_stroke_on_a_scaled_field_has_the_radius_of_the_brush() -> void:
	var field := await _edited_field()
	field.scale = Vector3.ONE * 0.5
	_sharpen(0.4)
	await _choose_tool("Erase")
	await click(_view(), _place_of(field, Vector3.ZERO))
	await _rested(field)
	var densities: Array[float] = []
	for z: float in [0.3, 1.2]:
		densities.append(field.map.get_density(Vector3(0, 0, z), GRASS) if field.map else 1.0)
	check_equal(densities, [0.0, 1.0] as Array[float], "densities within the radius and beyond it")
	field.scale = Vector3.ONE


func test_strokes_are_seen_while_they_are_drawn() -> void:
	var field := await _edited_field()
	field.map = PlantMap.new()
	await _rested(field)
	check_equal(field.get_plant_count(), 0, "plants of an empty map")
	await _choose_tool("Paint")
	var from := _in_window(_view(), _place_of(field, Vector3(0, 0, -1)))
	await _point(_view(), from)
	_press(_view(), from, MOUSE_BUTTON_LEFT, true)
	check(await until(func() -> bool: return field.get_plant_count() > 0), "plants after a touch")
	var few := field.get_plant_count()
	var to := _in_window(_view(), _place_of(field, Vector3(0, 0, 1)))
	_move(_view(), from, to, MOUSE_BUTTON_MASK_LEFT)
	check(await until(func() -> bool: return field.get_plant_count() > few), "plants of the move")
	_press(_view(), to, MOUSE_BUTTON_LEFT, false)
	await frames(2)
	await _rested(field)
	check(field.map.get_density(Vector3(0, 0, 0), GRASS) > 0.3, "no gap where the mouse was quick")
	await undo()
	await _rested(field)
	check_equal(field.get_plant_count(), 0, "plants after undo")
	check_equal(field.map.get_painted_species(), PackedStringArray(), "painted after undo")


func test_keys_change_what_the_brush_does() -> void:
	var field := await _edited_field()
	await _choose_tool("Paint")
	var radius := _settings().get_node("%Radius") as EditorSpinSlider
	var before := radius.value
	await click(_view(), _place_of(field, Vector3(0, 0, 1.5)))
	await press_key(_view(), KEY_BRACKETRIGHT)
	check(absf(radius.value - before * 1.2) < 0.06, "radius: %f" % radius.value)
	await press_key(_view(), KEY_BRACKETLEFT)
	check(absf(radius.value - before) < 0.06, "radius then: %f" % radius.value)
	check_equal(field.map.get_density(Vector3.ZERO, GRASS), 1.0, "density")
	await press_key(_view(), KEY_ESCAPE)
	check(not (_bar().get_node("%Paint") as Button).button_pressed, "Escape puts it down")


func test_height_and_pick() -> void:
	var field := await _edited_field()
	await _choose_tool("Height")
	(_settings().get_node("%Strength") as EditorSpinSlider).value = 1.0
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(field.map.get_height_factor(Vector3.ZERO, GRASS), 1.5, "height")
	check_equal(_history().get_current_action_name(), tr("Paint Plant Height"), "its name")
	(_settings().get_node("%PlantHeight") as EditorSpinSlider).value = 0.5
	await _choose_tool("Pick")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(
		(_settings().get_node("%PlantHeight") as EditorSpinSlider).value, 1.5, "picked height"
	)
	check((_bar().get_node("%Paint") as Button).button_pressed, "it paints then")
	check(_is_painted(GRASS), "what was picked")
	(_settings().get_node("%Strength") as EditorSpinSlider).value = 0.5
	await _paint_only([])
	await _choose_tool("Paint")


func test_the_brush_is_seen() -> void:
	var field := await _edited_field()
	field.size = Vector2(12, 12)
	field.species = [
		PlantFieldSpecies.of(load("res://addons/undergrowth/species/meadow_grass.tres")),
		PlantFieldSpecies.of(load("res://addons/undergrowth/species/poppy.tres"), 0.2),
	]
	await _rested(field)
	await _choose_tool("Erase")
	(_settings().get_node("%Radius") as EditorSpinSlider).value = 0.8
	await drag(_view(), _place_of(field, Vector3(-3, 0, -1)), _place_of(field, Vector3(3, 0, 2)))
	await _rested(field)
	var at := _place_of(field, Vector3(2, 0, -1))
	await frames(30)
	_move(_view(), _in_window(_view(), at), _in_window(_view(), at) + Vector2(1, 1), 0)
	await frames(3)
	await take_picture("brush")
	check(field.map != null, "it is painted")
	await _choose_tool("Erase")
