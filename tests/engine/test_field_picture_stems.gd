## Stems in a field bend as those of a Plant3D in the same state do.
extends "res://tests/engine/picture_harness.gd"

const STEP := 1.0 / 60.0
## Of an outline of about 400 pixels, with tips at 77 degrees: the accuracy of bones.
const MAX_STEM_PIXELS := 100
const MIN_SECOND_MODE_PIXELS := 40
const STEPS_OF_IMPULSE := 9

var _field: PlantField3D
var _wind: PlantWind


func before_each() -> void:
	make_stage()
	_wind = make_crossing_wind()
	_field = await make_added_field(_wind)


func after_each() -> void:
	stage.free()


func test_a_reed_in_steady_wind() -> void:
	await _compare(make_reed(), Transform3D(Basis(Vector3.UP, 0.7)), 240, 0.9)


func test_a_reed_that_swings_back_in_a_turned_field() -> void:
	_field.rotation.y = 1.9
	await _compare(make_reed(), Transform3D(Basis(Vector3.UP, -2.1)), 22, 0.8)


func test_a_reed_that_leans() -> void:
	var species := make_reed()
	species.lean = deg_to_rad(20.0)
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0)), 240, 2.5)


func test_a_reed_that_nods_under_its_weight() -> void:
	var species := make_reed()
	species.lean = deg_to_rad(25.0)
	species.stem.nods = true
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0)), 240, 0.0, false, 0.02)


func test_low_leaves_of_a_leaning_stem_stay_at_its_root() -> void:
	var leaf := PlantBlade.of({length = Vector2(0.4, 0.4), width = 0.08})
	var leaves := PlantArrangement.new()
	leaves.part = leaf
	leaves.count = Vector2i(4, 4)
	leaves.from = 0.03
	leaves.to = 0.08
	leaves.angle = Vector2(1.2, 1.2)
	var species := PlantFunction.new()
	species.arrangements = [leaves]
	species.law = PlantFunction.LAW_STEM
	species.stem = PlantStem.new()
	species.stem.joints = 8
	species.lean = deg_to_rad(20.0)
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0)), 240, 2.5, false, 0.03)


func test_a_reed_of_two_modes_on_a_slope() -> void:
	var species := make_reed()
	species.stem.modes = 2
	var tilt := Basis(Vector3(1, 0, 0.5).normalized(), -0.3)
	await _compare(species, Transform3D(tilt * Basis(Vector3.UP, 2.0)), 13, 0.8, true)


func test_a_reed_on_a_slope() -> void:
	var tilt := Basis(Vector3(1, 0, 0.5).normalized(), -0.3)
	await _compare(make_reed(), Transform3D(tilt * Basis(Vector3.UP, 2.0)), 14, 0.8)


func test_a_reed_of_two_modes() -> void:
	var species := make_reed()
	species.stem.modes = 2
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0)), 15, 0.8, true)


func test_a_reed_of_two_modes_without_a_push() -> void:
	var species := make_reed()
	species.stem.modes = 2
	species.lean = deg_to_rad(15.0)
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0)), 300, 1.5)


func test_a_reed_in_air() -> void:
	_wind.kind = PlantWind.KIND_AIR
	_wind.turbulence = 0.0
	_wind.speed = 90.0
	var species := make_reed()
	species.damping_ratio = 0.5
	var place := Transform3D(Basis(Vector3.UP, 0.7))
	var id := _field.add_plants([place], species)[0]
	for i in 400:
		_field._preview(STEP, _wind)
	var in_field := await picture()
	var state := _field.get_motion_state([id])
	_field.hide()
	var plant := await make_twin(_field, id, species, place, 0)
	for blowing: PlantWind in [_wind, null]:
		plant.wind = blowing
		plant.reset_motion()
		var own := PackedFloat32Array()
		for part: int in [0, 3]:
			var v := Vector3(state[part], state[part + 1], state[part + 2]) * place.basis
			own.append_array([v.x, v.y, v.z])
		plant.set_motion_state(own)
		await frames(2)
		var different := count_different(in_field, await picture())
		if blowing:
			check(plant.get_deflection() > 0.7, "it is bent, %.2f" % plant.get_deflection())
			check(different <= MAX_STEM_PIXELS, "%d pixels differ" % different)
		else:
			check(different > 2 * MAX_STEM_PIXELS, "%d differ from newtons' shape" % different)


## Waves with the frequency of its second mode.
func test_a_follower_of_two_modes() -> void:
	var id := await _add_follower()
	_wind.kind = PlantWind.KIND_WAVES
	_wind.strength = 3.0
	_wind.frequency = 3.4
	for i in 240:
		_field._preview(STEP, _wind)
	var in_field := await picture()
	var state := _field.get_motion_state([id])
	var plant := await _hide_for_twin(id)
	plant.set_motion_state(_in_axes_of(plant, state))
	await _check_modes(plant, in_field, await picture())


