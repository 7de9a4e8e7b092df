## The layer of the second mode of stems, which the renderer reads while they have one.
extends "res://tests/engine/drawing/drawing_harness.gd"


func before_each() -> void:
	var species := CurvePlantFunction.new()
	species.stem = PlantStem.new()
	species.stem.modes = 2
	field = PlantField3D.from_species([species])
	field.size = Vector2(6, 6)
	field.density = 4.0


func test_the_second_mode_is_drawn_from_a_push_on() -> void:
	await start()
	await frames(20)
	_check_layers(false)
	field.apply_impulse_in_sphere(Vector3.ZERO, 20.0, Vector3(0.003, 0, 0))
	await frames(4)
	_check_layers(true)


func _check_layers(has_second: bool) -> void:
	var layers := poses()
	var rows := beats(layers.size())
	var plants := drawn_plants()
	check(plants.size() > 100, "%d plants are drawn" % plants.size())
	var wrong := 0
	for plant: DrawnPlant in plants.values():
		var row := plant.layer * SIDE + plant.texel / SIDE
		var second := int(rows.decode_float(16 * row + 8))
		wrong += 0 if (second >= 0) == has_second else 1
	check_equal(wrong, 0, "plants of %d, second mode %s" % [plants.size(), has_second])
