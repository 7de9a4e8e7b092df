@tool
extends RefCounted
## Advances the clocks of winds in the editor, where no simulation does it. Graphs and previews can
## show the same wind at the same time. Its clock advances once per frame for any number of callers.

static var _frames: Dictionary[int, int] = {}


## Advances the clock of [param wind] by [param delta] seconds, once per frame.
static func advance(wind: PlantWind, delta: float) -> void:
	var frame := Engine.get_process_frames()
	var id := wind.get_instance_id()
	if _frames.get(id, -1) == frame:
		return
	if _frames.size() > 64:
		_frames.clear()
	_frames[id] = frame
	wind.advance(delta)
