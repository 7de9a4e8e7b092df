@tool
extends Button
## The species that the brush paints: a button that shows tiles over the 3D view, one for
## all species of the field, and one for each. A click chooses one, and Ctrl several.

## Emitted when the user has chosen the species of [param layers]. Empty: all.
signal chosen(layers: PackedStringArray)

const TileTitles := preload("../widgets/tile_titles.gd")
const Translations := preload("../translations/translations.gd")

## Size of a picture in the tiles and on the button, in pixels at 100 %.
const PICTURE := 64
const SMALL_PICTURE := 24
const ALL_ICON := "../../icons/PlantField3D.svg"
## Size of that icon, in pixels.
const ICON_SIZE := 16.0
## Minimum width of a column, as a fraction of the picture's size.
const MIN_COLUMN := 1.3
## Maximum height of the tiles, as a fraction of the view's. More rows scroll.
const MAX_HEIGHT := 0.45
## Distance from the edges of the view, in pixels at 100 %.
const GAP := 8.0

# Layers of the map, and the titles of their species.
var _names: PackedStringArray = []
var _titles: PackedStringArray = []
var _frame := PanelContainer.new()
var _tiles := ItemList.new()


func _ready() -> void:
	toggle_mode = true
	toggled.connect(func(_on: bool) -> void: _show_tiles())
	visibility_changed.connect(_show_tiles)
	var unit := EditorInterface.get_editor_scale()
	add_theme_constant_override(&"icon_max_width", roundi(SMALL_PICTURE * unit))
	_make_frame(unit)
	_frame.get_parent_control().resized.connect(_place)
	_frame.resized.connect(_place)
	_tiles.multi_selected.connect(_on_selected)


## Shows the species of the layers [param names] with [param titles] and [param hints].
func fill(names: PackedStringArray, titles: PackedStringArray, hints: PackedStringArray) -> void:
	_names = names
	_titles = titles
	var words := titles.duplicate()
	words.append(tr("All Species"))
	TileTitles.fit_columns(_tiles, words, _tiles.fixed_icon_size.x * MIN_COLUMN)
	_tiles.clear()
	_tiles.add_item(TileTitles.wrap(_tiles, tr("All Species")), _draw_icon())
	_tiles.set_item_tooltip(0, tr("Paint all species of this field."))
	for i in names.size():
		var title := TileTitles.wrap(_tiles, titles[i])
		_tiles.add_item(title, get_theme_icon(&"Object", &"EditorIcons"))
		_tiles.set_item_tooltip(i + 1, hints[i])
	_place()


## Sets the picture of the species of [param layer].
func show_picture(layer: String, picture: Texture2D) -> void:
	var at := _names.find(layer)
	if at >= 0:
		_tiles.set_item_icon(at + 1, picture)
		_show_choice()


## Marks [param painted] as chosen. Empty: all.
func show_painted(painted: PackedStringArray) -> void:
	_tiles.deselect_all()
	for i in _names.size():
		if _names[i] in painted:
			_tiles.select(i + 1, false)
	if _tiles.item_count > 0 and not _tiles.is_anything_selected():
		_tiles.select(0)
	_show_choice()


## Returns the tiles: first that of all species, then those of the layers.
func get_tiles() -> ItemList:
	return _tiles


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _frame.is_inside_tree():
		_apply_theme()
	if what == NOTIFICATION_PREDELETE and is_instance_valid(_frame):
		_frame.queue_free()


func _make_frame(unit: float) -> void:
	_tiles.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_tiles.icon_mode = ItemList.ICON_MODE_TOP
	_tiles.select_mode = ItemList.SELECT_MULTI
	_tiles.allow_reselect = true
	_tiles.same_column_width = true
	_tiles.fixed_icon_size = Vector2i.ONE * roundi(PICTURE * unit)
	_frame.add_child(_tiles)
	_frame.set_translation_domain(Translations.DOMAIN)
	_frame.hide()
	EditorInterface.get_editor_viewport_3d(0).get_parent().get_parent().add_child(_frame)
	_apply_theme()


func _apply_theme() -> void:
	_frame.add_theme_stylebox_override(&"panel", get_theme_stylebox(&"panel", &"PopupPanel"))
	TileTitles.apply_theme(_tiles)


# Sharp at the size of the pictures.
func _draw_icon() -> Texture2D:
	var folder := (get_script() as Script).resource_path.get_base_dir()
	var source := FileAccess.get_file_as_string(folder.path_join(ALL_ICON))
	var image := Image.new()
	if image.load_svg_from_string(source, _tiles.fixed_icon_size.x / ICON_SIZE) != OK:
		return null
	return ImageTexture.create_from_image(image)


func _show_tiles() -> void:
	_frame.visible = button_pressed and is_visible_in_tree()
	_place()


func _show_choice() -> void:
	var selected := _tiles.get_selected_items()
	icon = null
	if selected.size() > 1:
		text = tr("%d Species") % selected.size()
	elif selected.is_empty() or selected[0] == 0:
		text = tr("All Species")
	else:
		text = _titles[selected[0] - 1]
		icon = _tiles.get_item_icon(selected[0])


# In the lower left corner of the view, above the button, with as many columns as it has room for.
func _place() -> void:
	if not _frame.is_inside_tree():
		return
	var view := _frame.get_parent_control().size
	var gap := GAP * EditorInterface.get_editor_scale()
	var tile := _get_tile_size()
	var margin := _tiles.get_theme_stylebox(&"panel").get_minimum_size()
	margin.x += _tiles.get_v_scroll_bar().get_combined_minimum_size().x
	var room := view.x - 4.0 * gap - margin.x
	var columns := clampi(floori(room / tile.x), 1, maxi(_tiles.item_count, 1))
	var max_rows := maxi(floori(view.y * MAX_HEIGHT / tile.y), 1)
	var rows := clampi(ceili(_tiles.item_count / float(columns)), 1, max_rows)
	_tiles.max_columns = columns
	_tiles.custom_minimum_size = Vector2(columns, rows) * tile + margin
	_frame.reset_size()
	_frame.position = Vector2(gap, maxf(view.y - _frame.size.y - gap, 0.0))


func _get_tile_size() -> Vector2:
	var font := _tiles.get_theme_font(&"font")
	var line := font.get_height(_tiles.get_theme_font_size(&"font_size"))
	var gaps := Vector2(
		_tiles.get_theme_constant(&"h_separation"), _tiles.get_theme_constant(&"v_separation")
	)
	var own := Vector2(_tiles.fixed_column_width, _tiles.fixed_icon_size.y)
	own.y += TileTitles.LINES * line + _tiles.get_theme_constant(&"icon_margin")
	return (own + gaps).ceil() + Vector2(TileTitles.COLUMN_SLACK, 0.0)


func _on_selected(index: int, _is_on: bool) -> void:
	var layers: PackedStringArray = []
	for i in _tiles.get_selected_items() if index > 0 else PackedInt32Array():
		if i > 0:
			layers.append(_names[i - 1])
	chosen.emit(layers)
