@tool
extends Control
## A picture of a wind. It follows what is changed on the wind, and lets go of it at its end.

## The wind that is drawn; of null nothing is.
var wind: PlantWind:
	set(value):
		if wind and wind.changed.is_connected(_on_wind_changed):
			wind.changed.disconnect(_on_wind_changed)
		wind = value
		if wind:
			wind.changed.connect(_on_wind_changed)
		_on_wind_taken()


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		wind = null


## Another wind is drawn from now on.
func _on_wind_taken() -> void:
	_on_wind_changed()


## Something of the wind was changed.
func _on_wind_changed() -> void:
	queue_redraw()


## Whether it is told in metres per second, not in newtons.
func _is_air() -> bool:
	return wind and wind.kind == PlantWind.KIND_AIR
