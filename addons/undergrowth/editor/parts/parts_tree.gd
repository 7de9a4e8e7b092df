@tool
extends Tree
## The parts of a species as a tree: plant, fronds, leaflets. A row has a name, a count, a colour
## and an eye. A click into the count edits it, a click on the colour changes it, a click on the eye
## hides the parts, a drag changes the order or the carrier.

## Emitted when another row was selected. Null: the plant itself.
signal chosen(arrangement: PlantArrangement)

const PartSteps := preload("part_steps.gd")
const Translations := preload("../translations/translations.gd")
## The columns.
const NAME := 0
const COUNT := 1
const COLOR := 2
const EYE := 3
## Widths in pixels at 100 %.
const COUNT_WIDTH := 50
const COLOR_WIDTH := 22
const EYE_WIDTH := 22
const INDENT := 10
## Between an item's border and its content, and between columns.
const MARGIN := 2
const SWATCH := Vector2(16, 12)
const DIM := 0.45

var _function: PlantFunction
var _steps: PartSteps
# Selected arrangement, or null for the plant.
var _chosen: PlantArrangement
var _is_outdated := false
var _picker: PopupPanel
# Width of the names' column at the last update.
var _room := 0


## Shows the parts of [param function]. Changes are steps of [param steps].
func setup(function: PlantFunction, steps: PartSteps) -> void:
	_function = function
	_steps = steps
	columns = 4
	select_mode = SELECT_SINGLE
	allow_reselect = true
	scroll_horizontal_enabled = false
	scroll_vertical_enabled = false  # The inspector around it scrolls.
	var scale_factor := EditorInterface.get_editor_scale()
	set_column_expand(COUNT, false)
	set_column_expand(COLOR, false)
	set_column_custom_minimum_width(COUNT, int(COUNT_WIDTH * scale_factor))
	set_column_expand(EYE, false)
	set_column_custom_minimum_width(COLOR, int(COLOR_WIDTH * scale_factor))
	set_column_custom_minimum_width(EYE, int(EYE_WIDTH * scale_factor))
	set_column_clip_content(NAME, true)
	for constant: StringName in [
		&"inner_item_margin_left", &"inner_item_margin_right", &"h_separation"
	]:
		add_theme_constant_override(constant, int(MARGIN * scale_factor))
	add_theme_constant_override(&"item_margin", int(INDENT * scale_factor))
	item_mouse_selected.connect(_on_mouse_selected)
	cell_selected.connect(_on_cell_selected)
	item_edited.connect(_on_item_edited)
	function.changed.connect(_update_soon)
	resized.connect(_on_resized)


## Returns the selected arrangement, or null for the plant.
func get_chosen() -> PlantArrangement:
	return _chosen


## Selects the row of [param arrangement]. Null: the plant.
func choose(arrangement: PlantArrangement) -> void:
	_chosen = arrangement
	_update()
	chosen.emit(_chosen)


## Returns what carries [param arrangement]: another one, or the species. Null if it is not there.
func find_carrier(arrangement: PlantArrangement) -> Resource:
	return _find_carrier(_function, arrangement)


func _find_carrier(carrier: Resource, arrangement: PlantArrangement) -> Resource:
	var children := PartSteps.children_of(carrier)
	if arrangement in children:
		return carrier
	for child in children:
		var found := _find_carrier(child, arrangement) if child else null
		if found:
			return found
	return null


func _notification(what: int) -> void:
	if _function and (what == NOTIFICATION_ENTER_TREE or what == NOTIFICATION_THEME_CHANGED):
		_update_soon()


# Once for any number of changes in a frame.
func _update_soon() -> void:
	if not _is_outdated:
		_is_outdated = true
		_update.call_deferred()


func _update() -> void:
	_is_outdated = false
	if not is_inside_tree():
		return
	if _chosen and not find_carrier(_chosen):
		_chosen = null
		chosen.emit.call_deferred(null)
	clear()
	var top := create_item()
	top.set_text(NAME, Translations.text("Plant"))
	top.set_metadata(NAME, _function)
	_room = get_column_width(NAME)
	_add_rows(top, _function, 2)
	_select_chosen(top)
	var margins := get_theme_stylebox(&"panel").get_minimum_size().y
	custom_minimum_size.y = _sum_heights(top) + margins


func _on_resized() -> void:
	if get_column_width(NAME) != _room:
		_update_soon()


# A long name is in two lines.
func _wrap(text: String, depth: int) -> String:
	var font := get_theme_font(&"font")
	var font_size := get_theme_font_size(&"font_size")
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	if width <= _room - depth * (get_theme_constant(&"item_margin") + MARGIN):
		return text
	var at := text.rfind(" ")
	return text if at < 0 else text.left(at) + "\n" + text.substr(at + 1)


