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
