## Soft borders of fields: plants near edges are lower and fewer, all other plants are the same.
extends "res://tests/engine/field_harness.gd"

const FALLOFF := 1.5
const HALF := 8.0  # Metres, half of the field's side.


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2.ONE * 2.0 * HALF
	field.density = 18.0  # The first build is not divided into tiles.


func test_a_falloff_keeps_the_plants_that_remain() -> void:
	await start()
	var all := _heights()
	var ids := sorted_ids()
	check_equal(field.edge_falloff, 0.0, "default falloff")
	field.edge_falloff = FALLOFF
	await rested()
	var left := _heights()
	check(left.size() < ids.size() - 100, "%d of %d plants" % [left.size(), ids.size()])
	var lower := 0
	for id in left:
		check(id in all, "plant %d is new" % id)
		lower += 1 if left[id] < 0.9 * all[id] else 0
	check(lower > 50, "%d plants are lower" % lower)
	field.edge_falloff = 0.0
	await rested()
	check_equal(sorted_ids(), ids, "plants without a falloff")
	check_equal(_heights(), all, "heights without a falloff")


func test_plants_are_fewer_near_the_edge_and_complete_in_the_middle() -> void:
	await start()
	var all := _count_by_distance()
	field.edge_falloff = FALLOFF
	await rested()
	var left := _count_by_distance()
	check(left[0] < 0.5 * all[0], "%d of %d at the edge" % [left[0], all[0]])
	check_equal(left[1], all[1], "plants in the middle")


func test_changes_saved_without_a_falloff_are_applied_with_one() -> void:
	await start()
	var edge := Vector3(HALF, 0, 0)
	check(field.remove_in_sphere(edge, 3.0) > 50, "plants are removed")
	field.set_height_in_sphere(Vector3.ZERO, 2.0, 0.1)
	var changes := field.get_changes()
	var all := _heights()
	field.free()
	before_each()
	field.edge_falloff = FALLOFF
	await start()
	check(field.apply_changes(changes), "applied")
	await rested()
	check_equal(field.find_plants_in_sphere(edge, 2.9).size(), 0, "removed plants")
	var left := _heights()
	check(left.size() > 0.7 * all.size(), "%d of %d plants" % [left.size(), all.size()])
	for id in left:
		check(id in all, "plant %d is new" % id)
	for id in field.find_plants_in_sphere(Vector3.ZERO, 1.9):
		check_near(left[id], all[id], 1e-4, "height of a mown plant")


func test_tiles_have_the_border_of_the_whole_field() -> void:
	field.edge_falloff = FALLOFF
	await start()
	var whole := _heights()
	field.free()
	before_each()
	field.edge_falloff = FALLOFF
	field.tile_size = 5.0
	field.view_distance = 40.0
	field.add_child(Camera3D.new())
	await start()
	await rested()
	check_equal(_heights(), whole, "plants of tiles")


func test_a_dragged_road_has_a_soft_border() -> void:
	field.edge_falloff = FALLOFF
	field.exclusions = [add_path("Road", [Vector3(-9, 0, 3), Vector3(9, 0, 3)])]
	field.exclusion_widths = [1.0]
	await start()
	var before := field.get_plant_count()
	var reported := [0]
	field.build_progressed.connect(func(_ratio: float) -> void: reported[0] += 1)
	(field.get_node("Road") as Path3D).curve.set_point_position(1, Vector3(9, 0, -4))
	await rested()
	check_equal(reported[0], 0, "it was not built as a whole")
	check(absi(field.get_plant_count() - before) < before / 4, "%d plants" % before)
	var dragged := _heights()
	field.rebuild()
	await filled(field)
	check_equal(_heights(), dragged, "plants of a whole build")


# Heights of all plants by id.
func _heights() -> Dictionary[int, float]:
	var ids := sorted_ids()
	var heights := field.get_plant_heights(ids)
	var by_id: Dictionary[int, float] = {}
	for i in ids.size():
		by_id[ids[i]] = heights[i]
	return by_id


# Numbers of plants within half of the falloff from the edge, and farther than it.
func _count_by_distance() -> Array[int]:
	var counts: Array[int] = [0, 0]
	for id in field.get_plant_ids():
		var at := field.get_plant_transform(id).origin
		var distance := HALF - maxf(absf(at.x), absf(at.z))
		counts[0] += 1 if distance < 0.5 * FALLOFF else 0
		counts[1] += 1 if distance > FALLOFF else 0
	return counts
