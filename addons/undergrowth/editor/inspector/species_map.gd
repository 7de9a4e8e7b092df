@tool
extends VBoxContainer
## A button at the top of a field's inspector that shows which species grows where: the field from
## above, with a colour for each species.

const SpeciesPicture := preload("../field/species_picture.gd")
const LayerTitles := preload("../brush/layer_titles.gd")
const Translations := preload("../translations/translations.gd")
const PICTURE_HEIGHT := 180.0
## Side of a colour in the legend.
const MARK := 12.0
## Minimum time between two pictures in milliseconds.
const PAUSE_MSEC := 500

# All inspectors: a field that is selected again keeps it.
static var _is_open := false

var _field: PlantField3D
var _button := Button.new()
var _picture := TextureRect.new()
var _legend := HFlowContainer.new()
var _shown_count := -1
var _next_msec := 0


## Shows the species of [param field].
func setup(field: PlantField3D) -> void:
	_field = field
	name = "SpeciesMap"
	set_translation_domain(Translations.DOMAIN)
	_button.name = "Button"
	_button.text = tr("Species Map")
	_button.tooltip_text = tr("Shows the field from above, with a colour for each species.")
	_button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	_button.toggle_mode = true
	_button.set_pressed_no_signal(_is_open)
	_button.toggled.connect(_on_toggled)
	_picture.name = "Picture"
	_picture.custom_minimum_size.y = PICTURE_HEIGHT * EditorInterface.get_editor_scale()
	_picture.expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	_picture.stretch_mode = TextureRect.STRETCH_KEEP_ASPECT_CENTERED
	_picture.texture_filter = CanvasItem.TEXTURE_FILTER_NEAREST
	_legend.name = "Legend"
	for child: Control in [_button, _picture, _legend]:
		add_child(child)
	field.build_finished.connect(_forget)
	_on_toggled(_is_open)


func _process(_delta: float) -> void:
	var is_due := _is_open and is_visible_in_tree() and Time.get_ticks_msec() >= _next_msec
	if is_due and is_instance_valid(_field) and _field.is_inside_tree():
		if _field.get_plant_count() != _shown_count:  # The brush and code change it, too.
			_show()


func _on_toggled(is_open: bool) -> void:
	_is_open = is_open
	_picture.visible = is_open
	_legend.visible = is_open
	_forget()


func _forget() -> void:
	_shown_count = -1


func _show() -> void:
	_next_msec = Time.get_ticks_msec() + PAUSE_MSEC
	_shown_count = _field.get_plant_count()
	var drawn := SpeciesPicture.of(_field) as SpeciesPicture
	_picture.texture = ImageTexture.create_from_image(drawn.image) if drawn.image else null
	for child in _legend.get_children():
		child.free()
	for i in _field.species.size():
		if _field.species[i] and _field.species[i].species:
			_add_title(i, drawn.counts[i])


func _add_title(entry: int, count: int) -> void:
	var mark := ColorRect.new()
	mark.color = SpeciesPicture.color_of(entry)
	mark.custom_minimum_size = Vector2.ONE * MARK * EditorInterface.get_editor_scale()
	mark.size_flags_vertical = SIZE_SHRINK_CENTER
	var title := Label.new()
	title.text = "%s (%d)" % [LayerTitles.of_species(_field.species[entry].species), count]
	title.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	var row := HBoxContainer.new()
	row.add_child(mark)
	row.add_child(title)
	_legend.add_child(row)
