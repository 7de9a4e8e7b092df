@tool
extends "wind_test.gd"
## The wind page: its controls, its graph, and its files.

const DirectionDial := preload("res://addons/undergrowth/editor/widgets/direction_dial.gd")
const ForceGraph := preload("res://addons/undergrowth/editor/widgets/force_graph.gd")
const WindMap := preload("res://addons/undergrowth/editor/widgets/wind_map.gd")
const WindSpectrum := preload("res://addons/undergrowth/editor/widgets/wind_spectrum.gd")
const WIND_FILE := "res://bura š.tres"


func test_kind_is_chosen() -> void:
	await _choose_kind(PlantWind.KIND_BURSTS)
	check_equal(_wind().kind, PlantWind.KIND_BURSTS, "kind")
	check((part("Wind/Frequency") as Control).visible, "bursts have a frequency")
	await _choose_kind(PlantWind.KIND_CONSTANT)
	check_equal(_wind().kind, PlantWind.KIND_CONSTANT, "kind")
	check(not (part("Wind/Frequency") as Control).visible, "a constant wind has none")


func test_strength_is_typed() -> void:
	await open_page("Wind")
	await _type_number("Strength", "2.5")
	check_equal(_wind().strength, 2.5, "strength")
	await _type_number("Strength", "5000000")
	check_equal(_wind().strength, 1e6, "strength, at most")
	var reported := (part("Status/Text") as Label).text
	check(reported.contains("Strength"), "the status line: " + reported)
	await _type_number("Strength", "3")


func test_dial_is_turned() -> void:
	await open_page("Wind")
	var dial := part("Wind/Dial") as DirectionDial
	await _reveal(dial)
	var middle := dial.size * 0.5
	await drag(dial, middle + Vector2(0, 20), middle + Vector2(30, 0))
	check_equal(_degrees(), 90.0, "towards the right")
	await press_key(dial, KEY_RIGHT)
	check_equal(_degrees(), 91.0, "one key farther")
	await press_key(dial, KEY_LEFT, 0, false, true)
	check_equal(_degrees(), 76.0, "back with Shift")
	var reported := (part("Wind/Heading") as Label).text
	check(reported.contains("76°") and reported.contains("+x"), "the label says " + reported)


func test_the_graph_moves_and_shows_a_gust() -> void:
	await _choose_kind(PlantWind.KIND_GUST)
	var graph := part("Wind/Graph") as ForceGraph
	var before := graph.get_now()
	await frames(5)
	check(graph.get_now() > before, "now moves on")
	check(graph.wind == _wind(), "the graph is of the page's wind")
	_wind().gust_duration = 60.0  # For a machine of any speed.
	await _press_button("Gust")
	var force := _wind().sample(_wind().get_time()).length()
	check(is_equal_approx(force, _wind().strength), "the gust blows with %f N" % force)
	_wind().gust_duration = 0.5


func test_air_has_fields_of_its_own_and_presets() -> void:
	await _choose_kind(PlantWind.KIND_AIR)
	check_equal(_wind().kind, PlantWind.KIND_AIR, "kind")
	check((part("Wind/Speed") as Control).visible, "air has a speed")
	check(not (part("Wind/Strength") as Control).visible, "and no newtons")
	await _press_button("Gale")
	check(is_equal_approx(_wind().speed, 19.0), "speed of a gale")
	var reported := (part("Wind/Beaufort") as Label).text
	check(reported.begins_with("8"), "Beaufort's number: " + reported)
	await _choose_kind(PlantWind.KIND_WAVES)
	check(not (part("Wind/Speed") as Control).visible, "waves have no speed")


func test_nothing_moves_when_a_preset_is_chosen() -> void:
	await open_page("Wind")
	(part("Wind") as ScrollContainer).scroll_vertical = 0
	var names: Array[String] = ["Calm", "Breeze", "Storm", "Gust", "SetForScene", "Save"]
	names.append_array(["Kind"] as Array[String])
	await _choose_kind(PlantWind.KIND_WAVES)
	await frames(3)
	var before := _rects_of(names)
	var page := (part("Wind") as Control).get_global_rect()
	for name in names:
		check(page.encloses(before[name]), name + " is visible without scrolling")
	await click(part("Wind/Fresh") as Control)
	await frames(3)
	check_equal(_wind().kind, PlantWind.KIND_AIR, "kind")
	check_equal(_rects_of(names), before, "places after a preset")
	await _choose_kind(PlantWind.KIND_GUST)
	await frames(3)
	check_equal(_rects_of(names), before, "places after another kind")


func test_presets_have_their_speeds_and_mark_the_chosen_one() -> void:
	await open_page("Wind")
	var breeze := part("Wind/Breeze") as Button
	var gale := part("Wind/Gale") as Button
	check(breeze.text.contains("5") and breeze.text.contains("m/s"), breeze.text)
	await _press_button("Breeze")
	check(breeze.button_pressed and not gale.button_pressed, "the breeze is marked")
	await _press_button("Breeze")
	check(breeze.button_pressed, "after another press, too")
	await _press_button("Gale")
	check(gale.button_pressed and not breeze.button_pressed, "the gale is marked")
	_wind().speed = 12.0
	check(not gale.button_pressed, "none is marked at another speed")
	await _press_button("Breeze")


func _rects_of(names: Array[String]) -> Dictionary[String, Rect2]:
	var rects: Dictionary[String, Rect2] = {}
	for name in names:
		rects[name] = (part("Wind/" + name) as Control).get_global_rect()
	return rects


func test_turbulence_of_the_ground_is_described_in_words() -> void:
	await _choose_kind(PlantWind.KIND_AIR)
	var slider := part("Wind/Turbulence") as EditorSpinSlider
	slider.value = -1.0
	check_equal(slider.call(&"get_shown"), tr("by roughness"), "below 0")
	slider.value = 0.2
	check_equal(slider.call(&"get_shown"), "", "a share is shown as it is")
	check(is_equal_approx(_wind().turbulence, 0.2), "and is the wind's")
	slider.value = -1.0


func test_air_does_not_make_the_dock_wider() -> void:
	await _choose_kind(PlantWind.KIND_WAVES)
	var before := dock().get_combined_minimum_size().x
	await _choose_kind(PlantWind.KIND_AIR)
	await frames(3)
	check_equal(dock().get_combined_minimum_size().x, before, "least width")


func test_the_inspector_folds_the_analysis_of_air() -> void:
	check(part("Wind").find_child("Spectrum", true, false) == null, "the dock has no analysis")
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


func _find_in_inspector(name: String) -> Control:
	return EditorInterface.get_inspector().find_children(name, "", true, false)[0] as Control


func test_wind_is_saved() -> void:
	await open_page("Wind")
	await _press_button("Save")
	var dialog: EditorFileDialog
	for child in part("Wind/WindActions").get_children():
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
	check(is_equal_approx(saved.direction, _wind().direction), "its direction")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(WIND_FILE))
	EditorInterface.get_resource_filesystem().scan()


func _degrees() -> float:
	return snappedf(rad_to_deg(_wind().direction), 0.001)
