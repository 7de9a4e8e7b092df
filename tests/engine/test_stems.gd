## Stems that bend along their length: their bones, how they swing, and what is wrong with them.
extends "res://tests/engine/harness.gd"


class Hollow:
	extends PlantFunction
	var width := -1.0

	func _calculate_curve_point(_offset: float) -> float:
		return width


const STEP := 1.0 / 60.0
const PATH := "user://saved_stem.tscn"
## Share of the length that the chain of bones may be longer or shorter.
const CHAIN_TOLERANCE := 1e-5
const FREQUENCY_TOLERANCE := 0.005
const DAMPING_TOLERANCE := 0.003
const TIP_TOLERANCE := 1e-5
## Of the length, beside a beam that keeps its length however far it bends.
const ELASTICA_TOLERANCE := 0.012

var _plant: Plant3D


func before_each() -> void:
	_plant = _add(_reed())


func after_each() -> void:
	for child in root.get_children():
		if child is Plant3D:
			child.free()
	DirAccess.remove_absolute(PATH)


func test_a_stem_has_a_bone_for_each_joint() -> void:
	for joints: int in [1, 4, 8]:
		_plant.species.stem.joints = joints
		await frames(1)
		var skeleton := _plant.get_skeleton()
		var expected: PackedStringArray = ["root", "tip"]
		for joint in joints:
			expected.append("stem_%d" % (joint + 1))
		var names: PackedStringArray = []
		for bone in skeleton.get_bone_count():
			names.append(skeleton.get_bone_name(bone))
		check_equal(names, expected, "bones")
		check_equal(_plant.get_joint_count(), joints, "joints")


func test_other_laws_have_one_joint() -> void:
	_plant.species.law = PlantFunction.LAW_SPRING
	await frames(1)
	check_equal(_plant.get_joint_count(), 1, "joints")
	check_equal(_plant.get_skeleton().get_bone_count(), 2, "bones")
	check_near(_plant.get_joint_position(1), _plant.get_tip_position(), TIP_TOLERANCE, "tip")


func test_a_joint_that_is_not_there_is_told_of() -> void:
	check_equal(_plant.get_joint_position(5), Vector3.ZERO, "no joint")
	check_error("get_joint_position(5) needs a joint from 0, the root, to 4")
	for joint: int in [0, 5]:
		_plant.apply_impulse(Vector3(0.001, 0, 0), joint)
		check_error("cannot reach joint %d. Use one from 1 to 4" % joint)
	check_near(_plant.get_deflection(), 0.0, 1e-6, "bend")


func test_the_chain_of_bones_keeps_its_length() -> void:
	for joints: int in [1, 2, 4, 8]:
		_plant.species.stem.joints = joints
		await frames(1)
		for push: float in [0.001, 0.1, 10.0]:
			_plant.reset_motion()
			_plant.apply_impulse(Vector3(push, 0, -0.3 * push))
			_run(_plant, 12)
			var skeleton := _plant.get_skeleton()
			var from := Vector3.ZERO
			var length := 0.0
			for bone: String in _chain(joints):
				var pose := skeleton.get_bone_global_pose(skeleton.find_bone(bone))
				length += from.distance_to(pose.origin)
				from = pose.origin
			var height := _plant.get_plant_height()
			check_near(
				length, height, CHAIN_TOLERANCE * height, "%d joints, %s N s" % [joints, push]
			)


func test_a_stem_swings_as_it_is_declared() -> void:
	for declared: Vector2 in [Vector2(0.7, 0.05), Vector2(1.9, 0.02), Vector2(1.0, 0.15)]:
		_plant.species.natural_frequency = declared.x
		_plant.species.damping_ratio = declared.y
		for height: float in [0.3, 1.5]:
			_plant.height = height
			await frames(1)
			var seen := _ring_down(_plant)
			var what := "of %.1f Hz, %.2f, %.1f m" % [declared.x, declared.y, height]
			check_near(seen.x / declared.x, 1.0, FREQUENCY_TOLERANCE, "frequency " + what)
			check_near(seen.y, declared.y, DAMPING_TOLERANCE, "damping " + what)


func test_joints_show_the_motion_and_do_not_change_it() -> void:
	var twin := _add(_reed())
	twin.species.stem.joints = 8
	await frames(1)
	for plant: Plant3D in [_plant, twin]:
		plant.apply_impulse(Vector3(0.002, 0, 0))
		_run(plant, 20)
	check(_plant.get_deflection() > 0.02, "it swings, %f" % _plant.get_deflection())
	check_near(twin.get_deflection(), _plant.get_deflection(), 1e-5, "bend")


