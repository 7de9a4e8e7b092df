@tool
extends VBoxContainer
## The list with thumbnails, in groups that fold: ready mixes, ready species, simple species, and
## the project's own.

## Emitted when the user chose a species or a mix.
signal chosen(entry: SpeciesEntry)
## Emitted when the list is current after a search of the files.
signal refreshed
## Emitted when the height of rows may have changed; see [method find_height_of_rows].
signal laid_out
## Emitted when the user requests a new species.
signal new_wanted

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("species_entry.gd")
const SpeciesCatalog := preload("species_catalog.gd")
const PlantPhoto := preload("../widgets/plant_photo.gd")
## The dragged entry's key in the data of a drag.
const DRAGGED_KEY := "undergrowth_key"
## File of the entry that is chosen at first.
const FIRST_MIX := "meadow.tscn"
const THUMBNAIL_SIZE := 48
## Minimum width of a column, as a fraction of the thumbnail's size, for the title.
const MIN_COLUMN := 1.2
## Pixels that the engine's list adds to each column. It also reserves room for a scroll bar.
const COLUMN_SLACK := 4
## Lines of a long title.
const TEXT_LINES := 2
## Pixels between two rows.
const ROW_GAP := 2
## Number of visible rows of a group, below its title.
const ROWS_SEEN := 2
## As a factor of the editor's font size.
const SMALL_FONT := 0.85
## Minimum number of new thumbnails for a progress bar. Those of the add-on alone are fewer.
const MANY := 48

var _thumbnails: Dictionary[String, Texture2D] = {}
var _stamps: Dictionary[String, int] = {}
var _chosen_key := ""
var _state: EditorState
# Height of the highest row so far, so that nothing moves while the user types a filter.
var _row_height := 0.0
# Title of this work in the status line while it is shown.
var _work_title := ""

@onready var _catalog: SpeciesCatalog = %Catalog
@onready var _photo: PlantPhoto = %Photo
@onready var _new: Button = %New
@onready var _filter: LineEdit = %Filter
@onready var _groups: Array[FoldableContainer] = [%Mixes, %Ready, %Simple, %Project]
@onready var _lists: Array[ItemList] = [%MixList, %ReadyList, %SimpleList, %ProjectList]
@onready var _scroll: ScrollContainer = %Scroll
@onready var _no_match: Label = %NoMatch
@onready var _project_hint: Label = %ProjectHint


## Fills the list and updates it after changes. Reports the progress of many new thumbnails to
## [param state].
func setup(state: EditorState) -> void:
	_state = state
	_state.work_changed.connect(_on_work_changed)
	_photo.taken.connect(_on_photo_taken)
	_new.pressed.connect(new_wanted.emit)
	_filter.text_changed.connect(func(_text: String) -> void: _fill())
	for list: ItemList in _lists:
		list.item_selected.connect(_on_item_selected.bind(list))
		list.resized.connect(_fit_columns.bind(list))
		list.set_drag_forwarding(_get_dragged.bind(list), Callable(), Callable())
	_catalog.changed.connect(_on_catalog_changed)
	_catalog.start()
	_apply_theme()


## Returns the entry with that key (a path or a class), or null.
func find(key: String) -> SpeciesEntry:
	for entry: SpeciesEntry in _entries():
		if entry.key == key:
			return entry
	return null


## Returns the entry for a new user: the meadow. If that file is missing, another mix or a species.
func get_first() -> SpeciesEntry:
	for entry in _catalog.mixes:
		if entry.key.get_file() == FIRST_MIX:
			return entry
	return _entries()[0]


## Returns the height of the search field, a group's title and two of its rows.
func find_height_of_rows() -> float:
	for list: ItemList in _lists:
		list.force_update_list_size()
		for i in list.item_count:
			_row_height = maxf(_row_height, list.get_item_rect(i).size.y)
	var gap := ROW_GAP * EditorInterface.get_editor_scale()
	return _scroll.position.y + _find_title_height() + ROWS_SEEN * (_row_height + gap) + gap


