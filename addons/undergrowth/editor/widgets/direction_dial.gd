@tool
extends Control
## A compass seen from above, with +x to the right and +z towards the viewer. A drag of the arrow
## sets the direction that the wind blows to. Arrow keys rotate by 1°, with Shift by 15°.

## Emitted when the user rotated the arrow.
signal direction_changed(degrees: float)

const FINE_TURN := 1.0
const COARSE_TURN := 15.0
## Names of the eight main directions, in steps of 45° from 0°.
const HEADINGS: Array[String] = ["+z", "+x +z", "+x", "+x −z", "−z", "−x −z", "−x", "−x +z"]

## Direction that the wind blows to: 0 towards +z, 90 towards +x.
@export_range(0.0, 360.0) var degrees := 0.0:
	set(value):
		degrees = fposmod(value, 360.0)
		queue_redraw()


## Returns the meaning of the arrow, such as "90° towards +x".
func describe() -> String:
	var heading := roundi(degrees / 45.0) % HEADINGS.size()
	return tr("%s° towards %s") % [String.num(degrees, 1).trim_suffix(".0"), HEADINGS[heading]]


func _ready() -> void:
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)


func _get_minimum_size() -> Vector2:
	return Vector2(112, 112) * EditorInterface.get_editor_scale()


func _get_tooltip(_at: Vector2) -> String:
	return tr("%s.\nDrag to turn; arrow keys turn by 1°, with Shift by 15°.") % describe()


func _gui_input(event: InputEvent) -> void:
	if event is InputEventMouseMotion and event.button_mask & MOUSE_BUTTON_MASK_LEFT:
		_turn_towards(event.position, event.shift_pressed)
	elif event is InputEventMouseButton and event.button_index == MOUSE_BUTTON_LEFT:
		if event.pressed:
			grab_focus()
			_turn_towards(event.position, event.shift_pressed)
	elif event is InputEventKey and event.pressed:
		_turn_by_key(event)


func _turn_towards(at: Vector2, coarse: bool) -> void:
	var arm := at - size / 2.0
	if arm.length() > 2.0:
		_set_by_user(
			snappedf(rad_to_deg(atan2(arm.x, arm.y)), COARSE_TURN if coarse else FINE_TURN)
		)
	accept_event()


func _turn_by_key(event: InputEventKey) -> void:
	var turn := COARSE_TURN if event.shift_pressed else FINE_TURN
	match event.keycode:
		KEY_LEFT, KEY_UP:
			_set_by_user(degrees - turn)
		KEY_RIGHT, KEY_DOWN:
			_set_by_user(degrees + turn)
		_:
			return
	accept_event()


func _set_by_user(angle: float) -> void:
	degrees = angle
	direction_changed.emit(degrees)


func _draw() -> void:
	var scale_factor := EditorInterface.get_editor_scale()
	var font := get_theme_font("font", "Label")
	var font_size := roundi(get_theme_font_size("font_size", "Label") * 0.85)
	var text_color := get_theme_color("font_color", "Label")
	var faint := Color(text_color, 0.25)
	var center := size / 2.0
	var radius := minf(size.x, size.y) / 2.0 - font_size * 1.3
	draw_circle(center, radius, Color(text_color, 0.06))
	draw_arc(center, radius, 0.0, TAU, 64, faint, scale_factor, true)
	for step in 24:
		var out := Vector2.RIGHT.rotated(TAU * step / 24.0)
		var inner := 0.86 if step % 6 == 0 else 0.93
		draw_line(center + out * radius * inner, center + out * radius, faint, scale_factor, true)
	for heading: int in [0, 2, 4, 6]:
		var out := Vector2(sin(heading * PI / 4.0), cos(heading * PI / 4.0))
		_draw_name(font, font_size, center + out * (radius + font_size * 0.72), HEADINGS[heading])
	_draw_arrow(center, radius, scale_factor)
	if has_focus():
		draw_rect(
			Rect2(Vector2.ZERO, size),
			get_theme_color("accent_color", "Editor"),
			false,
			scale_factor
		)


func _draw_name(font: Font, font_size: int, at: Vector2, text: String) -> void:
	var extent := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size)
	var baseline := at + Vector2(-extent.x / 2.0, font.get_ascent(font_size) - extent.y / 2.0)
	var color := Color(get_theme_color("font_color", "Label"), 0.7)
	draw_string(font, baseline, text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size, color)


func _draw_arrow(center: Vector2, radius: float, scale_factor: float) -> void:
	var color := get_theme_color("accent_color", "Editor")
	var along := Vector2(sin(deg_to_rad(degrees)), cos(deg_to_rad(degrees)))
	var across := along.orthogonal()
	var tip := center + along * radius * 0.82
	var neck := tip - along * 12.0 * scale_factor
	draw_line(center - along * radius * 0.6, neck, color, 2.5 * scale_factor, true)
	var head := PackedVector2Array(
		[tip, neck + across * 6.0 * scale_factor, neck - across * 6.0 * scale_factor]
	)
	draw_colored_polygon(head, color)