func test_other_joints_build_the_mesh_anew_and_keep_the_motion() -> void:
	_plant.apply_impulse(Vector3(0.002, 0, 0))
	_run(_plant, 20)
	var mesh := _plant.get_mesh()
	var tip := _plant.get_tip_position()
	_plant.species.stem.joints = 6
	await frames(1)
	check(_plant.get_mesh() != mesh, "the mesh is another one")
	check_equal(_plant.get_joint_count(), 6, "joints")
	check_near(_plant.get_tip_position(), tip, 1e-4, "tip")


func test_what_a_stem_is_made_of_leaves_its_mesh() -> void:
	var mesh := _plant.get_mesh()
	var heard := [0]
	_plant.mesh_changed.connect(func() -> void: heard[0] += 1)
	_plant.species.natural_frequency = 2.0
	_plant.species.damping_ratio = 0.2
	_plant.species.stem.youngs_modulus = 4e9
	_plant.species.stem.diameter = 0.006
	_plant.species.stem.wind_weights = PackedFloat32Array([0, 0, 0, 1])
	await frames(2)
	check(_plant.get_mesh() == mesh, "the mesh stays")
	check_equal(heard[0], 0, "changes told of")


func test_a_blow_on_a_lower_joint_moves_the_tip_less() -> void:
	var before := 0.0
	for joint: int in [1, 2, 3, 4]:
		_plant.reset_motion()
		_plant.apply_impulse(Vector3(0.0005, 0, 0), joint)
		_run(_plant, 10)
		var way := _plant.get_tip_position().x
		check(way > 1.5 * before, "joint %d moves it %f m, the one below %f" % [joint, way, before])
		before = way
	_plant.reset_motion()
	_plant.apply_impulse(Vector3(0.0005, 0, 0))
	_run(_plant, 10)
	check_near(_plant.get_tip_position().x, before, TIP_TOLERANCE, "the tip is meant by default")


func test_a_steady_wind_bends_by_its_force() -> void:
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_CONSTANT
	_plant.species.damping_ratio = 0.5
	var weak := _calm_slope(1e-4)
	check(weak > 1e-4, "it bends, %f" % weak)
	for times: float in [2.0, 10.0]:
		check_near(_calm_slope(times * 1e-4) / weak, times, 1e-3 * times, "bend of %.0f" % times)
	_plant.species.wind_weight = 0.5
	check_near(_calm_slope(1e-4) / weak, 0.5, 1e-3, "half the weight")
	_plant.species.wind_weight = 1.0
	_plant.species.mass = 7.0
	check_near(_calm_slope(1e-4) / weak, 1.0, 1e-4, "a mass that does not count")
	_plant.species.stem.wind_weights = PackedFloat32Array([0, 0, 0, 1])
	var on_tip := _calm_slope(1e-4)
	_plant.species.stem.wind_weights = PackedFloat32Array([1, 0, 0, 0])
	var below := _calm_slope(1e-4)
	check(on_tip > 3.0 * below, "at the tip %f, at the lowest joint %f" % [on_tip, below])


func test_a_stem_in_air_has_the_shape_of_drag() -> void:
	var stem := _plant.species.stem
	_plant.height = 1.2
	stem.diameter = 0.004
	stem.taper = 0.0
	stem.density = 1.0
	stem.youngs_modulus = 1.5e9
	for property: String in ["head_mass", "head_drag_area", "leaf_mass", "leaf_drag_area"]:
		stem.set(property, 0.0)
	var bending := 1.5e9 * PI * 0.004 ** 4 / 64.0
	var drag := 0.5 * 1.2 * 1.1 * 0.004 * 1.2 ** 3 / bending
	_plant.wind = PlantWind.new()
	_plant.wind.turbulence = 0.0
	for kind: PlantWind.Kind in [PlantWind.KIND_CONSTANT, PlantWind.KIND_AIR]:
		_plant.wind.kind = kind
		for load: float in [6.0, 24.0]:
			_plant.wind.strength = load * bending / 1.2 ** 2
			_plant.wind.speed = sqrt(load / drag) * log(10.0 / 0.03) / log(1.2 / 0.03)
			_plant.reset_motion()
			_run(_plant, 600)
			var expected := _elastica_tip(load, kind == PlantWind.KIND_AIR) * 1.2
			var tip := Vector2(_plant.get_tip_position().z, _plant.get_tip_position().y)
			check_near(tip, expected, ELASTICA_TOLERANCE * 1.2, "load %f" % load)


