@tool
extends "wind_test.gd"
## The panel of the wind in the toolbar of the 3D view, and a wind in the inspector.

const DirectionDial := preload("res://addons/undergrowth/editor/widgets/direction_dial.gd")
const WindMap := preload("res://addons/undergrowth/editor/widgets/wind_map.gd")
const WindSpectrum := preload("res://addons/undergrowth/editor/widgets/wind_spectrum.gd")
const WIND_FILE := "res://bura š.tres"
const EMPTY := "res://wind_nothing.tscn"


func test_the_button_is_there_while_the_scene_has_plants() -> void:
	await _open_scene()
	var button := find_by_script(WIND_BUTTON_SCRIPT)
	check(button.is_visible_in_tree(), "visible with plants")
	var root := Node3D.new()
	root.name = "Nothing"
	_save_scene(root, EMPTY)
	EditorInterface.open_scene_from_path(EMPTY)
	await frames(5)
	check(not button.is_visible_in_tree(), "hidden without")
	check(not wind_panel().is_visible_in_tree(), "its panel, too")


func test_speed_is_typed_and_described() -> void:
	var plants := await _open_scene()
	await _type_number("Speed", "9.3")
	check_equal(plants[0].wind.kind, PlantWind.KIND_AIR, "kind in the scene")
	check(is_equal_approx(plants[0].wind.speed, 9.3), "speed: %f" % plants[0].wind.speed)
	var reported := (wind_part("Beaufort") as Label).text
	check(reported.contains("5 · "), "Beaufort's number: " + reported)
	await take_picture("wind_panel")
	await _type_number("Speed", "5000000")
	check_equal(plants[0].wind.speed, 100.0, "speed, at most")
	reported = (wind_panel().get_node("%Status").get_node("%Text") as Label).text
	check(reported.contains(tr("Speed")), "the panel says it: " + reported)
	await undo()  # Fast steps of one title are merged.
	if plants[0].wind.kind != PlantWind.KIND_CONSTANT:
		await undo()
	check_equal(plants[0].wind.kind, PlantWind.KIND_CONSTANT, "kind after undo")
	EditorInterface.save_scene()


func test_the_panel_shows_messages_about_the_wind_only() -> void:
	await _open_scene()
	await open_wind()
	var state: EditorState = dock().get("state")
	var text := wind_panel().get_node("%Status").get_node("%Text") as Label
	state.report_wind("")
	state.report("Poppy is selected.")
	check_equal(text.text, "", "a message about a species")
	await _press_button("SetForScene")
	check(text.text.contains("3"), "a message about the wind: " + text.text)
	check_equal((part("Status/Text") as Label).text, text.text, "in the panel below, too")


func test_dial_is_turned() -> void:
	var plants := await _open_scene()
	var before := plants[0].wind.direction
	await open_wind()
	var dial := wind_part("Dial") as DirectionDial
	var middle := dial.size * 0.5
	await drag(dial, middle + Vector2(0, 20), middle + Vector2(30, 0))
	check_equal(_degrees(), 90.0, "towards the right")
	await press_key(dial, KEY_RIGHT)
	check_equal(_degrees(), 91.0, "one key farther")
	await press_key(dial, KEY_LEFT, 0, false, true)
	check_equal(_degrees(), 76.0, "back with Shift")
	check_equal((wind_part("Direction") as EditorSpinSlider).value, 76.0, "as a number")
	await undo()
	check_equal(plants[0].wind.direction, before, "direction after one step of undo")
	EditorInterface.save_scene()


func test_nothing_moves_when_a_preset_is_chosen() -> void:
	await _open_scene()
	await open_wind()
	var names: Array[String] = ["Calm", "Breeze", "Storm", "Gust", "SetForScene", "Save", "Dial"]
	var before := _rects_of(names)
	await click(wind_part("Fresh") as Control)
	await frames(3)
	check_equal(_wind().kind, PlantWind.KIND_AIR, "kind")
	check_equal(_rects_of(names), before, "places after a preset")
	await undo()
	EditorInterface.save_scene()


func test_presets_have_their_speeds_and_mark_the_chosen_one() -> void:
	await _open_scene()
	await open_wind()
	var breeze := wind_part("Breeze") as Button
	var gale := wind_part("Gale") as Button
	check(breeze.text.contains("5") and breeze.text.contains("m/s"), breeze.text)
	await _press_button("Breeze")
	check(breeze.button_pressed and not gale.button_pressed, "the breeze is marked")
	await _press_button("Breeze")
	check(breeze.button_pressed, "after another press, too")
	await _press_button("Gale")
	check(gale.button_pressed and not breeze.button_pressed, "the gale is marked")
	_wind().speed = 12.0
	check(not gale.button_pressed, "none is marked at another speed")
	EditorInterface.save_scene()


func _rects_of(names: Array[String]) -> Dictionary[String, Rect2]:
	var rects: Dictionary[String, Rect2] = {}
	for name in names:
		rects[name] = (wind_part(name) as Control).get_global_rect()
	return rects


func test_a_gust_is_added() -> void:
	var plants := await _open_scene()
	var wind := plants[0].wind
	check(_wind() == wind, "the panel edits the wind of the scene")
	wind.kind = PlantWind.KIND_GUST
	wind.gust_duration = 60.0  # For a machine of any speed.
	await _press_button("Gust")
	var force := wind.sample(wind.get_time()).length()
	check(is_equal_approx(force, wind.strength), "the gust blows with %f N" % force)
	EditorInterface.save_scene()