func _add_rows(item: TreeItem, carrier: Resource, depth: int) -> void:
	for arrangement in PartSteps.children_of(carrier):
		if not arrangement:
			continue
		var row := item.create_child()
		row.set_metadata(NAME, arrangement)
		row.set_text(NAME, _wrap(PartSteps.title_of(arrangement), depth))
		row.set_tooltip_text(NAME, PartSteps.title_of(arrangement))
		row.set_text(COUNT, PartSteps.describe_count(arrangement.count))
		row.set_editable(COUNT, true)
		row.set_tooltip_text(
			COUNT, Translations.text("Number of parts on each carrier, such as 9 or 7–9.")
		)
		var eye := &"GuiVisibilityVisible" if arrangement.visible else &"GuiVisibilityHidden"
		row.set_icon(EYE, get_theme_icon(eye, &"EditorIcons"))
		row.set_tooltip_text(EYE, Translations.text("Show or hide these parts."))
		if arrangement.part:
			row.set_icon(COLOR, _make_swatch(PartSteps.color_of(arrangement.part)))
			row.set_tooltip_text(COLOR, Translations.text("Color of these parts."))
		if not arrangement.visible:
			for column in columns:
				row.set_custom_color(column, Color(get_theme_color(&"font_color"), DIM))
		_add_rows(row, arrangement, depth + 1)


func _make_swatch(color: Color) -> Texture2D:
	var extent := Vector2i(SWATCH * EditorInterface.get_editor_scale())
	var image := Image.create_empty(extent.x, extent.y, false, Image.FORMAT_RGB8)
	image.fill(color)
	return ImageTexture.create_from_image(image)


func _select_chosen(top: TreeItem) -> void:
	var item := top
	while item:
		if item.get_metadata(NAME) == (_chosen if _chosen else _function):
			item.select(NAME)
			return
		item = item.get_next_in_tree()


func _sum_heights(top: TreeItem) -> float:
	var sum := 0.0
	var item := top
	while item:
		sum += get_item_area_rect(item).size.y + get_theme_constant(&"v_separation")
		item = item.get_next_in_tree()
	return sum


func _on_cell_selected() -> void:
	var arrangement := get_selected().get_metadata(NAME) as PlantArrangement
	if arrangement != _chosen:
		_chosen = arrangement
		chosen.emit(arrangement)


func _on_mouse_selected(_at: Vector2, button: int) -> void:
	var item := get_selected()
	if button != MOUSE_BUTTON_LEFT or not item or not item.get_metadata(NAME) is PlantArrangement:
		return
	if get_selected_column() == COUNT:
		edit_selected.call_deferred(true)
	elif get_selected_column() == COLOR:
		_open_picker(item)
	elif get_selected_column() == EYE:
		_toggle(item.get_metadata(NAME) as PlantArrangement)


func _on_item_edited() -> void:
	var arrangement := get_edited().get_metadata(NAME) as PlantArrangement
	var text := get_edited().get_text(COUNT)
	var count := PartSteps.parse_count(text, arrangement.count)
	_steps.set_value(arrangement, &"count", count, Translations.text("Change Count"))
	_update_soon()  # Also if the text was no count.


func _toggle(arrangement: PlantArrangement) -> void:
	var shown := Translations.text("Show Part")
	var title := Translations.text("Hide Part") if arrangement.visible else shown
	_steps.set_value(arrangement, &"visible", not arrangement.visible, title)


func _open_picker(item: TreeItem) -> void:
	var part := (item.get_metadata(NAME) as PlantArrangement).part
	if not part:
		return
	if _picker:
		_picker.queue_free()
	_picker = PopupPanel.new()
	var colors := ColorPicker.new()
	colors.edit_alpha = false
	colors.color = PartSteps.color_of(part)
	colors.color_changed.connect(
		func(color: Color) -> void: _steps.shift_colors(part, color - PartSteps.color_of(part))
	)
	_picker.add_child(colors)
	add_child(_picker)
	var place := get_item_area_rect(item, COLOR)
	_picker.popup(Rect2i(Vector2i(get_screen_position() + place.position), Vector2i.ZERO))


func _get_drag_data(at: Vector2) -> Variant:
	var item := get_item_at_position(at)
	var arrangement := item.get_metadata(NAME) as PlantArrangement if item else null
	if not arrangement:
		return null
	drop_mode_flags = DROP_MODE_ON_ITEM | DROP_MODE_INBETWEEN  # The end of a drag resets it.
	var label := Label.new()
	label.text = item.get_text(NAME)
	set_drag_preview(label)
	return {"type": "undergrowth_part", "part": arrangement, "function": _function}


func _can_drop_data(at: Vector2, data: Variant) -> bool:
	if data is not Dictionary or data.get("function") != _function:
		return false
	var item := get_item_at_position(at)
	return item and not PartSteps.contains(data["part"], item.get_metadata(NAME))


func _drop_data(at: Vector2, data: Variant) -> void:
	var item := get_item_at_position(at)
	var target := item.get_metadata(NAME) as Resource
	var arrangement: PlantArrangement = data["part"]
	var from := find_carrier(arrangement)
	var section := get_drop_section_at_position(at)
	if section == 0 or target == _function:
		_steps.move(arrangement, from, target, PartSteps.children_of(target).size())
	else:
		var to := find_carrier(target as PlantArrangement)
		var index := PartSteps.children_of(to).find(target as PlantArrangement)
		_steps.move(arrangement, from, to, index + (1 if section > 0 else 0))
