@tool
@icon("res://addons/undergrowth/icons/PlantRustle3D.svg")
class_name PlantRustle3D
extends AudioStreamPlayer3D
## The sound of a field: it rustles by the wind over the plants near the listener, and by bodies
## that move through them.
##
## Set [member field]. The node moves to the plants that are nearest to the current
## [AudioListener3D] or camera, or to the body that is louder, so that the distance to the plants is
## heard. Its level is 0 dB at [member full_speed], relative to [member level_db]. Without a
## [member AudioStreamPlayer3D.stream] it plays a rustle of its own.

## Seconds between two searches for the nearest plants.
const SEARCH_INTERVAL := 0.25
## Seconds in which the level follows a change.
const SMOOTHING := 0.12
## Below this level nothing is played.
const MIN_AMPLITUDE := 0.001
## The level in dB grows by 30 times the logarithm of the air's speed.
const EXPONENT := 1.5
const MIX_RATE := 22050
const NOISE_SAMPLES := 44100
const OVERLAP := 4410

static var _rustle: AudioStreamWAV

## The field that rustles. Its wind must be of [constant PlantWind.KIND_AIR].
@export var field: PlantField3D:
	set(value):
		_leave_field()
		field = value
		_follow_field()
		update_configuration_warnings()
## The level at [member full_speed] beside the plants.
@export_range(-60.0, 12.0, 0.1, "suffix:dB") var level_db := -6.0
## Speed of the air over the plants at which the sound has its full level.
@export_range(1.0, 30.0, 0.1, "or_greater", "suffix:m/s") var full_speed := 12.0
## Speed of a body in the plants at which the sound has its full level. Bodies are those of
## [member PlantField3D.bodies_group].
@export_range(0.5, 20.0, 0.1, "or_greater", "suffix:m/s") var full_body_speed := 4.0
## Plants within this distance of the listener are searched first. Beyond it the edge of the field
## that is nearest to the listener rustles.
@export_range(0.5, 20.0, 0.1, "suffix:m") var radius := 4.0

var _amplitude := 0.0
var _bodies: Dictionary[Node3D, Vector3] = {}
var _plants := Vector3.ZERO
var _has_plants := false
var _wait := 0.0
var _task := -1


func _get_configuration_warnings() -> PackedStringArray:
	if field == null:
		return ["Set field to the PlantField3D that rustles."]
	if field.wind == null or field.wind.kind != PlantWind.KIND_AIR:
		return [
			"Set the wind of the field to Air. Other winds have no speed, so only bodies rustle."
		]
	return []


func _ready() -> void:
	if Engine.is_editor_hint():
		return
	_follow_field()
	if stream == null and _rustle == null:
		_task = WorkerThreadPool.add_task(_prepare_rustle)


func _exit_tree() -> void:
	_finish_task()


func _process(delta: float) -> void:
	if Engine.is_editor_hint() or not is_instance_valid(field) or not field.is_inside_tree():
		return
	_wait -= delta
	if _wait <= 0.0:
		_wait = SEARCH_INTERVAL
		_search()
	var wanted := _wind_amplitude() if _has_plants else 0.0
	var place := _plants if _has_plants else global_position
	for body: Node3D in _bodies.keys():
		if not is_instance_valid(body) or not body.is_inside_tree():
			_bodies.erase(body)
			continue
		var speed: float = body.global_position.distance_to(_bodies[body]) / maxf(delta, 1e-4)
		_bodies[body] = body.global_position
		var amplitude := minf(speed / full_body_speed, 1.0)
		if amplitude > wanted:
			wanted = amplitude
			place = body.global_position
	global_position = place
	_amplitude = lerpf(_amplitude, wanted, 1.0 - exp(-delta / SMOOTHING))
	volume_db = level_db + linear_to_db(maxf(_amplitude, MIN_AMPLITUDE))
	if _amplitude < MIN_AMPLITUDE:
		stop()
	elif not playing:
		_start()


func _start() -> void:
	if _task >= 0 and WorkerThreadPool.is_task_completed(_task):
		_finish_task()
	if stream == null and _task < 0:
		stream = _rustle
	if stream != null:
		play(randf() * stream.get_length())


func _finish_task() -> void:
	if _task >= 0:
		WorkerThreadPool.wait_for_task_completion(_task)
		_task = -1


func _search() -> void:
	var listener: Node3D = get_viewport().get_audio_listener_3d()
	if listener == null:
		listener = get_viewport().get_camera_3d()
	_has_plants = listener != null
	if listener == null:
		return
	var place := listener.global_position
	var id := field.find_nearest_plant(place, radius)
	if id < 0 and not field.endless:
		var half := 0.5 * Vector3(field.size.x, 0.0, field.size.y)
		place = field.to_global(field.to_local(place).clamp(-half, half))
		id = field.find_nearest_plant(place, radius)
	_has_plants = id >= 0
	if _has_plants:
		_plants = field.get_plant_transform(id).origin


func _wind_amplitude() -> float:
	var wind := field.wind
	if wind == null or wind.kind != PlantWind.KIND_AIR:
		return 0.0
	var air := wind.sample_over_canopy(
		wind.get_time(), PackedVector2Array([Vector2(_plants.x, _plants.z)])
	)
	return minf(pow(air[0].length() / full_speed, EXPONENT), 1.0)


func _follow_field() -> void:
	if field == null or Engine.is_editor_hint() or not is_inside_tree():
		return
	if not field.body_entered_plants.is_connected(_on_body_entered):
		field.body_entered_plants.connect(_on_body_entered)
		field.body_exited_plants.connect(_on_body_exited)


func _leave_field() -> void:
	_bodies.clear()
	if is_instance_valid(field) and field.body_entered_plants.is_connected(_on_body_entered):
		field.body_entered_plants.disconnect(_on_body_entered)
		field.body_exited_plants.disconnect(_on_body_exited)


func _on_body_entered(body: Node3D) -> void:
	_bodies[body] = body.global_position


func _on_body_exited(body: Node3D) -> void:
	_bodies.erase(body)


static func _prepare_rustle() -> void:
	_rustle = _make_rustle()


## Two seconds without a seam: hiss of leaves, in grains of a few milliseconds.
static func _make_rustle() -> AudioStreamWAV:
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var noise := PackedFloat32Array()
	noise.resize(NOISE_SAMPLES + OVERLAP)
	var low := 0.0
	var grain := 0.0
	for i in noise.size():
		var white := random.randf_range(-1.0, 1.0)
		low += 0.25 * (white - low)
		if random.randf() < 0.004:
			grain = maxf(grain, random.randf())
		grain *= 0.997
		noise[i] = (white - low) * (0.25 + 0.75 * grain)
	var bytes := PackedByteArray()
	bytes.resize(2 * NOISE_SAMPLES)
	for i in NOISE_SAMPLES:
		var share := minf(float(i) / OVERLAP, 1.0)
		var value := noise[i] * sqrt(share)
		if share < 1.0:
			value += noise[NOISE_SAMPLES + i] * sqrt(1.0 - share)
		bytes.encode_s16(2 * i, int(clampf(value, -1.0, 1.0) * 32767.0))
	var made := AudioStreamWAV.new()
	made.format = AudioStreamWAV.FORMAT_16_BITS
	made.mix_rate = MIX_RATE
	made.loop_mode = AudioStreamWAV.LOOP_FORWARD
	made.loop_end = NOISE_SAMPLES
	made.data = bytes
	return made
