## Run by a test with --fixed-fps. A walker moves through a field. Prints the mean path length of
## the tips near its way as `way METRES`. With the argument `physics` the walker moves in physics
## frames, without it in drawn ones. `ticks=N` sets the physics frames per second, and `contact`
## enables contact between tips.
extends SceneTree

const SPEED := 2.0  # m/s
const START := -4.0  # m
const SECONDS := 5.0
const SAMPLE := 1.0 / 30.0  # s
const REACH := 0.8  # m, maximum distance of counted tips.

var _field := PlantField3D.from_species([TulipFunction.new()])
var _walker := StaticBody3D.new()
var _tips := PackedVector3Array()
var _near: PackedInt64Array = []
var _elapsed := -1.0
var _walked := 0.0
var _samples := 0
var _way := 0.0


func _initialize() -> void:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("ticks="):
			Engine.physics_ticks_per_second = word.trim_prefix("ticks=").to_int()
	Engine.max_physics_steps_per_frame = 100
	_field.contact_enabled = "contact" in OS.get_cmdline_user_args()
	_field.size = Vector2(6, 6)
	_field.density = 12.0
	_field.bodies_group = &"walkers"
	root.add_child(_field)
	var shape := CollisionShape3D.new()
	shape.shape = CapsuleShape3D.new()
	_walker.add_child(shape)
	_walker.add_to_group(&"walkers")
	_walker.position = Vector3(START, 1.0, 0)
	root.add_child(_walker)
	_field.build_finished.connect(_begin)


func _physics_process(delta: float) -> bool:
	if "physics" in OS.get_cmdline_user_args():
		_walk(delta)
	return false


func _process(delta: float) -> bool:
	if _elapsed < 0.0:
		return false
	_elapsed += delta
	if not "physics" in OS.get_cmdline_user_args():
		_walk(delta)
	if _elapsed >= _samples * SAMPLE:
		_sample()
	if _elapsed >= SECONDS:
		print("way %f" % (_way / _near.size()))
	return _elapsed >= SECONDS


func _begin() -> void:
	for id in _field.get_plant_ids():
		if absf(_field.get_plant_transform(id).origin.z) < REACH:
			_near.append(id)
	_tips = _field.get_tip_positions(_near)
	_elapsed = 0.0


func _walk(delta: float) -> void:
	if _elapsed >= 0.0:
		_walked += delta
		_walker.position.x = START + SPEED * _walked


func _sample() -> void:
	_samples += 1
	var tips := _field.get_tip_positions(_near)
	for i in _near.size():
		_way += tips[i].distance_to(_tips[i])
	_tips = tips
