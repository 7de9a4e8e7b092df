## Base of the engine tests of fields: a field, and common operations on it.
extends "res://tests/engine/settling_harness.gd"

const STEP := 1.0 / 60.0

var field: PlantField3D


func after_each() -> void:
	if is_instance_valid(field):
		field.free()
	Engine.time_scale = 1.0
	paused = false


## Adds the field to the tree and waits until it is built.
func start() -> void:
	root.add_child(field)
	await built(field)
	await frames(1)


## Waits until [param building] is built, and leaves the processor to its workers.
func built(building: PlantField3D) -> void:
	var is_built := [false]
	building.build_finished.connect(func() -> void: is_built[0] = true, CONNECT_ONE_SHOT)
	while not is_built[0]:
		OS.delay_usec(500)
		await process_frame


## Waits until [param filling] is built and its tiles are joined. A signal's sender must not be
## freed while it emits.
func filled(filling: PlantField3D) -> void:
	await built(filling)
	while filling.is_inside_tree() and not is_settled(filling):
		await process_frame


## Starts a rebuild of the field and returns in a frame in which its worker is still busy. On a busy
## machine the worker may finish before the next frame.
func catch_filling() -> void:
	for attempt in 50:
		field.rebuild()
		await frames(1)
		if field.is_building():
			return
	check(false, "it is never seen to fill")


## Waits for at least [param count] more steps of the simulation, by the wind's clock.
func step(count: int) -> void:
	if field.wind == null:
		await frames(count * 3)
		return
	var end := field.wind.get_time() + (count - 0.5) * STEP
	while field.wind.get_time() < end:
		await process_frame


## Waits until all nodes have processed a frame: the present one, if they have not yet. Timers end
## after that.
func processed() -> void:
	await create_timer(0.0).timeout


## Adds the field, and beside it a twin that differs only in [param settings], in the same wind.
## Both are built and at rest, and move by [method step_both] only.
func start_with_twin(settings: Dictionary) -> PlantField3D:
	field.simulation_enabled = false
	var twin: PlantField3D = field.duplicate()
	twin.wind = field.wind
	twin.species = field.species
	for property: String in settings:
		twin.set(property, settings[property])
	root.add_child(field)
	root.add_child(twin)
	while field.is_building() or twin.is_building():
		await process_frame
	return twin


## Runs a step of the field and its twin. A preview never drops steps, which a slow frame may do.
func step_both(twin: PlantField3D) -> void:
	field.wind.advance(STEP)
	field._preview(STEP, field.wind)
	twin._preview(STEP, field.wind)


## Runs [param count] steps of both. Returns the maximum distance of a tip from its twin's (x), and
## from its initial position (y).
func max_apart(twin: PlantField3D, count: int) -> Vector2:
	var before := all_tips()
	var maximum := Vector2.ZERO
	for i in count:
		step_both(twin)
		var tips := all_tips()
		var others := all_tips(twin)
		for plant in tips.size():
			maximum.x = maxf(maximum.x, tips[plant].distance_to(others[plant]))
			maximum.y = maxf(maximum.y, tips[plant].distance_to(before[plant]))
	return maximum


## Returns all tips, in the axes of their field.
func all_tips(of := field) -> PackedVector3Array:
	return of.get_tip_positions(of.get_plant_ids())


## Returns the sorted ids of all plants, because a field with a new style lists them in another
## order.
func sorted_ids() -> PackedInt64Array:
	var ids := field.get_plant_ids()
	ids.sort()
	return ids


## Returns the vector from a plant's root to its tip.
func relative_tip(id: int) -> Vector3:
	return field.get_tip_position(id) - field.get_plant_transform(id).origin


## Returns the number of tips farther than [param distance] from their position in
## [method all_tips].
func count_moved(from: PackedVector3Array, distance: float) -> int:
	var now := all_tips()
	var count := 0
	for i in from.size():
		count += 1 if now[i].distance_to(from[i]) > distance else 0
	return count


## Waits until the field has applied or rejected the latest changes.
func rested() -> void:
	await settled(field)


## Returns a capsule in the group "walkers".
func add_walker() -> StaticBody3D:
	return add_body(CapsuleShape3D.new())


## Returns a plate as collider ground, with this width in metres and its top at that height.
func add_plate(side: float, top: float) -> StaticBody3D:
	var plate := StaticBody3D.new()
	add_shape(plate, box_shape(Vector3(side, 1.0, side)))
	plate.position.y = top - 0.5
	root.add_child(plate)
	return plate


func box_shape(size: Vector3) -> BoxShape3D:
	var box := BoxShape3D.new()
	box.size = size
	return box


## Adds a [Path3D] through [param points] below the field, saved with it. Returns its node path.
func add_path(title: String, points: Array[Vector3]) -> NodePath:
	var path := Path3D.new()
	path.name = title
	path.curve = Curve3D.new()
	for point in points:
		path.curve.add_point(point)
	field.add_child(path)
	path.owner = field
	return NodePath(title)


## Returns the positions of the plants of an entry of the field's species, by id.
func places_of(entry: int) -> Dictionary[int, Vector3]:
	var places: Dictionary[int, Vector3] = {}
	var species := field.species[entry].species
	for id in field.get_plant_ids():
		if field.get_plant_species(id) == species:
			places[id] = field.get_plant_transform(id).origin
	return places
