## The renderer's data of plants that are instances of prototypes.
extends "res://tests/engine/drawing/drawing_harness.gd"


func before_each() -> void:
	field = make_field(16.0, 4.0)
	field.prototypes = 8


func test_each_plant_that_is_pushed_has_a_place_of_its_own() -> void:
	await start()
	check_equal(_places().size(), 0, "places before")
	var hit := field.apply_impulse_in_sphere(Vector3.ZERO, 6.0, Vector3(0.5, 0, 0))
	check(hit > SIDE, "%d plants are hit" % hit)
	await step(3)
	var places := _places()
	check_equal(places.size(), hit, "places")
	for place: Vector2i in places:
		check(place.x >= 1 and place.x <= SIDE, "column %d, counted from 1" % place.x)


func test_plants_that_were_removed_stay_hidden_when_others_are_pushed() -> void:
	await start()
	var removed := field.remove_in_sphere(Vector3.ZERO, 2.0)
	check(removed > 10, "%d plants are removed" % removed)
	await step(3)
	field.apply_impulse_in_sphere(Vector3.ZERO, 6.0, Vector3(0.5, 0, 0))
	await step(3)
	var layers := poses()
	for plant: DrawnPlant in drawn_plants().values():
		var is_gone := plant.root.length() < 1.9
		check(not is_gone or is_hidden(layers, plant), "hidden at %s" % plant.root)


## Column, counted from 1, and row of all simulated plants. Each may occur once.
func _places() -> Dictionary[Vector2i, bool]:
	var layers := poses()
	var found: Dictionary[Vector2i, bool] = {}
	for plant: DrawnPlant in drawn_plants().values():
		var column := int(half(layers, plant.layer, plant.texel, 2))
		var place := Vector2i(column, int(half(layers, plant.layer, plant.texel, 3)))
		if column > 0:
			check(not found.has(place), "place %s is used once" % place)
			found[place] = true
	return found
