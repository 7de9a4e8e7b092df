@tool
extends RefCounted
## What the preview of one species shows. It survives the controls of the inspector, which makes new
## ones at each change of the list of properties.

## Emitted when the shown plant changed.
signal changed

const EditorState := preload("../editor_state.gd")
const OrbitCamera := preload("orbit_camera.gd")
## Maximum number of remembered species.
const MAX_KNOWN := 32

static var _known: Dictionary[int, RefCounted] = {}

## In metres. 0: the species' own.
var height := 0.0:
	set(value):
		height = value
		changed.emit()
var first_seed := EditorState.FIRST_SEED:
	set(value):
		first_seed = value
		changed.emit()
## Vertical segments.
var segments := EditorState.NEAR_SEGMENTS:
	set(value):
		segments = value
		changed.emit()
## States of the buttons, by their names.
var tools: Dictionary[StringName, bool] = {}
## Angles and zoom of the camera.
var turn := OrbitCamera.START_TURN
var tilt := OrbitCamera.START_TILT
var zoom := 1.0


## Returns the view of [param function].
static func of(function: PlantFunction) -> RefCounted:
	var id := function.get_instance_id()
	if _known.size() > MAX_KNOWN and not _known.has(id):
		_known.clear()
	if not _known.has(id):
		_known[id] = new()
	return _known[id]
