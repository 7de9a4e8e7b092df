@tool
extends "editor_test.gd"
## Disabling and enabling the add-on.

const PLUGIN := "undergrowth"
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
	var counts := part("Plant/Preview/Counts") as Label
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


func _choose_poppy() -> void:
	await open_page("Plant")
	var found := find_item("Poppy")
	await click_item(found[0], found[1])
	await frames(3)


func _switch_off_and_on() -> void:
	EditorInterface.set_plugin_enabled(PLUGIN, false)
	await frames(4)
	check(dock() == null, "nothing is left of the dock")
	EditorInterface.set_plugin_enabled(PLUGIN, true)
	await frames(20)
	check(dock() != null, "the dock is back")


func _count(monitor: Performance.Monitor) -> int:
	return int(Performance.get_monitor(monitor))


func test_a_wide_dock_is_laid_out_side_by_side() -> void:
	await open_page("Plant")
	var split := part("Plant/Split") as SplitContainer
	check(split.vertical, "one below the other in a narrow dock")
	var page := part("Plant") as Control
	var content := dock()
	var home := content.get_parent()
	var window := Window.new()
	window.size = Vector2i(1100, 420)
	EditorInterface.get_base_control().add_child(window)
	content.reparent(window, false)
	content.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	await frames(5)
	check(not split.vertical, "side by side at %s" % page.size)
	await frames(30)
	var picture := window.get_texture().get_image()
	if not pictures_folder.is_empty():
		picture.save_png(pictures_folder.path_join("dock_wide.png"))
	content.reparent(home, false)
	window.queue_free()
	await frames(5)
	check(split.vertical, "one below the other again")


func test_the_library_is_reloaded_under_the_dock() -> void:
	await open_page("Plant")
	check_equal(
		GDExtensionManager.reload_extension(LIBRARY), GDExtensionManager.LOAD_STATUS_OK, "status"
	)
	await frames(10)
	check(dock() != null, "the dock is there")
	await _choose_poppy()
	var counts := part("Plant/Preview/Counts") as Label
	check(counts.text.contains("tris"), "it shows a plant: " + counts.text)
	var plant := part("Plant/Preview/Plants").get_child(0) as Plant3D
	var moves := func() -> bool: return plant.get_deflection() > 1e-3
	check(await until(moves), "the plant moves")
