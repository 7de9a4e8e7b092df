@tool
extends RefCounted
## The panel at the bottom of the editor, for versions of the engine without the class EditorDock.

var _plugin: EditorPlugin
var _content: Control


## Adds [param content] to the editor. The tab has no icon.
func add(plugin: EditorPlugin, content: Control, domain: StringName, _icon: Texture2D) -> void:
	_plugin = plugin
	_content = content
	content.set_translation_domain(domain)
	plugin.add_control_to_bottom_panel(content, "Undergrowth")


## Brings the panel to the front.
func show() -> void:
	_plugin.make_bottom_panel_item_visible(_content)


## Removes the panel and its content.
func remove() -> void:
	_plugin.remove_control_from_bottom_panel(_content)
	_content.queue_free()
