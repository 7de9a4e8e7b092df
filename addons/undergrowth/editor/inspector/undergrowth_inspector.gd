@tool
extends EditorInspectorPlugin
## Puts a moving plant on top of a species' properties, and the force over time on top of a wind's.

const PlantInspectorView := preload("plant_inspector_view.gd")
const WindInspectorView := preload("wind_inspector_view.gd")
const PLANT_VIEW := preload("plant_inspector_view.tscn")
const WIND_VIEW := preload("wind_inspector_view.tscn")


func _can_handle(object: Object) -> bool:
	return object is PlantFunction or object is PlantWind


func _parse_begin(object: Object) -> void:
	if object is PlantFunction:
		var plant_view: PlantInspectorView = PLANT_VIEW.instantiate()
		plant_view.function = object
		add_custom_control(plant_view)
	else:
		var wind_view: WindInspectorView = WIND_VIEW.instantiate()
		wind_view.wind = object
		add_custom_control(wind_view)
