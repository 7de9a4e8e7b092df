@tool
extends VBoxContainer
## Tiles with pictures of mixes and species, with a filter and categories: ready mixes, ready
## species, simple stems, and the project's own species.

## Emitted when the user clicked a tile. [param entries] are the selected ones; the clicked one is
## the last.
signal chosen(entries: Array[SpeciesEntry])
## Emitted when the user double-clicked a tile.
signal opened(entry: SpeciesEntry)
## Emitted when the list is current after a search of the files.
signal refreshed
## Emitted when the user requests a new species.
signal new_wanted

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("species_entry.gd")
const SpeciesCatalog := preload("species_catalog.gd")
const MixText := preload("mix_text.gd")
const PlantPhoto := preload("../widgets/plant_photo.gd")
const TileTitles := preload("../widgets/tile_titles.gd")
## The dragged entry's key in the data of a drag.
const DRAGGED_KEY := "undergrowth_key"
## File of the entry that is chosen at first.
const FIRST_MIX := "meadow.tscn"
## In pixels at 100 %.
const THUMBNAIL_SIZE := 64
## Minimum width of a column, as a fraction of the thumbnail's size, for the title.
const MIN_COLUMN := 1.3
## Minimum number of new thumbnails for a progress bar. Those of the add-on alone are fewer.
const MANY := 48

var _thumbnails: Dictionary[String, Texture2D] = {}
var _stamps: Dictionary[String, int] = {}
# Species of mixes and their percentages (MixText), by the keys of the mixes.
var _mix_shares: Dictionary[String, Array] = {}
var _chosen_key := ""
var _state: EditorState
# Title of this work in the status line while it is shown.
var _work_title := ""

@onready var _catalog: SpeciesCatalog = %Catalog
@onready var _photo: PlantPhoto = %Photo
@onready var _new: Button = %New
@onready var _filter: LineEdit = %Filter
## Buttons of the categories, in the order of [method SpeciesCatalog.list_groups].
@onready var _categories: Array[Button] = [%Mixes, %Ready, %Simple, %Project]
@onready var _all: Button = %All
@onready var _tiles: ItemList = %Tiles
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
	_filter.custom_minimum_size.x *= EditorInterface.get_editor_scale()
	_all.button_group.pressed.connect(func(_button: BaseButton) -> void: _fill())
	_tiles.multi_selected.connect(_on_selected)
	_tiles.item_activated.connect(func(index: int) -> void: opened.emit(_entry_at(index)))
	_tiles.resized.connect(_fit_columns)
	_tiles.set_drag_forwarding(_get_dragged, Callable(), Callable())
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


## Marks the entry with that key as chosen, without a signal.
func mark(key: String) -> void:
	_chosen_key = key
	_tiles.deselect_all()
	for i in _tiles.item_count:
		if _entry_at(i).key == key:
			_tiles.select(i)


## Scrolls to the chosen entry after the layout of the list.
func reveal_chosen() -> void:
	await get_tree().process_frame
	_tiles.ensure_current_is_visible()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()
	elif what == NOTIFICATION_TRANSLATION_CHANGED and _state:
		_fill()


func _apply_theme() -> void:
	if is_part_of_edited_scene():
		return
	var size := roundi(THUMBNAIL_SIZE * EditorInterface.get_editor_scale())
	_new.icon = get_theme_icon(&"Add", &"EditorIcons")
	_filter.right_icon = get_theme_icon(&"Search", &"EditorIcons")
	_tiles.fixed_icon_size = Vector2i(size, size)
	TileTitles.apply_theme(_tiles)
	_fit_columns()
	for hint: Label in [_project_hint, _no_match]:
		var pale := get_theme_color(&"font_disabled_color", &"Editor")
		hint.add_theme_color_override(&"font_color", pale)


