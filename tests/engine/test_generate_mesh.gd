## The guarantees of generate_mesh() for all species, both shadings and all levels of detail.
extends "res://tests/engine/harness.gd"

## The engine stores normals in 2 × 16 bits and weights in 16.
const NORMAL_TOLERANCE := 1e-3
const WEIGHT_TOLERANCE := 2e-5
const SEED := 5

var _lods: Array[int] = [1, 2, 3, 4, 7, 12, 16, 33, 64]


func test_counts_of_smooth_meshes() -> void:
	for species in _all_species():
		for lod in _lods:
			var points := species.get_base_shape(lod).size()
			_check_counts(species, lod, (lod + 1) * (points + 1) + 2 * points)


func test_counts_of_flat_meshes() -> void:
	for species in _all_species():
		species.shading = PlantFunction.SHADING_FLAT
		for lod in _lods:
			var points := species.get_base_shape(lod).size()
			_check_counts(species, lod, 3 * (2 * points * lod + 2 * (points - 2)))


func test_meshes_are_closed_and_wound_clockwise_from_outside() -> void:
	for species in _all_species():
		for shading: PlantFunction.ShadingMode in _shadings():
			species.shading = shading
			for lod in _lods:
				var arrays := _build(species, lod)
				var label := "%s, lod %d, shading %d" % [species.get_class(), lod, shading]
				check_equal(_open_edges(arrays), 0, "open edges of " + label)
				check(_volume(arrays) > 0.0, "clockwise from outside: " + label)


func test_normals_are_unit_and_outward() -> void:
	for species in _all_species():
		for shading: PlantFunction.ShadingMode in _shadings():
			species.shading = shading
			for lod in _lods:
				_check_normals(_build(species, lod), "%s, lod %d" % [species.get_class(), lod])


func test_weights_grow_with_height_and_sum_to_one() -> void:
	for species in _all_species():
		var arrays := _build(species, 12)
		var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
		var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
		check_equal(weights.size(), positions.size() * 4, "weights")
		for i in positions.size():
			check_equal(bones.slice(4 * i, 4 * i + 4), PackedInt32Array([0, 1, 0, 0]), "bones")
			var share := positions[i].y / 1.5
			check_near(weights[4 * i + 1], share, WEIGHT_TOLERANCE, "weight of the tip")
			check_near(weights[4 * i], 1.0 - share, WEIGHT_TOLERANCE, "weight of the root")
			check_equal(weights[4 * i + 2] + weights[4 * i + 3], 0.0, "other weights")


func test_uvs_run_around_and_down() -> void:
	for shading: PlantFunction.ShadingMode in _shadings():
		var species := TulipFunction.new()
		species.shading = shading
		var arrays := _build(species, 8)
		var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var uvs: PackedVector2Array = arrays[Mesh.ARRAY_TEX_UV]
		var box := Rect2(uvs[0], Vector2.ZERO)
		for i in uvs.size():
			box = box.expand(uvs[i])
			check_near(uvs[i].y, 1.0 - positions[i].y / 1.5, 1e-5, "v")
		check_near(box.position, Vector2.ZERO, 1e-6, "least uv")
		check_near(box.end, Vector2.ONE, 1e-6, "largest uv")


func test_equal_arguments_give_equal_bytes() -> void:
	for species in _all_species():
		species.shape_deviation = 1.0
		species.color_deviation = 1.0
		var bytes := var_to_bytes(_build(species, 12))
		check_equal(var_to_bytes(_build(species, 12)), bytes, species.get_class())
		var twin: PlantFunction = species.duplicate()
		check_equal(var_to_bytes(_build(twin, 12)), bytes, "a duplicate of " + species.get_class())


func test_seed_changes_only_irregular_meshes() -> void:
	var tulip := TulipFunction.new()
	var regular := var_to_bytes(tulip.generate_mesh(1.5, 12, 1).surface_get_arrays(0))
	check_equal(var_to_bytes(_build(tulip, 12)), regular, "regular mesh of another seed")
	tulip.shape_deviation = 0.5
	var first := var_to_bytes(tulip.generate_mesh(1.5, 12, 1).surface_get_arrays(0))
	check(first != regular, "the deviation is seen")
	check(first != var_to_bytes(_build(tulip, 12)), "the seed is seen")


func test_height_scales_the_mesh_upward_only() -> void:
	for species in _all_species():
		for height: float in [0.01, 1.0, 1000.0]:
			var box := species.generate_mesh(height, 12).get_aabb()
			check_near(box.end.y, height, 1e-6 * height, species.get_class())
			check_near(box.position.y, 0.0, 1e-6 * height, "ground")


