## Pictures of plants with cards, compared with all of their parts.
extends "res://tests/engine/picture_harness.gd"

const SIDE := 300
const SPECIES: Array[String] = [
	"male_fern",
	"common_reed",
	"wheat",
	"barley",
	"white_clover",
	"yarrow",
	"oxeye_daisy",
	"buttercup",
	"red_clover",
	"dandelion",
	"poppy",
	"bellflower",
	"lavender",
	"cornflower"
]
## Of these, one of this many is drawn with Forward+, which needs three times as long. Cards depend
## on their species, and both renderers share the shaders.
const OF_FORWARD := 3
const MAX_COVERAGE_ERROR := 0.1
## Of levels that drop some leaves, because they have so few segments.
const MAX_COVERAGE_ERROR_OF_FEW := 0.3
## Of trumpets and leaflets that are not as deep as a picture of them.
const DEEP: Dictionary = {"cornflower": 0.14, "red_clover": 0.13}
const MAX_COLOR_ERROR := 3.0  # CIE 1976.
## Of glossy petals, of leaves that turn to the camera, and of spikes whose whorls are lit from
## above.
const OTHER_COLORS: Dictionary = {
	"cornflower": 10.0,
	"lavender": 7.0,
	"oxeye_daisy": 4.5,
	"poppy": 5.5,
	"red_clover": 3.5,
	"yarrow": 5.0
}
const PLANTS := 3
const FINEST := 512  # Pixels of a picture whose mean is that of its smallest mipmap.
const PIXELS_OF_RADIAN := 703.7  # At 1080 lines and a vertical angle of view of 75°.
## Species whose heads are compared from all heights, on the average of some plants.
const HEADS: Array[String] = ["yarrow", "oxeye_daisy", "dandelion"]
const HEAD_ANGLES: Array[float] = [0.17, 0.44, 0.58, 0.72, 0.87, 1.12]
const HEAD_PLANTS := 8
const HEAD_DISTANCE := 2.0
const FEW := 5  # Segments: with so few, plants drop some leaves.
const COARSE := 100  # Pixels: stems are thinner than one at 6 m.
const MIN_STEM := 15
const MAX_BLUE := 0.7  # Of the green of a stem.
const THINNED := 7.5  # m: beyond this distance fewer plants are drawn, which are wider.
const LOW := 0.3  # Angles of the camera above the plant, rad.
const HIGH := 1.1


## Mean colours, times the covered area, and covered areas (w): of a species with cards, and
## with all of its parts.
class Pair:
	var what: String
	var segments: int
	var shown: Vector4
	var whole: Vector4


var _field: PlantField3D
var _root: Vector3
var _height: float


func before_each() -> void:
	make_stage()
	stage.size = Vector2i(SIDE, SIDE)
	stage.transparent_bg = true


func after_each() -> void:
	stage.free()


func test_levels_with_cards_cover_as_much_in_the_same_colour() -> void:
	stage.size = Vector2i(FINEST, FINEST)
	var is_forward := RenderingServer.get_current_rendering_method() == "forward_plus"
	for index in range(0, SPECIES.size(), OF_FORWARD if is_forward else 1):
		var name := SPECIES[index]
		for pair in await _pairs_of(name):
			var share := pair.shown.w / pair.whole.w
			var most := MAX_COVERAGE_ERROR if pair.segments > FEW else MAX_COVERAGE_ERROR_OF_FEW
			most = maxf(most, DEEP.get(name, 0.0))
			check(absf(share - 1.0) <= most, "%s covers %.2f" % [pair.what, share])
			var apart := _lab(pair.shown).distance_to(_lab(pair.whole))
			most = maxf(MAX_COLOR_ERROR, OTHER_COLORS.get(name, 0.0))
			check(apart < most, "%s differs in colour by %.1f" % [pair.what, apart])


func test_heads_cover_as_much_from_all_heights() -> void:
	for name in HEADS:
		await _sow(name, 4, HEAD_PLANTS)
		var shown := await _head_pixels()
		_field.levels = [PlantFieldLevel.of(64)]
		await settled(_field)
		var whole := await _head_pixels()
		var shares: Array[float] = []
		for i in HEAD_ANGLES.size():
			shares.append(snappedf(shown[i] / whole[i], 0.01))
		check(shares.min() > 0.75 and shares.max() < 1.15, "%s: %s" % [name, shares])
		var sum: float = shares.reduce(func(a: float, b: float) -> float: return a + b)
		var mean := sum / shares.size()
		check(absf(mean - 1.0) < 0.12, "%s: %.3f of the heads" % [name, mean])
		_field.free()


## Far stems are widened to a pixel. They do not take the colour of their flowers.
func test_thin_stems_stay_green() -> void:
	stage.size = Vector2i(COARSE, COARSE)
	await _sow("bellflower")
	_look(6.0, LOW, 0.0)
	var shown := await picture()
	var green := 0
	var blue := 0
	for y in range(COARSE / 2, 3 * COARSE / 4):
		for x in COARSE:
			var pixel := shown.get_pixel(x, y)
			green += 1 if pixel.a > 0.5 and pixel.b < MAX_BLUE * pixel.g else 0
			blue += 1 if pixel.a > 0.5 and pixel.b >= MAX_BLUE * pixel.g else 0
	check(green >= MIN_STEM, "%d pixels of the stem are green" % green)
	check(blue <= green / 4, "%d of %d are blue" % [blue, green + blue])
	_field.free()


