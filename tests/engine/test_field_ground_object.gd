## Fields on an object with height queries, such as a terrain of another add-on.
extends "res://tests/engine/field_harness.gd"

const LEFT_END := -8.0


## A ramp with an end, in ten lines: the interface of a terrain.
class Ramp:
	extends RefCounted
	var slope := 0.25

	func get_height(place: Vector3) -> float:
		return slope * place.x - 0.1 * place.z if place.x > LEFT_END else NAN

	func get_normal(_place: Vector3) -> Vector3:
		return Vector3(-slope, 1.0, 0.1)


## The same ramp with queries of many positions. It counts its calls and the positions of each.
class BatchRamp:
	extends Ramp
	var calls := 0
	var places := 0
	var single := 0

	func get_height(place: Vector3) -> float:
		single += 1
		return super(place)

	func get_heights(world: PackedVector3Array) -> PackedFloat32Array:
		calls += 1
		places += world.size()
		var heights := PackedFloat32Array()
		for place in world:
			heights.append(super.get_height(place))
		return heights


## Hills without normals.
class Hills:
	extends RefCounted
	var places := 0

	func get_height(place: Vector3) -> float:
		places += 1
		return 1.5 * sin(0.2 * place.x) * cos(0.15 * place.z)


## A slope of 45° without normals.
class Slope:
	extends RefCounted

	func get_height(place: Vector3) -> float:
		return place.x


## A slope of 45° without normals that ends in the middle of the field.
class Ledge:
	extends RefCounted
	const END := 1.0

	func get_height(place: Vector3) -> float:
		return place.x if place.x < END else NAN


## Level ground around a round hole.
class Pond:
	extends RefCounted
	const RADIUS := 3.3

	func get_height(place: Vector3) -> float:
		return NAN if Vector2(place.x, place.z).length() < RADIUS else 0.5


class WrongBatch:
	extends Ramp
	var answer: Variant

	func get_heights(_places: PackedVector3Array) -> Variant:
		return answer


class Terrain:
	extends Node3D
	var data: Object


## Level ground that is freed at the end of the frame of its first query.
class Passing:
	extends Object
	var is_ending := false

	func get_height(_place: Vector3) -> float:
		if not is_ending:
			is_ending = true
			free.call_deferred()
		return 1.0


class Faulty:
	extends Node3D
	var height: Variant
	var normal: Variant = Vector3.UP

	func get_height(_place: Vector3) -> Variant:
		return height

	func get_normal(_place: Vector3) -> Variant:
		return normal


var terrain: Terrain


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.density = 2.0
	field.ground_mode = PlantField3D.GROUND_OBJECT
	terrain = Terrain.new()
	terrain.name = "Terrain"
	terrain.data = Ramp.new()
	root.add_child(terrain)


func after_each() -> void:
	super()
	if is_instance_valid(terrain):
		terrain.free()


