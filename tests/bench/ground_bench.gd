## Measures streaming over ground that the main thread reads, and prints a JSON list of rows.
##
## Run headless with --fixed-fps 60. A camera moves at 8 m/s over hills. The field has 12 plants per
## square metre and a view distance of 130 m. Frames last a sixtieth of a second, so that worker
## threads have the same time as in a game. median_ms and worst_ms are the main thread's time per
## frame for placement, heights included. holes_100 and holes_115 are the numbers of sampled
## positions without a plant nearby, at these distances (m) from the camera.
extends SceneTree

const VIEW_DISTANCE := 130.0  # m.
const DENSITY := 12.0
const SPEED := 8.0  # m/s.
const FRAMES := 900
const FRAMES_BETWEEN_POLLS := 30
const BEARINGS := 48
const NEARBY := 2.0  # m. A circle of this radius contains 150 plants.
const MAP_SIZE := 701  # m.
const FRAME_USEC := 16667
const SPACINGS: Array[float] = [0.5, 0.0]


## A terrain written in GDScript.
class Hills:
	extends Node3D

	func get_height(place: Vector3) -> float:
		return height_at(place.x, place.z)

	static func height_at(x: float, z: float) -> float:
		return 3.0 * sin(0.05 * x) * cos(0.04 * z) + 0.3 * sin(0.3 * x + 0.2 * z)


## The same, with queries of many positions.
class HillsInBatches:
	extends Hills

	func get_heights(places: PackedVector3Array) -> PackedFloat32Array:
		var heights := PackedFloat32Array()
		heights.resize(places.size())
		for i in places.size():
			heights[i] = height_at(places[i].x, places[i].z)
		return heights


var _rows: Array[Dictionary] = []
var _last_frame := 0  # µs, start of the frame.


func _initialize() -> void:
	_run()


func _run() -> void:
	for spacing: float in SPACINGS:
		await _measure("ground_colliders", _make_colliders(), spacing)
		await _measure("ground_object", Hills.new(), spacing)
		await _measure("ground_object_batch", HillsInBatches.new(), spacing)
	print(JSON.stringify(_rows))
	quit()


func _make_colliders() -> Node3D:
	var shape := HeightMapShape3D.new()
	shape.map_width = MAP_SIZE
	shape.map_depth = MAP_SIZE
	var heights := PackedFloat32Array()
	var half := MAP_SIZE / 2
	for z in range(-half, half + 1):
		for x in range(-half, half + 1):
			heights.append(Hills.height_at(x, z))
	shape.map_data = heights
	var body := StaticBody3D.new()
	var owner_shape := CollisionShape3D.new()
	owner_shape.shape = shape
	body.add_child(owner_shape)
	return body


func _measure(title: String, ground: Node3D, spacing: float) -> void:
	ground.name = "Ground"
	root.add_child(ground)
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position.x = -60.0
	var field := PlantField3D.from_species([GrassFunction.new()])
	field.density = DENSITY
	field.endless = true
	field.view_distance = VIEW_DISTANCE
	field.ground_sample_spacing = spacing
	field.simulation_enabled = false
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	if ground is Hills:
		field.ground_mode = PlantField3D.GROUND_OBJECT
		field.ground_object = NodePath("../Ground")
	await physics_frame
	await physics_frame
	root.add_child(field)
	await field.build_finished
	var usec: Array[float] = []
	var holes := {100.0: 0, 115.0: 0}
	for i in FRAMES:
		camera.position.x += SPEED / 60.0
		await _frame_over()
		usec.append(field.get_statistics()["build_usec"])
		if i % FRAMES_BETWEEN_POLLS == FRAMES_BETWEEN_POLLS - 1:
			for distance: float in holes:
				holes[distance] += _count_holes(field, camera.position, distance)
	var count := field.get_plant_count()
	usec.sort()
	var median := usec[usec.size() / 2]
	var row := {
		"name": "%s_%s" % [title, "exact" if spacing == 0.0 else "grid"],
		"plants": count,
		"threads": OS.get_processor_count(),
		"median_ms": median / 1000.0,
		"worst_ms": usec[-1] / 1000.0,
		"us_per_plant": median / count,
		"holes_100": holes[100.0],
		"holes_115": holes[115.0],
		"looked_at": BEARINGS * FRAMES / FRAMES_BETWEEN_POLLS,
		"renderer": "headless"
	}
	_rows.append(row)
	field.free()
	camera.free()
	ground.free()
	await process_frame


func _count_holes(field: PlantField3D, camera_position: Vector3, distance: float) -> int:
	var holes := 0
	for i in BEARINGS:
		var place := (
			camera_position + distance * Vector3.RIGHT.rotated(Vector3.UP, TAU * i / BEARINGS)
		)
		place.y = Hills.height_at(place.x, place.z)
		if not field.get_species_at(place, NEARBY):
			holes += 1
	return holes


## Extends a frame to a sixtieth of a second.
func _frame_over() -> void:
	await process_frame
	var left := FRAME_USEC - (Time.get_ticks_usec() - _last_frame)
	if left > 0:
		OS.delay_usec(left)
	_last_frame = Time.get_ticks_usec()
