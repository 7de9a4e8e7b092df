## Fields of stems that bend along their length: forces, performance settings, and drawing.
extends "res://tests/engine/field_stem_harness.gd"

## Height at which a low body touches (m).
const LOW := 0.45


func test_a_low_body_pushes_the_stem_where_it_touches() -> void:
	field.density = 0.0
	field.wind = null
	field.bodies_group = &"walkers"
	await start()
	var id := field.add_plants([Transform3D()], field.species[0].species)[0]
	await frames(2)
	var ball := SphereShape3D.new()
	ball.radius = 0.1
	var body := add_body(ball, Vector3(-0.06, LOW, 0))
	await step(60)
	var tip := relative_tip(id)
	check(tip.x > 0.1, "the tip goes to %s" % tip)
	check(absf(tip.z) < 0.02, "it goes away from the ball: %s" % tip)
	check(tip.x < 0.6, "it is not thrown: %s" % tip)
	body.position.y = 3.0
	await step(900)
	check(relative_tip(id).distance_to(Vector3(0, HEIGHT, 0)) < 0.02, "it comes back")


func test_a_low_body_pushes_an_isolated_plant() -> void:
	await start()
	var plant := Plant3D.new()
	plant.species = _reed()
	plant.bodies_group = &"walkers"
	plant.position = Vector3(30, 0, 0)
	root.add_child(plant)
	var ball := SphereShape3D.new()
	ball.radius = 0.1
	add_body(ball, Vector3(30 - 0.06, LOW, 0))
	await step(60)
	check(plant.get_tip_position().x > 0.1, "the tip goes to %s" % plant.get_tip_position())
	plant.free()


func test_tips_of_stems_push_each_other() -> void:
	field.density = 0.0
	field.wind = null
	field.contact_enabled = true
	field.species[0].species.collision_radius = 0.1
	await start()
	var places: Array[Transform3D] = []
	for x: float in [0.0, 0.25]:
		places.append(Transform3D(Basis(), Vector3(x, 0, 0)))
	var ids := field.add_plants(places, field.species[0].species)
	await frames(2)
	var before := field.get_tip_position(ids[1]).x
	field.apply_impulse_in_sphere(Vector3.ZERO, 0.1, Vector3(0.004, 0, 0))
	var farthest := 0.0
	for i in 40:
		await step(1)
		farthest = maxf(farthest, field.get_tip_position(ids[1]).x - before)
	check(farthest > 0.02, "the other goes %f m" % farthest)


func test_stems_follow_prototypes() -> void:
	field.prototypes = 8
	await start()
	check_equal(field.get_statistics()["simulated"], 8)
	await step(60)
	var before := all_tips()
	await step(20)
	var moved := count_moved(before, 1e-4)
	check(moved > 0.9 * before.size(), "%d of %d plants moved" % [moved, before.size()])
	var hit := field.apply_impulse_in_sphere(Vector3.ZERO, 2.0, Vector3(0.003, 0, 0))
	check(hit > 10, "%d plants are hit" % hit)
	await step(4)
	check_equal(field.get_statistics()["simulated"], 8 + hit, "they swing by themselves")


func test_stems_that_are_stepped_less_often_stay_near() -> void:
	var twin := await start_with_twin({"update_interval": 4})
	var maximum := max_apart(twin, 120)
	check(maximum.y > 0.02, "they move %f m" % maximum.y)
	check(maximum.x < 0.25 * maximum.y, "%f m away, they move %f m" % [maximum.x, maximum.y])
	twin.free()


func test_far_stems_still_move() -> void:
	_camera = Camera3D.new()
	_camera.position = Vector3(0, 2, 500)
	root.add_child(_camera)
	field.far_distance = 10.0
	await start()
	var before := all_tips()
	await step(80)
	check(count_moved(before, 1e-4) > 0.9 * before.size(), "they move")


