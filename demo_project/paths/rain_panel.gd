extends PanelContainer
## Lets it rain and snow on all plants with one wind.

const HEAVY := 20.0  # mm/h.
const COMING := 8.0  # s.

## The wind whose rain and snow change.
@export var wind: PlantWind

var _change: Tween


func _ready() -> void:
	(%Rain as Button).toggled.connect(_let_rain)
	(%Snow as Slider).value_changed.connect(_set_snow)


func _let_rain(on: bool) -> void:
	if _change:
		_change.kill()
	wind.rain = HEAVY if on else 0.0
	_change = create_tween()
	_change.tween_property(wind, ^"wetness", 1.0 if on else 0.0, COMING)


func _set_snow(share: float) -> void:
	wind.snow = share
