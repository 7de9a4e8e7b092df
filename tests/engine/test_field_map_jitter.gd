## A field with a painted jitter of scale and color: where it counts, and that plants stay.
extends "res://tests/engine/field_map_harness.gd"

const RADIUS := 5.0
const MIDDLE := Vector3(2, 0, -1)
const JITTER := 0.4
const OTHERS := 6.0


func before_each() -> void:
	super()
	for title: String in [TULIP, GRASS]:
		map.fill_polygon(field.get_outline_points(), title)
	field.map = map


func test_a_stroke_of_scale_jitter_changes_scales_in_it_only() -> void:
	await _start_again()
	var before := all_plants()
	map.paint_scale_jitter(MIDDLE, RADIUS, TULIP, JITTER, 1.0, 0.0)
	await rested()
	_check_jitter(before, all_plants())
	var stroked := all_plants()
	field.rebuild()
	await filled(field)
	check_equal(all_plants(), stroked, "plants of a full build")
	map.paint_scale_jitter(MIDDLE, RADIUS, TULIP, 0.0, 1.0, 0.0)
	await rested()
	check_equal(all_plants(), before, "plants without jitter")


func test_the_seed_chooses_the_jitter() -> void:
	map.paint_scale_jitter(MIDDLE, RADIUS, TULIP, JITTER, 1.0, 0.0)
	await _start_again()
	var one := all_plants()
	field.seed = 5
	await rested()
	check(all_plants() != one, "another seed gives other plants")
	field.seed = 0
	await rested()
	check_equal(all_plants(), one, "the first seed gives the first plants")


func test_jitter_of_color_leaves_every_plant_as_it_is() -> void:
	await _start_again()
	var before := all_plants()
	map.paint_color_jitter(MIDDLE, RADIUS, TULIP, 1.0, 1.0, 0.0)
	await rested()
	check_equal(all_plants(), before, "places, heights, seeds and species")


func test_removed_plants_do_not_return_with_jitter() -> void:
	await _start_again()
	var gone := field.find_plants_in_sphere(MIDDLE, 2.0)
	field.remove_in_sphere(MIDDLE, 2.0)
	await rested()
	map.paint_color_jitter(MIDDLE, RADIUS, TULIP, 1.0, 1.0, 0.0)
	map.paint_scale_jitter(MIDDLE, RADIUS, TULIP, JITTER, 1.0, 0.0)
	await rested()
	var there := field.get_plant_ids()
	for id in gone:
		check(not id in there, "plant %d is back" % id)


func _check_jitter(before: Dictionary, after: Dictionary) -> void:
	check_equal(after.keys().size(), before.keys().size(), "number of plants")
	var factors := PackedFloat32Array()
	for id: int in before:
		var was: Transform3D = before[id][0]
		var now: Transform3D = after[id][0]
		check_equal(now.origin, was.origin, "place of plant %d" % id)
		var factor := now.basis.get_scale().y / was.basis.get_scale().y
		var is_tulip: bool = before[id][3] == "TulipFunction"
		if is_tulip and was.origin.distance_to(MIDDLE) < RADIUS - 0.5:
			factors.append(factor)
		elif not is_tulip or was.origin.distance_to(MIDDLE) > OTHERS:
			check_near(factor, 1.0, 1e-6, "scale of plant %d" % id)
	factors.sort()
	check(factors.size() > 100, "%d tulips in the stroke" % factors.size())
	check_near(factors[0], 1.0 - JITTER, 0.05, "smallest factor")
	check_near(factors[-1], 1.0 + JITTER, 0.05, "largest factor")


func _start_again() -> void:
	root.add_child(field)
	await filled(field)
