@tool
extends MarginContainer
## The settings of the brush below the 3D view: numbers, and the species of the field. The toolbar
## above it does not change with the tool.

const BrushDensity := preload("brush_density.gd")
const BrushOptions := preload("brush_options.gd")
const DensitySlider := preload("density_slider.gd")
const LayerTitles := preload("layer_titles.gd")
const SpeciesMenu := preload("species_menu.gd")
const Translations := preload("../translations/translations.gd")

## Distance from the row, in pixels at 100 %.
const MARGIN := 8
## Width of a slider beside its texts, in pixels at 100 %.
const SLIDER_SLACK := 34.0

var _options: BrushOptions
var _field: PlantField3D
# Layers of the species, in the order of their tiles.
var _names: PackedStringArray = []
# Layers of species that the field does not contain yet.
var _new_layers: PackedStringArray = []

@onready var _row: HFlowContainer = %Row
@onready var _radius: EditorSpinSlider = %Radius
@onready var _path_width: EditorSpinSlider = %PathWidth
@onready var _strength: EditorSpinSlider = %Strength
@onready var _falloff: EditorSpinSlider = %Falloff
@onready var _density: DensitySlider = %Density
@onready var _as_mixed: Button = %AsMixed
@onready var _plant_height: EditorSpinSlider = %PlantHeight
@onready var _scale_jitter: EditorSpinSlider = %ScaleJitter
@onready var _color_jitter: EditorSpinSlider = %ColorJitter
@onready var _message: Label = %Message
@onready var _menu: SpeciesMenu = %SpeciesMenu


## Shows and changes [param options].
func setup(options: BrushOptions) -> void:
	_options = options
	set_translation_domain(Translations.DOMAIN)
	_radius.value_changed.connect(func(metres: float) -> void: _options.radius = metres)
	_path_width.value_changed.connect(func(metres: float) -> void: _options.width = metres)
	_strength.value_changed.connect(func(share: float) -> void: _options.strength = share)
	_falloff.value_changed.connect(func(share: float) -> void: _options.falloff = share)
	_density.value_changed.connect(func(plants: float) -> void: _options.density = plants)
	_as_mixed.toggled.connect(_on_as_mixed_toggled)
	_plant_height.value_changed.connect(func(factor: float) -> void: _options.height = factor)
	_scale_jitter.value_changed.connect(func(part: float) -> void: _options.scale_jitter = part)
	_color_jitter.value_changed.connect(func(part: float) -> void: _options.color_jitter = part)
	_menu.chosen.connect(func(layers: PackedStringArray) -> void: _options.species = layers)
	for side: StringName in [&"margin_left", &"margin_right"]:
		add_theme_constant_override(side, int(MARGIN * EditorInterface.get_editor_scale()))
	options.changed.connect(_show)
	_translate()
	_show()


## Shows the species of [param field] (null: none), and [param added], which the field does not
## contain yet, by their future layers in the map, with [param new_titles].
func show_field(
	field: PlantField3D,
	added: Dictionary[String, PlantFunction] = {},
	new_titles: Dictionary[String, String] = {}
) -> void:
	_field = field
	var functions: Array[PlantFunction] = []
	var names: PackedStringArray = []
	var titles: PackedStringArray = []
	for entry: PlantFieldSpecies in field.species if field else []:
		var layer := entry.get_layer_name() if entry else ""
		if layer and not layer in names:
			functions.append(entry.species)
			names.append(layer)
			titles.append(LayerTitles.of(field, layer))
	for layer in added:
		functions.append(added[layer])
		names.append(layer)
		titles.append("+ " + new_titles[layer])
	var new_layers: PackedStringArray = added.keys()
	if names != _names or new_layers != _new_layers:
		_names = names
		_new_layers = new_layers
		_make_tiles(functions, titles)
	_show()


func _make_tiles(functions: Array[PlantFunction], titles: PackedStringArray) -> void:
	var hints: PackedStringArray = []
	for i in _names.size():
		hints.append(_explain(_names[i], titles[i]))
	_menu.fill(_names, titles, hints)
	for i in _names.size():
		if functions[i]:
			EditorInterface.get_resource_previewer().queue_edited_resource_preview(
				functions[i], self, &"_on_thumbnail_ready", _names[i]
			)


