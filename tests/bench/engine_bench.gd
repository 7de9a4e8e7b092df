## Measures plants in the engine against alternatives and prints a JSON list of rows.
##
## Run with --fixed-fps 60, so that each frame is one step, headless or with a renderer. With a
## renderer the rows contain its name, and only plants of four joints are measured. All variants
## show the same skinned mesh on a skeleton of two bones. The time of the same frames without motion
## is subtracted. bone_pose_only is the cost of the engine's own call: the script's loop around it
## is subtracted. plant3d_held has plants with a referenced skeleton. Plants without one report
## motion to the renderer only, and headless to none. stem_4_held has such plants with stems of four
## joints. spring_bone_4 has the engine's simulator on as many bones. Both are in the scene and move
## by turns.
extends SceneTree

const COUNTS: Array[int] = [100, 1000, 3000, 10000]
const WARM_UP_FRAMES := 30
const BLOCKS := 21
const FRAMES_PER_BLOCK := 12
const FRAMES_TO_BEGIN := 4  # Until the motion has fully started.
const MANY := 3000  # Number of plants from which a block is one frame.
const MAX_JOINTED := 1000

var _rows: Array[Dictionary] = []
var _moving: Array[Skeleton3D] = []
var _looping: Array[Skeleton3D] = []
var _frame := 0
var _renderer := "headless"


func _initialize() -> void:
	_run()


func _run() -> void:
	if DisplayServer.get_name() != "headless":
		_renderer = RenderingServer.get_current_rendering_method()
	for count: int in COUNTS:
		if _renderer == "headless":
			await _measure("plant3d", count, _add_plants)
			await _measure("plant3d_held", count, _add_held_plants)
			await _measure("spring_bone_2", count, _add_spring_bones)
			await _measure("bone_pose_only", count, _add_posed)
		if count <= MAX_JOINTED:
			await _measure_joints(count)
	print(JSON.stringify(_rows))
	quit()


## A stem of four joints.
func _jointed() -> PlantFunction:
	var species := TulipFunction.new()
	species.law = PlantFunction.LAW_STEM
	species.wind_weight = -1.0
	return species


func _measure(title: String, count: int, fill: Callable) -> void:
	var scene := Node3D.new()
	root.add_child(scene)
	var still := _make_plants(scene, count, TulipFunction.new())
	if title == "bone_pose_only":
		for plant: Plant3D in still:
			_looping.append(plant.get_skeleton())
	var frames := 1 if count >= MANY else FRAMES_PER_BLOCK
	var idle := await _median_frame_usec(frames)
	fill.call(still)
	var busy := await _median_frame_usec(frames)
	_moving.clear()
	_looping.clear()
	scene.queue_free()
	await process_frame
	_add_row(title, count, busy - idle)


## Measures stems of four joints and spring bones on as many, in one scene and by turns, so that
## other load on the machine affects both.
func _measure_joints(count: int) -> void:
	var scene := Node3D.new()
	root.add_child(scene)
	var species := _jointed()
	var stems := _make_plants(scene, count, species)
	_add_held_plants(stems)
	var springs := _add_spring_bones(_make_plants(scene, count, species))
	var by_stems: Array[float] = []
	var by_springs: Array[float] = []
	for block: int in BLOCKS:
		_move(stems, "simulation_enabled", false)
		_move(springs, "active", false)
		var idle := await _frame_usec()
		_move(stems, "simulation_enabled", true)
		by_stems.append(await _frame_usec() - idle)
		_move(stems, "simulation_enabled", false)
		_move(springs, "active", true)
		by_springs.append(await _frame_usec() - idle)
	_add_row("stem_4_held", count, _median(by_stems))
	_add_row("spring_bone_4", count, _median(by_springs))
	scene.queue_free()
	await process_frame


func _move(those: Array, property: String, on: bool) -> void:
	for one: Node in those:
		one.set(property, on)


func _frame_usec() -> float:
	for i: int in FRAMES_TO_BEGIN:
		await process_frame
	var start := Time.get_ticks_usec()
	for i: int in FRAMES_PER_BLOCK:
		await process_frame
	return float(Time.get_ticks_usec() - start) / FRAMES_PER_BLOCK


func _add_row(title: String, count: int, usec: float) -> void:
	(
		_rows
		. append(
			{
				"name": title,
				"plants": count,
				"threads": 1,
				"median_ms": usec / 1000.0,
				"us_per_plant": usec / count,
				"renderer": _renderer,
			}
		)
	)


func _make_plants(scene: Node3D, count: int, species: PlantFunction) -> Array[Plant3D]:
	var plants: Array[Plant3D] = []
	for i: int in count:
		var plant := Plant3D.new()
		plant.species = species
		plant.segments = 8
		plant.seed = i
		plant.simulation_enabled = false
		scene.add_child(plant)
		plants.append(plant)
	return plants


func _add_plants(plants: Array[Plant3D]) -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_WAVES
	wind.strength = 10.0
	wind.frequency = 0.5
	for plant: Plant3D in plants:
		plant.wind = wind
		plant.simulation_enabled = true


func _add_held_plants(plants: Array[Plant3D]) -> void:
	_add_plants(plants)
	for plant: Plant3D in plants:
		plant.get_skeleton()


func _add_spring_bones(plants: Array[Plant3D]) -> Array[SpringBoneSimulator3D]:
	var made: Array[SpringBoneSimulator3D] = []
	for plant: Plant3D in plants:
		var skeleton := plant.get_skeleton()
		var first := skeleton.find_bone("stem_1")
		if first < 0:
			skeleton.set_bone_rest(1, Transform3D(Basis.IDENTITY, Vector3.UP))
			skeleton.reset_bone_poses()
		var simulator := SpringBoneSimulator3D.new()
		skeleton.add_child(simulator)
		simulator.setting_count = 1
		simulator.set_root_bone(0, maxi(first, 0))
		simulator.set_end_bone(0, 1)
		simulator.set_gravity(0, 1.0)
		simulator.set_gravity_direction(0, Vector3.RIGHT)
		made.append(simulator)
	return made


func _add_posed(_plants: Array[Plant3D]) -> void:
	_moving = _looping
	_looping = []


func _process(_delta: float) -> bool:
	_frame += 1
	var turn := Quaternion(Vector3.RIGHT, 0.3 * sin(0.1 * _frame))
	for skeleton: Skeleton3D in _moving:
		skeleton.set_bone_pose_rotation(1, turn)
	for skeleton: Skeleton3D in _looping:
		skeleton.get_bone_parent(1)
	return false


func _median_frame_usec(frames: int) -> float:
	for i: int in WARM_UP_FRAMES:
		await process_frame
	var times: Array[float] = []
	for block: int in BLOCKS:
		var start := Time.get_ticks_usec()
		for i: int in frames:
			await process_frame
		times.append(float(Time.get_ticks_usec() - start) / frames)
	return _median(times)


func _median(values: Array[float]) -> float:
	values.sort()
	return values[values.size() / 2]
