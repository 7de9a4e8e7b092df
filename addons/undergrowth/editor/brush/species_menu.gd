@tool
extends MenuButton
## A menu with pictures for the species of a field, if a toolbar has no room for them. Several can
## be selected.

## Emitted when the user selected or deselected the species of [param layer].
signal chosen(layer: String, is_on: bool)

## Size of a picture, in pixels at 100 %.
const PICTURE := 32

# Layers of the map, and the titles of their species.
var _names: PackedStringArray = []
var _titles: PackedStringArray = []


func _ready() -> void:
	get_popup().hide_on_checkable_item_selection = false
	get_popup().index_pressed.connect(_on_index_pressed)


## Shows the species of the layers [param names] with [param titles].
func fill(names: PackedStringArray, titles: PackedStringArray) -> void:
	_names = names
	_titles = titles
	var popup := get_popup()
	popup.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	popup.clear()
	for title in titles:
		popup.add_check_item(title)


## Sets the picture of the species of [param layer].
func show_picture(layer: String, picture: Texture2D) -> void:
	var at := _names.find(layer)
	if at >= 0:
		get_popup().set_item_icon(at, picture)
		var width := roundi(PICTURE * EditorInterface.get_editor_scale())
		get_popup().set_item_icon_max_width(at, width)


## Marks [param painted] as selected. Empty: all.
func show_painted(painted: PackedStringArray) -> void:
	var count := 0
	var last := ""
	for i in _names.size():
		var is_on := _names[i] in painted
		get_popup().set_item_checked(i, is_on)
		last = _titles[i] if is_on else last
		count += int(is_on)
	match count:
		0:
			text = tr("All Species")
		1:
			text = last
		_:
			text = tr("%d Species") % count


func _on_index_pressed(index: int) -> void:
	chosen.emit(_names[index], not get_popup().is_item_checked(index))
