## Pictures of the shipped species: leaves are visible, and flowers have their colours.
extends "res://tests/engine/picture_harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
const GREEN := 0.25
const WHITE := -1.0
## Hue of visible parts besides leaves. WHITE has none.
const HUES: Dictionary = {
	"bamboo": GREEN,
	"barley": 0.12,
	"bramble": GREEN,
	"dog_rose": GREEN,
	"hazel": GREEN,
	"heather": 0.87,
	"bellflower": 0.68,
	"buttercup": 0.145,
	"cattail": 0.05,
	"common_reed": 0.97,
	"cornflower": 0.62,
	"dandelion": 0.14,
	"dead_leaves": 0.07,
	"field_horsetail": GREEN,
	"garden_tulip": 0.0,
	"ivy_carpet": 0.3,
	"lavender": 0.71,
	"lawn_grass": GREEN,
	"male_fern": GREEN,
	"meadow_grass": GREEN,
	"moss_cushion": 0.2,
	"oxeye_daisy": WHITE,
	"plantain": GREEN,
	"poppy": 0.0,
	"red_clover": 0.87,
	"seedlings": GREEN,
	"straw": 0.12,
	"twigs": 0.08,
	"wheat": 0.12,
	"white_clover": WHITE,
	"wild_strawberry": WHITE,
	"yarrow": WHITE,
}
const HUE_WIDTH := 0.06
const MIN_SATURATION := 0.2
const MIN_FLOWER := 8
## Minimum number of pixels of a thin plant.
const MIN_VISIBLE_PIXELS := 60
## Species whose forms of these levels have no green.
const RIPE: PackedStringArray = ["dead_leaves", "heather", "straw", "twigs", "wheat"]
const MIN_WHITE := 0.5
const MAX_CREAMY := 0.3
## As in a field up to 12 m, and up to 25 m.
const LEVELS: PackedInt32Array = [12, 6]
## Metres: the height of the stage.
const HEIGHT := 1.3

const PAINT := Color(0.25, 0.4, 0.12)


## Broad leaves of one colour.
class Painted:
	extends PlantFunction
	var leaf := PlantBlade.of(
		{length = 1.0, width = 0.25, base_color = PAINT, tip_color = PAINT, translucency = 0.0}
	)

	func _grow(plant: PlantGrowth) -> void:
		plant.scatter(leaf, 5, {radius = 0.1})


func before_each() -> void:
	make_stage()


func after_each() -> void:
	stage.free()


func test_leaves_and_flowers_are_seen_in_their_colours() -> void:
	for file: String in HUES:
		for segments in LEVELS:
			var shown := await _picture_of(file, segments)
			var what := "%s at %d" % [file, segments]
			check(count_different(shown, empty_picture()) > MIN_VISIBLE_PIXELS, what + " is seen")
			var flower := _count_hue(shown, HUES[file])
			check(flower >= MIN_FLOWER, "%s: %d pixels of its own colour" % [what, flower])
			var green := _count_hue(shown, GREEN)
			check(green >= MIN_FLOWER or file in RIPE, "%s: %d green pixels" % [what, green])


## The engine converts a material's colour to linear light. Vertices need the same conversion.
func test_a_colour_of_vertices_is_that_colour_in_a_material() -> void:
	var pictures: Array[Image] = []
	for by_vertices: bool in [true, false]:
		var species := Painted.new()
		var material := ShaderMaterial.new()
		material.shader = load("res://addons/undergrowth/shaders/plant_parts.gdshader")
		for name in ["patchiness", "clumpiness", "dead_leaves"]:
			material.set_shader_parameter(name, 0.0)
		material.set_shader_parameter("vertex_colors", by_vertices)
		material.set_shader_parameter("albedo", Color.WHITE if by_vertices else PAINT)
		species.material = material
		var plant := Plant3D.new()
		plant.species = species
		plant.simulation_enabled = false
		stage.add_child(plant)
		pictures.append(await picture())
		plant.free()
	check(count_different(pictures[0], empty_picture()) > 200, "leaves are seen")
	var different := count_different(pictures[0], pictures[1])
	check(different <= MAX_DIFFERENT, "%d pixels differ" % different)


func _picture_of(file: String, segments: int) -> Image:
	var plant := Plant3D.new()
	plant.species = load(FOLDER + file + ".tres")
	plant.segments = segments
	plant.seed = 4
	plant.simulation_enabled = false
	stage.add_child(plant)
	plant.scale = Vector3.ONE * HEIGHT / plant.get_mesh().get_aabb().end.y
	var shown := await picture()
	plant.free()
	return shown


func _count_hue(shown: Image, hue: float) -> int:
	var count := 0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			var color := shown.get_pixel(x, y)
			if hue == WHITE:
				count += 1 if color.v > MIN_WHITE and color.s < MAX_CREAMY else 0
			elif color.v > 0.1 and color.s >= MIN_SATURATION:
				var way := absf(color.h - hue)
				count += 1 if minf(way, 1.0 - way) < HUE_WIDTH else 0
	return count
