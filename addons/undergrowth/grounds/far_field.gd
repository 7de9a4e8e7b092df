extends RefCounted
## The mean colour of a field far away, from a small picture of some of its plants: as a camera a
## little above shows them, with the tones of plant_parts.gdshader.

const DEFAULT_SPECIES := "res://addons/undergrowth/species/meadow_grass.tres"
## Few, as of distant plants.
const SEGMENTS := 2
const SEEDS := 3
## Maximum number of drawn plants.
const PLANTS := 800
## Radians above the horizon.
const RISE := 0.13
## Metres: a pixel of the screen at these plants, a pixel of the picture, and its height.
const SCREEN_PIXEL := 0.03
const PIXEL := 0.012
const BAND := 0.24
const COLUMNS := 96
const STRIPS := 12
## Of extension/core/placement/placement.cpp and clump.hpp.
const CLUMP_HEIGHT := 0.25
const CLUMP_SIZE := 0.9
const GOLDEN := 0.618034
const ROWS := int(BAND / PIXEL)
## As in the shaders: undergrowth_width, undergrowth_patches and undergrowth_parts.gdshaderinc.
const MAX_WIDENING := 3.0
const TONE := 0.9
const FAR_OPENNESS := 0.6
const FAR_SHARE := 0.35

## Mean albedo (linear) relative to the shader's tone, without dead leaves.
var color := Vector3.ZERO
var openness := FAR_OPENNESS
var translucency := 0.0
## Number of pixels with plants.
var covered := 0

var _first := 0  # Column of the strip.
var _depths := PackedFloat32Array()
var _shown: Array[Vector4] = []  # Albedo, openness.
var _through := PackedFloat32Array()


func _init(field: PlantField3D) -> void:
	var entries := _entries_of(field)
	var weights := 0.0
	for entry in entries:
		weights += entry.weight
	var kinds: Array[Kind] = []
	var tallest := 0.0
	for entry in entries:
		var size := (entry.scale_range.x + entry.scale_range.y) * 0.5
		var share := entry.density_factor * entry.weight / maxf(weights, 1e-6)
		for i in SEEDS:
			var mesh := entry.species.generate_mesh(0.0, SEGMENTS, i + 1)
			if mesh == null:
				break  # The species has an error, which it reports.
			var kind := Kind.new(mesh, size, field.density * share / SEEDS)
			tallest = maxf(tallest, mesh.get_aabb().end.y * size)
			kinds.append(kind)
	if not kinds.is_empty():
		_draw_all(kinds, tallest, field)
		_measure()


static func _entries_of(field: PlantField3D) -> Array[PlantFieldSpecies]:
	var entries: Array[PlantFieldSpecies] = []
	for entry in field.species:
		if entry != null and entry.species != null and entry.weight > 0.0:
			entries.append(entry)
	if entries.is_empty() and field.species.is_empty() and ResourceLoader.exists(DEFAULT_SPECIES):
		entries.append(PlantFieldSpecies.of(load(DEFAULT_SPECIES), 1.0))
	return entries


func _draw_all(kinds: Array[Kind], tallest: float, field: PlantField3D) -> void:
	_depths.resize(COLUMNS * ROWS)
	_depths.fill(INF)
	_shown.resize(COLUMNS * ROWS)
	_through.resize(COLUMNS * ROWS)
	var deep := (tallest * cos(RISE) + BAND) / sin(RISE)
	var random := RandomNumberGenerator.new()
	random.seed = 2
	# Narrow strips, each of which repeats along x. Clumps share a species by `clumping`.
	var part := minf(1.0, PLANTS / maxf(field.density * deep * COLUMNS * PIXEL, 1e-6))
	var wide := maxi(int(part * COLUMNS / STRIPS), 4)
	var count := field.density * deep * wide * PIXEL
	var shares := PackedFloat32Array()
	var sum := 0.0
	for kind in kinds:
		sum += kind.density
		shares.append(sum)
	var turn := 0.5
	var clump_turn := 0.5
	for strip in STRIPS:
		var clumps: Array[int] = []
		for i in ceili(deep / field.clump_size) + 1:
			clump_turn = fposmod(clump_turn + GOLDEN, 1.0)
			clumps.append(_chosen(shares, clump_turn * sum))
		var heights := PackedFloat32Array()
		for i in ceili(deep / CLUMP_SIZE) + 1:
			heights.append(random.randf_range(-1.0, 1.0))
		var shift := random.randf()
		for i in int(count):
			var at := Vector2(random.randf() * wide * PIXEL, (i + random.randf()) / count * deep)
			var number := clumps[int(at.y / field.clump_size + shift)]
			if random.randf() >= field.clumping:
				turn = fposmod(turn + GOLDEN, 1.0)
				number = _chosen(shares, turn * sum)
			_first = strip * COLUMNS / STRIPS
			var tall := 1.0 + CLUMP_HEIGHT * field.combed * heights[int(at.y / CLUMP_SIZE)]
			_draw(kinds[number], at, tall, random.randf() * TAU, tallest * cos(RISE), wide)


func _chosen(shares: PackedFloat32Array, at: float) -> int:
	return mini(shares.bsearch(at), shares.size() - 1)


func _draw(kind: Kind, at: Vector2, tall: float, angle: float, bottom: float, columns: int) -> void:
	var c := cos(angle)
	var s := sin(angle)
	var count := kind.points.size()
	var places := PackedVector3Array()
	places.resize(count)
	for i in count:
		var p := kind.points[i]
		var x := at.x + c * p.x + s * p.z
		var z := at.y + c * p.z - s * p.x
		var up := tall * p.y * cos(RISE) + z * sin(RISE) - bottom
		places[i] = Vector3(x / PIXEL, up / PIXEL, z * cos(RISE) - tall * p.y * sin(RISE))
	for i in range(0, kind.indices.size(), 3):
		_fill(kind, places, kind.indices[i], kind.indices[i + 1], kind.indices[i + 2], columns)


