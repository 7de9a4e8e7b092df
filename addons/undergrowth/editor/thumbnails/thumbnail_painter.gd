@tool
extends RefCounted
## Draws a species of a stem from its width and colour along the height, row by row, and one of
## parts from its mesh. It uses no scene and may run on any thread.

const MeshPainter := preload("mesh_painter.gd")
const PlantGroup := preload("../widgets/plant_group.gd")
const Traits := preload("../inspector/species_traits.gd")

const PLANT_SEED := 1
const RINGS := 48
## Vertex budget of a plant of parts, sufficient for recognizable flowers.
const PART_SEGMENTS := 9
## Factor of the drawn resolution, for smooth edges after scaling down.
const FINER := 2
const MARGIN := 0.06
## Plants with a lower ratio of width to height are drawn as a tuft.
const SLIM := 0.12
## Sideways bend of the tips of a tuft, as fractions of the height.
const TUFT: Array[float] = [-0.24, 0.27, 0.02]
const SINGLE: Array[float] = [0.0]
const LIGHT := Vector2(-0.55, 0.835)
const AMBIENT := 0.55
## Half the width of the thinnest stem, as a fraction of the picture.
const THINNEST := 0.016


## Returns a picture of [param function] on a transparent background, or null if the species has an
## error.
static func paint(function: PlantFunction, size: Vector2i) -> Image:
	if not function.find_problem(0.0, RINGS, PLANT_SEED).is_empty():
		return null
	if Traits.has_models(function):
		return _paint_mesh(function.generate_mesh(0.0, RINGS, PLANT_SEED), size)
	if Traits.has_parts(function):
		return _paint_parts(function, size)
	var canvas := Image.create_empty(size.x * FINER, size.y * FINER, false, Image.FORMAT_RGBA8)
	var profile := _profile(function)
	var height := _height(function)
	var widest := 0.0
	for half_width in profile:
		widest = maxf(widest, half_width * 2.0)
	var bends := TUFT if widest < SLIM * height else SINGLE
	var area := Vector2(canvas.get_size()) * (1.0 - 2.0 * MARGIN)
	var meter := minf(area.y / height, area.x / widest)
	var colors := _colors(function)
	for bend in bends:
		_paint_stem(canvas, profile, colors, meter, height * meter, bend)
	canvas.fix_alpha_edges()  # Without it the transparent pixels would darken the edges.
	canvas.resize(size.x, size.y, Image.INTERPOLATE_BILINEAR)
	return canvas


static func _paint_parts(function: PlantFunction, size: Vector2i) -> Image:
	return _paint_mesh(PlantGroup.build(function, PART_SEGMENTS, PLANT_SEED), size)


static func _paint_mesh(mesh: ArrayMesh, size: Vector2i) -> Image:
	var canvas := MeshPainter.new().paint(mesh, size * FINER)
	canvas.fix_alpha_edges()
	canvas.resize(size.x, size.y, Image.INTERPOLATE_BILINEAR)
	return canvas


static func _height(function: PlantFunction) -> float:
	var rng := RandomNumberGenerator.new()
	rng.seed = PLANT_SEED
	return maxf(function.generate_height(rng), 1e-4)


# Returns half the width in metres at RINGS + 1 heights.
static func _profile(function: PlantFunction) -> PackedFloat32Array:
	var radius := 0.0
	for point in function.get_base_shape(RINGS):
		radius = maxf(radius, Vector2(point.x, point.z).length())
	var widths := PackedFloat32Array()
	for ring in RINGS + 1:
		widths.append(function.calculate_curve_point(float(ring) / RINGS) * radius)
	return widths


static func _colors(function: PlantFunction) -> PackedColorArray:
	var colors := PackedColorArray()
	for ring in RINGS + 1:
		colors.append(function.calculate_color_at_point(float(ring) / RINGS))
	return colors


static func _paint_stem(
	canvas: Image,
	profile: PackedFloat32Array,
	colors: PackedColorArray,
	meter: float,
	rows: float,
	bend: float
) -> void:
	var foot := canvas.get_height() - (canvas.get_height() - rows) / 2.0
	var middle := canvas.get_width() / 2.0
	var thinnest := canvas.get_width() * THINNEST
	for row in int(rows):
		var along := (row + 0.5) / rows
		var place := along * RINGS
		var ring := mini(int(place), RINGS - 1)
		var half := lerpf(profile[ring], profile[ring + 1], place - ring) * meter
		if half <= 0.0:
			continue
		var center := middle + bend * rows * along * along
		var color := colors[ring].lerp(colors[ring + 1], place - ring)
		_paint_row(canvas, roundi(foot) - 1 - row, center, maxf(half, thinnest), color)


static func _paint_row(canvas: Image, y: int, center: float, half: float, color: Color) -> void:
	if y < 0 or y >= canvas.get_height():
		return
	var first := maxi(0, roundi(center - half))
	var last := mini(canvas.get_width() - 1, maxi(roundi(center + half) - 1, first))
	for x in range(first, last + 1):
		# Lit as a round stem: the normal rotates from one edge to the other.
		var across := clampf((x + 0.5 - center) / half, -1.0, 1.0)
		var normal := Vector2(across, sqrt(1.0 - across * across))
		var light := AMBIENT + (1.0 - AMBIENT) * maxf(0.0, normal.dot(LIGHT))
		canvas.set_pixel(x, y, Color(color.r * light, color.g * light, color.b * light, 1.0))
