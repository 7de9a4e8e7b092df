## A rebuild of a field transfers the motion of its plants, and no frame shows an intermediate
## state.
extends "res://tests/engine/field_harness.gd"

const MANY := 5000
const BLOW := Vector3(0.004, 0.0, 0.001)
const ROUNDING := 1e-4
const HALF_AN_IMPULSE := 0.05  # m/s: half of one blow on a tip, more than rounding.


func before_each() -> void:
	field = _make_field()


## The result is the same to the bit for any order of changes.
func test_a_rebuilt_field_equals_one_that_is_built_at_once() -> void:
	await start()
	field.density = 40.0
	await filled(field)
	field.clumping = 0.6
	field.size = Vector2(14, 12)
	await filled(field)
	var refilled := _described(field)
	var other := _make_field()
	other.density = 40.0
	other.clumping = 0.6
	other.size = Vector2(14, 12)
	root.add_child(other)
	await filled(other)
	check_equal(refilled, _described(other), "plants")
	field.density = 50.0
	field.clumping = 0.0
	field.size = Vector2(11, 11)
	await filled(field)
	other.density = 50.0
	other.clumping = 0.0
	other.size = Vector2(11, 11)
	await filled(other)
	check_equal(_described(field), _described(other), "plants then")
	other.free()


func test_edits_during_a_rebuild_are_preserved() -> void:
	field.simulation_enabled = false
	await start()
	check(field.get_plant_count() > MANY, "%d plants" % field.get_plant_count())
	var ids := field.get_plant_ids()
	var pushed := ids[MANY / 2]
	field.apply_impulse_in_sphere(Vector3.ZERO, 3.0, BLOW)
	var others := ids.duplicate()
	others.remove_at(others.find(pushed))
	var before := field.get_motion_state(others)
	for attempt in 4:
		field.clump_size += 0.5  # All plants exist again.
		var blows := 0
		var state := field.get_motion_state([pushed])
		var at := field.get_plant_transform(pushed).origin
		await frames(1)
		while field.is_building():
			field.apply_impulse_in_sphere(at, 0.001, BLOW)
			blows += 1
			await process_frame
		check(blows > 1, "it takes %d frames" % blows)
		check(field.has_plant(pushed), "it exists again")
		check_near(_max_apart(field.get_motion_state(others), before), 0.0, ROUNDING, "others")
		var now := field.get_motion_state([pushed])
		field.set_motion_state([pushed], state)
		for i in blows:
			field.apply_impulse_in_sphere(at, 0.001, BLOW)
		var wanted := field.get_motion_state([pushed])
		check_near(_max_apart(now, wanted), 0.0, HALF_AN_IMPULSE, "it has got all %d blows" % blows)
		check(_max_apart(now, state) > 0.01 * blows, "which it feels")


func test_removals_and_additions_during_a_rebuild_are_preserved() -> void:
	await start()
	var function := field.species[0].species
	for attempt in 3:
		field.clump_size += 0.5
		await frames(1)
		var gone := PackedInt64Array()
		var added := PackedInt64Array()
		while field.is_building():
			var ids := field.get_plant_ids()
			gone.append(ids[ids.size() / 3])
			field.remove_plant(ids[ids.size() / 3])
			added.append_array(field.add_plants([Transform3D()], function))
			await process_frame
		for id in gone:
			check(not field.has_plant(id), "%d is gone" % id)
		for id in added:
			check(field.has_plant(id), "%d was added" % id)
		field.remove_plants(added)


func test_a_superseded_build_leaves_nothing_behind() -> void:
	await start()
	for i in 40:
		field.density = 40.0 + i % 7
		await frames(i % 5)
	field.density = 44.0
	await rested()
	var drawn: PackedInt32Array = field.get_statistics()["drawn_by_level"]
	var other := _make_field()
	other.density = 44.0
	root.add_child(other)
	await filled(other)
	await frames(2)
	check_equal(drawn, other.get_statistics()["drawn_by_level"], "what is drawn")
	check_equal(_described(field), _described(other), "plants")
	other.free()


## At any phase: placement, planning, preparation or transfer of motion.
func test_a_superseded_build_of_other_seeds_leaves_nothing_behind() -> void:
	await start()
	for i in 80:
		field.seed += 1
		var until := Time.get_ticks_usec() + 150 * i
		while field.is_building() and Time.get_ticks_usec() < until:
			await process_frame
	await rested()
	var drawn: PackedInt32Array = field.get_statistics()["drawn_by_level"]
	var other := _make_field()
	other.seed = field.seed
	root.add_child(other)
	await filled(other)
	await frames(2)
	check_equal(drawn, other.get_statistics()["drawn_by_level"], "what is drawn")
	check_equal(_described(field), _described(other), "plants")
	other.free()


func test_leaving_the_tree_during_it() -> void:
	await start()
	for i in 12:
		field.clump_size += 0.25
		await frames(i % 4)
		root.remove_child(field)
		field.get_tip_positions(field.get_plant_ids())
		await frames(1)
		root.add_child(field)
		await frames(i % 3)
	await rested()
	check(field.get_plant_count() > MANY, "%d plants" % field.get_plant_count())


func _max_apart(some: PackedFloat32Array, others: PackedFloat32Array) -> float:
	var maximum := 0.0 if some.size() == others.size() else INF
	for i in mini(some.size(), others.size()):
		maximum = maxf(maximum, absf(some[i] - others[i]))
	return maximum


func _described(of: PlantField3D) -> Array:
	var ids := of.get_plant_ids()
	ids.sort()
	return [ids, of.get_plant_transforms(ids), of.get_plant_heights(ids)]


func _make_field() -> PlantField3D:
	var made := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()], [4, 1])
	made.size = Vector2(12, 12)
	made.density = 50.0
	return made
