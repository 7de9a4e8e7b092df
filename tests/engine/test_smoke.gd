extends "res://tests/engine/field_harness.gd"


func test_smoke() -> void:
	field = PlantField3D.from_species(
		[GrassFunction.new(), TulipFunction.new()], PackedFloat32Array([9, 1])
	)
	field.size = Vector2(30, 30)
	field.density = 5.0
	field.wind = PlantWind.new()
	root.add_child(field)
	await field.filled
	await frames(2)
	var ids := field.get_plant_ids()
	check_near(field.get_plant_count(), 4500, 150.0)
	check_equal(ids.size(), field.get_plant_count())
	var unique := {}
	for id in ids:
		unique[id] = true
	check_equal(unique.size(), ids.size(), "unique ids")
	for i in range(0, ids.size(), 50):
		check(field.has_plant(ids[i]), "has %d" % ids[i])
	var tips := field.get_tip_positions(ids)
	await frames(60)
	check(field.get_tip_positions(ids) != tips, "moves")
	var n := field.remove_in_sphere(Vector3(2, 0, 2), 3.0)
	check(n > 50, "removed %d" % n)
	check_equal(field.get_plant_count(), ids.size() - n)
	var added := field.add_plants(
		[Transform3D(Basis(), Vector3(50, 0, 0))], BellflowerFunction.new()
	)
	check_equal(added.size(), 1)
	check(field.has_plant(added[0]), "has added")
	await frames(5)
	check(field.is_point_in_plants(Vector3(50, 0.05, 0)), "point")
	tips = field.get_tip_positions(field.get_plant_ids())
	var before := field.get_plant_ids()
	field.tile_size = 7.0
	await dressed()
	await frames(1)
	var after := field.get_plant_ids()
	var a := Array(before)
	a.sort()
	var b := Array(after)
	b.sort()
	check_equal(b, a, "ids after retile")
	field.simulation_enabled = false
	await frames(2)
	(field.species[0] as PlantFieldSpecies).species.tip_color = Color.RED
	check(not field.is_filling(), "a colour fills nothing")
	var now := field.get_tip_positions(after)
	await dressed()
	await frames(1)
	var c := Array(field.get_plant_ids())
	c.sort()
	check_equal(c, a, "ids after recolour")
	var later := field.get_tip_positions(after)
	var most := 0.0
	for i in now.size():
		most = maxf(most, now[i].distance_to(later[i]))
	check(most < 1e-5, "tips stay %f" % most)
	field.prototypes = 8
	field.simulation_enabled = true
	await dressed()
	await frames(10)
	check_equal(field.get_plant_count(), after.size())
	print(field.get_statistics())
	field.free()
	await frames(3)
