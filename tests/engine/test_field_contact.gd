## Contact between the tips of a field's plants.
extends "res://tests/engine/field_harness.gd"


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new()])
	field.size = Vector2(30, 30)
	field.density = 2.0
	field.contact_enabled = true
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_WAVES


func test_an_absurd_collision_radius_is_reported_once() -> void:
	field.species[0].species.collision_radius = 50.0
	await start()
	check(field.get_plant_count() > 1500, "%d plants exist" % field.get_plant_count())
	await step(20)
	check_error("too many tips are near each other")


func test_usual_fields_report_no_crowd() -> void:
	field.density = 20.0
	await start()
	await step(30)
	check(field.get_plant_count() > 15000, "%d plants exist" % field.get_plant_count())
