@tool
extends Control
## How fast a wind of air is over the tops of a field at this moment, seen from above: bright where
## gusts and waves run. Up is -z. The owner lets the wind's clock go on.

## Metres of the field from side to side, and places that are asked along each.
const SPAN := 40.0
const SIDE := 56
## Frames between two pictures.
const EVERY := 3

## The wind that is drawn; nothing is drawn of null and of winds that are forces.
var wind: PlantWind:
	set(value):
		wind = value
		queue_redraw()

var _places := _grid()
var _image := Image.create_empty(SIDE, SIDE, false, Image.FORMAT_L8)
var _texture := ImageTexture.create_from_image(_image)
var _drawn_at := -1.0
var _frame := 0


func _get_minimum_size() -> Vector2:
	return Vector2(120, 120) * EditorInterface.get_editor_scale()


func _process(_delta: float) -> void:
	_frame += 1
	if not _is_air() or not is_visible_in_tree() or _frame % EVERY != 0:
		return
	if wind.get_time() != _drawn_at:
		_take_picture()
		queue_redraw()


## Speeds in m/s, [constant SIDE] by [constant SIDE] of them, row by row from -z.
func get_speeds() -> PackedFloat32Array:
	var speeds := PackedFloat32Array()
	if _is_air():
		for velocity in wind.sample_over_stand(wind.get_time(), _places):
			speeds.append(velocity.length())
	return speeds


func _is_air() -> bool:
	return wind and wind.kind == PlantWind.KIND_AIR


func _take_picture() -> void:
	_drawn_at = wind.get_time()
	var speeds := get_speeds()
	var mean := 0.0
	for speed in speeds:
		mean += speed / speeds.size()
	var bytes := PackedByteArray()
	bytes.resize(speeds.size())
	for i in speeds.size():
		bytes[i] = clampi(roundi(255.0 * 0.5 * speeds[i] / maxf(mean, 0.01)), 0, 255)
	_image.set_data(SIDE, SIDE, false, Image.FORMAT_L8, bytes)
	_texture.update(_image)


func _draw() -> void:
	if not _is_air():
		return
	var side := minf(size.x, size.y)
	var accent := get_theme_color("accent_color", "Editor")
	draw_texture_rect(_texture, Rect2(0, 0, side, side), false, accent.lerp(Color.WHITE, 0.3))
	var font_size := roundi(get_theme_font_size("font_size", "Label") * 0.8)
	var font := get_theme_font("font", "Label")
	var told := tr("Over the field, %d m") % roundi(SPAN)
	var at := Vector2(4.0, side - font.get_descent(font_size) - 2.0)
	draw_string_outline(font, at, told, HORIZONTAL_ALIGNMENT_LEFT, side, font_size, 4, Color.BLACK)
	draw_string(font, at, told, HORIZONTAL_ALIGNMENT_LEFT, side, font_size, Color.WHITE)


static func _grid() -> PackedVector2Array:
	var places := PackedVector2Array()
	for z in SIDE:
		for x in SIDE:
			places.append((Vector2(x + 0.5, z + 0.5) / SIDE - Vector2(0.5, 0.5)) * SPAN)
	return places
