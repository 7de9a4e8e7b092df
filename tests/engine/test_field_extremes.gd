## Fields with extreme sizes and unusual values.
extends "res://tests/engine/settling_harness.gd"

const QUARTER := 900.0
## Allowed growth of the engine's lists while nothing happens.
const MAX_GROWTH_BYTES := 300_000.0

var _field: PlantField3D


func before_each() -> void:
	_field = PlantField3D.from_species([TulipFunction.new()])
	_field.density = 4.0
	_field.wind = PlantWind.new()
	_field.wind.kind = PlantWind.KIND_WAVES
	_field.wind.strength = 3.0


func after_each() -> void:
	Engine.time_scale = 1.0
	if is_instance_valid(_field):
		_field.free()


func test_a_million_plants() -> void:
	_field.size = Vector2(500, 500)
	_field.species[0].variants = 2
	_field.levels = [PlantFieldLevel.of(2)]
	await _fill()
	check_near(_field.get_plant_count(), 1_000_000, 5000.0)
	await frames(4)
	var reported := _field.get_statistics()
	check_equal(reported["simulated"], _field.get_plant_count())
	check(
		reported["bytes_per_plant"] <= 96.0,
		"at most 96 bytes a plant: %s" % reported["bytes_per_plant"]
	)
	var last := _field.get_plant_ids()[-1]
	check(_field.get_tip_position(last).is_finite(), "the last tip is finite")
	check(_field.remove_in_sphere(Vector3.ZERO, 5.0) > 200, "plants in the middle are removed")
	await frames(2)


func test_more_plants_than_there_may_be_are_refused() -> void:
	_field.size = Vector2(5, 5)
	await _fill()
	var count := _field.get_plant_count()
	_field.size = Vector2(50000, 50000)
	await settled(_field)
	check_error("plants")
	check_equal(_field.get_plant_count(), count)


func test_more_histories_than_a_graphics_card_can_draw_are_refused() -> void:
	_field.size = Vector2(6, 6)
	await _fill()
	var ids := _field.get_plant_ids()
	var many: Array[PlantFieldSpecies] = []
	for i in 130:  # 17 layers each.
		many.append(PlantFieldSpecies.of(GrassFunction.new()))
		many[i].variants = 1
	_field.species = many
	_field.prototypes = 1
	while _field.is_building():
		await process_frame
	check_error("texture layers")
	check_equal(_field.get_plant_ids(), ids, "the plants of before")


func test_a_quarter_of_an_hour_of_wind_leads_to_no_drift_and_takes_no_memory() -> void:
	_field.size = Vector2(4, 4)
	await _fill()
	await frames(100)
	var before := Performance.get_monitor(Performance.MEMORY_STATIC)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var end := _field.wind.get_time() + QUARTER
	Engine.time_scale = 1000.0
	while _field.wind.get_time() < end:
		await process_frame
	Engine.time_scale = 1.0
	await frames(100)
	check(
		Performance.get_monitor(Performance.MEMORY_STATIC) - before < MAX_GROWTH_BYTES,
		"memory grew by %d" % (Performance.get_monitor(Performance.MEMORY_STATIC) - before)
	)
	check_equal(Performance.get_monitor(Performance.OBJECT_COUNT), objects, "objects")
	_field.wind = null
	var deadline := Time.get_ticks_msec() + 60000
	while _farthest_from_rest() > 0.01 and Time.get_ticks_msec() < deadline:
		Engine.time_scale = 20.0
		await frames(20)
	check(_farthest_from_rest() <= 0.01, "in calm air all come to rest")
	for id in _field.get_plant_ids():
		var place := _field.get_plant_transform(id)
		var length := _field.get_plant_height(id)
		check_near(_field.get_tip_position(id).distance_to(place.origin), length, 1e-3, "length")


