extends VBoxContainer
## What the plants cost: of some fields, or of all Plant3D nodes.

const SMOOTHING := 0.2
const PERIOD := 0.1  # s between two looks.

## The fields whose figures are shown. None: those of all Plant3D nodes.
var fields: Array[PlantField3D] = []
## Whether frames per second are shown.
var shows_frame_rate := true

var _step_time := -1.0  # µs.
var _main_time := -1.0  # µs.
var _wait := 0.0  # s.


func _process(delta: float) -> void:
	_wait -= delta
	if _wait > 0.0:
		return
	_wait = PERIOD
	(%FrameRate as Label).text = "%d fps" % Engine.get_frames_per_second()
	(%FrameRateRow as Control).visible = shows_frame_rate
	for row: Control in [%DrawnRow, %MainTimeRow, %MemoryRow]:
		row.visible = not fields.is_empty()
	if get_tree().paused:
		return  # Plants that pause are not stepped: the last figures stay.
	if fields:
		_show_fields()
	else:
		_show_nodes()


static func as_time(microseconds: float) -> String:
	if microseconds < 1000.0:
		return "%d µs" % roundi(microseconds)
	return "%.2f ms" % (microseconds / 1000.0)


## 51234 as "51 234".
static func as_count(count: int) -> String:
	return "%d %03d" % [count / 1000, count % 1000] if count >= 10000 else "%d" % count


func _show_nodes() -> void:
	var simulation := Engine.get_singleton(&"PlantSimulation")
	_step_time = _smooth(_step_time, simulation.call(&"get_step_time_usec"))
	(%Plants as Label).text = as_count(simulation.call(&"get_plant_count"))
	(%StepTime as Label).text = as_time(_step_time)


func _show_fields() -> void:
	var plants := 0
	var step_time := 0.0
	var main_time := 0.0
	var bytes := 0.0
	var drawn: Array[int] = []
	for field in fields:
		var statistics := field.get_statistics()
		plants += statistics["plants"]
		step_time += statistics["step_usec"]
		main_time += statistics["main_usec"]
		bytes += statistics["bytes_per_plant"] * statistics["plants"]
		_add(statistics["drawn_by_level"], drawn)
	_step_time = _smooth(_step_time, step_time)
	_main_time = _smooth(_main_time, main_time)
	(%Plants as Label).text = as_count(plants)
	(%Drawn as Label).text = " · ".join(drawn.map(_in_thousands))
	(%StepTime as Label).text = as_time(_step_time)
	(%MainTime as Label).text = as_time(_main_time)
	(%Memory as Label).text = "%d B a plant" % roundi(bytes / maxi(plants, 1))


func _add(by_level: PackedInt32Array, drawn: Array[int]) -> void:
	for level in by_level.size():
		if level == drawn.size():
			drawn.append(0)
		drawn[level] += by_level[level]


func _in_thousands(count: int) -> String:
	return "%dk" % roundi(count / 1000.0)


func _smooth(before: float, now: float) -> float:
	return now if before < 0.0 else lerpf(before, now, SMOOTHING)
