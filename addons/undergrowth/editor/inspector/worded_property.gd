@tool
extends EditorProperty
## A number in the inspector that is a word for some values: it leaves the value to something else.

const WordedSlider := preload("../widgets/worded_slider.gd")


## The slider with a word for values below 0.
class WordSlider:
	extends "../widgets/worded_slider.gd"
	var word := ""

	func get_shown() -> String:
		return word if value < 0.0 else ""


var _slider: WordedSlider


## Shows the value in [param slider].
func setup(slider: WordedSlider) -> void:
	_slider = slider
	_slider.flat = true
	_slider.value_changed.connect(
		func(number: float) -> void: emit_changed(get_edited_property(), number)
	)
	add_child(_slider)
	add_focusable(_slider)


## Returns a slider for the range of a hint string. [param word] stands for values below 0.
static func make_slider(hint: String, word: String) -> WordedSlider:
	var parts := hint.split(",")
	var slider := WordSlider.new()
	slider.word = word
	slider.min_value = parts[0].to_float()
	slider.max_value = parts[1].to_float()
	slider.step = parts[2].to_float()
	slider.allow_greater = "or_greater" in hint
	slider.suffix = hint.get_slice("suffix:", 1) if "suffix:" in hint else ""
	return slider


func _update_property() -> void:
	_slider.set_value_no_signal(get_edited_object().get(get_edited_property()) as float)
	_slider.queue_redraw()


func _set_read_only(is_read_only: bool) -> void:
	_slider.read_only = is_read_only