func test_a_field_that_is_scaled_to_nothing_or_nowhere_recovers() -> void:
	_field.size = Vector2(6, 6)
	_field.bodies_group = &"walkers"
	_field.skeleton_distance = 20.0
	_field.far_distance = 1.0
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.position = Vector3(0, 1, 0)
	var walker := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = CapsuleShape3D.new()
	walker.add_child(shape)
	walker.add_to_group(&"walkers")
	root.add_child(walker)
	await _fill()
	for odd: Transform3D in [
		Transform3D(Basis.from_scale(Vector3.ZERO), Vector3.ZERO),
		Transform3D(Basis.from_scale(Vector3(1, 0, 1)), Vector3.ZERO),
		Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0)),
		Transform3D(Basis(Vector3(INF, 0, 0), Vector3.UP, Vector3.BACK), Vector3.ZERO),
		Transform3D(Basis.from_scale(Vector3(-1, 1, 1)), Vector3.ZERO),
		Transform3D(Basis.from_scale(Vector3(1e-20, 1e-20, 1e-20)), Vector3.ZERO),
		Transform3D(Basis.from_scale(Vector3(1e15, 1e15, 1e15)), Vector3.ZERO),
	]:
		_field.transform = Transform3D.IDENTITY
		# The engine reports each of its own nodes with a position that is not finite.
		_field.skeleton_distance = 20.0 if odd.is_finite() else 0.0
		await frames(20)
		_field.transform = odd
		await frames(10)
		if not odd.is_finite():
			check_error("is_finite()")  # The engine's error for the field itself.
		_field.remove_in_sphere(Vector3(1000, 0, 0), 1.0)
		_field.is_point_in_plants(Vector3.ZERO)
		_field.apply_impulse_in_sphere(Vector3(1000, 0, 0), 1.0, Vector3.RIGHT)
		_field.get_statistics()
		for tip in _tips():
			check(tip.is_finite(), "tip in %s" % odd)
	_field.transform = Transform3D.IDENTITY
	await frames(10)
	var before := _tips()
	await frames(30)
	check(_tips()[0] != before[0], "it moves again")
	walker.free()
	camera.free()


func test_frames_of_any_length() -> void:
	_field.size = Vector2(6, 6)
	await _fill()
	for time_scale: float in [0.0, 1e-6, 1.0, 1e3, 1e9]:
		Engine.time_scale = time_scale
		await frames(10)
		for tip in _tips():
			check(tip.is_finite(), "tip at a time scale of %s" % time_scale)


func test_an_error_is_reported_once_and_not_in_each_frame() -> void:
	_field.size = Vector2(4, 4)
	_field.species[0].weight = 0.0
	root.add_child(_field)
	await settled(_field)
	check_error("weight")
	for i in 3:
		_field.rebuild()
		await settled(_field)
	check_error_count("weight", 0)
	_field.species[0].weight = 1.0
	await _field.build_finished
	check(_field.get_plant_count() > 0, "it fills")
	_field.ground_mode = PlantField3D.GROUND_MESH
	await settled(_field)
	check_error("ground_mesh")
	_field.ground_mesh = NodePath("../Nobody")
	await settled(_field)
	check_error_count("ground_mesh", 0)
	_field.ground_mode = PlantField3D.GROUND_NONE
	_field.exclusions = [NodePath(".")]
	await settled(_field)
	check_error("exclusions[0]")


func _fill() -> void:
	root.add_child(_field)
	await frames(1)
	while _field.is_building():
		OS.delay_usec(1000)  # Workers need the processor.
		await process_frame
	await frames(1)


## Returns the maximum angle between a plant and upright, in radians.
func _farthest_from_rest() -> float:
	var farthest := 0.0
	var places := _field.get_plant_transforms(_field.get_plant_ids())
	var tips := _tips()
	for i in tips.size():
		var axis := tips[i] - places[i].origin
		farthest = maxf(farthest, axis.angle_to(Vector3.UP))
	return farthest


func _tips() -> PackedVector3Array:
	return _field.get_tip_positions(_field.get_plant_ids())
