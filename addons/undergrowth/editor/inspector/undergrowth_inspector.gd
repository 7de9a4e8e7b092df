@tool
extends EditorInspectorPlugin
## Adds a moving plant, the outline of its stem, and the tree of its parts above a species'
## properties, and the force over time above a wind's. Above a field's are the kinds of area and a
## map of the species, above a climber's its growth. Shows ranges as one control, and numbers below
## 0 as what they mean.

const PlantPreview := preload("plant_preview.gd")
const WindInspectorView := preload("wind_inspector_view.gd")
const HeightSlider := preload("../widgets/height_slider.gd")
const RangeProperty := preload("range_property.gd")
const AreaBar := preload("area_bar.gd")
const SpeciesMap := preload("species_map.gd")
const ClimberBar := preload("../climber/climber_bar.gd")
const ClimberPathTool := preload("../climber/climber_path_tool.gd")
const WordedProperty := preload("worded_property.gd")
const PartsEditor := preload("../parts/parts_editor.gd")
const ProfilePlot := preload("../widgets/profile_plot.gd")
const Traits := preload("species_traits.gd")
const FirstDrawing := preload("first_drawing.gd")
const Translations := preload("../translations/translations.gd")
const PREVIEW := preload("plant_preview.tscn")
const WIND_VIEW := preload("wind_inspector_view.tscn")
const FIELD := "PlantField3D"
const CLIMBER := "PlantClimber3D"
const HEIGHT := "height"
const PARTS := "arrangements"
## Classes with ranges or words.
const CLASSES: Array[StringName] = [
	&"PlantFunction",
	&"PlantWind",
	&"Plant3D",
	&"PlantField3D",
	&"PlantClimber3D",
	&"PlantArrangement",
	&"PlantPart",
	&"PlantStem",
	&"PlantFieldSpecies",
]
## Properties with the smaller number first, and those with the first and the last part of a row.
const RANGES: Array[String] = ["count", "length", "scale_range"]
const SPANS: Array[String] = ["angle", "tilt", "scale", "diameter"]
## What stands for numbers below 0.
const WORDS: Dictionary[String, String] = {
	"taper": "as drawn",
	"head_mass": "as drawn",
	"head_drag_area": "as drawn",
	"leaf_mass": "as drawn",
	"leaf_drag_area": "as drawn",
	"drag_area": "by wind weight",
	"wind_weight": "automatic",
	"turbulence": "by roughness",
}

## Draws paths of climbers. The plugin sets it.
var climber_paths: ClimberPathTool


func _can_handle(object: Object) -> bool:
	return CLASSES.any(func(kind: StringName) -> bool: return object.is_class(kind))


func _parse_begin(object: Object) -> void:
	if object is PlantFunction:
		_add_species(object as PlantFunction)
	elif object is PlantWind:
		var wind_view: WindInspectorView = WIND_VIEW.instantiate()
		wind_view.wind = object
		add_custom_control(wind_view)
	var curves := object as CurvePlantFunction
	if curves and FirstDrawing.is_missing(curves):
		_offer_drawing(curves)


# Above the folded groups.
func _parse_category(object: Object, category: String) -> void:
	if object is PlantField3D and category == FIELD:
		var bar := AreaBar.new()
		bar.setup(object as PlantField3D)
		add_custom_control(bar)
		var map := SpeciesMap.new()
		map.setup(object as PlantField3D)
		add_custom_control(map)
	elif object is PlantClimber3D and category == CLIMBER:
		var climbing := ClimberBar.new()
		climbing.setup(object as PlantClimber3D, climber_paths)
		add_custom_control(climbing)


func _parse_property(
	object: Object,
	type: Variant.Type,
	name: String,
	_hint: PropertyHint,
	hint_string: String,
	_usage: int,
	_wide: bool
) -> bool:
	if object is Plant3D:
		if name == HEIGHT:
			_add_worded(name, HeightSlider.new())
		return name == HEIGHT
	if object is PlantFunction and name == PARTS:
		return _has_tree(object as PlantFunction)
	if type in [TYPE_VECTOR2, TYPE_VECTOR2I] and name in RANGES + SPANS:
		var pair := RangeProperty.new()
		pair.setup(type == TYPE_VECTOR2I, hint_string, "–" if name in RANGES else "→")
		add_property_editor(name, pair)
		return true
	if type == TYPE_FLOAT and WORDS.has(name):
		_add_worded(name, WordedProperty.make_slider(hint_string, Translations.text(WORDS[name])))
		return true
	return false


func _add_worded(name: String, slider: EditorSpinSlider) -> void:
	var worded := WordedProperty.new()
	worded.setup(slider)
	add_property_editor(name, worded)


func _add_species(function: PlantFunction) -> void:
	var preview: PlantPreview = PREVIEW.instantiate()
	preview.function = function
	add_custom_control(preview)
	if Traits.has_stem(function):
		var plot := ProfilePlot.new()
		plot.name = "Plot"
		plot.setup(function, EditorInterface.get_editor_undo_redo())
		add_custom_control(plot)
	if _has_tree(function):
		var parts := PartsEditor.new()
		parts.setup(function)
		add_custom_control(parts)


# A simple stem without parts keeps the plain list.
static func _has_tree(function: PlantFunction) -> bool:
	return function.get_class() == "PlantFunction" or not function.arrangements.is_empty()


# A new species of curves is a bare cone.
func _offer_drawing(curves: CurvePlantFunction) -> void:
	var button := Button.new()
	button.text = Translations.text("Begin with a Leaf")
	button.tooltip_text = Translations.text("Gives it a width curve and colours, to be changed.")
	button.pressed.connect(_draw_leaf.bind(curves))
	add_custom_control(button)


func _draw_leaf(curves: CurvePlantFunction) -> void:
	var undo := EditorInterface.get_editor_undo_redo()
	undo.create_action(Translations.text("Draw a Leaf"), UndoRedo.MERGE_DISABLE, curves)
	undo.add_do_property(curves, &"width_curve", FirstDrawing.make_curve())
	undo.add_do_property(curves, &"color_gradient", FirstDrawing.make_gradient())
	undo.add_undo_property(curves, &"width_curve", null)
	undo.add_undo_property(curves, &"color_gradient", null)
	for what: StringName in [&"add_do_method", &"add_undo_method"]:
		undo.call(what, curves, &"notify_property_list_changed")
	undo.commit_action()