func test_plants_follow_the_ground_of_a_nodes_property() -> void:
	field.ground_object = NodePath("../Terrain:data")
	field.position = Vector3(2, 5, 0)
	await start()
	check(field.get_plant_count() > 500, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		var place := field.to_global(field.get_plant_transform(id).origin)
		check_near(place.y, place.x * 0.25 - place.z * 0.1, 1e-3, "height")
		check(place.x > LEFT_END, "nothing grows beside the ground")


func test_the_ground_s_slope_counts_where_it_is_available() -> void:
	field.ground_object = NodePath("../Terrain:data")
	field.slope_limits = Vector2(0.0, 0.2)
	await start()
	check_equal(field.get_plant_count(), 0, "plants on a slope of 15°")
	field.slope_limits = Vector2(0.0, 0.3)
	await filled(field)
	check(field.get_plant_count() > 500, "%d plants" % field.get_plant_count())


func test_new_plants_follow_it() -> void:
	field.ground_object = NodePath("../Terrain:data")
	field.map = PlantMap.new()
	root.add_child(field)
	await rested()
	field.map.paint(Vector3(3, 0, 3), 4.0, "Tulip", 1.0, 0.0)
	await rested()
	check(field.get_plant_count() > 50, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id).origin
		check_near(place.y, place.x * 0.25 - place.z * 0.1, 1e-3, "height")


func test_an_object_that_returns_no_height_is_reported_once() -> void:
	field.ground_object = NodePath("../Terrain")
	root.add_child(field)
	await rested()
	check_error("is no object with a method get_height(Vector3) -> float")
	field.rebuild()
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	field.ground_object = NodePath("../Terrain:data")
	await rested()
	check(field.get_plant_count() > 500, "it grows when it is there")


func test_a_missing_path_is_one_error() -> void:
	field.ground_object = NodePath()
	root.add_child(field)
	await rested()
	check_error("ground_object '' is no object")


func test_heights_of_the_wrong_type_are_one_error_and_the_plants_stay() -> void:
	field.ground_object = NodePath("../Terrain:data")
	await start()
	var count := field.get_plant_count()
	var faulty := Faulty.new()
	terrain.data = faulty
	faulty.height = "five"
	field.rebuild()
	await rested()
	check_error("get_height() of")
	faulty.height = 1.0
	faulty.normal = 7
	field.slope_alignment = 1.0
	field.rebuild()
	await rested()
	check_error("get_normal() of")
	check_equal(field.get_plant_count(), count, "plants")
	faulty.free()


func test_no_ground_anywhere_is_one_warning() -> void:
	var faulty := Faulty.new()
	faulty.height = NAN
	terrain.data = faulty
	field.ground_object = NodePath("../Terrain:data")
	await start()
	check_error("ground_object returned no ground at any position")
	field.rebuild()
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	faulty.free()


func test_an_object_that_is_freed_during_a_query_is_one_error() -> void:
	var passing := Passing.new()
	terrain.data = passing
	field.density = 400.0
	field.ground_sample_spacing = 0.0
	field.build_budget_msec = 0.1  # Far less than the time of all calls.
	field.ground_object = NodePath("../Terrain:data")
	root.add_child(field)
	await rested()
	check(not is_instance_valid(passing), "it is queried")
	check_error("ground_object")
	check_equal(field.get_plant_count(), 0, "plants")


func test_slope_limits_hold_on_an_object_without_normals() -> void:
	terrain.data = Slope.new()
	field.ground_object = NodePath("../Terrain:data")
	for spacing: float in [0.0, 0.5]:
		for density: float in [2.0, 20.0]:
			field.ground_sample_spacing = spacing
			field.density = density
			field.slope_limits = Vector2(0.0, deg_to_rad(20.0))
			await _grown()
			check_equal(field.get_plant_count(), 0, "plants on 45° at %.0f/m²" % density)
			field.slope_limits = Vector2(deg_to_rad(40.0), deg_to_rad(50.0))
			await filled(field)
			check(field.get_plant_count() > 300.0 * density, "they grow on 45° where it is allowed")


func test_plants_lean_with_an_object_without_normals() -> void:
	await _check_leans(Slope.new())


func test_plants_at_the_end_of_an_object_without_normals_lean_with_its_slope() -> void:
	field.density = 20.0
	await _check_leans(Ledge.new())
	var last := field.find_plants_in_box(AABB(Vector3(0.8, -9, -9), Vector3(0.2, 18, 18)))
	check(last.size() > 20, "%d plants at the end" % last.size())


func _check_leans(ground: Object) -> void:
	terrain.data = ground
	field.species[0].species.law = PlantFunction.LAW_SPRING
	field.species[0].species.lean = 0.0
	field.species[0].lean_deviation = 0.0
	field.simulation_enabled = false
	field.ground_object = NodePath("../Terrain:data")
	field.slope_alignment = 1.0
	await start()
	var up := Vector3(-1, 1, 0).normalized()
	var worst := 0.0
	for id in field.get_plant_ids():
		worst = maxf(worst, relative_tip(id).angle_to(up))
	check(worst < 5e-3, "a plant is %.3f rad off the slope's normal" % worst)


func test_a_field_reads_a_tenth_as_many_heights_as_it_has_plants() -> void:
	var hills := Hills.new()
	terrain.data = hills
	field.density = 60.0
	field.ground_object = NodePath("../Terrain:data")
	await start()
	var count := field.get_plant_count()
	check_near(count, 60 * 20 * 20, 600.0, "plants")
	check(hills.places * 10 < count, "%d heights are read for %d plants" % [hills.places, count])
	var worst := 0.0
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id).origin
		worst = maxf(worst, absf(place.y - 1.5 * sin(0.2 * place.x) * cos(0.15 * place.z)))
	check(worst < 0.005, "plants are off by at most %.4f m" % worst)
	hills.places = 0
	field.ground_sample_spacing = 0.0
	await filled(field)
	check_equal(hills.places, count, "heights that are read for each plant")