func test_its_wind_is_opened_in_the_inspector() -> void:
	var plants := await _open_scene()
	await _press_button("Inspect")
	check(EditorInterface.get_inspector().get_edited_object() == plants[0].wind, "inspected")
	check(wind_panel().is_visible_in_tree(), "the panel stays open")
	EditorInterface.edit_node(null)


func test_the_inspector_folds_the_analysis_of_air() -> void:
	var wind := (load("res://addons/undergrowth/winds/fresh.tres") as PlantWind).duplicate()
	EditorInterface.edit_resource(wind)
	await open_inspector()
	await frames(5)
	var analysis := _find_in_inspector("Analysis") as FoldableContainer
	var map := _find_in_inspector("Map") as WindMap
	var spectrum := _find_in_inspector("Spectrum") as WindSpectrum
	check(analysis.is_visible_in_tree() and analysis.folded, "it is folded")
	check(not spectrum.is_visible_in_tree(), "nothing is measured")
	await click(analysis, Vector2(20.0, 10.0))
	await frames(3)
	check(map.is_visible_in_tree() and spectrum.is_visible_in_tree(), "both are shown")
	var speeds := map.get_speeds()
	check_equal(speeds.size(), WindMap.SIDE * WindMap.SIDE, "places of the map")
	var sorted := Array(speeds)
	sorted.sort()
	check(sorted[-1] > 1.3 * sorted[0], "gusts: %f to %f m/s" % [sorted[0], sorted[-1]])
	await until(func() -> bool: return spectrum.get_points().size() > 15)
	await take_picture("air")
	var points := spectrum.get_points()
	check(points.size() > 15, "%d points of the spectrum" % points.size())
	for point in points:
		if point.x > 0.2:
			var share := point.y / spectrum.kaimal(point.x)
			check(share > 0.4 and share < 2.5, "%f of Kaimal's at %f Hz" % [share, point.x])
	wind.speed = 4.0
	check_equal(spectrum.get_points().size(), 0, "another wind is measured again")
	wind.kind = PlantWind.KIND_WAVES
	check(not map.is_visible_in_tree(), "forces have no map")
	EditorInterface.edit_node(null)


func test_names_of_air_fit_in_the_inspector() -> void:
	EditorInterface.edit_resource(PlantWind.new())
	(EditorInterface.get_inspector().get_edited_object() as PlantWind).kind = PlantWind.KIND_AIR
	await open_inspector()
	await frames(10)
	var count := 0
	var inspector := EditorInterface.get_inspector()
	for property: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if property.get_edited_object() is PlantWind and property.is_visible_in_tree():
			var font := property.get_theme_font(&"font", &"Tree")
			var font_size := property.get_theme_font_size(&"font_size", &"Tree")
			var width := font.get_string_size(property.label, 0, -1, font_size).x
			var room := property.size.x * property.name_split_ratio
			check(width < room, "%s is %f wide of %f" % [property.label, width, room])
			count += 1
	check(count >= 8, "%d properties" % count)
	EditorInterface.edit_node(null)


func _find_in_inspector(name: String) -> Control:
	return EditorInterface.get_inspector().find_children(name, "", true, false)[0] as Control


func test_wind_is_saved() -> void:
	await _open_scene()
	for property: StringName in [&"canopy_wave_amount", &"wetness", &"snow", &"rain"]:
		_wind().set(property, 0.45)
	await _press_button("Save")
	var dialog: EditorFileDialog
	for child in wind_part("WindActions").get_children():
		dialog = child as EditorFileDialog
	check(dialog and dialog.visible, "a dialog asks where")
	var line := dialog.get_line_edit()
	line.grab_focus()
	line.text = ""
	await type(line, WIND_FILE.get_file())
	await press_key(line, KEY_ENTER)
	await frames(3)
	var saved := load(WIND_FILE) as PlantWind
	check(saved != null, "the file is there")
	for property in saved.get_property_list():
		var is_own: bool = (
			property["usage"] & PROPERTY_USAGE_STORAGE and property["type"] == TYPE_FLOAT
		)
		if is_own and property["name"] != "time":
			check_equal(
				saved.get(property["name"]), _wind().get(property["name"]), property["name"]
			)
	DirAccess.remove_absolute(ProjectSettings.globalize_path(WIND_FILE))
	EditorInterface.get_resource_filesystem().scan()


func test_saving_over_a_wind_changes_it_where_it_is_used() -> void:
	await _open_scene()
	var before := PlantWind.new()
	check_equal(ResourceSaver.save(before, WIND_FILE), OK, "saving a wind for the test")
	var used := load(WIND_FILE) as PlantWind
	_wind().speed = 13.5
	_wind().rain = 4.0
	wind_part("WindActions").call(&"save", WIND_FILE)
	check_equal([used.speed, used.rain], [13.5, 4.0], "the wind that was loaded before")
	check(load(WIND_FILE) == used, "it is that of the file")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(WIND_FILE))
	EditorInterface.get_resource_filesystem().scan()


func _degrees() -> float:
	return snappedf(rad_to_deg(_wind().direction), 0.001)
