## Run by a test with --fixed-fps. A walker moves through plants of a field, and another through
## single plants at the same positions beside it. Prints the movement of their tips as `ways METRES
## METRES METRES`: the mean path lengths of both, and the maximum distance between corresponding
## tips. With the argument `physics` walkers move in physics frames, without it in drawn ones.
extends SceneTree

const SPEED := 2.0  # m/s
const START := -4.0  # m
const SECONDS := 5.0
const SAMPLE := 1.0 / 30.0  # s
const ASIDE := Vector3(0, 0, 20)  # m, offset of the single plants.

var _field := PlantField3D.new()
var _ids: PackedInt64Array = []
var _plants: Array[Plant3D] = []
var _walkers: Array[StaticBody3D] = []
var _tips: Array[Vector3] = []
var _is_filled := false
var _elapsed := -1.0
var _walked := 0.0
var _samples := 0
var _ways := [0.0, 0.0]
var _max_distance := 0.0


func _initialize() -> void:
	_field.density = 0.0
	_field.bodies_group = &"walkers"
	root.add_child(_field)
	for i in 2:
		var walker := StaticBody3D.new()
		var shape := CollisionShape3D.new()
		shape.shape = CapsuleShape3D.new()
		walker.add_child(shape)
		walker.add_to_group(&"walkers")
		walker.position = Vector3(START, 1.0, 0) + i * ASIDE
		root.add_child(walker)
		_walkers.append(walker)
	_field.build_finished.connect(func() -> void: _is_filled = true)


func _physics_process(delta: float) -> bool:
	if "physics" in OS.get_cmdline_user_args():
		_walk(delta)
	return false


func _process(delta: float) -> bool:
	if _elapsed < 0.0:
		# Set here for any end of the build, so that both start to step with the same frame.
		if _is_filled:
			_begin()
		return false
	_elapsed += delta
	if not "physics" in OS.get_cmdline_user_args():
		_walk(delta)
	if _elapsed >= _samples * SAMPLE:
		_sample()
	if _elapsed >= SECONDS:
		print("ways %f %f %f" % [_ways[0] / _ids.size(), _ways[1] / _ids.size(), _max_distance])
	return _elapsed >= SECONDS


func _begin() -> void:
	var tulip := TulipFunction.new()
	var places: Array[Transform3D] = []
	for i in 40:
		places.append(Transform3D(Basis(), Vector3(0.1 * i - 2.0, 0, 0.8 * sin(1.7 * i))))
	_ids = _field.add_plants(places, tulip)
	for id in _ids:
		var plant := Plant3D.new()
		plant.species = tulip
		plant.height = _field.get_plant_height(id)
		plant.transform = _field.get_plant_transform(id).translated(ASIDE)
		plant.bodies_group = &"walkers"
		root.add_child(plant)
		_plants.append(plant)
	_tips = _all_tips()
	_elapsed = 0.0


func _walk(delta: float) -> void:
	if _elapsed >= 0.0:
		_walked += delta
		for walker in _walkers:
			walker.position.x = START + SPEED * _walked


func _all_tips() -> Array[Vector3]:
	var tips: Array[Vector3] = []
	tips.assign(_field.get_tip_positions(_ids))
	for plant in _plants:
		tips.append(plant.to_global(plant.get_tip_position()))
	return tips


func _sample() -> void:
	_samples += 1
	var tips := _all_tips()
	for i in _ids.size():
		_max_distance = maxf(_max_distance, (tips[i] + ASIDE).distance_to(tips[_ids.size() + i]))
	for i in tips.size():
		_ways[i / _ids.size()] += tips[i].distance_to(_tips[i])
	_tips = tips
