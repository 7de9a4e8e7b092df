@tool
extends RefCounted
## One stroke of the brush on the map of a field, from press to release: one step of undo. A field
## without a map gets one with the density of its area. The stroke also adds new species.

const FieldEntries := preload("../actions/field_entries.gd")
const AreaModes := preload("../field/area_modes.gd")
const LayerTitles := preload("layer_titles.gd")
const Translations := preload("../translations/translations.gd")
const BrushDensity := preload("brush_density.gd")
const BrushOptions := preload("brush_options.gd")

const GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
## Distance between touches, in radii.
const SPACING := 0.35

var _field: PlantField3D
var _options: BrushOptions
var _tool: BrushOptions.Tool
var _smooths: bool
# Chosen layers. Empty: all of the field.
var _species: PackedStringArray = []
var _map: PlantMap
var _before: PlantMap
var _is_new := false
var _species_before: Array[PlantFieldSpecies] = []
var _density_before := 0.0
var _rect := Rect2()
var _last := Vector3.INF
# The painted species, and the density of each in plants/m².
var _names: PackedStringArray = []
var _densities: PackedFloat64Array = []


func _init(
	field: PlantField3D,
	options: BrushOptions,
	tool: BrushOptions.Tool,
	smooths: bool,
	species: PackedStringArray,
	added: Array[PlantFieldSpecies] = []
) -> void:
	_field = field
	_options = options
	_tool = tool
	_smooths = smooths
	_species = species
	_species_before = field.species
	_density_before = field.density
	if field.species.is_empty():
		field.species = [PlantFieldSpecies.of(load(GRASS) as PlantFunction)]
	_is_new = field.map == null
	_map = AreaModes.make_map(field) if _is_new else field.map
	_before = _map.snapshot()
	_map.area_changed.connect(_on_area_changed)
	for entry in added:
		FieldEntries.add(field, entry)
	if _is_new:
		field.map = _map
	_names = _choose_names()
	_densities = BrushDensity.divide(field, _names, options.density)


## Moves the brush to [param place], in world axes, with [param pressure] (0 to 1).
func move_to(place: Vector3, pressure: float) -> void:
	var goal := _field.to_local(place)
	var step := maxf(_radius() * SPACING, 0.01)
	if _last == Vector3.INF:
		_touch(goal, pressure)
		_last = goal
		return
	while _last.distance_to(goal) >= step:
		_last = _last.move_toward(goal, step)
		_touch(_last, pressure)


## Returns the reason for a stroke without any change or visible change, or an empty text.
func explain() -> String:
	if _last == Vector3.INF:
		return ""
	var names := Translations.text("All species")
	if _species and _names:
		names = LayerTitles.join(_field, _names)
	if not _rect.has_area():
		return _explain_nothing(names)
	if _tool != BrushOptions.Tool.PAINT or _smooths:
		return ""
	if _options.is_as_mixed and is_zero_approx(BrushDensity.sum_of_mix(_field, _names)):
		return Translations.text("%s: the mix has none of it. Set a density.") % names
	return _explain_room()


## Ends the stroke.
func finish(undo: EditorUndoRedoManager) -> void:
	_map.area_changed.disconnect(_on_area_changed)
	if not _rect.has_area() and _field.species == _species_before:
		_field.map = null if _is_new else _map
		return
	undo.create_action(_title(), UndoRedo.MERGE_DISABLE, _field)
	if _field.species != _species_before:
		undo.add_do_property(_field, &"species", _field.species)
		undo.add_undo_property(_field, &"species", _species_before)
	if _field.density != _density_before:
		undo.add_do_property(_field, &"density", _field.density)
		undo.add_undo_property(_field, &"density", _density_before)
	if _is_new:
		undo.add_do_property(_field, &"map", _map)
		undo.add_undo_property(_field, &"map", null)
	if _rect.has_area():
		undo.add_do_method(_map, &"restore", _map.snapshot(), _rect)
		undo.add_undo_method(_map, &"restore", _before, _rect)
	undo.commit_action()


func _touch(place: Vector3, pressure: float) -> void:
	var strength := _options.strength * pressure
	for i in _names.size():
		var title := _names[i]
		if _smooths:
			_map.smooth(place, _radius(), title, strength, _options.falloff)
		elif _tool == BrushOptions.Tool.HEIGHT:
			var height := _options.height
			_map.paint_height(place, _radius(), title, height, strength, _options.falloff)
		elif _tool == BrushOptions.Tool.JITTER:
			_touch_jitter(place, title, strength)
		elif _tool == BrushOptions.Tool.PAINT and not _options.is_as_mixed:
			var density := _densities[i]
			_map.paint_plants(place, _radius(), title, density, strength, _options.falloff)
		else:
			var share := 1.0 if _tool == BrushOptions.Tool.PAINT else 0.0
			_map.paint_towards(place, _radius(), title, share, strength, _options.falloff)


func _touch_jitter(place: Vector3, title: String, strength: float) -> void:
	var falloff := _options.falloff
	_map.paint_scale_jitter(place, _radius(), title, _options.scale_jitter, strength, falloff)
	_map.paint_color_jitter(place, _radius(), title, _options.color_jitter, strength, falloff)


# In the field's own axes.
func _radius() -> float:
	var scale := _field.global_basis.get_scale().x
	return clampf(_options.radius / maxf(scale, 1e-6), 0.01, BrushOptions.MAX_RADIUS)


# Returns the chosen layers of the field, or all if none is chosen.
func _choose_names() -> PackedStringArray:
	var names := FieldEntries.layers_of(_field)
	if _species.is_empty():
		return names
	var chosen: PackedStringArray = []
	for title in names:
		if title in _species:
			chosen.append(title)
	return chosen


func _on_area_changed(rect: Rect2) -> void:
	_rect = _rect.merge(rect) if _rect.has_area() else rect


func _explain_nothing(names: String) -> String:
	if _options.strength <= 0.0:
		return Translations.text("Strength is 0.")
	if _smooths:
		return Translations.text("%s: all is smooth here already.") % names
	match _tool:
		BrushOptions.Tool.ERASE:
			return Translations.text("%s: nothing to erase here.") % names
		BrushOptions.Tool.HEIGHT:
			return Translations.text("%s: the height is reached here already.") % names
		BrushOptions.Tool.JITTER:
			return Translations.text("%s: this jitter is reached here already.") % names
	var density := _options.density
	var message := Translations.text("%s: %s plants/m² grow here already.")
	if _options.is_as_mixed:
		density = BrushDensity.sum_of_mix(_field, _names)
		message = Translations.text(
			"%s: this area already has the density of the mix, %s plants/m². Set a higher density."
		)
	return message % [names, String.num(density, 2)]


# Scales all species down if the painted density exceeds the field's maximum.
func _explain_room() -> String:
	var room := BrushDensity.sum_of_mix(_field, FieldEntries.layers_of(_field))
	var painted := 0.0
	for title in FieldEntries.layers_of(_field):
		painted += _map.get_plant_density(_last, title)
	if painted <= room * 1.01:
		return ""
	var message := Translations.text(
		"%s plants/m² are painted here, but the field grows %s at most. Raise the field's density."
	)
	return message % [String.num(painted, 2), String.num(room, 2)]


func _title() -> String:
	if _smooths:
		return Translations.text("Smooth Plants")
	match _tool:
		BrushOptions.Tool.ERASE:
			return Translations.text("Erase Plants")
		BrushOptions.Tool.HEIGHT:
			return Translations.text("Paint Plant Height")
		BrushOptions.Tool.JITTER:
			return Translations.text("Paint Plant Jitter")
	return Translations.text("Paint Plants")
