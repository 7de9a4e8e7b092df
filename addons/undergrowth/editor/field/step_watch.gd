@tool
extends RefCounted
## Runs a task in the frames after each step of undo and each change of the scene. It waits while
## the left mouse button is pressed, because sliders create steps while the user drags them.

var _plugin: EditorPlugin
var _begin: Callable
var _on_next: Callable
var _is_running := false


## Calls [param begin] at each step of undo of [param plugin], then [param on_next] in each frame
## until it returns true.
func setup(plugin: EditorPlugin, begin: Callable, on_next: Callable) -> void:
	_plugin = plugin
	_begin = begin
	_on_next = on_next
	plugin.get_undo_redo().history_changed.connect(_on_step)  # A step was added.
	plugin.get_undo_redo().version_changed.connect(_on_step)  # A step was undone or redone.
	plugin.scene_changed.connect(_on_scene_changed)
	_on_step()


## Ends the task.
func close() -> void:
	_plugin.get_undo_redo().history_changed.disconnect(_on_step)
	_plugin.get_undo_redo().version_changed.disconnect(_on_step)
	_plugin.scene_changed.disconnect(_on_scene_changed)
	_stop()


func _on_scene_changed(_root: Node) -> void:
	_on_step()


func _on_step() -> void:
	_begin.call()
	if not _is_running:
		_is_running = true
		_plugin.get_tree().process_frame.connect(_on_frame)


func _on_frame() -> void:
	if not Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT) and _on_next.call():
		_stop()


func _stop() -> void:
	if _is_running:
		_is_running = false
		_plugin.get_tree().process_frame.disconnect(_on_frame)