func test_cards_turn_to_the_camera() -> void:
	await _sow("common_reed")
	var distance: float = 1.1 * _field.get_statistics()["levels"][0]["ends"][0]
	var counts: Array[float] = []
	for turn in 6:
		_look(distance, LOW, TAU * turn / 6.0)
		counts.append(_pixels(await picture()))
	check(counts.min() > 0.6 * counts.max(), "pixels by direction: %s" % [counts])
	_field.free()


## Means of a species at the near end of each near level with cards, and without levels.
func _pairs_of(name: String) -> Array[Pair]:
	await _sow(name, 4, PLANTS)
	var listed: Dictionary = _field.get_statistics()["levels"][0]
	var distances: Array[float] = []
	var segments: Array[int] = []
	for i in range(1, listed["ends"].size()):
		if listed["are_carded"][i] and listed["ends"][i - 1] < THINNED:
			distances.append(1.02 * listed["ends"][i - 1])
			segments.append(listed["segments"][i])
	check(distances.size() > 0, "%s has cards" % name)
	var shown := await _means(distances)
	_field.levels = [PlantFieldLevel.of(64)]
	await settled(_field)
	var whole := await _means(distances)
	var pairs: Array[Pair] = []
	for i in shown.size():
		var pair := Pair.new()
		pair.what = "%s at %.1f m, from %.1f rad" % [name, distances[i / 2], HIGH if i % 2 else LOW]
		pair.segments = segments[i / 2]
		pair.shown = shown[i]
		pair.whole = whole[i]
		pairs.append(pair)
	_field.free()
	return pairs


## Pixels of the upper parts of all plants, by angle of the camera.
func _head_pixels() -> Array[float]:
	var counts: Array[float] = []
	for angle in HEAD_ANGLES:
		var sum := 0.0
		for id in _field.find_plants_in_sphere(Vector3.ZERO, 40.0):
			var height := _field.get_plant_height(id)
			var head := _field.get_plant_transform(id).origin + Vector3(0, 0.93 * height, 0)
			var camera := stage.get_camera_3d()
			var way := Vector3(0, sin(angle), cos(angle))
			camera.look_at_from_position(head + HEAD_DISTANCE * way, head)
			camera.fov = rad_to_deg(2.0 * atan(0.2 * height / HEAD_DISTANCE))
			sum += _pixels(await picture())
		counts.append(sum)
	return counts


func _sow(name: String, variants := 4, plants := 1) -> void:
	_field = PlantField3D.from_species([load("res://addons/undergrowth/species/%s.tres" % name)])
	_field.size = Vector2(20, 20)
	_field.density = 0.02
	_field.species[0].variants = variants
	_field.simulation_enabled = false
	stage.add_child(_field)
	await settled(_field)
	var ids := _field.find_plants_in_sphere(Vector3.ZERO, 40.0)
	for i in range(plants, ids.size()):
		_field.remove_plant(ids[i])
	_root = _field.get_plant_transform(ids[0]).origin
	_height = _field.get_plant_height(ids[0])


## Means over all plants, from low and high angles.
func _means(distances: Array[float]) -> Array[Vector4]:
	var means: Array[Vector4] = []
	for distance in distances:
		for angle: float in [LOW, HIGH]:
			var sum := Vector4.ZERO
			for id in _field.find_plants_in_sphere(Vector3.ZERO, 40.0):
				_root = _field.get_plant_transform(id).origin
				_height = _field.get_plant_height(id)
				_look(distance, angle, id)
				_read_usual_mipmaps()
				sum += _mean_of(await picture())
			means.append(sum)
	return means


## Pictures are finer than a user's, so that no stem is widened to a pixel. Their textures are not.
func _read_usual_mipmaps() -> void:
	var camera := stage.get_camera_3d()
	var finer := 0.5 * FINEST / tan(deg_to_rad(0.5 * camera.fov)) / PIXELS_OF_RADIAN
	stage.texture_mipmap_bias = log(finer) / log(2.0)


## Mean of all pixels. w: covered share.
func _mean_of(image: Image) -> Vector4:
	image.convert(Image.FORMAT_RGBAF)
	image.generate_mipmaps()
	var bytes := image.get_data().slice(-16).to_float32_array()
	return Vector4(bytes[0], bytes[1], bytes[2], bytes[3])


func _lab(mean: Vector4) -> Vector3:
	var color := Color(mean.x / mean.w, mean.y / mean.w, mean.z / mean.w).srgb_to_linear()
	var x := (0.4124 * color.r + 0.3576 * color.g + 0.1805 * color.b) / 0.9505
	var y := 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b
	var z := (0.0193 * color.r + 0.1192 * color.g + 0.9505 * color.b) / 1.089
	var roots := Vector3(pow(x, 1.0 / 3.0), pow(y, 1.0 / 3.0), pow(z, 1.0 / 3.0))
	return Vector3(116 * roots.y - 16, 500 * (roots.x - roots.y), 200 * (roots.y - roots.z))


func _look(distance: float, angle: float, turn: float) -> void:
	var target := _root + Vector3(0, 0.5 * _height, 0)
	var way := Vector3(0, sin(angle), cos(angle)).rotated(Vector3.UP, turn)
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(target + distance * way, target)
	camera.fov = clampf(rad_to_deg(2.0 * atan(0.65 * _height / distance)), 1.0, 120.0)


func _pixels(image: Image) -> float:
	var covered := BitMap.new()
	covered.create_from_image_alpha(image, 0.5)
	return maxf(covered.get_true_bit_count(), 1.0)