## Marks the entry with that key as chosen, without a signal.
func mark(key: String) -> void:
	_chosen_key = key
	for list: ItemList in _lists:
		list.deselect_all()
		for i in list.item_count:
			if (list.get_item_metadata(i) as SpeciesEntry).key == key:
				list.select(i)


## Scrolls to the chosen entry after the layout of the lists.
func reveal_chosen() -> void:
	await get_tree().process_frame
	for list: ItemList in _lists:
		for i in list.get_selected_items():
			_unfold(list)
			var row := list.get_item_rect(i)
			var above := _scroll.get_global_rect().position.y
			var top := list.get_global_rect().position.y + row.position.y - above
			if top < 0.0 or top + row.size.y > _scroll.size.y:
				_scroll.scroll_vertical += int(top)


func _unfold(list: ItemList) -> void:
	_groups[_lists.find(list)].folded = false


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()
	elif what == NOTIFICATION_TRANSLATION_CHANGED and _state:
		_fill()


func _apply_theme() -> void:
	if is_part_of_edited_scene():
		return
	_row_height = 0.0
	var size := roundi(THUMBNAIL_SIZE * EditorInterface.get_editor_scale())
	_new.icon = get_theme_icon(&"Add", &"EditorIcons")
	_filter.right_icon = get_theme_icon(&"Search", &"EditorIcons")
	for list: ItemList in _lists:
		list.fixed_icon_size = Vector2i(size, size)
		list.max_text_lines = TEXT_LINES
		list.add_theme_constant_override(&"h_separation", 0)
		list.add_theme_constant_override(&"v_separation", ROW_GAP)
		var font_size := roundi(get_theme_font_size(&"font_size", &"ItemList") * SMALL_FONT)
		list.add_theme_font_size_override(&"font_size", font_size)
		list.add_theme_stylebox_override(&"panel", StyleBoxEmpty.new())
		_fit_columns(list)
	for hint: Label in [_project_hint, _no_match]:
		var pale := get_theme_color(&"font_disabled_color", &"Editor")
		hint.add_theme_color_override(&"font_color", pale)


# From the theme, because the minimum sizes of a group and its content can be out of date.
func _find_title_height() -> float:
	var group := _groups[0]
	var font_size := group.get_theme_font_size(&"font_size")
	var line := group.get_theme_font(&"font").get_height(font_size)
	line = maxf(line, group.get_theme_icon(&"expanded_arrow").get_height())
	for panel: StringName in [&"title_panel", &"panel"]:
		line += group.get_theme_stylebox(panel).get_minimum_size().y
	return line


# As many columns as fit, over the whole width.
func _fit_columns(list: ItemList) -> void:
	var room := floori(list.size.x - list.get_v_scroll_bar().get_combined_minimum_size().x)
	var minimum := maxi(
		floori(list.fixed_icon_size.x * MIN_COLUMN), _longest_word(list) + COLUMN_SLACK
	)
	list.fixed_column_width = maxi(room / maxi(room / maxi(minimum, 1), 1) - COLUMN_SLACK, 0)
	for i in list.item_count:
		list.set_item_text(i, _wrap(list, (list.get_item_metadata(i) as SpeciesEntry).title))
	laid_out.emit.call_deferred()


