@tool
extends EditorProperty
## A plant's height in the inspector. 0 is shown as "by species".

const HeightSlider := preload("../widgets/height_slider.gd")

var _slider := HeightSlider.new()


func _init() -> void:
	_slider.flat = true
	_slider.value_changed.connect(_on_value_changed)
	add_child(_slider)
	add_focusable(_slider)


func _update_property() -> void:
	_slider.set_value_no_signal(get_edited_object().get(get_edited_property()) as float)
	_slider.queue_redraw()


func _set_read_only(is_read_only: bool) -> void:
	_slider.read_only = is_read_only


func _on_value_changed(metres: float) -> void:
	emit_changed(get_edited_property(), metres)
