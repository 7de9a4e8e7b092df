@tool
extends RefCounted
## Numbers beside the pointer: the radius of the brush, and what grows there.

const Translations := preload("../translations/translations.gd")
const BrushDensity := preload("brush_density.gd")
const BrushOptions := preload("brush_options.gd")

## Distance from the pointer, in pixels at 100 %.
const OFFSET := Vector2(18, 30)
const OUTLINE := 4
const SHADE := Color(0.0, 0.0, 0.0, 0.7)


## Returns the text for [param point], in the axes of [param field]. [param titles] are the painted
## species.
static func describe(
	field: PlantField3D,
	options: BrushOptions,
	tool: BrushOptions.Tool,
	titles: PackedStringArray,
	point: Vector3
) -> String:
	if tool == BrushOptions.Tool.HEIGHT:
		var factor := 1.0
		if field.map and titles:
			factor = field.map.get_height_factor(point, titles[0])
		return "%s m\n× %s" % [String.num(options.radius, 1), String.num(factor, 2)]
	if tool == BrushOptions.Tool.JITTER:
		return "%s m\n%s" % [String.num(options.radius, 1), _describe_jitter(field, titles, point)]
	var density := 0.0
	for title in titles:
		density += BrushDensity.at(field, title, point)
	var grown := Translations.text("%s plants/m²") % String.num(density, 2)
	if tool == BrushOptions.Tool.PICK:
		return grown
	return "%s m\n%s" % [String.num(options.radius, 1), grown]


static func _describe_jitter(
	field: PlantField3D, titles: PackedStringArray, point: Vector3
) -> String:
	var jitter := Vector2.ZERO
	if field.map and titles:
		jitter.x = field.map.get_scale_jitter(point, titles[0])
		jitter.y = field.map.get_color_jitter(point, titles[0])
	var text := Translations.text("Scale %s, Color %s")
	return text % [String.num(jitter.x, 2), String.num(jitter.y, 2)]


## Draws [param text] on [param overlay] beside [param pointer].
static func draw(overlay: Control, pointer: Vector2, text: String) -> void:
	var scale := EditorInterface.get_editor_scale()
	var font := overlay.get_theme_font(&"font", &"Label")
	var font_size := overlay.get_theme_font_size(&"font_size", &"Label")
	var at := pointer + OFFSET * scale
	var left := HORIZONTAL_ALIGNMENT_LEFT
	var outline := int(OUTLINE * scale)
	overlay.draw_multiline_string_outline(font, at, text, left, -1, font_size, -1, outline, SHADE)
	overlay.draw_multiline_string(font, at, text, left, -1, font_size)
