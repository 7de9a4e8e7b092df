## Run by a test with --fixed-fps: a field and a plant in a wind. Prints for each step `step NUMBER
## HASH DIFFERENCE`: the motion time in steps, a hash of all motion states, and the difference (s)
## between the wind's clock and the motion time. With the argument `air` the wind is air, with
## `blend` air that changes, without them waves of newtons.
extends SceneTree

const FIRST := 200
const LAST := 320

var _field := PlantField3D.from_species([TulipFunction.new()])
var _plant := Plant3D.new()
var _ids := PackedInt64Array()
var _reported := -1


func _initialize() -> void:
	_field.size = Vector2(5, 5)
	_field.density = 12.0
	_field.far_distance = 0.0
	_field.wind = PlantWind.new()
	if "air" in OS.get_cmdline_user_args() or "blend" in OS.get_cmdline_user_args():
		_field.wind.kind = PlantWind.KIND_AIR
		_field.wind.speed = 6.0
	root.add_child(_field)
	_plant.species = TulipFunction.new()
	_plant.wind = _field.wind
	_field.build_finished.connect(_begin)


# Both move from the next frame on.
func _begin() -> void:
	_ids = _field.get_plant_ids()
	root.add_child(_plant)
	if "blend" in OS.get_cmdline_user_args():
		var gale := _field.wind.duplicate() as PlantWind
		gale.speed = 18.0
		gale.direction = 1.0
		_field.wind.blend_to(gale, 6.0)


func _process(_delta: float) -> bool:
	if _ids.is_empty():
		return false
	var time := _field.get_motion_time()
	var step := roundi(time / PlantSimulation.step_length)
	if step >= FIRST and step != _reported:
		_reported = step
		var states := [_field.get_motion_state(_ids), _plant.get_motion_state()]
		print("step %d %d %f" % [step, hash(states), absf(_field.wind.get_time() - time)])
	return step >= LAST