# One width for all tiles, in any category and with any filter.
func _fit_columns() -> void:
	var titles: PackedStringArray = []
	for entry in _entries():
		titles.append(tr(entry.title))
	TileTitles.fit_columns(_tiles, titles, _tiles.fixed_icon_size.x * MIN_COLUMN)
	for i in _tiles.item_count:
		_tiles.set_item_text(i, TileTitles.wrap(_tiles, tr(_entry_at(i).title)))


func _entry_at(index: int) -> SpeciesEntry:
	return _tiles.get_item_metadata(index)


func _entries() -> Array[SpeciesEntry]:
	var entries: Array[SpeciesEntry] = []
	for group in _catalog.list_groups():
		entries.append_array(group)
	return entries


func _fill() -> void:
	var groups := _catalog.list_groups()
	_tiles.clear()
	for i in groups.size():
		if _all.button_pressed or _categories[i].button_pressed:
			for entry: SpeciesEntry in groups[i]:
				_add_tile(entry)
	_fit_columns()
	var is_empty_project := _catalog.project_species.is_empty() and _categories[-1].button_pressed
	_project_hint.visible = is_empty_project
	_no_match.visible = _tiles.item_count == 0 and not is_empty_project
	mark(_chosen_key)


func _add_tile(entry: SpeciesEntry) -> void:
	if not _matches_filter(entry):
		return
	var index := _tiles.add_item("", _picture_of(entry))
	_tiles.set_item_metadata(index, entry)
	_show_tooltip(index)


func _show_tooltip(index: int) -> void:
	var text := _entry_at(index).key
	if _mix_shares.has(text):
		text += "\n" + MixText.describe(_mix_shares[text])
	_tiles.set_item_tooltip(index, text)


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
			_photo.request(entry.key, func() -> Object: return _make_sitter(entry))
			wanted += 1
	if wanted >= MANY and _state.work_total == 0:
		_work_title = tr("Taking pictures of %d species") % wanted
		_state.begin_work(_work_title, wanted)
	refreshed.emit()


# The field of a mix is made for its picture alone, and describes the mix as well.
func _make_sitter(entry: SpeciesEntry) -> Object:
	var sitter := entry.make_sitter()
	if sitter is PlantField3D:
		_mix_shares[entry.key] = MixText.find_shares(sitter as PlantField3D)
	return sitter


func _shows_work() -> bool:
	return _state.work_total > 0 and _state.work_title == _work_title


func _on_work_changed() -> void:
	if _shows_work() and _state.work_cancelled:
		_photo.clear()
		_state.end_work()


func _on_photo_taken(key: String, picture: Texture2D) -> void:
	_thumbnails[key] = picture if picture else get_theme_icon(&"FileDeadBigThumb", &"EditorIcons")
	for i in _tiles.item_count:
		if _entry_at(i).key == key:
			_tiles.set_item_icon(i, _thumbnails[key])
			_show_tooltip(i)
	if _shows_work():
		_state.advance_work()
		if _state.work_done >= _state.work_total:
			_state.end_work()


# Other parts of the editor take the file or the resource, such as a property of the inspector.
func _get_dragged(at: Vector2) -> Variant:
	var index := _tiles.get_item_at_position(at, true)
	if index < 0:
		return null
	var entry := _entry_at(index)
	var picture := TextureRect.new()
	picture.texture = _tiles.get_item_icon(index)
	_tiles.set_drag_preview(picture)
	if entry.kind == SpeciesEntry.Kind.CLASS:
		return {"type": "resource", "resource": entry.instantiate(), DRAGGED_KEY: entry.key}
	return {"type": "files", "files": PackedStringArray([entry.key]), DRAGGED_KEY: entry.key}


func _on_selected(index: int, is_on: bool) -> void:
	var entries: Array[SpeciesEntry] = []
	for i in _tiles.get_selected_items():
		if i != index:
			entries.append(_entry_at(i))
	if is_on:
		entries.append(_entry_at(index))
	if entries:
		_chosen_key = entries[-1].key
		chosen.emit(entries)
