## The bounding box of a plant in every bend, compared with its skinned vertices at the largest
## bends.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0
## Bones are in single precision, and vertices of a mesh are on a grid of 16 bits at worst.
const SKIN_TOLERANCE := 1e-3

var _plant: Plant3D


func before_each() -> void:
	_plant = Plant3D.new()
	_plant.species = TulipFunction.new()
	_plant.simulation_enabled = false
	root.add_child(_plant)


func after_each() -> void:
	_plant.free()


func test_reach_covers_the_largest_bends_of_all_species() -> void:
	for species in _all_species():
		for law: PlantFunction.MotionLaw in _laws():
			species.law = law
			species.stays_above_ground = false
			_plant.species = species
			_check_reach("%s, law %d" % [species.get_class(), law])


func test_reach_covers_irregular_plants() -> void:
	for species in _all_species():
		species.shape_deviation = 1.0
		_plant.species = species
		for seed_value in 5:
			_plant.seed = seed_value
			_check_reach("%s, seed %d" % [species.get_class(), seed_value])


func test_the_bounds_cover_leaning_plants() -> void:
	for degrees: float in [30.0, 59.0, 61.0, 90.0, 135.0, 180.0]:
		_plant.rotation_degrees = Vector3(degrees, 20.0, 0.0)
		for law: PlantFunction.MotionLaw in _laws():
			_plant.species.law = law
			await frames(1)
			_check_reach("%f degrees, law %d" % [degrees, law])


func test_reach_is_not_much_larger_than_the_plant() -> void:
	_plant.height = 2.0
	var reach := _plant.get_reach()
	check(reach.size.x < 2.0 * 2.2, "its width, %f" % reach.size.x)
	check(reach.end.y >= 2.0, "the tip is inside")


func _all_species() -> Array[PlantFunction]:
	return [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new(),
		CurvePlantFunction.new(),
	]


func _laws() -> Array[PlantFunction.MotionLaw]:
	return [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING, PlantFunction.LAW_STEM]


## Pushes the plant hard in all directions and compares its skinned vertices with its box.
func _check_reach(label: String) -> void:
	var reach := _plant.get_reach().grow(SKIN_TOLERANCE)
	var outside := 0
	var maximum := 0.0
	for side in 8:
		var angle := TAU * side / 8.0
		_plant.reset_motion()
		_plant.apply_impulse(Vector3(cos(angle), -0.3, sin(angle)) * 1e4)
		for i in 3:
			_plant.advance(STEP)
			outside += _count_outside(reach)
			maximum = maxf(maximum, _plant.get_deflection())
	check_equal(outside, 0, "vertices out of reach of " + label)
	check(maximum > 1.0, "%s bends far: %f" % [label, maximum])


func _count_outside(reach: AABB) -> int:
	var skeleton := _plant.get_skeleton()
	var moves: Array[Transform3D] = []
	for bone in skeleton.get_bone_count():
		var rest := skeleton.get_bone_global_rest(bone)
		moves.append(skeleton.get_bone_global_pose(bone) * rest.affine_inverse())
	var arrays := _plant.get_mesh().surface_get_arrays(0)
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
	var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
	var outside := 0
	for i in positions.size():
		var skinned := Vector3.ZERO
		for k in range(4 * i, 4 * i + 4):
			skinned += weights[k] * (moves[bones[k]] * positions[i])
		if not reach.has_point(skinned):
			outside += 1
	return outside
