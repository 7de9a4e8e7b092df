## Alternatives to fields of plants: as many bodies of a physics engine, and a script's loop. Also
## the methods of measuring and printing. field_bench.gd extends this file.
extends SceneTree

const PEER_COUNTS: Array[int] = [1000, 10000]
const WARM_UP_FRAMES := 60
const BLOCKS := 21
const FRAMES_PER_BLOCK := 8

var _rows: Array[Dictionary] = []


func _measure_peers() -> void:
	for count: int in PEER_COUNTS:
		await _measure_jolt(count)
	for count: int in PEER_COUNTS:
		_measure_gdscript(count)


## A body for each plant's tip, with a pin joint at its root, simulated by Jolt.
func _measure_jolt(count: int) -> void:
	var space := PhysicsServer3D.space_create()
	var shape := PhysicsServer3D.sphere_shape_create()
	PhysicsServer3D.shape_set_data(shape, 0.05)
	var made: Array[RID] = [shape]
	var side := ceili(sqrt(count))
	for i in count:
		made.append_array(_add_jolt_plant(space, shape, Vector3(i % side, 0.0, i / side)))
	var idle := await _median_frame_usec(true)
	PhysicsServer3D.space_set_active(space, true)
	var usec := await _median_frame_usec(true) - idle
	made.reverse()  # Joints must be freed before their bodies.
	for rid in made:
		PhysicsServer3D.free_rid(rid)
	PhysicsServer3D.free_rid(space)
	_add_row("jolt", count, usec, {"threads": OS.get_processor_count()})
	await process_frame


func _add_jolt_plant(space: RID, shape: RID, root_place: Vector3) -> Array[RID]:
	var place := Transform3D(Basis.IDENTITY, root_place + Vector3.UP)
	var body := PhysicsServer3D.body_create()
	PhysicsServer3D.body_set_mode(body, PhysicsServer3D.BODY_MODE_RIGID)
	PhysicsServer3D.body_add_shape(body, shape)
	PhysicsServer3D.body_set_collision_mask(body, 0)
	PhysicsServer3D.body_set_collision_layer(body, 0)
	PhysicsServer3D.body_set_space(body, space)
	PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_TRANSFORM, place)
	PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_CAN_SLEEP, false)
	PhysicsServer3D.body_set_constant_force(body, Vector3(1.0, 20.0, 0.0))
	var joint := PhysicsServer3D.joint_create()
	PhysicsServer3D.joint_make_pin(joint, body, Vector3.DOWN, RID(), root_place)
	return [body, joint]


## The elasticity law in a script's loop over packed arrays.
func _measure_gdscript(count: int) -> void:
	var directions := PackedVector3Array()
	var rates := PackedVector3Array()
	directions.resize(count)
	directions.fill(Vector3.UP)
	rates.resize(count)
	var times: Array[float] = []
	for i in BLOCKS:
		var start := Time.get_ticks_usec()
		_step_in_script(directions, rates, Vector3(3.0, 0.0, 1.0))
		times.append(Time.get_ticks_usec() - start)
	_add_row("gdscript", count, _median(times), {"threads": 1})


func _step_in_script(
	directions: PackedVector3Array, rates: PackedVector3Array, wind: Vector3
) -> void:
	const STEP := 1.0 / 60.0
	for i in directions.size():
		var direction := directions[i]
		var pull := Vector3(wind.x, 9.81 * (5.0 * absf(direction.y) - 1.0), wind.z) - 0.3 * rates[i]
		var rate := rates[i] + (pull - pull.dot(direction) * direction) * STEP
		direction = (direction + rate * STEP).normalized()
		rates[i] = rate - rate.dot(direction) * direction
		directions[i] = direction


func _add_row(title: String, count: int, usec: float, more: Dictionary) -> void:
	var row := {
		"name": title,
		"plants": count,
		"median_ms": usec / 1000.0,
		"us_per_plant": usec / count,
	}
	row.merge(more)
	_rows.append(row)


## Of frames, or of physics frames, each of which is one step.
func _median_frame_usec(of_physics := false) -> float:
	var ticked := physics_frame if of_physics else process_frame
	for i: int in WARM_UP_FRAMES:
		await ticked
	var times: Array[float] = []
	for block: int in BLOCKS:
		var start := Time.get_ticks_usec()
		for i: int in FRAMES_PER_BLOCK:
			await ticked
		times.append(float(Time.get_ticks_usec() - start) / FRAMES_PER_BLOCK)
	return _median(times)


func _median(values: Array[float]) -> float:
	values.sort()
	return values[values.size() / 2]


## Returns the mean of the middle half, for values that vary between frames.
func _mean_without_outliers(values: Array[float]) -> float:
	values.sort()
	var middle := values.slice(values.size() / 4, values.size() - values.size() / 4)
	return (
		middle.reduce(func(sum: float, value: float) -> float: return sum + value) / middle.size()
	)
