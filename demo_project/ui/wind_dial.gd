extends Control
## A round dial for a direction in degrees, seen from above.
##
## Drag its needle, or turn the wheel over it. 0 points down, towards the viewer (+z), 90 to the
## right (+x).

## The user turned the dial.
signal value_changed(degrees: float)

const RIM := Color(1.0, 1.0, 1.0, 0.16)
const TICK := Color(1.0, 1.0, 1.0, 0.4)
const NEEDLE := Color(0.68, 0.81, 0.44)
const WHEEL_STEP := 5.0

## Where the needle points, in [0, 360).
@export_range(0.0, 360.0, 1.0, "suffix:°") var value := 0.0:
	set(degrees):
		value = fposmod(degrees, 360.0)
		queue_redraw()


func _gui_input(event: InputEvent) -> void:
	var mouse := event as InputEventMouse
	if mouse and mouse.button_mask & MOUSE_BUTTON_MASK_LEFT:
		var pointed := mouse.position - size / 2.0
		_turn_to(rad_to_deg(atan2(pointed.x, pointed.y)))
	var button := event as InputEventMouseButton
	if button and button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_UP:
		_turn_to(value + WHEEL_STEP)
	elif button and button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
		_turn_to(value - WHEEL_STEP)


func _draw() -> void:
	var middle := size / 2.0
	var radius := minf(middle.x, middle.y) - 2.0
	draw_arc(middle, radius, 0.0, TAU, 48, RIM, 3.0, true)
	for quarter in 4:
		var outward := Vector2.from_angle(quarter * TAU / 4.0)
		draw_line(middle + outward * (radius - 7.0), middle + outward * (radius - 3.0), TICK, 1.5)
	var angle := deg_to_rad(value)
	var forward := Vector2(sin(angle), cos(angle))
	var neck := middle + forward * (radius - 17.0)
	var side := forward.orthogonal() * 7.0
	draw_line(middle - forward * (radius - 8.0), neck, NEEDLE, 3.0, true)
	draw_colored_polygon([middle + forward * (radius - 4.0), neck + side, neck - side], NEEDLE)


func _turn_to(degrees: float) -> void:
	value = roundf(degrees)
	accept_event()
	value_changed.emit(value)
