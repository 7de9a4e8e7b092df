@tool
extends RefCounted
## A picture of a field from above: each pixel has the mean colour of its plants, whose species have
## a colour each. -z is at the top.

## Maximum number of pixels of a side. With few plants, a pixel has the area of a plant.
const MAX_SIDE := 96
## Maximum number of plants that count. Of more plants, evenly chosen ones do.
const MAX_PLANTS := 20000
## Hues of adjacent species differ by this, so that few species have quite different ones.
const HUE_STEP := 0.618
const SATURATION := 0.7
const LIGHT := 0.9
## Colour of plants whose species is not in the field's list.
const OTHER := Color(0.6, 0.6, 0.6)
## Opacity of a pixel with few plants.
const MIN_ALPHA := 0.3

## The picture. It is null without plants.
var image: Image
## Number of plants by entry of the field's species.
var counts := PackedInt32Array()


## Draws [param field], which is in the tree.
static func of(field: PlantField3D) -> RefCounted:
	var made := new()
	made.call(&"_draw", field)
	return made


## Returns the colour of an entry of a field's species.
static func color_of(entry: int) -> Color:
	return Color.from_hsv(fposmod(0.08 + entry * HUE_STEP, 1.0), SATURATION, LIGHT)


func _draw(field: PlantField3D) -> void:
	counts.resize(field.species.size())
	var ids := field.get_plant_ids()
	var step := maxi(1, ceili(float(ids.size()) / MAX_PLANTS))
	var entries: Dictionary[PlantFunction, int] = {}
	for i in field.species.size():
		if field.species[i] and field.species[i].species not in entries:
			entries[field.species[i].species] = i
	var places := PackedVector2Array()
	var colors := PackedColorArray()
	var area := Rect2()
	for i in range(0, ids.size(), step):
		var at := field.get_plant_transform(ids[i]).origin
		var entry: int = entries.get(field.get_plant_species(ids[i]), -1)
		var place := Vector2(at.x, at.z)
		area = Rect2(place, Vector2.ZERO) if places.is_empty() else area.expand(place)
		places.append(place)
		colors.append(OTHER if entry < 0 else color_of(entry))
		if entry >= 0:
			counts[entry] += step
	if not places.is_empty():
		_fill(places, colors, area)


func _fill(places: PackedVector2Array, colors: PackedColorArray, area: Rect2) -> void:
	var finest := maxf(maxf(area.size.x, area.size.y), 0.01) / MAX_SIDE
	var pixel := maxf(finest, sqrt(area.get_area() / places.size()))
	var size := Vector2i((area.size / pixel).ceil()).clampi(1, MAX_SIDE)
	var sums := PackedColorArray()
	sums.resize(size.x * size.y)
	sums.fill(Color(0, 0, 0, 0))
	for i in places.size():
		var at := Vector2i((places[i] - area.position) / pixel).min(size - Vector2i.ONE)
		sums[at.y * size.x + at.x] += colors[i]  # The alpha counts plants.
	var full := 2.0 * places.size() / sums.size()
	image = Image.create_empty(size.x, size.y, false, Image.FORMAT_RGBA8)
	for i in sums.size():
		if sums[i].a > 0.0:
			var color := sums[i] / sums[i].a
			color.a = clampf(sums[i].a / full, MIN_ALPHA, 1.0)
			image.set_pixel(i % size.x, i / size.x, color)
