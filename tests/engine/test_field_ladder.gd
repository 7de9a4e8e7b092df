## The performance settings of a field: threads, intervals, prototypes. Also the cost of contact.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(30, 30)
	field.density = 3.0
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES
	field.wind.strength = 2.0


func test_the_number_of_threads_does_not_change_the_motion() -> void:
	field.size = Vector2(80, 80)
	field.max_threads = 1
	field.wind.travel_speed = 0.0
	var other := await start_with_twin({"max_threads": 4})
	var before := all_tips()
	for i in 40:
		step_both(other)
	check(count_moved(before, 0.01) > 1000, "they move")
	check_equal(all_tips(other), all_tips(), "tips")
	other.free()


func test_changing_the_motion_keeps_the_state() -> void:
	await start()
	await step(30)
	field.simulation_enabled = false
	await frames(2)
	var before := all_tips()
	field.species[0].species.mass = 3.0
	field.wind.strength = 9.0
	field.wind.travel_speed = 2.0
	field.update_interval = 3
	check_equal(all_tips(), before, "tips")
	check(not field.is_building(), "the field is not rebuilt")


func test_an_interval_stays_near_the_full_rate() -> void:
	var other := await start_with_twin({"update_interval": 4})
	var maximum := max_apart(other, 200)
	check(maximum.y > 0.1, "they move %f m" % maximum.y)
	check(maximum.x < 0.25 * maximum.y, "%f m away, they move %f m" % [maximum.x, maximum.y])
	other.free()


func test_prototypes_do_not_move_in_unison() -> void:
	field.prototypes = 8
	await start()
	check_equal(field.get_statistics()["simulated"], 8)
	await step(60)
	var tips := _relative_tips()
	await step(20)
	var later := _relative_tips()
	var moved := 0
	var same := 0
	for i in range(1, tips.size()):
		moved += 1 if tips[i].distance_to(later[i]) > 1e-4 else 0
		same += 1 if tips[i].distance_to(tips[0]) < 1e-4 else 0
	check(moved > tips.size() * 0.9, "%d of %d plants moved" % [moved, tips.size()])
	check(same < tips.size() * 0.2, "%d of %d plants are as the first" % [same, tips.size()])


func test_a_pushed_follower_swings_on_when_the_field_is_rebuilt() -> void:
	var tulip := field.species[0].species as TulipFunction
	tulip.law = PlantFunction.LAW_SPRING
	tulip.natural_frequency = 0.5
	tulip.damping_ratio = 20.0  # It returns to rest in half a minute.
	field.prototypes = 4
	field.wind.strength = 0.0
	await start()
	var own := field.get_plant_ids()[7]
	var added := field.add_plants([Transform3D(Basis(), Vector3(40, 0, 0))], tulip)[0]
	await step(2)
	var places := [field.get_plant_transform(own).origin, Vector3(40, 0, 0)]
	for place: Vector3 in places:
		field.apply_impulse_in_sphere(place, 0.01, tulip.mass * Vector3(60, 0, 30))
	await step(20)
	field.simulation_enabled = false  # Off during a build of any number of frames.
	await frames(2)
	var before := [relative_tip(own), relative_tip(added)]
	field.rebuild()
	await rested()
	for index in 2:
		var now := relative_tip([own, added][index])
		check(before[index].angle_to(Vector3.UP) > 0.1, "the blow bends it: %s" % [before])
		check(now.angle_to(before[index]) < 0.02, "now %s, before %s" % [now, before[index]])


func test_far_plants_are_stepped_less_often_and_still_move() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 2, 500)
	root.add_child(camera)
	field.far_distance = 10.0
	await start()
	var before := all_tips()
	await step(80)
	check(all_tips() != before, "they move")
	camera.free()


func test_contact_keeps_running() -> void:
	field.density = 20.0
	field.contact_enabled = true
	await start()
	await step(30)
	for tip in all_tips():
		check(tip.is_finite(), "a tip is finite")


func _relative_tips() -> PackedVector3Array:
	var tips := PackedVector3Array()
	var ids := field.get_plant_ids()
	for i: int in range(0, ids.size(), 20):
		tips.append(relative_tip(ids[i]).normalized())
	return tips
