@tool
extends EditorProperty
## A number in the inspector that is a word below 0: it leaves the value to something else.


## The slider with the word.
class WordSlider:
	extends "../widgets/worded_slider.gd"
	var word := ""

	func get_shown() -> String:
		return word if value < 0.0 else ""


var _slider := WordSlider.new()


## [param hint] is the hint string of the property's range. [param word] stands for values below 0.
func setup(hint: String, word: String) -> void:
	var parts := hint.split(",")
	_slider.word = word
	_slider.min_value = parts[0].to_float()
	_slider.max_value = parts[1].to_float()
	_slider.step = parts[2].to_float()
	_slider.allow_greater = "or_greater" in hint
	_slider.suffix = hint.get_slice("suffix:", 1) if "suffix:" in hint else ""
	_slider.flat = true
	_slider.value_changed.connect(
		func(number: float) -> void: emit_changed(get_edited_property(), number)
	)
	add_child(_slider)
	add_focusable(_slider)


func _update_property() -> void:
	_slider.set_value_no_signal(get_edited_object().get(get_edited_property()) as float)
	_slider.queue_redraw()


func _set_read_only(is_read_only: bool) -> void:
	_slider.read_only = is_read_only