## Shows [param text] beside the settings until one of them changes.
func show_message(text: String) -> void:
	_message.text = text
	_message.visible = not text.is_empty()


## Returns the layers that these settings paint.
func get_painted_names() -> PackedStringArray:
	return _options.species if _options.species else _names


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED and _options:
		_translate()


func _explain(layer: String, title: String) -> String:
	if layer in _new_layers:
		return tr("Picked in the panel. Painting adds it to the field.")
	return title


func _on_thumbnail_ready(
	_path: String, preview: Texture2D, _small: Texture2D, layer: String
) -> void:
	if preview:
		_menu.show_picture(layer, preview)


func _on_as_mixed_toggled(is_on: bool) -> void:
	if is_on:
		_options.is_as_mixed = true
	else:
		_options.density = _density.value


# The slider ends at the total density of all species, which is the maximum of the field.
func _show_density() -> void:
	var is_shown := _options.tool == BrushOptions.Tool.PAINT
	_density.visible = is_shown
	_as_mixed.visible = is_shown
	_as_mixed.set_pressed_no_signal(_options.is_as_mixed)
	if not is_instance_valid(_field):
		return
	_density.set_value_no_signal(0.0)  # Without it a lower maximum would count as a new value.
	_density.max_value = maxf(BrushDensity.sum_of_mix(_field, _names), _density.step)
	var mixed := BrushDensity.sum_of_mix(_field, get_painted_names())
	_density.set_value_no_signal(mixed if _options.is_as_mixed else _options.density)
	_density.mark = mixed
	_as_mixed.tooltip_text = (
		tr("Paint the density of the field's mix: %s plants/m².") % String.num(mixed, 2)
	)


func _show() -> void:
	show_message("")
	visible = _options.tool not in [BrushOptions.Tool.NONE, BrushOptions.Tool.PICK]
	var paints := not _options.draws_path()
	_menu.visible = paints
	_path_width.visible = not paints
	for slider: Control in [_radius, _strength, _falloff]:
		slider.visible = paints
	_menu.show_painted(_options.species)
	_show_density()
	_plant_height.visible = _options.tool == BrushOptions.Tool.HEIGHT
	for slider: Control in [_scale_jitter, _color_jitter]:
		slider.visible = _options.tool == BrushOptions.Tool.JITTER
	_radius.set_value_no_signal(_options.radius)
	_path_width.set_value_no_signal(_options.width)
	_strength.set_value_no_signal(_options.strength)
	_falloff.set_value_no_signal(_options.falloff)
	_plant_height.set_value_no_signal(_options.height)
	_scale_jitter.set_value_no_signal(_options.scale_jitter)
	_color_jitter.set_value_no_signal(_options.color_jitter)


# These sliders do not translate their labels themselves.
func _translate() -> void:
	_radius.label = tr("Radius")
	_path_width.label = tr("Width")
	_strength.label = tr("Strength")
	_falloff.label = tr("Falloff")
	_density.label = tr("Density")
	_density.suffix = tr("plants/m²")
	_plant_height.label = tr("Height")
	_scale_jitter.label = tr("Scale Jitter")
	_color_jitter.label = tr("Color Jitter")
	_fit_sliders()
	_menu.show_painted(_options.species)


# As wide as the label, the widest usual number and the unit in any language.
func _fit_sliders() -> void:
	var font := get_theme_font(&"font", &"LineEdit")
	var font_size := get_theme_font_size(&"font_size", &"LineEdit")
	var slack := SLIDER_SLACK * EditorInterface.get_editor_scale()
	for slider: Control in _row.get_children():
		if slider is not EditorSpinSlider:
			continue
		var number := slider as EditorSpinSlider
		var digits := "00.0" if number.step >= 0.1 else "00.00"
		var text := "%s %s %s" % [number.label, digits, number.suffix]
		var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
		number.custom_minimum_size.x = ceilf(width + slack)