# Returns the minimum column width in pixels. All entries of the add-on use the same width with any
# filter. Those of the project may need wider columns.
func _longest_word(list: ItemList) -> int:
	var font := list.get_theme_font(&"font")
	var font_size := list.get_theme_font_size(&"font_size")
	var longest := 0.0
	var groups := _catalog.list_groups()
	if list != _lists[-1]:
		groups.pop_back()
	for group in groups:
		for entry: SpeciesEntry in group:
			for word in tr(entry.title).split(" "):
				var width := font.get_string_size(word, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
				longest = maxf(longest, width)
	return ceili(longest)


# The list itself would break a long title within a word.
func _wrap(list: ItemList, title: String) -> String:
	var text := tr(title)
	var font := list.get_theme_font(&"font")
	var font_size := list.get_theme_font_size(&"font_size")
	var length := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	if length <= list.fixed_column_width - COLUMN_SLACK:
		return text
	var half := text.length() / 2
	var before := text.rfind(" ", half)
	var after := text.find(" ", half)
	var nearer_after := before < 0 or (after >= 0 and after - half < half - before)
	var at := after if nearer_after else before
	return text if at < 0 else text.left(at) + "\n" + text.substr(at + 1)


func _entries() -> Array[SpeciesEntry]:
	var entries: Array[SpeciesEntry] = []
	for group in _catalog.list_groups():
		entries.append_array(group)
	return entries


func _fill() -> void:
	var groups := _catalog.list_groups()
	var is_found := false
	for i in _lists.size():
		_fill_list(_lists[i], groups[i])
		_groups[i].visible = _lists[i].item_count > 0
		is_found = is_found or _groups[i].visible
	# The empty group of the project informs new users that it exists.
	_project_hint.visible = _catalog.project_species.is_empty()
	_groups[-1].visible = _groups[-1].visible or (_project_hint.visible and _filter.text.is_empty())
	_no_match.visible = not is_found
	mark(_chosen_key)


func _fill_list(list: ItemList, entries: Array[SpeciesEntry]) -> void:
	list.clear()
	for entry in entries:
		if _matches_filter(entry):
			var index := list.add_item("", _picture_of(entry))
			list.set_item_metadata(index, entry)
			list.set_item_tooltip(index, entry.key)
	_fit_columns(list)
	list.visible = list.item_count > 0


# Also finds its English title, which is the name of its file.
func _matches_filter(entry: SpeciesEntry) -> bool:
	var wanted := _filter.text
	return wanted.is_empty() or tr(entry.title).containsn(wanted) or entry.title.containsn(wanted)


func _picture_of(entry: SpeciesEntry) -> Texture2D:
	var picture: Texture2D = _thumbnails.get(entry.key)
	return picture if picture else get_theme_icon(&"FileThumbnail", &"EditorIcons")


func _on_catalog_changed() -> void:
	_fill()
	var wanted := 0
	for entry: SpeciesEntry in _entries():
		if _stamps.get(entry.key, -1) != entry.stamp:
			_stamps[entry.key] = entry.stamp
			# A bound method would not reference the entry, which is freed at the next search of the
			# files.
			_photo.request(entry.key, func() -> Object: return entry.make_sitter())
			wanted += 1
	if wanted >= MANY and _state.work_total == 0:
		_work_title = tr("Taking pictures of %d species") % wanted
		_state.begin_work(_work_title, wanted)
	refreshed.emit()


func _shows_work() -> bool:
	return _state.work_total > 0 and _state.work_title == _work_title


func _on_work_changed() -> void:
	if _shows_work() and _state.work_cancelled:
		_photo.clear()
		_state.end_work()


func _on_photo_taken(key: String, picture: Texture2D) -> void:
	_thumbnails[key] = picture if picture else get_theme_icon(&"FileDeadBigThumb", &"EditorIcons")
	for list: ItemList in _lists:
		for i in list.item_count:
			if (list.get_item_metadata(i) as SpeciesEntry).key == key:
				list.set_item_icon(i, _thumbnails[key])
	if _shows_work():
		_state.advance_work()
		if _state.work_done >= _state.work_total:
			_state.end_work()


# Other parts of the editor take the file or the resource, such as a property of the inspector.
func _get_dragged(at: Vector2, list: ItemList) -> Variant:
	var index := list.get_item_at_position(at, true)
	if index < 0:
		return null
	var entry: SpeciesEntry = list.get_item_metadata(index)
	var picture := TextureRect.new()
	picture.texture = list.get_item_icon(index)
	list.set_drag_preview(picture)
	if entry.kind == SpeciesEntry.Kind.CLASS:
		return {"type": "resource", "resource": entry.instantiate(), DRAGGED_KEY: entry.key}
	return {"type": "files", "files": PackedStringArray([entry.key]), DRAGGED_KEY: entry.key}


func _on_item_selected(index: int, list: ItemList) -> void:
	var entry: SpeciesEntry = list.get_item_metadata(index)
	mark(entry.key)
	chosen.emit(entry)
