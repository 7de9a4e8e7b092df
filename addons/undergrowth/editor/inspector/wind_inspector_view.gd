@tool
extends VBoxContainer
## The force of a wind over the next seconds, with a button for a gust. For air, its speed, its
## Beaufort number and description, and a folded analysis: a map and the spectrum.

const Beaufort := preload("../wind/beaufort.gd")
const ForceGraph := preload("../widgets/force_graph.gd")
const WindMap := preload("../widgets/wind_map.gd")
const WindSpectrum := preload("../widgets/wind_spectrum.gd")
const Translations := preload("../translations/translations.gd")
const WindClock := preload("../wind/wind_clock.gd")

## Share of the names in a line's width.
const NAME_SHARE := 0.62

## The shown wind. Set it before the view enters the tree.
var wind: PlantWind

@onready var _beaufort: Label = %Beaufort
@onready var _graph: ForceGraph = %Graph
@onready var _analysis: FoldableContainer = %Analysis
@onready var _map: WindMap = %Map
@onready var _spectrum: WindSpectrum = %Spectrum
@onready var _gust: Button = %Gust


func _ready() -> void:
	set_translation_domain(Translations.DOMAIN)
	_graph.wind = wind
	_map.wind = wind
	_spectrum.wind = wind
	_gust.pressed.connect(_on_gust_pressed)
	_widen_names.call_deferred()
	if wind:
		wind.changed.connect(_show_beaufort)
		_show_beaufort()


func _process(delta: float) -> void:
	if wind and is_visible_in_tree():
		WindClock.advance(wind, delta)


func _show_beaufort() -> void:
	_analysis.visible = wind.kind == PlantWind.KIND_AIR
	_beaufort.visible = wind.kind == PlantWind.KIND_AIR
	_beaufort.text = "Beaufort " + Beaufort.describe(wind)


# Names such as Canopy Wave Amount are longer than values.
func _widen_names() -> void:
	var above := get_parent()
	while above and above is not EditorInspector:
		above = above.get_parent()
	for found in above.find_children("*", "EditorProperty", true, false) if above else []:
		var property := found as EditorProperty
		if property.get_edited_object() == wind:
			property.name_split_ratio = NAME_SHARE


func _on_gust_pressed() -> void:
	wind.trigger_gust()
