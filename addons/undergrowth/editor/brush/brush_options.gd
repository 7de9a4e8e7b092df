@tool
extends RefCounted
## What the brush is set to.

## Something below changed.
signal changed

enum Tool { NONE, PAINT, ERASE, HEIGHT, PICK }

const LEAST_RADIUS := 0.1
const MOST_RADIUS := 100.0
## In plants/m².
const MAX_DENSITY := 10000.0
## What a press of [ or ] does to the radius.
const RADIUS_FACTOR := 1.2

var tool := Tool.NONE:
	set(value):
		tool = value
		changed.emit()
## In metres of the world.
var radius := 2.0:
	set(value):
		radius = clampf(value, LEAST_RADIUS, MOST_RADIUS)
		changed.emit()
## How much of the way one touch goes.
var strength := 0.5:
	set(value):
		strength = clampf(value, 0.0, 1.0)
		changed.emit()
## 0: the edge is hard.
var falloff := 0.5:
	set(value):
		falloff = clampf(value, 0.0, 1.0)
		changed.emit()
## Painting goes to the density that the field's mix gives the species, and not to [member density].
var is_as_mixed := true:
	set(value):
		is_as_mixed = value
		changed.emit()
## The density to which painting goes, in plants/m² of all painted species together. Setting it sets
## [member is_as_mixed] to false.
var density := 1.0:
	set(value):
		density = clampf(value, 0.0, MAX_DENSITY)
		is_as_mixed = false
## What the height goes to, times the usual one.
var height := 1.5:
	set(value):
		height = clampf(value, 0.1, 3.9)
		changed.emit()
## Names of layers that are painted; none: all of the field.
var species: PackedStringArray = []:
	set(value):
		species = value
		changed.emit()


## The tool that counts while these keys are held.
func tool_with(ctrl: bool) -> Tool:
	return Tool.ERASE if ctrl and tool == Tool.PAINT else tool
