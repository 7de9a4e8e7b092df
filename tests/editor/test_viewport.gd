@tool
extends "viewport_test.gd"
## Plants in the editor's viewport and resources in its inspector.

const ForceGraph := preload("res://addons/undergrowth/editor/widgets/force_graph.gd")
const WIND_VIEW := "res://addons/undergrowth/editor/inspector/wind_inspector_view.gd"
const SCRIPT_FILE := "res://viewport_species.gd"
## A script that cannot run in the editor.
const SCRIPT := """extends PlantFunction

func _calculate_curve_point(_offset: float) -> float:
	return 1.0
"""
const SPECIES_FILE := "res://viewport_species.tres"

var _thumbnail: Texture2D
var _has_answer := false


func test_click_selects_a_plant() -> void:
	var plant := await _open_plant()
	EditorInterface.get_selection().clear()
	await click(_view(), _tip_of(plant, 0.9))
	await frames(2)
	check_equal(
		EditorInterface.get_selection().get_selected_nodes(), [plant] as Array[Node], "selection"
	)


func test_height_handle_is_one_step() -> void:
	var plant := await _open_plant()
	EditorInterface.get_selection().clear()
	EditorInterface.get_selection().add_node(plant)
	await frames(5)
	var before := plant.get_plant_height()
	var from := _tip_of(plant)
	await drag(_view(), from, from + Vector2(0, -40))
	check(plant.height > before, "the plant grows from %f to %f m" % [before, plant.height])
	var manager := EditorInterface.get_editor_undo_redo()
	var history := manager.get_history_undo_redo(manager.get_object_history_id(plant))
	check_equal(history.get_current_action_name(), tr("Change Plant Height"), "name of the step")
	await undo()
	check_equal(plant.height, 0.0, "height after undo")


func test_inspector_shows_a_moving_plant() -> void:
	EditorInterface.edit_resource(TulipFunction.new())
	await open_inspector()
	await frames(5)
	check(find_by_script(PREVIEW_SCRIPT) != null, "there is a preview")
	var plant := preview_part("Plants").get_child(0) as Plant3D
	var moves := func() -> bool: return plant.get_deflection() > 1e-3
	check(await until(moves), "the plant moves")


func test_the_inspector_explains_a_missing_plant() -> void:
	var file := FileAccess.open(SCRIPT_FILE, FileAccess.WRITE)
	file.store_string(SCRIPT)
	file.close()
	var function := PlantFunction.new()
	function.set_script(load(SCRIPT_FILE))
	EditorInterface.edit_resource(function)
	await open_inspector()
	await frames(5)
	var reported := (preview_part("Hint") as Label).text
	check(reported.contains("@tool"), "the preview says " + reported)
	EditorInterface.edit_resource(null)
	DirAccess.remove_absolute(ProjectSettings.globalize_path(SCRIPT_FILE))


func test_inspector_shows_the_force_of_a_wind() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_GUST
	EditorInterface.edit_resource(wind)
	await open_inspector()
	await frames(5)
	var view := _find_in_inspector(WIND_VIEW)
	check(view != null, "there is a graph")
	var graph := view.get_node("%Graph") as ForceGraph
	check(graph.wind == wind and graph.get_now() > 0.0, "it is of that wind and moves")
	var over := func() -> bool: return wind.get_time() > wind.gust_duration
	check(await until(over), "the first gust is over")
	wind.gust_duration = 60.0  # For a machine of any speed.
	wind.advance(60.0)
	await click(view.get_node("%Gust") as Control)
	check(wind.sample(wind.get_time()).length() > 0.0, "the button's gust blows")
	EditorInterface.edit_resource(null)


func test_species_files_have_thumbnails() -> void:
	check_equal(ResourceSaver.save(ReedFunction.new(), SPECIES_FILE), OK, "saving")
	_has_answer = false
	var previews := EditorInterface.get_resource_previewer()
	previews.queue_resource_preview(SPECIES_FILE, self, &"_on_thumbnail", null)
	check(await until(func() -> bool: return _has_answer), "the editor answers")
	check(_thumbnail != null, "there is a thumbnail")
	var used := _thumbnail.get_image().get_used_rect()
	check(used.size.y > _thumbnail.get_height() * 0.7, "the plant fills it: %s" % used)
	DirAccess.remove_absolute(ProjectSettings.globalize_path(SPECIES_FILE))


func _on_thumbnail(_path: String, preview: Texture2D, _small: Texture2D, _data: Variant) -> void:
	_thumbnail = preview
	_has_answer = true


func _find_in_inspector(script_path: String) -> Node:
	var found: Array[Node] = []
	_collect(EditorInterface.get_inspector(), script_path, found)
	return found[0] if found else null
