@tool
extends RefCounted
## Titles below the pictures of an [ItemList]: one width for all tiles, and two lines by words.

## As a factor of the editor's font size.
const SMALL_FONT := 0.85
const LINES := 2
## Pixels that the engine's list adds to each column.
const COLUMN_SLACK := 4


## Sets the font and the number of lines of [param tiles].
static func apply_theme(tiles: ItemList) -> void:
	var usual := tiles.get_parent_control().get_theme_font_size(&"font_size", &"ItemList")
	tiles.max_text_lines = LINES
	tiles.add_theme_font_size_override(&"font_size", roundi(usual * SMALL_FONT))


## Makes columns at least [param minimum] pixels wide, so that every word of [param titles] fits.
static func fit_columns(tiles: ItemList, titles: PackedStringArray, minimum: float) -> void:
	var widest := minimum
	for title in titles:
		for word in title.split(" "):
			widest = maxf(widest, _width_of(tiles, word) + COLUMN_SLACK)
	tiles.fixed_column_width = ceili(widest)


## Returns [param text] in two lines if it is wider than a column. The list itself would break a
## long title within a word.
static func wrap(tiles: ItemList, text: String) -> String:
	if _width_of(tiles, text) <= tiles.fixed_column_width - COLUMN_SLACK:
		return text
	var half := text.length() / 2
	var before := text.rfind(" ", half)
	var after := text.find(" ", half)
	var nearer_after := before < 0 or (after >= 0 and after - half < half - before)
	var at := after if nearer_after else before
	return text if at < 0 else text.left(at) + "\n" + text.substr(at + 1)


static func _width_of(tiles: ItemList, text: String) -> float:
	var font := tiles.get_theme_font(&"font")
	var font_size := tiles.get_theme_font_size(&"font_size")
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
