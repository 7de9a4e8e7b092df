## Parts of the ready species start on their stems, at rest and bent, at every level of detail.
extends "res://tests/engine/harness.gd"

const FOLDER := "res://addons/undergrowth/species"
const LEVELS: PackedInt32Array = [24, 12, 6, 3]
const SEEDS := 2
## m: lower starts are on the ground.
const GROUND := 0.004
## Of the tip, as a stereographic image: about 34 degrees.
const BEND := Vector2(0.3, 0.0)
## Of the plant's height: whorls and discs have a radius.
const MAX_AT_REST := 0.015
## The same for species whose parts begin at the rim of a wide tube.
const RIMS: Dictionary[String, float] = {"bellflower.tres": 0.03}
## Tolerance beyond the second order of a chord.
const MAX_BENT := 0.015
const MAX_SKINNED := 0.02
const ON_PLANT_3D: PackedStringArray = ["meadow_grass", "garden_tulip", "oxeye_daisy"]
## Litter does not bend.
const STILL: PackedStringArray = ["dead_leaves.tres", "straw.tres", "twigs.tres"]


## One part or body of a mesh.
class Piece:
	var middles: PackedVector3Array  ## On its midrib, row by row from its base.
	var bent: PackedVector3Array
	var is_spindle := false


func test_parts_begin_on_what_carries_them() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		if file.get_extension() == "tres":
			_check_species(file)
			await frames(1)


func test_parts_of_a_plant_3d_stay_on_its_bent_stem_at_every_level() -> void:
	var plant := Plant3D.new()
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_CONSTANT
	plant.wind.strength = 100.0
	plant.simulation_enabled = false
	root.add_child(plant)
	for name: String in ON_PLANT_3D:
		plant.species = load(FOLDER.path_join(name + ".tres")).duplicate()
		plant.species.law = PlantFunction.LAW_STEM
		for segments in LEVELS:
			plant.segments = segments
			var skeleton := plant.get_skeleton()
			plant.reset_motion()
			for i in 5:
				plant.advance(0.1)
			var arrays := plant.get_mesh().surface_get_arrays(0)
			var gap := _worst_gap(arrays, _skinned.bind(arrays, _moves(skeleton))).y
			var what := "%s, %d segments: " % [name, segments]
			check(gap <= MAX_SKINNED, what + "%.1f %% of the height" % (100.0 * gap))
			if "--print" in OS.get_cmdline_user_args():
				print(
					what + "Plant3D bent %.2f %%, tip %s" % [100.0 * gap, plant.get_tip_position()]
				)
	plant.free()


## From the rest of each bone to its pose.
func _moves(skeleton: Skeleton3D) -> Array[Transform3D]:
	var moves: Array[Transform3D] = []
	for bone in skeleton.get_bone_count():
		var rest := skeleton.get_bone_global_rest(bone)
		moves.append(skeleton.get_bone_global_pose(bone) * rest.affine_inverse())
	return moves


func _skinned(place: Vector3, vertex: int, arrays: Array, moves: Array[Transform3D]) -> Vector3:
	var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
	var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
	var moved := Vector3.ZERO
	for k in range(4 * vertex, 4 * vertex + 4):
		moved += weights[k] * (moves[bones[k]] * place)
	return moved


func _check_species(file: String) -> void:
	var species: PlantFunction = load(FOLDER.path_join(file))
	for segments in LEVELS:
		var worst := Vector2.ZERO
		for seed_of_plant in SEEDS:
			var arrays := species.generate_mesh(0.0, segments, seed_of_plant).surface_get_arrays(0)
			worst = worst.max(_worst_gap(arrays, _bent.bind(arrays)))
		var what := "%s, %d segments: " % [file, segments]
		check(
			worst.x <= RIMS.get(file, MAX_AT_REST),
			what + "%.1f %% of the height" % (100.0 * worst.x)
		)
		check(
			file in STILL or worst.y <= RIMS.get(file, MAX_BENT),
			what + "%.1f %% of the height, bent" % (100.0 * worst.y)
		)
		if "--print" in OS.get_cmdline_user_args():
			print("%s at rest %.2f %%, bent %.2f %%" % [what, 100.0 * worst.x, 100.0 * worst.y])


## Returns the largest gaps, relative to the plant's height, at rest and bent. bend(place, vertex)
## returns the bent place.
func _worst_gap(arrays: Array, bend: Callable) -> Vector2:
	var worst := Vector2.ZERO
	var pieces := _pieces(arrays, bend)
	for piece in pieces:
		if piece.middles[0].y > GROUND:
			var rows := piece.middles.size() if piece.is_spindle else 1
			worst = worst.max(_gap(piece, pieces, rows))
	return worst / _height(arrays)


