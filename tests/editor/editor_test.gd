@tool
extends "editor_hands.gd"
## Base of the editor tests: the dock and its parts.

## The lists of the plant page, from top to bottom.
const LISTS: Array[String] = ["MixList", "ReadyList", "SimpleList", "ProjectList"]
const DOCK_SCRIPT := "res://addons/undergrowth/editor/dock.gd"


## Returns the dock's content, or null if the plugin is off.
func dock() -> Control:
	return find_by_script(DOCK_SCRIPT)


## Returns the control of the editor with this script, or null.
func find_by_script(path: String) -> Control:
	var found: Array[Node] = []
	_collect(EditorInterface.get_base_control(), path, found)
	return found[0] if found else null


## Returns the node of the dock with that unique name. `part("Plant/List/ReadyList")` follows nested
## scenes.
func part(path: String) -> Node:
	var node: Node = dock()
	for name in path.split("/"):
		node = node.get_node("%" + name) if node else null
	return node


## Shows the dock and the page of that name (Plant or Wind).
func open_page(name: String) -> void:
	(dock().get_parent() as EditorDock).make_visible()
	await frames(2)
	var pages := part("Pages") as TabContainer
	var index := pages.get_tab_idx_from_control(part(name) as Control)
	var bar := pages.get_tab_bar()
	await click(bar, bar.get_tab_rect(index).get_center())


## Shows the editor's inspector in front of the dock, which is in the next tab.
func open_inspector() -> void:
	var above: Node = EditorInterface.get_inspector()
	while above is not EditorDock:
		above = above.get_parent()
	(above as EditorDock).make_visible()
	await frames(2)


## Clicks an item of a list at any scroll position.
func click_item(list: ItemList, index: int) -> void:
	await reveal_item(list, index)
	await click(list, list.get_item_rect(index).get_center())


## Unfolds the group of a list and scrolls to one of its items.
func reveal_item(list: ItemList, index: int) -> void:
	var above: Node = list.get_parent()
	while above is not ScrollContainer:
		if above is FoldableContainer:
			(above as FoldableContainer).folded = false
		above = above.get_parent()
	await frames(2)
	var scroll := above as ScrollContainer
	var at := list.get_global_rect().position.y + list.get_item_rect(index).position.y
	scroll.scroll_vertical += int(at - scroll.get_global_rect().position.y)
	await frames(2)


## Returns the title of an item, of any number of lines.
func item_title(list: ItemList, index: int) -> String:
	return list.get_item_text(index).replace("\n", " ")


## Returns the list of the plant page with an item called [param title], and its index, or [null,
## -1].
func find_item(title: String) -> Array:
	for name: String in LISTS:
		var list := part("Plant/List/" + name) as ItemList
		for i in list.item_count:
			if item_title(list, i) == title:
				return [list, i]
	return [null, -1]


func _collect(node: Node, script_path: String, found: Array[Node]) -> void:
	var script := node.get_script() as Script
	if script and script.resource_path == script_path:
		found.append(node)
		return
	for child in node.get_children(true):
		_collect(child, script_path, found)
