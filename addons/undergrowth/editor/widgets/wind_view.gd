@tool
extends Control
## Base class of pictures of a wind. It follows changes of the wind and disconnects at its end.

## The drawn wind. Null: none.
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


## Called when another wind is drawn.
func _on_wind_taken() -> void:
	_on_wind_changed()


## Called when properties of the wind changed.
func _on_wind_changed() -> void:
	queue_redraw()


## True if the unit is metres per second, false if it is newtons.
func _is_air() -> bool:
	return wind and wind.kind == PlantWind.KIND_AIR