func test_stems_near_the_camera_are_skeletons_with_their_bones() -> void:
	_camera = Camera3D.new()
	_camera.position = Vector3(0, 1, 1)
	root.add_child(_camera)
	_camera.make_current()
	field.skeleton_distance = 4.0
	await start()
	await step(60)
	field.simulation_enabled = false
	await frames(2)
	check(field.get_skeletons().size() > 10, "there are skeletons")
	for skeleton: Skeleton3D in field.get_skeletons():
		var id := field.get_skeleton_plant(skeleton)
		check_equal(skeleton.find_bone("stem_4"), 5, "bone of the last joint")
		var tip := skeleton.transform * skeleton.get_bone_global_pose(1).origin
		# Pictures are between two steps. The tolerance of bones beside the stem is a hundredth of
		# its length.
		check_near(tip, field.get_tip_position(id), 0.01 * HEIGHT + 0.01, "tip of plant %d" % id)


func test_tips_are_those_of_a_plant_alone_in_the_same_state() -> void:
	field.wind = null
	field.simulation_enabled = false
	await start()
	var id := field.get_plant_ids()[7]
	var alone := Plant3D.new()
	alone.species = field.species[0].species
	alone.simulation_enabled = false
	alone.height = field.get_plant_height(id) / field.get_plant_transform(id).basis.y.length()
	root.add_child(alone)
	alone.global_transform = field.get_plant_transform(id)
	await frames(1)
	for push: float in [0.0003, 0.002, 0.004]:
		alone.reset_motion()
		alone.apply_impulse(Vector3(push, 0, 0.5 * push))
		for i in 10:
			alone.advance(STEP)
		var state := alone.get_motion_state()
		var own := Basis(alone.global_basis.orthonormalized())
		var turned := PackedFloat32Array()
		for part: int in [0, 3]:
			var v := own * Vector3(state[part], state[part + 1], state[part + 2])
			turned.append_array([v.x, v.y, v.z])
		field.set_motion_state([id], turned)
		var expected := alone.to_global(alone.get_tip_position())
		check(alone.get_deflection() > 0.005, "it is bent, %f" % alone.get_deflection())
		check_near(field.get_tip_position(id), expected, TIP_TOLERANCE, "tip of %f" % push)
		var back := field.get_motion_state([id])
		for i in 6:
			check_near(back[i], turned[i], 2e-3 * maxf(1.0, absf(turned[i])), "state %d" % i)
	alone.free()


func test_what_stems_are_made_of_keeps_plants_and_their_motion() -> void:
	await start()
	await step(30)
	field.simulation_enabled = false
	await frames(2)
	var ids := field.get_plant_ids()
	var before := all_tips()
	var species := field.species[0].species
	species.natural_frequency = 2.0
	species.stem.density = 900.0
	species.stem.modes = 2
	await frames(3)
	check(not field.is_building(), "the field is not rebuilt")
	check_equal(field.get_plant_ids(), ids, "ids")
	check_equal(count_moved(before, 0.02), 0, "tips that jump")
	species.stem.joints = 7
	await rested()
	check_equal(field.get_plant_count(), ids.size(), "plants with other joints")
	check_equal(count_moved(before, 0.02), 0, "tips that jump with other joints")


func test_a_field_of_stems_that_buckle_is_reported_once() -> void:
	field.species[0].species.stem.youngs_modulus = 1e5
	await start()
	await step(30)
	check_error("The stem falls under its own weight")
	check(field.get_plant_count() > 400, "%d plants exist" % field.get_plant_count())
	for tip in all_tips():
		if not tip.is_finite():
			check(false, "a tip is finite")


func test_stems_changed_during_a_build_move_by_their_new_values() -> void:
	var stiff := _reed()
	stiff.natural_frequency = 3.0
	var twin := await start_with_twin({"species": [PlantFieldSpecies.of(stiff)]})
	for attempt in 50:
		var changing := _reed()
		field.species = [PlantFieldSpecies.of(changing)]
		await frames(1)
		if field.is_building():
			changing.natural_frequency = 3.0
			break
	check(field.is_building(), "it is seen to fill")
	while field.is_building():
		await process_frame
	var apart := await max_apart(twin, 30)
	check(apart.x < 1e-5, "tips are %f m from those that were stiff before" % apart.x)
	check(apart.y > 1e-3, "they go %f m" % apart.y)
	twin.free()