func test_deviating_meshes_stay_closed() -> void:
	for species in _all_species():
		species.shape_deviation = 1.0
		for shading: PlantFunction.ShadingMode in _shadings():
			species.shading = shading
			for lod: int in [1, 12, 64]:
				var label := "%s, lod %d" % [species.get_class(), lod]
				check_equal(_open_edges(_build(species, lod)), 0, "open edges of " + label)
				check(_volume(_build(species, lod)) > 0.0, "turned inside out: " + label)


func test_heights_and_lods_out_of_range_give_one_error_and_no_mesh() -> void:
	var tulip := TulipFunction.new()
	for height: float in [-1.0, NAN, INF, -INF, 1000.1, 1e30]:
		check(tulip.generate_mesh(height, 12) == null, "no mesh of height %f" % height)
		check_error("cannot be built")
	var grass: PlantFunction = load("res://addons/undergrowth/species/meadow_grass.tres")
	for species: PlantFunction in [tulip, grass]:
		for lod: int in [0, -1, 257, 1000000]:
			check(species.generate_mesh(1.0, lod) == null, "no mesh of lod %d" % lod)
			check_error("cannot be built")


func test_the_highest_lod_is_built() -> void:
	var mesh := TulipFunction.new().generate_mesh(1.0, 256)
	check_equal(mesh.surface_get_array_len(0), 257 * 257 + 2 * 256, "vertices")


func _all_species() -> Array[PlantFunction]:
	return [
		PlantFunction.new(),
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new(),
		CurvePlantFunction.new(),
	]


func _shadings() -> Array[PlantFunction.ShadingMode]:
	return [PlantFunction.SHADING_SMOOTH, PlantFunction.SHADING_FLAT]


func _build(species: PlantFunction, lod: int) -> Array:
	return species.generate_mesh(1.5, lod, SEED).surface_get_arrays(0)


func _check_counts(species: PlantFunction, lod: int, vertices: int) -> void:
	var arrays := _build(species, lod)
	var label := "%s, lod %d: " % [species.get_class(), lod]
	var points := species.get_base_shape(lod).size()
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	check_equal(indices.size(), 3 * (2 * points * lod + 2 * (points - 2)), label + "indices")
	for kind: int in [Mesh.ARRAY_VERTEX, Mesh.ARRAY_NORMAL, Mesh.ARRAY_COLOR, Mesh.ARRAY_TEX_UV]:
		check_equal(arrays[kind].size(), vertices, label + "array %d" % kind)
	for index in indices:
		if index < 0 or index >= vertices:
			check(false, label + "index %d is out of range" % index)


## A mean normal may lean away from one of its triangles, but never towards its inside.
func _check_normals(arrays: Array, label: String) -> void:
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var inward := 0
	for normal in normals:
		if absf(normal.length() - 1.0) > NORMAL_TOLERANCE:
			check(false, "%s: a normal has length %f" % [label, normal.length()])
	for i in range(0, indices.size(), 3):
		var a := positions[indices[i]]
		var face := (positions[indices[i + 2]] - a).cross(positions[indices[i + 1]] - a)
		for corner in 3:
			if face.normalized().dot(normals[indices[i + corner]]) < -NORMAL_TOLERANCE:
				inward += 1
	check_equal(inward, 0, "inward normals of " + label)


## Returns the edges with unequal numbers of both directions, after welding equal positions.
func _open_edges(arrays: Array) -> int:
	var balance := {}
	var corners := _welded_corners(arrays)
	for i in range(0, corners.size(), 3):
		for side in 3:
			var from := corners[i + side]
			var to := corners[i + (side + 1) % 3]
			var edge := Vector2i(mini(from, to), maxi(from, to))
			if from != to:
				balance[edge] = balance.get(edge, 0) + (1 if from < to else -1)
	return balance.values().filter(func(sum: int) -> bool: return sum != 0).size()


func _welded_corners(arrays: Array) -> PackedInt32Array:
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var first_at := {}
	var corners := PackedInt32Array()
	for index: int in arrays[Mesh.ARRAY_INDEX]:
		corners.append(first_at.get_or_add(positions[index], index))
	return corners


## Positive if triangles are clockwise, seen from outside.
func _volume(arrays: Array) -> float:
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var sum := 0.0
	for i in range(0, indices.size(), 3):
		var a := positions[indices[i]]
		sum -= a.dot(positions[indices[i + 1]].cross(positions[indices[i + 2]])) / 6.0
	return sum
