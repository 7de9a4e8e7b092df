@tool
extends "brush_test.gd"
## Effects of modifier keys and pens on strokes of the brush.

## Painting ends between the two rows of cells along it.
const EDGE := Vector3(0, 0, 1)


func test_ctrl_erases_while_it_paints() -> void:
	var field := await _edited_field()
	await _choose_tool("Paint")
	holds_ctrl = true
	await click(_view(), _place_of(field, Vector3.ZERO))
	holds_ctrl = false
	check_equal(_history().get_current_action_name(), tr("Erase Plants"), "the step's name")
	check(field.map.get_density(Vector3.ZERO, GRASS) < 0.6, "fewer plants under the brush")
	check((_bar().get_node("%Paint") as Button).button_pressed, "it paints again without Ctrl")


func test_shift_smooths() -> void:
	var field := await _edited_field()
	field.map = PlantMap.new()
	field.map.fill_polygon(_square(EDGE), GRASS)
	await _rested(field)
	var before := field.map.data
	await _choose_tool("Paint")
	holds_shift = true
	await drag(_view(), _place_of(field, Vector3(-1, 0, 1)), _place_of(field, Vector3(1, 0, 1)))
	holds_shift = false
	check_equal(_history().get_current_action_name(), tr("Smooth Plants"), "the step's name")
	var inside := field.map.get_density(EDGE - Vector3(0, 0, 0.1), GRASS)
	var outside := field.map.get_density(EDGE + Vector3(0, 0, 0.1), GRASS)
	check(inside < 0.95 and outside > 0.05, "the edge is %f | %f" % [inside, outside])
	check(inside > outside, "and denser where it was")
	var beyond := field.map.get_density(Vector3(0, 0, -1), GRASS)
	check_equal(beyond, 1.0, "beyond the brush")
	await undo()
	check_equal(field.map.data, before, "the map after undo")


func test_a_pen_does_less_where_it_is_pressed_less() -> void:
	var field := await _edited_field()
	await _choose_tool("Erase")
	_sharpen(0.5)
	pen_pressure = 0.2
	await _dab(field, Vector3.ZERO)
	pen_pressure = 0.6
	await _dab(field, Vector3(0, 0, 1.6))
	pen_pressure = 0.0
	var lightly := field.map.get_density(Vector3.ZERO, GRASS)
	var firmly := field.map.get_density(Vector3(0, 0, 1.6), GRASS)
	check(absf(lightly - 0.8) < 0.02, "a fifth of it is gone: %f" % lightly)
	check(absf(firmly - 0.4) < 0.02, "three fifths of it are gone: %f" % firmly)


func test_a_mouse_works_without_pressure() -> void:
	var field := await _edited_field()
	await _choose_tool("Erase")
	_sharpen(0.5)
	await _dab(field, Vector3.ZERO)
	check_equal(field.map.get_density(Vector3.ZERO, GRASS), 0.0, "after a mouse of pressure 0")
	pen_pressure = 1.0
	await _dab(field, Vector3(0, 0, 1.6))
	pen_pressure = 0.0
	check_equal(field.map.get_density(Vector3(0, 0, 1.6), GRASS), 0.0, "after one of pressure 1")


# Touches the ground, moves by a pixel and releases.
func _dab(field: PlantField3D, place: Vector3) -> void:
	var from := _in_window(_view(), _place_of(field, place))
	await _point(_view(), from)
	_press(_view(), from, MOUSE_BUTTON_LEFT, true)
	_move(_view(), from, from + Vector2.RIGHT, MOUSE_BUTTON_MASK_LEFT)
	_press(_view(), from, MOUSE_BUTTON_LEFT, false)
	await frames(2)


# Selects the area up to the line through [param edge], over the whole width.
func _square(edge: Vector3) -> PackedVector3Array:
	return [Vector3(-8, 0, -8), Vector3(8, 0, -8), Vector3(8, 0, edge.z), Vector3(-8, 0, edge.z)]
