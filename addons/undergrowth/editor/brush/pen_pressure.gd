@tool
extends RefCounted
## How strongly a stroke is pressed. Pens tell all between 0 and 1; mice tell 0 or 1, and both mean
## all of the strength.

# Something told so since the last stroke began.
var _is_pen := false


## A stroke begins. Whether its first touch is to wait for the pen to move: a press does not tell
## how strong it is.
func begin() -> bool:
	var waits := _is_pen
	_is_pen = false
	return waits


## How strong the brush is when the pointer moves so, from 0 to 1. Tell it of moves between two
## strokes, too.
func read(motion: InputEventMouseMotion) -> float:
	var is_between := motion.pressure > 0.0 and motion.pressure < 1.0
	_is_pen = _is_pen or is_between or motion.tilt != Vector2.ZERO
	if motion.pressure > 0.0:
		return motion.pressure
	return 0.0 if _is_pen else 1.0
