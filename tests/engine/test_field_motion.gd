## Motion of fields: its start, its extent and its winds.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(30, 30)
	field.density = 3.0
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES
	field.wind.strength = 2.0


func test_plants_move_in_wind() -> void:
	await start()
	var before := all_tips()
	var moved := {}
	for i in 10:
		await step(3)  # The final position of a tip can equal its first one.
		var tips := all_tips()
		for plant in tips.size():
			if tips[plant].distance_to(before[plant]) > 0.001:
				moved[plant] = true
	check_equal(moved.size(), field.get_plant_count(), "plants that moved")


func test_plants_keep_their_length() -> void:
	await start()
	await step(40)
	for id in field.get_plant_ids():
		var place := field.get_plant_transform(id)
		var length := field.get_plant_height(id)
		check_near(field.get_tip_position(id).distance_to(place.origin), length, 1e-4)


## Reads a plant after the field has started its step of the frame.
class Reader:
	extends Node

	var field: PlantField3D
	var id := -1
	var worst := 0.0  # m, between the tip and the end of its direction.

	func _process(_delta: float) -> void:
		var state := field.get_motion_state([id])
		var direction := Vector3(state[0], state[1], state[2])
		var tip := field.get_tip_position(id) - field.get_plant_transform(id).origin
		worst = maxf(worst, tip.distance_to(direction * tip.length()))


func test_a_state_that_is_read_during_a_step_is_that_after_the_step() -> void:
	await start()
	var reader := Reader.new()
	reader.field = field
	reader.id = field.get_plant_ids()[0]
	root.add_child(reader)
	await step(20)
	check_near(reader.worst, 0.0, 1e-5, "tip to the end of the direction")
	reader.free()


func test_still_air_leaves_plants_at_rest() -> void:
	field.wind = null
	await start()
	var before := all_tips()
	await step(30)
	check_equal(all_tips(), before, "tips")


func test_a_paused_tree_and_a_disabled_node_do_not_move() -> void:
	await start()
	await step(10)
	paused = true
	await frames(2)
	var before := all_tips()
	await frames(8)
	check_equal(all_tips(), before, "tips while paused")
	paused = false
	field.process_mode = Node.PROCESS_MODE_DISABLED
	await frames(2)
	before = all_tips()
	await frames(8)
	check_equal(all_tips(), before, "tips while disabled")
	field.process_mode = Node.PROCESS_MODE_INHERIT
	await step(8)
	check(all_tips() != before, "they move again")


func test_a_field_without_simulation_does_not_move() -> void:
	await start()
	await step(10)
	field.simulation_enabled = false
	await frames(2)
	var before := all_tips()
	await frames(8)
	check_equal(all_tips(), before, "tips")


func test_time_scale_0_stops_motion() -> void:
	await start()
	await step(10)
	Engine.time_scale = 0.0
	await frames(2)
	var before := all_tips()
	await frames(8)
	check_equal(all_tips(), before, "tips")


func test_the_wind_comes_to_plants_downwind_later() -> void:
	field.density = 0.0
	field.wind.kind = PlantWind.KIND_GUST
	field.wind.gust_duration = 0.3
	field.wind.direction = deg_to_rad(90.0)
	field.wind.travel_speed = 10.0
	root.add_child(field)
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean = 0.0
	function.damping_ratio = 1.0
	var transforms: Array[Transform3D] = [
		Transform3D(Basis.IDENTITY, Vector3(0, 0, 0)),
		Transform3D(Basis.IDENTITY, Vector3(5, 0, 0)),
	]
	var ids := field.add_plants(transforms, function)
	await frames(5)
	await step(240)
	var rest := [relative_tip(ids[0]), relative_tip(ids[1])]
	field.wind.trigger_gust()
	var first: Array[int] = [-1, -1]
	for i in 120:
		await step(1)
		for plant in 2:
			if first[plant] < 0 and relative_tip(ids[plant]).distance_to(rest[plant]) > 1e-4:
				first[plant] = i
	check(first[0] >= 0 and first[1] > first[0], "the gust comes to both: %s" % [first])
	# 5 m at 10 m/s take half a second.
	check_near((first[1] - first[0]) * STEP, 0.5, 0.1, "seconds of delay")


func test_wind_goes_on_where_plants_share_it() -> void:
	var plant := Plant3D.new()
	plant.species = TulipFunction.new()
	plant.wind = field.wind
	root.add_child(plant)
	await start()
	var before := field.wind.get_time()
	await step(60)
	# Exactly one of them advances the wind's clock.
	check_near(field.wind.get_time() - before, 1.0, 0.2, "seconds of wind")
	plant.free()
	before = field.wind.get_time()
	await step(60)
	check_near(field.wind.get_time() - before, 1.0, 0.2, "seconds of wind")


func test_a_moved_field_keeps_the_winds_direction() -> void:
	field.density = 0.0
	field.wind.kind = PlantWind.KIND_CONSTANT
	field.wind.direction = deg_to_rad(90.0)
	field.rotation.y = 1.1
	root.add_child(field)
	var id := field.add_plants([Transform3D.IDENTITY], TulipFunction.new())[0]
	await frames(5)
	await step(200)
	var tip := field.global_basis * field.get_tip_position(id)
	check(tip.x > 0.01, "it bends to +x: %s" % tip)
	check_near(tip.z, 0.0, 0.02, "z")


func test_monitors_include_all_fields() -> void:
	await start()
	check_equal(
		int(Performance.get_custom_monitor("undergrowth/field_plants")), field.get_plant_count()
	)
	root.remove_child(field)
	check(not Performance.has_custom_monitor("undergrowth/field_plants"), "no monitor is left")
