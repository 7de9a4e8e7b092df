@tool
extends RefCounted
## The pressure of a stroke. Pens report values between 0 and 1. Mice report 0 or 1, and both mean
## full strength.

# True if an event reported a pen's pressure since the start of the last stroke.
var _is_pen := false


## Starts a stroke. Returns true if its first touch has to wait for a pen's move: a press has no
## pressure.
func begin() -> bool:
	var waits := _is_pen
	_is_pen = false
	return waits


## Returns the strength of the brush, from 0 to 1, for this pointer event. Call it for moves between
## two strokes too.
func read(motion: InputEventMouseMotion) -> float:
	var is_between := motion.pressure > 0.0 and motion.pressure < 1.0
	_is_pen = _is_pen or is_between or motion.tilt != Vector2.ZERO
	if motion.pressure > 0.0:
		return motion.pressure
	return 0.0 if _is_pen else 1.0
