@tool
extends EditorInspectorPlugin
## Adds a moving plant above a species' properties, and the force over time above a wind's. Explains
## a plant's height of 0.

const PlantInspectorView := preload("plant_inspector_view.gd")
const WindInspectorView := preload("wind_inspector_view.gd")
const HeightProperty := preload("height_property.gd")
const FirstDrawing := preload("../plant_page/first_drawing.gd")
const Translations := preload("../translations/translations.gd")
const PLANT_VIEW := preload("plant_inspector_view.tscn")
const WIND_VIEW := preload("wind_inspector_view.tscn")
const HEIGHT := "height"


func _can_handle(object: Object) -> bool:
	return object is PlantFunction or object is PlantWind or object is Plant3D


func _parse_begin(object: Object) -> void:
	if object is PlantFunction:
		var plant_view: PlantInspectorView = PLANT_VIEW.instantiate()
		plant_view.function = object
		add_custom_control(plant_view)
	elif object is PlantWind:
		var wind_view: WindInspectorView = WIND_VIEW.instantiate()
		wind_view.wind = object
		add_custom_control(wind_view)
	var curves := object as CurvePlantFunction
	if curves and FirstDrawing.is_missing(curves):
		_offer_drawing(curves)


func _parse_property(
	object: Object,
	_type: Variant.Type,
	name: String,
	_hint: PropertyHint,
	_hint_string: String,
	_usage: int,
	_wide: bool
) -> bool:
	if object is not Plant3D or name != HEIGHT:
		return false
	add_property_editor(name, HeightProperty.new())
	return true


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
