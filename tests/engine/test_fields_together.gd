## The first fields of a process, which start together.
extends "res://tests/engine/settling_harness.gd"

const FIELDS := 6


func test_fields_that_build_together_all_finish() -> void:
	var fields: Array[PlantField3D] = []
	for i in FIELDS:
		var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
		field.density = 60.0
		field.size = Vector2(5, 4)
		root.add_child(field)
		fields.append(field)
	for field in fields:
		await settled(field)
	for field in fields:
		check(field.get_plant_count() > 1000, "%d plants" % field.get_plant_count())
		field.free()