func test_tall_stems_of_one_material_are_slow() -> void:
	_plant.species.damping_ratio = 0.05
	_plant.species.stem.diameter = 0.006
	_plant.species.stem.taper = 0.3
	_plant.species.stem.head_mass = 0.0
	_plant.species.stem.youngs_modulus = 4e9
	var before := INF
	for height: float in [0.5, 0.9, 1.5]:
		_plant.height = height
		await frames(1)
		var seen := _ring_down(_plant).x
		check(seen < 0.5 * before, "%.1f m swing at %.2f Hz" % [height, seen])
		before = seen
	_plant.species.stem.head_mass = 0.002
	await frames(1)
	check(_ring_down(_plant).x < 0.9 * before, "a head slows it")


func test_a_stem_that_cannot_stand_is_told_of_once_and_stands() -> void:
	_plant.species.resource_name = "Weak reed"
	_plant.species.stem.youngs_modulus = 1e6
	await frames(2)
	check_error(
		"'Weak reed': The stem falls under its own weight: give it a larger Young's modulus"
	)
	_plant.species.wind_weight = 0.5
	var twin := _add(_plant.species)
	twin.height = 0.7
	await frames(2)
	_plant.apply_impulse(Vector3(0.002, 0, 0))
	_run(_plant, 10)
	check(_plant.get_tip_position().is_finite(), "it has a tip")
	check(_plant.get_deflection() > 0.001, "it swings")
	_plant.species.stem.youngs_modulus = 1e11
	await frames(2)
	check_near(_plant.get_tip_position().length(), _plant.get_plant_height(), 0.1, "it stands")
	_plant.species.stem.youngs_modulus = 1e6
	await frames(2)
	check_error("falls under its own weight")


func test_a_species_that_cannot_be_built_is_told_of_once() -> void:
	var species := Hollow.new()
	var plant := _add(species)
	await frames(2)
	check_error("_calculate_curve_point")
	species.width = 0.1
	species.emit_changed()
	await frames(2)
	plant.apply_impulse(Vector3(0.01, 0, 0))
	_run(plant, 10)
	check(plant.get_deflection() > 1e-5, "it swings then, %f" % plant.get_deflection())


func test_wind_weights_need_one_for_each_joint() -> void:
	_plant.species.stem.wind_weights = PackedFloat32Array([1, 1])
	await frames(2)
	check_error("wind weights do not fit: give one of 0 to 1000 for each joint, not all 0, or none")
	_plant.species.stem.wind_weights = PackedFloat32Array([1, 1, 1, 1])
	await frames(2)
	check_equal(_plant.get_joint_count(), 4, "joints")


func test_a_frequency_that_no_stem_has_is_told_of() -> void:
	_plant.species.natural_frequency = 500.0
	await frames(2)
	check_error("natural frequency is out of range: use 0.02 to 100 Hz")
	_plant.species.natural_frequency = 1.0
	_plant.species.damping_ratio = 3.0
	await frames(2)
	check_error("damping ratio is out of range: use 0 to 1")


func test_a_bad_value_is_refused_once_and_the_old_one_stays() -> void:
	var bad := {
		"joints": [0, 9, -1],
		"modes": [0, 3],
		"youngs_modulus": [-1.0, 5.0, 2e12, NAN, INF],
		"density": [0.0, 3e4, NAN],
		"diameter": [-0.1, 1e-6, 2.0, NAN],
		"taper": [-1.1, 0.95, NAN],
		"head_mass": [-2.0, 101.0, NAN],
		"head_drag_area": [-2.0, 101.0, NAN],
		"leaf_mass": [-2.0, 101.0, INF],
		"leaf_drag_area": [-2.0, 101.0, NAN],
		"wind_weights":
		[PackedFloat32Array([1, -1]), PackedFloat32Array([2000]), PackedFloat32Array([NAN])],
	}
	var stem := PlantStem.new()
	stem.resource_name = "Straw"
	for property: String in bad:
		var before: Variant = stem.get(property)
		for value: Variant in bad[property]:
			stem.set(property, value)
			check_error("PlantStem 'Straw': " + property)
			check_equal(stem.get(property), before, property)


func test_values_are_told_of_where_they_change_only() -> void:
	var stem := PlantStem.new()
	var heard := [0]
	stem.changed.connect(func() -> void: heard[0] += 1)
	for times in 2:
		stem.joints = 5
		stem.taper = 0.3
		stem.wind_weights = PackedFloat32Array([1, 2])
	check_equal(heard[0], 3, "changes")


