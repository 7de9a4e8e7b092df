@tool
extends RefCounted
## Shows why a value was refused below its control in the inspector, until the next edit there.

const NAME := "RefusedValue"
## In the errors of refused values, after the name of the property.
const REFUSED := " cannot be "

var _listener: Listener


## Begins to listen to errors.
func setup() -> void:
	_listener = Listener.new()
	_listener.show = _show
	OS.add_logger(_listener)
	EditorInterface.get_inspector().property_edited.connect(_forget)


## Stops listening, and removes what is shown.
func close() -> void:
	OS.remove_logger(_listener)
	var inspector := EditorInterface.get_inspector()
	inspector.property_edited.disconnect(_forget)
	for shown in inspector.find_children(NAME + "*", "Label", true, false):
		shown.queue_free()


# The error is "CLASS 'NAME': PROPERTY cannot be VALUE; …".
func _show(error: String) -> void:
	var cause := error.substr(error.find(": ") + 2)
	var property := cause.get_slice(REFUSED, 0)
	for control in _controls_of(property):
		if error.begins_with(control.get_edited_object().get_class()):
			_show_below(control, property.capitalize() + cause.substr(property.length()))


func _show_below(control: EditorProperty, cause: String) -> void:
	_remove_below(control)
	var label := Label.new()
	label.name = NAME
	label.text = cause
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	label.add_theme_color_override(
		&"font_color", control.get_theme_color(&"error_color", &"Editor")
	)
	control.add_sibling(label)


func _forget(property: String) -> void:
	for control in _controls_of(property):
		_remove_below(control)


func _remove_below(control: EditorProperty) -> void:
	var next := control.get_index() + 1
	if next < control.get_parent().get_child_count():
		var below := control.get_parent().get_child(next)
		if below is Label and below.name.begins_with(NAME):
			control.get_parent().remove_child(below)
			below.queue_free()


func _controls_of(property: String) -> Array[EditorProperty]:
	var found: Array[EditorProperty] = []
	var inspector := EditorInterface.get_inspector()
	for control: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if control.get_edited_property() == property and control.get_edited_object() != null:
			found.append(control)
	return found


## Passes errors about refused values on, on the main thread.
class Listener:
	extends Logger

	var show: Callable

	func _log_error(
		_function: String,
		_file: String,
		_line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		_error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		var error := rationale if rationale else code
		if REFUSED in error:
			show.call_deferred(error)
