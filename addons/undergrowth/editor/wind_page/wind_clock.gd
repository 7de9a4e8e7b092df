@tool
extends RefCounted
## Lets the clocks of winds go on in the editor, where no simulation does it. Graphs and previews
## may show the same wind at the same time: its clock moves once a frame, whoever asks.

static var _frames: Dictionary[int, int] = {}


## Moves the clock of [param wind] on by [param delta] seconds, unless it was moved in this frame.
static func advance(wind: PlantWind, delta: float) -> void:
	var frame := Engine.get_process_frames()
	var id := wind.get_instance_id()
	if _frames.get(id, -1) == frame:
		return
	if _frames.size() > 64:
		_frames.clear()
	_frames[id] = frame
	wind.advance(delta)
