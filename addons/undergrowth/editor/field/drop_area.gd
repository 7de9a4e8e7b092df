@tool
extends Control
## An area over a 3D view that takes mixes and species of the dock, of the FileSystem and of the
## inspector. Only visible while one of them is dragged, so that the editor takes all other drops.

## Emitted when [param data] of a drag was dropped at [param pixel] of [param view].
signal dropped(data: Variant, view: SubViewport, pixel: Vector2)

const VIEWS := 4

var _view: SubViewport
# Returns true for data of a mix or a species.
var _accepts: Callable


## Adds one to each 3D view of the editor.
static func add_to_views(accepts: Callable, on_dropped: Callable) -> Array[Control]:
	var areas: Array[Control] = []
	for i in VIEWS:
		var area := new()
		area._view = EditorInterface.get_editor_viewport_3d(i)
		area._accepts = accepts
		area.name = "UndergrowthDropArea"
		area.hide()
		area.dropped.connect(on_dropped)
		area._view.get_parent().get_parent().add_child(area)
		area.set_anchors_and_offsets_preset(PRESET_FULL_RECT)
		areas.append(area)
	return areas


func _notification(what: int) -> void:
	if what == NOTIFICATION_DRAG_BEGIN:
		visible = _accepts.is_valid() and _accepts.call(get_viewport().gui_get_drag_data())
	elif what == NOTIFICATION_DRAG_END:
		hide()


func _can_drop_data(_at: Vector2, data: Variant) -> bool:
	return _accepts.call(data)


func _drop_data(at: Vector2, data: Variant) -> void:
	dropped.emit(data, _view, at * Vector2(_view.size) / size)