func _fill(kind: Kind, at: PackedVector3Array, i: int, j: int, k: int, columns: int) -> void:
	var a := at[i]
	var b := at[j]
	var c := at[k]
	var low := maxi(ceili(minf(a.y, minf(b.y, c.y)) - 0.5), 0)
	var top := mini(floori(maxf(a.y, maxf(b.y, c.y)) - 0.5), ROWS - 1)
	var area := (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)
	if low > top or absf(area) < 1e-6:
		return
	var left := ceili(minf(a.x, minf(b.x, c.x)) - 0.5)
	var right := floori(maxf(a.x, maxf(b.x, c.x)) - 0.5)
	for y in range(low, top + 1):
		for x in range(left, right + 1):
			var p := Vector2(x + 0.5, y + 0.5)
			var v := ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area
			var w := ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area
			var u := 1.0 - v - w
			if u < 0.0 or v < 0.0 or w < 0.0:
				continue
			var place := y * COLUMNS + _first + posmod(x, columns)
			var depth := u * a.z + v * b.z + w * c.z
			if depth < _depths[place]:
				_depths[place] = depth
				_shown[place] = u * kind.shown[i] + v * kind.shown[j] + w * kind.shown[k]
				_through[place] = u * kind.through[i] + v * kind.through[j] + w * kind.through[k]


func _measure() -> void:
	var sum := Vector4.ZERO
	var dimmed := 0.0
	for i in _depths.size():
		if _depths[i] < INF:
			var shown := _shown[i]
			var luminance := shown.x * 0.3 + shown.y * 0.6 + shown.z * 0.1
			sum += Vector4(shown.x, shown.y, shown.z, luminance)
			dimmed += luminance * shown.w
			translucency += _through[i]
			covered += 1
	if covered > 0:
		color = Vector3(sum.x, sum.y, sum.z) / (TONE * covered)
		openness = dimmed / maxf(sum.w, 1e-6)
		translucency /= covered


## A plant: its vertices as drawn far away, and its number per square metre.
class Kind:
	var density: float
	var points := PackedVector3Array()
	var indices := PackedInt32Array()
	var shown: Array[Vector4] = []
	var through := PackedFloat32Array()

	func _init(mesh: ArrayMesh, size: float, p_density: float) -> void:
		density = p_density
		for surface in mesh.get_surface_count():
			_add(mesh.surface_get_arrays(surface), size)

	func _add(arrays: Array, size: float) -> void:
		var own: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var colors: PackedColorArray = arrays[Mesh.ARRAY_COLOR]
		var at: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
		var first := points.size()
		for i in at:
			indices.append(first + i)
		var parts := PackedFloat32Array()
		var aside := PackedFloat32Array()
		if arrays[Mesh.ARRAY_CUSTOM0] != null:
			parts = arrays[Mesh.ARRAY_CUSTOM0]
		var has_parts := parts.size() == 4 * own.size()  # Other plants have one number per vertex.
		if has_parts:
			aside = arrays[Mesh.ARRAY_CUSTOM2]
		var mean := _mean_of(own, colors, at)
		for i in own.size():
			var beside := Vector3.ZERO
			var leafiness := 0.0
			if has_parts:
				beside = Vector3(aside[4 * i], aside[4 * i + 1], aside[4 * i + 2]) * size
				leafiness = parts[4 * i + 3]
			var lift := clampf(0.5 * SCREEN_PIXEL / maxf(beside.length(), 1e-6), 1.0, MAX_WIDENING)
			lift = lift if beside.length() > 1e-5 else 1.0
			points.append(own[i] * size + beside * (lift - 1.0))
			shown.append(_shown_of(colors[i], mean, 1.0 / lift))
			through.append(leafiness)

	## Returns the mean linear colour.
	func _mean_of(
		own: PackedVector3Array, colors: PackedColorArray, at: PackedInt32Array
	) -> Vector3:
		var sum := Vector3.ZERO
		var weights := 0.0
		for i in range(0, at.size(), 3):
			var a := own[at[i]]
			var area := (own[at[i + 1]] - a).cross(own[at[i + 2]] - a).length()
			for k in 3:
				var color := colors[at[i + k]]
				var weight := area * _tone_of(color.a) * (1.0 - 0.7 * (1.0 - color.a))
				sum += weight * _linear(color)
				weights += weight
		return sum / maxf(weights, 1e-12)

	## Returns albedo and openness of a vertex.
	func _shown_of(color: Color, mean: Vector3, contrast: float) -> Vector4:
		var light := mean.lerp(_linear(color), contrast)
		var most := maxf(light.x, light.z)
		var green := smoothstep(-0.1, 0.12, (light.y - most) / maxf(light.y, 0.001))
		light *= _tone_of(color.a)
		light *= minf(1.0, 0.85 / maxf(maxf(light.x, light.y), maxf(light.z, 1e-4)))
		return Vector4(light.x, light.y, light.z, lerpf(color.a, FAR_OPENNESS, FAR_SHARE * green))

	func _tone_of(open: float) -> float:
		return lerpf(0.3, 1.2, smoothstep(0.05, 0.7, open))

	func _linear(color: Color) -> Vector3:
		var light := color.srgb_to_linear()
		return Vector3(light.r, light.g, light.b)