## Returns the largest distances (m) of the first rows of a piece from the piece nearest to its
## base: at rest, and bent.
func _gap(piece: Piece, pieces: Array[Piece], rows: int) -> Vector2:
	var carrier: Piece = null
	var nearest := INF
	for other in pieces:
		if other == piece or other.middles.size() < 2 or other.is_spindle:
			continue
		var way := _distance(piece.middles[0], other.middles)
		if way < nearest:
			nearest = way
			carrier = other
	var gap := Vector2.ZERO
	if carrier == null:
		return gap
	var tip := carrier.middles[-1]
	var along := tip - carrier.middles[-2]
	for i in rows:
		if i == 0 or (piece.middles[i] - tip).dot(along) <= 0.0:
			gap.x = maxf(gap.x, _distance(piece.middles[i], carrier.middles))
			gap.y = maxf(gap.y, _distance(piece.bent[i], carrier.bent))
	return gap


func _distance(point: Vector3, line: PackedVector3Array) -> float:
	var minimum := INF
	for i in line.size() - 1:
		var on := Geometry3D.get_closest_point_to_segment(point, line[i], line[i + 1])
		minimum = minf(minimum, point.distance_to(on))
	return minimum


func _height(arrays: Array) -> float:
	var custom: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM3]
	return custom[0]


func _pieces(arrays: Array, bend: Callable) -> Array[Piece]:
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var uvs: PackedVector2Array = arrays[Mesh.ARRAY_TEX_UV]
	var asides: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM2]
	var of := _first_vertices(points.size(), arrays[Mesh.ARRAY_INDEX])
	var rows: Dictionary = {}  # By the piece's first vertex: by v: [vertices].
	for i in points.size():
		var by_v: Dictionary = rows.get_or_add(of[i], {})
		var row: PackedInt32Array = by_v.get_or_add(snappedf(uvs[i].y, 1e-4), PackedInt32Array())
		row.append(i)
		by_v[snappedf(uvs[i].y, 1e-4)] = row
	var pieces: Array[Piece] = []
	for by_v: Dictionary in rows.values():
		var piece := Piece.new()
		var places := by_v.keys()
		places.sort()
		places.reverse()
		for v: float in places:
			var i: int = by_v[v][0]
			var middle := points[i] - Vector3(asides[4 * i], asides[4 * i + 1], asides[4 * i + 2])
			piece.middles.append(middle)
			piece.bent.append(bend.call(middle, i))
		var ends := [by_v[places.front()].size(), by_v[places.back()].size()]
		piece.is_spindle = ends == [1, 1] and piece.middles.size() == 3
		var long := piece.middles[0].distance_to(piece.middles[-1])
		piece.is_spindle = piece.is_spindle and long > 0.02
		pieces.append(piece)
	return pieces


## Returns the first vertex of the piece of each vertex.
func _first_vertices(count: int, indices: PackedInt32Array) -> PackedInt32Array:
	var of := PackedInt32Array(range(count))
	for i in range(0, indices.size(), 3):
		var roots := [_root(of, indices[i]), _root(of, indices[i + 1]), _root(of, indices[i + 2])]
		for one: int in roots:
			of[one] = roots.min()
	for i in count:
		of[i] = _root(of, i)
	return of


func _root(of: PackedInt32Array, vertex: int) -> int:
	while of[vertex] != vertex:
		vertex = of[vertex]
	return vertex


## As undergrowth_bend_stem() bends it, for a stem that is an arc of a circle.
func _bent(place: Vector3, vertex: int, arrays: Array) -> Vector3:
	var offset: float = arrays[Mesh.ARRAY_CUSTOM0][4 * vertex]
	var x: float = arrays[Mesh.ARRAY_CUSTOM3][4 * vertex + 1]
	var height := _height(arrays)
	var centre := Vector3.ZERO
	var steps := 32
	for i in steps:
		var s := BEND * x * (i + 0.5) / steps
		centre += (
			Vector3(2.0 * s.x, 1.0 - s.length_squared(), 2.0 * s.y) / (1.0 + s.length_squared())
		)
	var s := BEND * x
	var along := (
		Vector3(2.0 * s.x, 1.0 - s.length_squared(), 2.0 * s.y) / (1.0 + s.length_squared())
	)
	var rise := Vector3(BEND.x, -s.dot(BEND), BEND.y) - s.dot(BEND) * along
	centre += 0.5 * maxf(offset - x, 0.0) * steps * 2.0 / (1.0 + s.length_squared()) * rise
	var aside := _turned(place - Vector3(0, x * height, 0), BEND * clampf(offset, x, 1.0))
	return centre * x * height / steps + aside


func _turned(v: Vector3, s: Vector2) -> Vector3:
	var axis := Vector3(s.y, 0.0, -s.x)
	return v + 2.0 / (1.0 + s.length_squared()) * axis.cross(axis.cross(v) + v)