func test_a_follower_of_two_modes_that_was_pushed() -> void:
	var id := await _add_follower()
	_wind.strength = 0.0
	_field._preview(STEP, _wind)
	var impulse := Vector3(0.12, 0.0, -0.08)
	check_equal(_field.apply_impulse_in_sphere(_field.global_position, 1.0, impulse), 1, "blown")
	for i in STEPS_OF_IMPULSE:
		_field._preview(STEP, _wind)
	var in_field := await picture()
	var plant := await _hide_for_twin(id)
	plant._preview(STEP, _wind)
	plant.apply_impulse(impulse)
	for i in STEPS_OF_IMPULSE:
		plant._preview(STEP, _wind)
	await frames(2)
	await _check_modes(plant, in_field, await picture())


func test_a_tulip_of_parts() -> void:
	var species: PlantFunction = load("res://addons/undergrowth/species/garden_tulip.tres")
	species = species.duplicate()
	species.law = PlantFunction.LAW_STEM
	species.frequency_height = 0.0  # A plant of this size would be too stiff.
	species.frequency_deviation = 0.0
	await _compare(species, Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3.ONE * 2.5)), 25, 0.8)


func _add_follower() -> int:
	_field.prototypes = 1
	await settled(_field)
	var species := make_reed()
	species.lean = 0.0  # Without it the rest would equal that of its prototype.
	species.natural_frequency = 0.6
	species.damping_ratio = 0.02
	species.stem.modes = 2
	return _field.add_plants([Transform3D(Basis(Vector3.UP, 0.7))], species)[0]


func _hide_for_twin(id: int) -> Plant3D:
	_field.hide()
	var place := _field.global_transform * _field.get_plant_transform(id)
	return await make_twin(_field, id, _field.get_plant_species(id), place, 0)


func _in_axes_of(plant: Plant3D, state: PackedFloat32Array) -> PackedFloat32Array:
	var own := PackedFloat32Array()
	for part in range(0, 12, 3):
		var v := Vector3(state[part], state[part + 1], state[part + 2]) * plant.global_basis
		own.append_array([v.x, v.y, v.z])
	return own


## It shows both modes, which differ from the tip's bend in a steady wind.
func _check_modes(plant: Plant3D, in_field: Image, alone: Image) -> void:
	check(count_different(in_field, empty_picture()) > MIN_PLANT, "a plant is drawn")
	var different := count_different(in_field, alone)
	check(different <= MAX_STEM_PIXELS, "%d pixels differ" % different)
	plant.set_motion_state(plant.get_motion_state().slice(0, 6))
	await frames(2)
	var of_one := count_different(alone, await picture())
	check(
		of_one > 3 * maxi(different, MIN_SECOND_MODE_PIXELS),
		"%d differ from one mode, %d from both" % [of_one, different]
	)


## Sets the strength of the wind (N) that bends the tip to about `slope`.
func _apply_wind(species: PlantFunction, slope: float) -> void:
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_CONSTANT
	plant.wind.strength = 1e-4
	stage.add_child(plant)
	for i in 600:
		plant.advance(STEP)
	_wind.strength = slope * plant.wind.strength / maxf(absf(tan(plant.get_deflection())), 1e-9)
	plant.free()


## The stems of a field step their second mode if they are `pushed`.
func _compare(
	species: PlantFunction,
	place: Transform3D,
	steps: int,
	slope: float,
	pushed := false,
	min_bend := 0.2
) -> void:
	_apply_wind(species, slope)
	var id := _field.add_plants([place], species)[0]
	if pushed:
		_field.apply_impulse_in_sphere(
			_field.global_transform * place.origin, 1.0, Vector3.UP * 1e-9
		)
	for i in steps:
		_field._preview(STEP, _wind)
	var in_field := await picture()
	_field.hide()
	var at := _field.global_transform * place
	var plant := await make_twin(_field, id, species, at, steps)
	var alone := await picture()
	check(plant.get_deflection() > min_bend, "it is bent, %.2f" % plant.get_deflection())
	check(count_different(in_field, empty_picture()) > MIN_PLANT, "a plant is drawn")
	var different := count_different(in_field, alone)
	var tip := _field.global_transform * _field.get_tip_position(id)
	var own_tip := plant.global_transform * plant.get_tip_position()
	check(tip.distance_to(own_tip) < 2e-3, "both tips are where the stem ends")
	check(different <= MAX_STEM_PIXELS, "%d pixels differ" % different)
	var last := plant.get_joint_position(plant.get_joint_count())
	check(last.is_equal_approx(plant.get_tip_position()), "the last joint is the tip")
	var skeleton := plant.get_skeleton()
	check_equal(skeleton.find_bone("stem_1"), 2, "bone of the first joint")
	for bone in range(1, skeleton.get_bone_count()):
		skeleton.set_bone_pose(bone, skeleton.get_bone_rest(bone))
	var stiff := count_different(alone, await picture())
	check(stiff > 3 * different, "%d pixels show the bend, %d differ" % [stiff, different])
