@tool
extends RefCounted
## The options of the brush.

## Emitted when an option changed.
signal changed

enum Tool { NONE, PAINT, ERASE, HEIGHT, JITTER, PICK, TRAIL, PATH }

const MIN_RADIUS := 0.1
const MAX_RADIUS := 100.0
## In plants/m².
const MAX_DENSITY := 10000.0
const MAX_SCALE_JITTER := 0.9
## Factor of the radius for a press of [ or ].
const RADIUS_FACTOR := 1.2

var tool := Tool.NONE:
	set(value):
		tool = value
		changed.emit()
## In metres of the world.
var radius := 2.0:
	set(value):
		radius = clampf(value, MIN_RADIUS, MAX_RADIUS)
		changed.emit()
## Of drawn paths, in metres.
var width := 1.0:
	set(value):
		width = clampf(value, MIN_RADIUS, MAX_RADIUS)
		changed.emit()
## Effect of one touch, as a fraction of the full effect.
var strength := 0.5:
	set(value):
		strength = clampf(value, 0.0, 1.0)
		changed.emit()
## 0: the edge is hard.
var falloff := 0.5:
	set(value):
		falloff = clampf(value, 0.0, 1.0)
		changed.emit()
## True to paint the density of the field's mix instead of [member density].
var is_as_mixed := true:
	set(value):
		is_as_mixed = value
		changed.emit()
## Target density in plants/m² of all painted species together. A new value sets
## [member is_as_mixed] to false.
var density := 1.0:
	set(value):
		density = clampf(value, 0.0, MAX_DENSITY)
		is_as_mixed = false
## Target height, as a factor of the species' own height.
var height := 1.5:
	set(value):
		height = clampf(value, 0.1, 3.9)
		changed.emit()
## Target of the random scale of plants: 0.2 is ± 20 %.
var scale_jitter := 0.2:
	set(value):
		scale_jitter = clampf(value, 0.0, MAX_SCALE_JITTER)
		changed.emit()
## Target of the random color of plants, up to 1.
var color_jitter := 0.2:
	set(value):
		color_jitter = clampf(value, 0.0, 1.0)
		changed.emit()
## Painted map layers. Empty: all layers of the field.
var species: PackedStringArray = []:
	set(value):
		species = value
		changed.emit()


## Returns the tool in effect while these keys are held.
func tool_with(ctrl: bool) -> Tool:
	return Tool.ERASE if ctrl and tool == Tool.PAINT else tool


## True while the tool draws a path.
func draws_path() -> bool:
	return tool in [Tool.TRAIL, Tool.PATH]


## Returns the radius and the falloff of the circle at the pointer.
func get_circle() -> Vector2:
	return Vector2(width * 0.5, 0.0) if draws_path() else Vector2(radius, falloff)
