@tool
extends RefCounted
## Brings docks of the editor to the front, in each version of the engine.

## The class of docks since Godot 4.6. Older versions have tabs only.
const DOCK := &"EditorDock"


## Shows the dock that contains [param control].
static func bring(control: Control) -> void:
	var shown: Node = control
	while shown and not shown.is_class(DOCK):
		var tabs := shown.get_parent() as TabContainer
		if tabs and not ClassDB.class_exists(DOCK):
			tabs.current_tab = tabs.get_tab_idx_from_control(shown as Control)
			return
		shown = shown.get_parent()
	if shown:
		shown.call(&"make_visible")
