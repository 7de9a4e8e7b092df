@tool
extends "editor_hands.gd"
## Base of the editor tests: the dock and its parts.

const DOCK_SCRIPT := "res://addons/undergrowth/editor/dock.gd"
const PREVIEW_SCRIPT := "res://addons/undergrowth/editor/inspector/plant_preview.gd"
const PLOT_SCRIPT := "res://addons/undergrowth/editor/widgets/profile_plot.gd"
const WIND_BUTTON_SCRIPT := "res://addons/undergrowth/editor/wind/wind_button.gd"
const CLIMBER_BAR_SCRIPT := "res://addons/undergrowth/editor/climber/climber_bar.gd"
## Scripts with several controls in turn. All others have one.
const RENEWED: PackedStringArray = [PREVIEW_SCRIPT, PLOT_SCRIPT, CLIMBER_BAR_SCRIPT]

# Controls by script. A search visits all nodes of the editor.
static var _found: Dictionary[String, Control] = {}


## Returns the panel's content, or null if the plugin is off.
func dock() -> Control:
	return find_by_script(DOCK_SCRIPT)


## Returns the control of the editor with this script, or null.
func find_by_script(path: String) -> Control:
	var known: Variant = _found.get(path)
	if is_instance_valid(known) and _is_in_editor(known as Control):
		return known
	var found: Array[Node] = []
	_collect(EditorInterface.get_base_control(), path, found)
	if found and path not in RENEWED:
		_found[path] = found[0]
	return found[0] if found else null


## Returns the node of the panel with that unique name. `part("Browser/List/Tiles")` follows nested
## scenes.
func part(path: String) -> Node:
	var node: Node = dock()
	for name in path.split("/"):
		node = node.get_node("%" + name) if node else null
	return node


## Returns the tiles of mixes and species.
func tiles() -> ItemList:
	return part("Browser/List/Tiles") as ItemList


## Returns a node of the preview in the inspector by its unique name.
func preview_part(name: String) -> Node:
	return find_by_script(PREVIEW_SCRIPT).get_node("%" + name)


## Returns the points of the stem's outline in the inspector.
func plot_points() -> Control:
	return find_by_script(PLOT_SCRIPT).get_node("Points") as Control


## Returns the content of the wind's panel.
func wind_panel() -> Control:
	return find_by_script(WIND_BUTTON_SCRIPT).get("_panel")


## Returns a node of the wind's panel by its unique name.
func wind_part(name: String) -> Node:
	return wind_panel().get_node("%" + name)


## Shows the panel with all tiles.
func open_panel() -> void:
	(dock().get_parent() as EditorDock).make_visible()
	(part("Browser/List/All") as Button).button_pressed = true
	await frames(2)


## Shows the wind's panel. The edited scene has plants.
func open_wind() -> void:
	if wind_panel().is_visible_in_tree():
		return
	EditorInterface.set_main_screen_editor("3D")
	await frames(2)
	await click(find_by_script(WIND_BUTTON_SCRIPT))
	await frames(3)
	check(wind_panel().is_visible_in_tree(), "the panel of the wind is open")


func close_wind() -> void:
	if wind_panel().is_visible_in_tree():
		await click(find_by_script(WIND_BUTTON_SCRIPT))


## Opens the species of the panel called [param title] in the inspector with a double click.
func inspect(title: String) -> void:
	await open_panel()
	var index := find_tile(title)
	check(index >= 0, title + " is listed")
	if index >= 0:
		await reveal_tile(index)
		await double_click(tiles(), place_of_tile(index))
		await frames(5)


## Shows the editor's inspector in front of the dock, which is in the next tab.
func open_inspector() -> void:
	var above: Node = EditorInterface.get_inspector()
	while above is not EditorDock:
		above = above.get_parent()
	(above as EditorDock).make_visible()
	await frames(2)


## Clicks the tile at any scroll position.
func click_tile(index: int) -> void:
	await reveal_tile(index)
	await click(tiles(), place_of_tile(index))


## Clicks the tile called [param title]. Returns false if there is none.
func choose_tile(title: String) -> bool:
	await open_panel()
	var index := find_tile(title)
	check(index >= 0, title + " is listed")
	if index >= 0:
		await click_tile(index)
	return index >= 0


## Returns the middle of a visible tile.
func place_of_tile(index: int) -> Vector2:
	var scrolled := Vector2(0.0, tiles().get_v_scroll_bar().value)
	return tiles().get_item_rect(index).get_center() - scrolled


## Scrolls to a tile.
func reveal_tile(index: int) -> void:
	var bar := tiles().get_v_scroll_bar()
	var row := tiles().get_item_rect(index)
	bar.value = row.position.y
	await frames(2)


## Returns the title of a tile, of any number of lines.
func tile_title(index: int) -> String:
	return tiles().get_item_text(index).replace("\n", " ")


## Returns the file or the class of a tile.
func tile_key(index: int) -> String:
	return tiles().get_item_metadata(index).get("key")


## Returns the index of the tile called [param title], or -1.
func find_tile(title: String) -> int:
	for i in tiles().item_count:
		if tile_title(i) == title:
			return i
	return -1


## Returns the index of the tile of a file or a class, or -1.
func find_key(key: String) -> int:
	for i in tiles().item_count:
		if tile_key(i) == key:
			return i
	return -1


func _is_in_editor(control: Control) -> bool:
	return control.is_inside_tree() and not control.is_queued_for_deletion()


func _collect(node: Node, script_path: String, found: Array[Node]) -> void:
	var script := node.get_script() as Script
	if script and script.resource_path == script_path:
		found.append(node)
		return
	for child in node.get_children(true):
		_collect(child, script_path, found)
