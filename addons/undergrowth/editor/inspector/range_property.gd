@tool
extends EditorProperty
## Two numbers of a Vector2 or Vector2i in one line below their name: "min – max", or "first → last"
## of parts along their carrier.

const GAP := 2

var _first := EditorSpinSlider.new()
var _last := EditorSpinSlider.new()
var _is_angle := false
var _is_integer := false


## [param hint] is the hint string of the property's range. [param sign] is between the numbers.
func setup(is_integer: bool, hint: String, sign: String) -> void:
	_is_integer = is_integer
	var line := HBoxContainer.new()
	line.add_theme_constant_override(&"separation", GAP)
	var between := Label.new()
	between.text = sign
	line.add_child(_first)
	line.add_child(between)
	line.add_child(_last)
	for slider: EditorSpinSlider in [_first, _last]:
		slider.flat = true
		slider.size_flags_horizontal = SIZE_EXPAND_FILL
		slider.value_changed.connect(_on_value_changed)
		_apply_hint(slider, hint)
		add_focusable(slider)
	add_child(line)
	set_bottom_editor(line)


func _apply_hint(slider: EditorSpinSlider, hint: String) -> void:
	slider.min_value = -1e6
	slider.max_value = 1e6
	slider.step = 1.0 if _is_integer else 0.001
	var numbers: PackedFloat64Array = []
	for word in hint.split(",", false):
		if word.is_valid_float():
			numbers.append(word.to_float())
	if numbers.size() >= 2:
		slider.min_value = numbers[0]
		slider.max_value = numbers[1]
	if numbers.size() >= 3:
		slider.step = numbers[2]
	slider.allow_lesser = "or_less" in hint or numbers.size() < 2
	slider.allow_greater = "or_greater" in hint or numbers.size() < 2
	slider.rounded = _is_integer
	_is_angle = "radians_as_degrees" in hint
	var unit := hint.get_slice("suffix:", 1).get_slice(",", 0) if "suffix:" in hint else ""
	slider.suffix = "°" if _is_angle else unit


func _update_property() -> void:
	var value: Variant = get_edited_object().get(get_edited_property())
	_first.set_value_no_signal(_shown(value[0]))
	_last.set_value_no_signal(_shown(value[1]))


func _set_read_only(is_read_only: bool) -> void:
	_first.read_only = is_read_only
	_last.read_only = is_read_only


func _shown(number: float) -> float:
	return rad_to_deg(number) if _is_angle else number


func _on_value_changed(_number: float) -> void:
	var pair := Vector2(_first.value, _last.value)
	if _is_angle:
		pair = Vector2(deg_to_rad(pair.x), deg_to_rad(pair.y))
	emit_changed(get_edited_property(), Vector2i(pair) if _is_integer else pair)
