@tool
extends "brush_test.gd"
## Effects of modifier keys and pens on strokes of the brush.

const BrushOptions := preload("res://addons/undergrowth/editor/brush/brush_options.gd")
const BrushReadout := preload("res://addons/undergrowth/editor/brush/brush_readout.gd")
const Translations := preload("res://addons/undergrowth/editor/translations/translations.gd")
const TULIP := "Tulip"
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


func test_ctrl_and_shift_erase_all_species() -> void:
	var field := await _edited_field()
	await _choose_only(field.get_parent())
	field.species = [field.species[0], PlantFieldSpecies.of(TulipFunction.new())]
	await _choose_only(field)
	await _rested(field)
	await _choose_tool("Paint")
	_sharpen(0.5)
	await _paint_only([GRASS])
	var other := Vector3(0, 0, 1.6)
	holds_ctrl = true
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(field.map.get_density(Vector3.ZERO, GRASS), 0.0, "the chosen species with Ctrl")
	check_equal(field.map.get_density(Vector3.ZERO, TULIP), 1.0, "another species with Ctrl")
	holds_shift = true
	await click(_view(), _place_of(field, other))
	holds_ctrl = false
	holds_shift = false
	check_equal(_history().get_current_action_name(), tr("Erase Plants"), "the step's name")
	check_equal(field.map.get_density(other, GRASS), 0.0, "the chosen species with Shift too")
	check_equal(field.map.get_density(other, TULIP), 0.0, "another species with Shift too")
	await _paint_only([])
	await _choose_tool("Paint")


func test_ctrl_and_the_wheel_change_the_radius() -> void:
	var field := await _edited_field()
	await _choose_tool("Paint")
	var radius := _settings().get_node("%Radius") as EditorSpinSlider
	var before := radius.value
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var seen_from := camera.global_transform
	holds_ctrl = true
	await wheel(_view(), 2)
	check(absf(radius.value - before * 1.44) < 0.06, "radius: %f" % radius.value)
	await wheel(_view(), -2)
	holds_ctrl = false
	await frames(20)
	check(absf(radius.value - before) < 0.06, "radius then: %f" % radius.value)
	check_equal(camera.global_transform, seen_from, "the view")
	check(field.map == null, "nothing is painted")
	await _choose_tool("Paint")


func test_numbers_beside_the_pointer() -> void:
	var field := await _edited_field()
	var names: PackedStringArray = [GRASS]
	var options := BrushOptions.new()
	var describe := func(tool: BrushOptions.Tool, point: Vector3) -> String:
		return BrushReadout.describe(field, options, tool, names, point)
	var mixed := String.num(field.density, 2)
	var unit := Translations.text("%s plants/m²")
	var paint := BrushOptions.Tool.PAINT
	check_equal(describe.call(paint, Vector3.ZERO), "2.0 m\n" + unit % mixed, "without a map")
	check_equal(describe.call(paint, Vector3(9, 0, 0)), "2.0 m\n" + unit % "0.0", "beside it")
	field.map = PlantMap.new()
	field.map.paint_plants(Vector3.ZERO, 1.0, GRASS, 3.0, 1.0, 0.0)
	field.map.paint_height(Vector3.ZERO, 1.0, GRASS, 1.5, 1.0, 0.0)
	var text: String = describe.call(paint, Vector3.ZERO)
	check_equal(text, "2.0 m\n" + unit % "3.0", "plants of a map")
	check_equal(describe.call(BrushOptions.Tool.HEIGHT, Vector3.ZERO), "2.0 m\n× 1.5", "height")
	field.map.paint_color_jitter(Vector3.ZERO, 1.0, GRASS, 1.0, 1.0, 0.0)
	var jitter := Translations.text("Scale %s, Color %s") % ["0.0", "1.0"]
	check_equal(describe.call(BrushOptions.Tool.JITTER, Vector3.ZERO), "2.0 m\n" + jitter, "jitter")
	check_equal(describe.call(BrushOptions.Tool.PICK, Vector3.ZERO), unit % "3.0", "pick")


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
