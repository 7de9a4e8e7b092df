@tool
extends EditorSpinSlider
## The slider of the brush's density, with a mark at the density of the field's mix.

## In pixels at 100 %.
const MARK_SIZE := Vector2(2, 7)
## Width of the slider's grabber in pixels at 100 %.
const GRABBER := 4

## In the unit of the slider. 0: no mark.
var mark := 0.0:
	set(value):
		mark = value
		queue_redraw()


func _draw() -> void:
	if mark <= 0.0 or mark > max_value:
		return
	var scale_factor := EditorInterface.get_editor_scale()
	var extent := (MARK_SIZE * scale_factor).round()
	var middle := Vector2(get_mark_x(), size.y - extent.y * 0.5)
	var color := get_theme_color(&"accent_color", &"Editor")
	draw_rect(Rect2((middle - extent * 0.5).round(), extent), color)


## Returns the horizontal position of the mark, which is that of the grabber at the same value.
func get_mark_x() -> float:
	var box := get_theme_stylebox(&"normal", &"LineEdit")
	var grabber := GRABBER * EditorInterface.get_editor_scale()
	var width := size.x - box.get_minimum_size().x - grabber
	var ratio := inverse_lerp(min_value, max_value, mark)
	return box.get_offset().x + ratio * width + grabber * 0.5
