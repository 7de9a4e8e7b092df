@tool
extends "editor_test.gd"
## Disabling and enabling the add-on.

const PLUGIN := "undergrowth"
## Of a drawn field.
const MIN_PRIMITIVES := 3000
const BOTTOM_PANEL := "res://addons/undergrowth/editor/place/bottom_panel.gd"
const LIBRARY := "res://addons/undergrowth/undergrowth.gdextension"


func test_off_and_on_again() -> void:
	# At the first time, the editor creates permanent controls of its own.
	await _switch_off_and_on()
	var nodes := _count(Performance.OBJECT_NODE_COUNT)
	var orphans := _count(Performance.OBJECT_ORPHAN_NODE_COUNT)
	for i in 2:
		await _switch_off_and_on()
	check_equal(_count(Performance.OBJECT_NODE_COUNT), nodes, "nodes after twice more")
	check_equal(_count(Performance.OBJECT_ORPHAN_NODE_COUNT), orphans, "orphans")
	await _choose_poppy()
	var counts := preview_part("Counts") as Label
	check(counts.text.contains("tris"), "it shows a plant: " + counts.text)


func test_nothing_stays_when_switched_off() -> void:
	EditorInterface.set_plugin_enabled(PLUGIN, false)
	await frames(4)
	check(dock() == null, "no dock")
	check(not TranslationServer.has_domain(&"undergrowth"), "no texts")
	var left: Array[String] = []
	for node in EditorInterface.get_base_control().find_children("*", "", true, false):
		var script := node.get_script() as Script
		if script and script.resource_path.begins_with("res://addons/undergrowth/"):
			left.append(script.resource_path)
	check_equal(left, [] as Array[String], "nodes with scripts of the add-on")
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	await frames(10)
	check(dock() != null, "the dock is back")
	check(dock().is_visible_in_tree(), "in front, so that it is found")


func test_versions_without_docks_have_the_panel_at_the_bottom() -> void:
	var plugin := EditorPlugin.new()
	var place: RefCounted = (load(BOTTOM_PANEL) as GDScript).new()
	var content := Label.new()
	place.call(&"add", plugin, content, &"undergrowth", null)
	check(content.is_inside_tree(), "it is in the editor")
	check_equal(content.get_translation_domain(), &"undergrowth")
	place.call(&"show")
	await frames(2)
	check(content.is_visible_in_tree(), "it is in front")
	place.call(&"remove")
	await frames(2)
	check(not is_instance_valid(content), "it is gone")
	plugin.free()


func _choose_poppy() -> void:
	await inspect("Poppy")


func _switch_off_and_on() -> void:
	EditorInterface.set_plugin_enabled(PLUGIN, false)
	await frames(4)
	check(dock() == null, "nothing is left of the dock")
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	await frames(20)
	check(dock() != null, "the dock is back")


func _count(monitor: Performance.Monitor) -> int:
	return int(Performance.get_monitor(monitor))


func test_the_library_is_reloaded_under_the_dock() -> void:
	await open_panel()
	check_equal(
		GDExtensionManager.reload_extension(LIBRARY), GDExtensionManager.LOAD_STATUS_OK, "status"
	)
	await frames(10)
	check(dock() != null, "the dock is there")
	await _choose_poppy()
	var counts := preview_part("Counts") as Label
	check(counts.text.contains("tris"), "it shows a plant: " + counts.text)
	var plant := preview_part("Plants").get_child(0) as Plant3D
	var moves := func() -> bool: return plant.get_deflection() > 1e-3
	check(await until(moves), "the plant moves")


func test_a_field_is_drawn_after_the_library_is_reloaded() -> void:
	var field := PlantField3D.from_species([GrassFunction.new()])
	field.size = Vector2(4, 4)
	field.density = 20.0
	var root := Node3D.new()
	root.name = "Yard"
	root.add_child(field)
	field.owner = root
	field = null
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, "res://reloaded.tscn")
	EditorInterface.open_scene_from_path("res://reloaded.tscn")
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	check(await until(_is_built), "the field is built")
	check(await _is_drawn(), "the field is drawn")
	GDExtensionManager.reload_extension(LIBRARY)
	await frames(10)
	check(await until(_is_built), "the field is built again")
	check(await _is_drawn(), "the field is drawn again")
	(EditorInterface.get_edited_scene_root().get_child(0) as Node3D).hide()
	check(not await _is_drawn(), "a hidden field is not drawn")
	EditorInterface.save_scene()
	EditorInterface.close_scene()


# Untyped calls: the types of this script are those of the library before a reload.
func _is_built() -> bool:
	var field := EditorInterface.get_edited_scene_root().get_child(0)
	return field.call("get_plant_count") > 0 and not field.call("is_building")


# The grid and the gizmos of the view have fewer primitives than the field.
func _is_drawn() -> bool:
	var view := EditorInterface.get_editor_viewport_3d(0)
	for i in 10:
		await drawn()
		await frames(2)
		var count := view.get_render_info(
			Viewport.RENDER_INFO_TYPE_VISIBLE, Viewport.RENDER_INFO_PRIMITIVES_IN_FRAME
		)
		if count > MIN_PRIMITIVES:
			return true
	return false
