## Fields on any object that tells of heights, such as a terrain of another add-on.
extends "res://tests/engine/field_harness.gd"

const LEFT_END := -8.0


## A ramp that ends, in ten lines: what a terrain has to answer.
class Ramp:
	extends RefCounted
	var slope := 0.25

	func get_height(place: Vector3) -> float:
		return slope * place.x - 0.1 * place.z if place.x > LEFT_END else NAN

	func get_normal(_place: Vector3) -> Vector3:
		return Vector3(-slope, 1.0, 0.1)


class Terrain:
	extends Node3D
	var data: Object


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


func test_plants_stand_on_what_a_property_of_a_node_answers() -> void:
	field.ground_object = NodePath("../Terrain:data")
	field.position = Vector3(2, 5, 0)
	await start()
	check(field.get_plant_count() > 500, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		var place := field.to_global(field.get_plant_transform(id).origin)
		check_near(place.y, place.x * 0.25 - place.z * 0.1, 1e-3, "height")
		check(place.x > LEFT_END, "nothing grows beside the ground")


func test_the_ground_s_slope_counts_where_it_is_told() -> void:
	field.ground_object = NodePath("../Terrain:data")
	field.slope_limits = Vector2(0.0, 0.2)
	await start()
	check_equal(field.get_plant_count(), 0, "plants on a slope of 15°")
	field.slope_limits = Vector2(0.0, 0.3)
	await filled(field)
	check(field.get_plant_count() > 500, "%d plants" % field.get_plant_count())


func test_newcomers_stand_on_it() -> void:
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


func test_an_object_that_answers_nothing_is_told_once() -> void:
	field.ground_object = NodePath("../Terrain")
	root.add_child(field)
	await rested()
	check_error("leads to no object that answers get_height(Vector3) -> float")
	field.fill()
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	field.ground_object = NodePath("../Terrain:data")
	await rested()
	check(field.get_plant_count() > 500, "it grows when it is there")


func test_answers_of_the_wrong_type_are_one_message_and_what_stands_stays() -> void:
	field.ground_object = NodePath("../Terrain:data")
	await start()
	var count := field.get_plant_count()
	var faulty := Faulty.new()
	terrain.data = faulty
	faulty.height = "five"
	field.fill()
	await rested()
	check_error("get_height() of")
	faulty.height = 1.0
	faulty.normal = 7
	field.fill()
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
	check_error("ground_object tells of no ground at any of its places")
	field.fill()
	await rested()
	check_equal(field.get_plant_count(), 0, "plants")
	faulty.free()


func test_an_object_that_is_freed_while_it_is_asked_is_one_message() -> void:
	var faulty := Faulty.new()
	faulty.height = 1.0
	terrain.data = faulty
	field.density = 400.0
	field.ground_object = NodePath("../Terrain:data")
	root.add_child(field)
	await frames(3)
	check(field.is_filling(), "it is asked")
	faulty.free()
	await rested()
	check_error("ground_object")
	check_equal(field.get_plant_count(), 0, "plants")