func test_leaves_that_are_said_to_weigh_something_catch_the_wind_as_drawn() -> void:
	var tulip: PlantFunction = load("res://addons/undergrowth/species/poppy.tres").duplicate()
	tulip.law = PlantFunction.LAW_STEM
	tulip.damping_ratio = 0.5
	tulip.stem = PlantStem.new()
	_plant.species = tulip
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_CONSTANT
	await frames(2)
	tulip.stem.leaf_drag_area = 0.0
	var bare := _calm_slope(1e-4)
	tulip.stem.leaf_drag_area = -1.0
	var drawn := _calm_slope(1e-4)
	check(absf(drawn / bare - 1.0) > 0.01, "leaves catch the wind: %f, %f" % [bare, drawn])
	tulip.stem.leaf_mass = 1e-6
	tulip.stem.leaf_drag_area = 0.0
	var light_bare := _calm_slope(1e-4)
	tulip.stem.leaf_drag_area = -1.0
	var tolerance := 0.3 * absf(drawn / bare - 1.0)
	check_near(_calm_slope(1e-4) / light_bare, drawn / bare, tolerance, "so do light ones")


func test_a_scene_with_a_stem_is_saved() -> void:
	var stem := _plant.species.stem
	stem.joints = 7
	stem.youngs_modulus = 3e9
	stem.wind_weights = PackedFloat32Array([0, 0, 0, 0, 0, 0, 1])
	var scene := PackedScene.new()
	scene.pack(_plant)
	check_equal(ResourceSaver.save(scene, PATH), OK, "saving")
	var loaded: PackedScene = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	var twin: Plant3D = loaded.instantiate()
	root.add_child(twin)
	check_equal(twin.species.law, PlantFunction.LAW_STEM, "law")
	for property: String in ["joints", "youngs_modulus", "wind_weights", "taper", "density"]:
		check_equal(twin.species.stem.get(property), stem.get(property), property)
	check_equal(twin.get_joint_count(), 7, "joints")


func test_a_stem_goes_on_from_the_state_of_another() -> void:
	_plant.apply_impulse(Vector3(0.003, 0, 0.001))
	_run(_plant, 20)
	var twin := _add(_plant.species)
	twin.set_motion_state(_plant.get_motion_state())
	check_near(twin.get_tip_position(), _plant.get_tip_position(), TIP_TOLERANCE, "tip")
	_run(_plant, 50)
	_run(twin, 50)
	check_near(twin.get_tip_position(), _plant.get_tip_position(), 10 * TIP_TOLERANCE, "later")


func test_a_stem_goes_on_with_both_modes_where_its_simulation_begins_anew() -> void:
	_plant.species.stem.modes = 2
	var twin := _add(_plant.species)
	await frames(1)
	for plant: Plant3D in [_plant, twin]:
		plant.simulation_enabled = true
		plant.apply_impulse(Vector3(0.004, 0, 0.002), 2)
	await frames(5)
	twin.simulation_enabled = false
	twin.simulation_enabled = true
	await frames(5)
	check(_plant.get_deflection() > 1e-3, "it swings, %f" % _plant.get_deflection())
	check_equal(twin.get_tip_position(), _plant.get_tip_position(), "tip")
	check_equal(twin.get_joint_position(2), _plant.get_joint_position(2), "joint")


func test_a_new_species_is_a_stem_that_sways_in_a_new_wind_and_in_air() -> void:
	var breeze: PlantWind = load("res://addons/undergrowth/winds/breeze.tres").duplicate()
	for radius: float in [0.05, 0.02, 0.004]:
		var species := CurvePlantFunction.new()
		check_equal(species.law, PlantFunction.LAW_STEM, "law")
		species.radius = radius
		var plant := _add(species)
		await frames(1)
		for wind: PlantWind in [PlantWind.new(), breeze]:
			plant.wind = wind
			plant.reset_motion()
			var farthest := 0.0
			for i in 900:
				plant.advance(STEP)
				farthest = maxf(farthest, rad_to_deg(plant.get_deflection()))
			var what := "radius %.3f sways by %.1f degrees" % [radius, farthest]
			check(farthest > 3.0 and farthest < 60.0, what)
		plant.wind = null
		_run(plant, 3000)
		check_near(plant.get_deflection(), 0.0, 1e-3, "it stands upright in calm")


