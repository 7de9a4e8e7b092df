@tool
extends "wind_view.gd"
## The current speed of a wind of air over the top of a field, seen from above. Gusts and waves are
## bright. Up is -z. It draws nothing for winds that are forces. The owner advances the wind's
## clock.

## Width of the field in metres, and number of samples along each side.
const SPAN := 40.0
const SIDE := 56
## Frames between two pictures.
const EVERY := 3
## As a factor of the editor's font size.
const FONT_SHARE := 0.8
## Brightness of the mean speed, and increase of brightness with speed. The gusts of air differ by
## less than the mean.
const MEAN_BRIGHTNESS := 0.45
const CONTRAST := 1.2
## Brightness of the ground below, as a fraction of the accent's colour.
const DARKNESS := 0.8

var _places := _grid()
var _image := Image.create_empty(SIDE / 2, SIDE / 2, false, Image.FORMAT_LA8)
var _texture := ImageTexture.create_from_image(_image)
var _drawn_at := -1.0
var _frame := 0


func _init() -> void:
	texture_filter = CanvasItem.TEXTURE_FILTER_LINEAR


func _get_minimum_size() -> Vector2:
	return Vector2(104, 124) * EditorInterface.get_editor_scale()


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
		for velocity in wind.sample_over_canopy(wind.get_time(), _places):
			speeds.append(velocity.length())
	return speeds


func _take_picture() -> void:
	_drawn_at = wind.get_time()
	var speeds := get_speeds()
	var mean := 0.0
	for speed in speeds:
		mean += speed / speeds.size()
	var bytes := PackedByteArray()
	bytes.resize(2 * speeds.size())
	bytes.fill(255)
	for i in speeds.size():
		var more := speeds[i] / maxf(mean, 0.01) - 1.0
		bytes[2 * i + 1] = clampi(roundi(255.0 * (MEAN_BRIGHTNESS + CONTRAST * more)), 0, 255)
	_image.set_data(SIDE, SIDE, false, Image.FORMAT_LA8, bytes)
	_image.shrink_x2()  # Smaller eddies look like noise.
	_texture.update(_image)


func _draw() -> void:
	if not _is_air():
		return
	var font_size := roundi(get_theme_font_size("font_size", "Label") * FONT_SHARE)
	var font := get_theme_font("font", "Label")
	var text := Color(get_theme_color("font_color", "Label"), 0.75)
	var top := font_size * 1.5
	var side := minf(size.x, size.y - top)
	var accent := get_theme_color("accent_color", "Editor")
	var place := Rect2(0, top, side, side)
	draw_rect(place, accent.darkened(DARKNESS))
	draw_texture_rect(_texture, place, false, accent.lightened(0.3))
	draw_rect(place, Color(text, 0.15), false)
	var at := Vector2(0.0, top - font.get_descent(font_size) - 2.0)
	var label := tr("Field, %d m") % roundi(SPAN)
	draw_string(font, at, label, HORIZONTAL_ALIGNMENT_LEFT, size.x, font_size, text)


static func _grid() -> PackedVector2Array:
	var places := PackedVector2Array()
	for z in SIDE:
		for x in SIDE:
			places.append((Vector2(x + 0.5, z + 0.5) / SIDE - Vector2(0.5, 0.5)) * SPAN)
	return places
