@tool
extends RefCounted
## The panel as a dock, which users can move. Godot 4.6 and newer; older versions cannot compile it.

var _plugin: EditorPlugin
var _dock: EditorDock


## Adds [param content] to the editor.
func add(plugin: EditorPlugin, content: Control, domain: StringName, icon: Texture2D) -> void:
	_plugin = plugin
	_dock = EditorDock.new()
	_dock.set_translation_domain(domain)
	_dock.name = "Undergrowth"
	_dock.title = "Undergrowth"
	_dock.layout_key = "Undergrowth"
	_dock.default_slot = EditorDock.DOCK_SLOT_BOTTOM
	_dock.available_layouts = EditorDock.DOCK_LAYOUT_ALL
	_dock.dock_icon = icon
	_dock.add_child(content)
	plugin.add_dock(_dock)


## Brings the panel to the front.
func show() -> void:
	_dock.make_visible()


## Removes the panel and its content.
func remove() -> void:
	_plugin.remove_dock(_dock)
	_dock.queue_free()