func test_a_species_that_comes_to_a_standing_plant() -> void:
	var plant := Plant3D.new()
	root.add_child(plant)
	await frames(1)
	var species := _reed()
	species.stem.youngs_modulus = 4e9
	plant.species = species
	plant.apply_impulse(Vector3(0.002, 0, 0))
	await frames(3)
	check(plant.get_tip_position().is_finite(), "it has a tip")
	check_equal(plant.get_joint_count(), 4, "joints")


func test_a_point_is_in_a_stem_where_that_is_bent_to() -> void:
	_plant.touch_margin = 0.0
	_plant.species.collision_radius = 0.01
	_plant.species.stem.joints = 8
	await frames(1)
	_plant.apply_impulse(Vector3(0.05, 0, 0))
	_run(_plant, 8)
	check(_plant.get_deflection() > 0.3, "it is bent, %f" % _plant.get_deflection())
	for joint in range(1, 9):
		var place := _plant.get_joint_position(joint)
		check(_plant.is_point_in_plants(place), "joint %d" % joint)
	var straight := 0.5 * _plant.get_tip_position()
	check(not _plant.is_point_in_plants(straight + Vector3(0.03, 0, 0)), "beside it")


func _reed() -> PlantFunction:
	var species := CurvePlantFunction.new()
	species.height_min = 1.2
	species.height_max = 1.2
	species.radius = 0.004
	species.wind_weight = 1.0
	species.natural_frequency = 1.0
	species.damping_ratio = 0.05
	species.stem = PlantStem.new()
	return species


func _add(species: PlantFunction) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	root.add_child(plant)
	return plant


func _run(plant: Plant3D, steps: int) -> void:
	for i in steps:
		plant.advance(STEP)


## The bones of the stem and the tip's, from the root up.
func _chain(joints: int) -> PackedStringArray:
	var names: PackedStringArray = []
	for joint in joints:
		names.append("stem_%d" % (joint + 1))
	names.append("tip")
	return names


## tan of the tip's angle where a constant wind of so many newtons holds the plant.
func _calm_slope(newtons: float) -> float:
	_plant.wind.strength = newtons
	_plant.reset_motion()
	_run(_plant, 900)
	return tan(_plant.get_deflection())


## Where the tip of a uniform stem of length 1 is under a wind that presses on all of it, so much in
## all over its bending stiffness: across the stem as drag does, or as newtons.
func _elastica_tip(load: float, drags: bool) -> Vector2:
	var low := 0.0
	var high := 0.5 * PI
	for i in 50:
		var middle := 0.5 * (low + high)
		if _elastica_root(middle, load, drags).z < 0.0:
			low = middle
		else:
			high = middle
	var found := _elastica_root(low, load, drags)
	return Vector2(found.x, found.y)


## From the tip down: the way across and up, and the angle that is left at the root.
func _elastica_root(angle: float, load: float, drags: bool) -> Vector3:
	const PARTS := 400
	var way := Vector3(0, 0, angle)
	var force := Vector2.ZERO
	var moment := 0.0
	for i in PARTS:
		var share := cos(way.z) ** 2 if drags else 1.0
		var press := Vector2(cos(way.z), -sin(way.z)) if drags else Vector2.RIGHT
		force += press * (load * share / PARTS)
		moment += force.dot(Vector2(cos(way.z), -sin(way.z))) / PARTS
		way += Vector3(sin(way.z), cos(way.z), 0.0) / PARTS
		way.z -= moment / PARTS
	return way


## Frequency (Hz) and damping ratio that a small blow shows: by the times where the tip goes through
## its rest, and the swings between.
func _ring_down(plant: Plant3D) -> Vector2:
	plant.reset_motion()
	plant.apply_impulse(Vector3(1e-5, 0, 0))
	var times: PackedFloat64Array = []
	var peaks: PackedFloat64Array = [0.0]
	var last := 0.0
	for i in range(1, 2000):
		plant.advance(STEP)
		var now := plant.get_tip_position().x
		if last > 0.0 and now <= 0.0:
			times.append(i - 1 + last / (last - now))
			peaks.append(0.0)
		peaks[-1] = maxf(peaks[-1], now)
		last = now
		if times.size() == 7:
			break
	if times.size() < 7:
		return Vector2.ZERO
	var damped := (times[6] - times[0]) / 6.0 * STEP
	var shrinks := log(peaks[1] / peaks[5]) / 4.0
	var ratio := shrinks / sqrt(TAU * TAU + shrinks * shrinks)
	return Vector2(1.0 / (damped * sqrt(1.0 - ratio * ratio)), ratio)
