@tool
extends VBoxContainer
## The list of species with thumbnails: the ready ones, and below them the project's own.

## The user chose a species.
signal chosen(entry: SpeciesEntry)
## The list is current: files were looked through.
signal refreshed

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("species_entry.gd")
const SpeciesCatalog := preload("species_catalog.gd")
const PlantPhoto := preload("../widgets/plant_photo.gd")
const THUMBNAIL_SIZE := 48
## Of the thumbnail's.
const COLUMN_WIDTH := 1.4
## Of the editor's font size.
const SMALL_FONT := 0.85
## From so many new thumbnails on, progress is shown.
const MANY := 24

var _thumbnails: Dictionary[String, Texture2D] = {}
var _stamps: Dictionary[String, int] = {}
var _chosen_key := ""
var _state: EditorState
# What the status line calls our work, while it shows it.
var _work_title := ""

@onready var _catalog: SpeciesCatalog = %Catalog
@onready var _photo: PlantPhoto = %Photo
@onready var _filter: LineEdit = %Filter
@onready var _ready_list: ItemList = %ReadyList
@onready var _project_list: ItemList = %ProjectList
@onready var _no_match: Label = %NoMatch
@onready var _project_hint: Label = %ProjectHint


## Fills the list and keeps it current. Many new thumbnails show their progress in [param state].
func setup(state: EditorState) -> void:
	_state = state
	_state.work_changed.connect(_on_work_changed)
	_photo.taken.connect(_on_photo_taken)
	_filter.text_changed.connect(func(_text: String) -> void: _fill())
	for list: ItemList in [_ready_list, _project_list]:
		list.item_selected.connect(_on_item_selected.bind(list))
	_catalog.changed.connect(_on_catalog_changed)
	_catalog.start()
	_dress()


## The entry with that key (a path or a class), or null.
func find(key: String) -> SpeciesEntry:
	for entry: SpeciesEntry in _entries():
		if entry.key == key:
			return entry
	return null


## The first ready species.
func get_first() -> SpeciesEntry:
	return _catalog.ready_species[0]


## Marks the entry with that key as chosen, without a signal.
func mark(key: String) -> void:
	_chosen_key = key
	for list: ItemList in [_ready_list, _project_list]:
		list.deselect_all()
		for i in list.item_count:
			if (list.get_item_metadata(i) as SpeciesEntry).key == key:
				list.select(i)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_dress()


func _dress() -> void:
	if is_part_of_edited_scene():
		return
	var size := roundi(THUMBNAIL_SIZE * EditorInterface.get_editor_scale())
	_filter.right_icon = get_theme_icon(&"Search", &"EditorIcons")
	for list: ItemList in [_ready_list, _project_list]:
		list.fixed_icon_size = Vector2i(size, size)
		# Three stand side by side in a dock of the usual width.
		list.fixed_column_width = roundi(size * COLUMN_WIDTH)
		list.add_theme_constant_override(&"h_separation", 0)
		var font_size := roundi(get_theme_font_size(&"font_size", &"ItemList") * SMALL_FONT)
		list.add_theme_font_size_override(&"font_size", font_size)
	for hint: Label in [_project_hint, _no_match]:
		var pale := get_theme_color(&"font_disabled_color", &"Editor")
		hint.add_theme_color_override(&"font_color", pale)


func _entries() -> Array:
	return _catalog.ready_species + _catalog.project_species


func _fill() -> void:
	_fill_list(_ready_list, _catalog.ready_species)
	_fill_list(_project_list, _catalog.project_species)
	_project_hint.visible = _catalog.project_species.is_empty()
	_no_match.visible = _ready_list.item_count + _project_list.item_count == 0
	mark(_chosen_key)


func _fill_list(list: ItemList, entries: Array[SpeciesEntry]) -> void:
	list.clear()
	for entry in entries:
		if _filter.text.is_empty() or entry.title.containsn(_filter.text):
			var index := list.add_item(entry.title, _picture_of(entry))
			list.set_item_metadata(index, entry)
			list.set_item_tooltip(index, entry.key)
	list.visible = list.item_count > 0


func _picture_of(entry: SpeciesEntry) -> Texture2D:
	var picture: Texture2D = _thumbnails.get(entry.key)
	return picture if picture else get_theme_icon(&"FileThumbnail", &"EditorIcons")


func _on_catalog_changed() -> void:
	_fill()
	var wanted := 0
	for entry: SpeciesEntry in _entries():
		if _stamps.get(entry.key, -1) != entry.stamp:
			_stamps[entry.key] = entry.stamp
			# A bound method would not keep the entry, which goes when files are looked through anew.
			_photo.request(entry.key, func() -> PlantFunction: return entry.instantiate())
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
	for list: ItemList in [_ready_list, _project_list]:
		for i in list.item_count:
			if (list.get_item_metadata(i) as SpeciesEntry).key == key:
				list.set_item_icon(i, _thumbnails[key])
	if _shows_work():
		_state.advance_work()
		if _state.work_done >= _state.work_total:
			_state.end_work()


func _on_item_selected(index: int, list: ItemList) -> void:
	var entry: SpeciesEntry = list.get_item_metadata(index)
	mark(entry.key)
	chosen.emit(entry)