func test_tiles_that_come_read_half_as_many_heights_as_they_have_plants() -> void:
	var hills := Hills.new()
	terrain.data = hills
	field.density = 12.0
	field.endless = true
	field.view_distance = 30.0
	field.ground_object = NodePath("../Terrain:data")
	var camera := Camera3D.new()
	root.add_child(camera)
	await start()
	hills.places = 0
	camera.position.x = 1000.0
	await until(_plants_around.bind(camera), "tiles exist around the camera")
	var count := field.get_plant_count()
	check(count > 12 * 30 * 30 * 3, "%d plants" % count)
	check(hills.places > 0, "heights are read")
	check(hills.places * 2 < count, "%d heights are read for %d plants" % [hills.places, count])
	camera.free()


func _plants_around(camera: Camera3D) -> bool:
	var reported := field.get_statistics()
	return (
		reported["tiles_waiting"] == 0
		and field.find_nearest_plant(camera.position, 10.0) >= 0
		and field.find_plants_in_sphere(Vector3.ZERO, 20.0).is_empty()
	)


func test_heights_of_many_places_are_read_at_once() -> void:
	var ramp := BatchRamp.new()
	terrain.data = ramp
	field.ground_object = NodePath("../Terrain:data")
	for spacing: float in [0.5, 0.0]:
		ramp.calls = 0
		ramp.places = 0
		field.density = 12.0
		field.ground_sample_spacing = spacing
		await _grown()
		check_equal(ramp.single, 0, "calls of get_height()")
		check(ramp.calls > 0, "get_heights() is called")
		check(ramp.places > 50 * ramp.calls, "%d places in %d calls" % [ramp.places, ramp.calls])
		for id in field.get_plant_ids():
			var place := field.get_plant_transform(id).origin
			check_near(place.y, place.x * 0.25 - place.z * 0.1, 1e-3, "height")
			check(place.x > LEFT_END, "nothing grows beside the ground")


func test_wrong_answers_for_many_places_are_one_error() -> void:
	var wrong := WrongBatch.new()
	terrain.data = wrong
	field.ground_object = NodePath("../Terrain:data")
	wrong.answer = PackedFloat32Array([1.0])
	root.add_child(field)
	await rested()
	check_error("get_heights() of")
	check_equal(field.get_plant_count(), 0, "plants")


func test_a_hole_in_the_ground_has_an_exact_edge() -> void:
	terrain.data = Pond.new()
	field.density = 30.0
	field.ground_object = NodePath("../Terrain:data")
	await start()
	check(field.get_plant_count() > 10000, "%d plants" % field.get_plant_count())
	var nearest := INF
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id).origin
		nearest = minf(nearest, Vector2(place.x, place.z).length())
	check(nearest >= Pond.RADIUS, "nothing grows in the hole")
	check(nearest < Pond.RADIUS + 0.1, "plants grow up to its edge, %.2f m" % nearest)


## Adds the field to the tree if necessary and waits until it is built.
func _grown() -> void:
	if field.is_inside_tree():
		await filled(field)
	else:
		await start()
