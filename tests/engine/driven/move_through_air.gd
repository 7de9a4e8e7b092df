## Run by a test with --fixed-fps. A wake passes a field, and a plant and a field move through still
## air. Prints the mean distance of tips from their rest over time as `bends METRES METRES METRES`:
## of the field in the wake, of the moving plant, and of the moving field. With the argument
## `physics` nodes move in physics frames, without it in drawn ones.
extends SceneTree

const WAKE_SPEED := 8.0  # m/s
const WAKE_START := -12.0  # m
const CARRY_SPEED := 5.0  # m/s
const FAR := Vector3(0, 0, 2000)  # m, out of reach of the wake.
const SECONDS := 5.0
const HEIGHT := 0.8  # m

var _field := PlantField3D.new()
var _wake := PlantWindSource3D.new()
var _plant := Plant3D.new()
var _ship := PlantField3D.new()
var _rests := PackedVector3Array()
var _ids := PackedInt64Array()
var _ship_id := -1
var _is_filled := false
var _elapsed := -1.0
var _moved := 0.0
var _bends := Vector3.ZERO


func _initialize() -> void:
	Engine.max_physics_steps_per_frame = 100
	_field.density = 0.0
	_field.far_distance = 0.0
	root.add_child(_field)
	_wake.kind = PlantWindSource3D.KIND_WAKE
	_wake.radius = 1.0
	_wake.position = Vector3(WAKE_START, 0.5, 0)
	root.add_child(_wake)
	_plant.species = _species()
	_plant.height = HEIGHT
	_plant.position = FAR
	root.add_child(_plant)
	_ship.density = 0.0
	_ship.position = FAR * 2.0
	root.add_child(_ship)
	_ship.build_finished.connect(func() -> void: _is_filled = true)


func _species() -> PlantFunction:
	var species := GrassFunction.new()
	species.law = PlantFunction.LAW_SPRING
	species.lean = 0.0
	species.mass = 0.01
	species.wind_weight = 0.02
	species.natural_frequency = 1.5
	species.damping_ratio = 0.4
	return species


func _physics_process(delta: float) -> bool:
	if "physics" in OS.get_cmdline_user_args():
		_move(delta)
	return false


func _process(delta: float) -> bool:
	if _elapsed < 0.0:
		if _is_filled and not _field.is_building():
			_begin()
		return false
	_elapsed += delta
	if not "physics" in OS.get_cmdline_user_args():
		_move(delta)
	_sum(delta)
	if _elapsed >= SECONDS:
		print("bends %f %f %f" % [_bends.x / SECONDS, _bends.y / SECONDS, _bends.z / SECONDS])
	return _elapsed >= SECONDS


func _begin() -> void:
	var places: Array[Transform3D] = []
	for x in 5:
		for z in 4:
			places.append(Transform3D(Basis.IDENTITY, Vector3(x - 2.0, 0, z * 0.7 + 0.5)))
	_ids = _field.add_plants(places, _species())
	_rests = _field.get_tip_positions(_ids)
	_ship_id = _ship.add_plants([Transform3D.IDENTITY], _species())[0]
	_elapsed = 0.0


func _move(delta: float) -> void:
	if _elapsed >= 0.0:
		_moved += delta
		_wake.position.x = WAKE_START + WAKE_SPEED * _moved
		_plant.position.x = CARRY_SPEED * _moved
		_ship.position.x = CARRY_SPEED * _moved


func _sum(delta: float) -> void:
	var tips := _field.get_tip_positions(_ids)
	for i in _ids.size():
		_bends.x += tips[i].distance_to(_rests[i]) * delta / _ids.size()
	var tip := _plant.get_tip_position()
	_bends.y += Vector2(tip.x, tip.z).length() * delta
	var of_ship := _ship.get_tip_position(_ship_id)
	_bends.z += Vector2(of_ship.x, of_ship.z).length() * delta
