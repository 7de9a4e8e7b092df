## Poses of plants that no step moves, in tiles that are built one by one.
extends "res://tests/engine/drawing/drawing_harness.gd"

const FAR := 100.0

var _camera: Camera3D


func before_each() -> void:
	field = PlantField3D.from_species([GrassFunction.new()])  # All of its plants lean at rest.
	field.simulation_enabled = false
	field.density = 12.0
	_camera = Camera3D.new()
	root.add_child(_camera)


func after_each() -> void:
	super()
	_camera.free()


func test_plants_of_all_tiles_lean_after_the_first_build() -> void:
	field.size = Vector2(60, 60)
	await start()
	await frames(2)
	_check_leans()


func test_plants_of_tiles_that_come_later_lean() -> void:
	field.size = Vector2(300, 60)
	field.view_distance = 24.0
	await start()
	await _streamed()
	_check_leans()
	_camera.position.x = FAR
	await _streamed()
	_check_leans()


func test_plants_of_tiles_that_are_built_again_lean() -> void:
	field.size = Vector2(40, 40)
	await start()
	field.density = 16.0
	await filled(field)
	await frames(2)
	_check_leans()


func test_the_last_step_is_drawn_when_the_simulation_ends() -> void:
	field.size = Vector2(10, 10)
	field.simulation_enabled = true
	field.wind = PlantWind.new()
	await start()
	await frames(30)
	field.simulation_enabled = false
	await frames(2)
	var layers := poses()
	var worst := 0.0
	for plant: DrawnPlant in drawn_plants().values():
		var id := field.find_nearest_plant(field.to_global(plant.root), 0.01)
		var state := field.get_motion_state([id])
		var bend := Vector2(state[0], state[2]) / (1.0 + state[1])
		var drawn := Vector2(
			half(layers, plant.layer, plant.texel, 2), half(layers, plant.layer, plant.texel, 3)
		)
		worst = maxf(worst, drawn.distance_to(bend))
	check_near(worst, 0.0, 1e-3, "bend that is drawn, from that after the last step")


func _streamed() -> void:
	await frames(20)
	while field.is_building() or field.get_statistics()["tiles_waiting"] > 0:
		await process_frame
	await frames(2)


## Checks that the texels of all drawn plants have a bend.
func _check_leans() -> void:
	var layers := poses()
	var plants := drawn_plants()
	check_equal(plants.size(), field.get_plant_count(), "drawn")
	var upright := 0
	for plant: DrawnPlant in plants.values():
		var has_texel := plant.layer < layers.size()
		var now := Vector2.ZERO
		if has_texel:
			now.x = half(layers, plant.layer, plant.texel, 2)
			now.y = half(layers, plant.layer, plant.texel, 3)
		upright += 1 if now.is_zero_approx() else 0
	check_equal(upright, 0, "upright plants of %d" % plants.size())
