## Levels of the ready species of parts show the same area and colour as the plant, from all sides.
extends "res://tests/engine/harness.gd"

const FOLDER := "res://addons/undergrowth/species"
const FINEST := 60  # Segments: most plants are drawn with all of their parts.
const SEED := 4
const COLUMNS := 768
const ROWS := 512
const OUTLINES := 4
## By segments: tolerance of the area, on the mean over all sides and from the worst one. These dots
## are coarse for the branches of a cornflower. With finer ones its difference is 4 %.
const MAX_DEVIATIONS: Dictionary = {
	12: [0.04, 0.06], 6: [0.04, 0.09], 3: [0.04, 0.06], 2: [0.04, 0.06], 1: [0.04, 0.065]
}
## Flat plants of the lowest layer, some centimetres high, lose parts that nothing hides: from the
## side their coarsest forms cover less than the plant.
const LOWEST_LAYER := {
	"dead_leaves.tres": 3,
	"ivy_carpet.tres": 2,
	"straw.tres": 1,
	"white_clover.tres": 2,
	"wild_strawberry.tres": 1,
}
const MAX_LOWEST_DEVIATIONS: Dictionary = {3: [0.05, 0.1], 2: [0.25, 0.3], 1: [0.55, 0.7]}

## Largest triangle from above (m²) at 5 segments.
const MAX_PLATES := {"lawn_grass": 6e-4, "cattail": 150e-4, "barley": 20e-4}


## Twisted leaves on the ground have no area from the side when they are drawn flat.
func test_dead_leaves_do_not_become_plates() -> void:
	for name: String in MAX_PLATES:
		var species: PlantFunction = load(FOLDER.path_join(name + ".tres"))
		var largest := 0.0
		for seed in [1, 2, 3]:
			var arrays := species.generate_mesh(0.0, 5, seed).surface_get_arrays(0)
			var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
			var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
			for i in range(0, indices.size(), 3):
				var one := points[indices[i + 1]] - points[indices[i]]
				var other := points[indices[i + 2]] - points[indices[i]]
				largest = maxf(largest, 0.5 * absf(one.cross(other).y))
		check(largest < MAX_PLATES[name], "%s: %.1f cm²" % [name, 1e4 * largest])


func test_levels_cover_as_much_as_the_plant_from_every_side() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		if file.get_extension() == "tres":
			_check_species(file)
			await frames(1)


func _check_species(file: String) -> void:
	var species: PlantFunction = load(FOLDER.path_join(file))
	var fine := species.generate_mesh(0.0, FINEST, SEED)
	var box := fine.get_aabb()
	var areas := _outlines(fine, box)
	for segments: int in MAX_DEVIATIONS:
		var level := _outlines(species.generate_mesh(0.0, segments, SEED), box)
		var sum := 0.0
		var worst := 0.0
		for side in OUTLINES:
			sum += level[side] / areas[side] - 1.0
			worst = maxf(worst, absf(level[side] / areas[side] - 1.0))
		var what := "%s, %d segments: " % [file, segments]
		var is_lowest: bool = segments <= LOWEST_LAYER.get(file, 0)
		var limits: Array = (MAX_LOWEST_DEVIATIONS if is_lowest else MAX_DEVIATIONS)[segments]
		check(absf(sum) / OUTLINES < limits[0], what + "mean %+.3f" % (sum / OUTLINES))
		check(worst < limits[1], what + "worst %.3f" % worst)


## Returns the number of dots that a mesh covers from each of four sides.
func _outlines(mesh: ArrayMesh, box: AABB) -> PackedFloat32Array:
	var arrays := mesh.surface_get_arrays(0)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var reach := maxf(box.position.abs().max(box.end).length(), 0.01)
	var areas := PackedFloat32Array()
	for side in OUTLINES:
		var turn := side * PI / OUTLINES
		var flat := PackedVector2Array()
		for point in points:
			var x := (point.x * cos(turn) + point.z * sin(turn)) / reach
			var y := (point.y - box.position.y) / box.size.y
			flat.append(Vector2((0.5 + 0.45 * x) * COLUMNS, (0.1 + 0.8 * y) * ROWS))
		areas.append(_count(flat, indices))
	return areas


func _count(flat: PackedVector2Array, indices: PackedInt32Array) -> int:
	var dots := PackedByteArray()
	dots.resize(COLUMNS * ROWS)
	for i in range(0, indices.size(), 3):
		_draw(dots, flat[indices[i]], flat[indices[i + 1]], flat[indices[i + 2]])
	return dots.count(1)


func _draw(dots: PackedByteArray, a: Vector2, b: Vector2, c: Vector2) -> void:
	var from := clampi(ceili(minf(minf(a.y, b.y), c.y) - 0.5), 0, ROWS)
	var to := clampi(ceili(maxf(maxf(a.y, b.y), c.y) - 0.5), 0, ROWS)
	for row in range(from, to):
		var level := row + 0.5
		var left := INF
		var right := -INF
		# Unrolled over the edges: an array of them takes most of the time.
		if (a.y <= level) != (b.y <= level):
			var x := a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y)
			left = x
			right = x
		if (b.y <= level) != (c.y <= level):
			var x := b.x + (c.x - b.x) * (level - b.y) / (c.y - b.y)
			left = minf(left, x)
			right = maxf(right, x)
		if (c.y <= level) != (a.y <= level):
			var x := c.x + (a.x - c.x) * (level - c.y) / (a.y - c.y)
			left = minf(left, x)
			right = maxf(right, x)
		if left == INF:
			continue
		var begin := row * COLUMNS
		for column in range(
			clampi(ceili(left - 0.5), 0, COLUMNS), clampi(ceili(right - 0.5), 0, COLUMNS)
		):
			dots[begin + column] = 1
