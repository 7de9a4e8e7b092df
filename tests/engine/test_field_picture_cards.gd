## Pictures of plants with cards, compared with all of their parts.
extends "res://tests/engine/picture_harness.gd"

const SIDE := 300
const SPECIES: Array[String] = ["male_fern", "common_reed", "wheat"]
const FLOWERS: Array[String] = [
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
## Of single plants whose head is sparser than that of the picture.
const SPARSE: Dictionary = {"yarrow": 0.2}
## Species whose heads are compared from all heights, on the average of some plants.
const HEADS: Array[String] = ["yarrow", "oxeye_daisy", "dandelion"]
const HEAD_ANGLES: Array[float] = [0.17, 0.44, 0.58, 0.72, 0.87, 1.12]
const HEAD_PLANTS := 8
const HEAD_DISTANCE := 2.0
const FEW := 5  # Segments: with so few, plants drop some leaves.
const COARSE := 100  # Pixels: stems are thinner than one at 6 m.
const MIN_STEM := 15
const MAX_BLUE := 0.7  # Of the green of a stem.
const FINE := 600  # Pixels: thin stems are wider than one, and are not widened.
const THINNED := 7.5  # m: beyond this distance fewer plants are drawn, which are wider.
const LOW := 0.3  # Angles of the camera above the plant, rad.
const HIGH := 1.1


## Pictures of a species with cards, and with all of its parts.
class Pair:
	var what: String
	var segments: int
	var shown: Image
	var whole: Image


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
	for name in SPECIES:
		for pair in await _pairs_of(name):
			var share := _pixels(pair.shown) / _pixels(pair.whole)
			check(share > 0.85 and share < 1.15, "%s covers %.2f" % [pair.what, share])
			var apart := _mean(pair.shown).distance_to(_mean(pair.whole))
			check(apart < 0.03, "%s differs in colour by %.3f" % [pair.what, apart])


func test_flowers_with_cards_cover_as_much_from_the_side_and_from_above() -> void:
	stage.size = Vector2i(FINE, FINE)
	for name in FLOWERS:
		for pair in await _pairs_of(name, 1):
			var share := _pixels(pair.shown) / _pixels(pair.whole)
			var most := 0.1 if pair.segments > FEW else 0.15
			most = maxf(most, SPARSE.get(name, 0.0))
			check(absf(share - 1.0) < most, "%s covers %.2f" % [pair.what, share])


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


## Pictures of a species at the near end of each near level with cards, and without levels.
func _pairs_of(name: String, variants := 4) -> Array[Pair]:
	await _sow(name, variants)
	var listed: Dictionary = _field.get_statistics()["levels"][0]
	var distances: Array[float] = []
	var segments: Array[int] = []
	for i in range(1, listed["ends"].size()):
		if listed["are_carded"][i] and listed["ends"][i - 1] < THINNED:
			distances.append(1.02 * listed["ends"][i - 1])
			segments.append(listed["segments"][i])
	check(distances.size() > 0, "%s has cards" % name)
	var shown := await _pictures(distances)
	_field.levels = [PlantFieldLevel.of(64)]
	await settled(_field)
	var whole := await _pictures(distances)
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


func _pictures(distances: Array[float]) -> Array[Image]:
	var made: Array[Image] = []
	for distance in distances:
		for angle: float in [LOW, HIGH]:
			_look(distance, angle, 0.0)
			made.append(await picture())
	return made


func _look(distance: float, angle: float, turn: float) -> void:
	var target := _root + Vector3(0, 0.5 * _height, 0)
	var way := Vector3(0, sin(angle), cos(angle)).rotated(Vector3.UP, turn)
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(target + distance * way, target)
	camera.fov = clampf(rad_to_deg(2.0 * atan(0.65 * _height / distance)), 1.0, 120.0)


func _pixels(image: Image) -> float:
	var count := 0
	for y in image.get_height():
		for x in image.get_width():
			count += 1 if image.get_pixel(x, y).a > 0.5 else 0
	return maxf(count, 1.0)


func _mean(image: Image) -> Vector3:
	var sum := Vector3.ZERO
	for y in image.get_height():
		for x in image.get_width():
			var pixel := image.get_pixel(x, y)
			sum += Vector3(pixel.r, pixel.g, pixel.b) if pixel.a > 0.5 else Vector3.ZERO
	return sum / _pixels(image)
