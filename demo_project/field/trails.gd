@tool
extends Node3D
## Trails through fields: nothing grows on them, and the ground shows where they are.
##
## Each child is a Path3D, the middle of one trail.

const PIXELS := 768
const STAMP_STEP := 0.12  # m between two stamps of the picture.
const FRINGE := 0.45  # m beside a trail where the ground turns into grass.

## The fields that the trails lead through.
@export var fields: Array[PlantField3D] = []
## The ground's material, which gets a picture of the trails.
@export var ground_material: ShaderMaterial
## Half the side of the square around the origin that the picture covers.
@export_range(5.0, 200.0, 1.0, "suffix:m") var reach := 48.0
## Width of a trail.
@export_range(0.3, 5.0, 0.05, "suffix:m") var width := 1.3
## How much narrower and wider the worn ground gets on its way.
@export_range(0.0, 0.5, 0.01) var raggedness := 0.22

var _noise := FastNoiseLite.new()


func _ready() -> void:
	_noise.seed = 21
	_noise.frequency = 0.35
	var trails: Array[Path3D] = []
	var picture := PackedByteArray()
	picture.resize(PIXELS * PIXELS)
	for child in get_children():
		var path := child as Path3D
		if path:
			trails.append(path)
			_stamp(path.curve, picture)
	for field in fields:
		var paths: Array[NodePath] = []
		var widths := PackedFloat32Array()
		for trail in trails:
			paths.append(field.get_path_to(trail))
			widths.append(width)
		field.exclusions = paths
		field.exclusion_widths = widths
	if ground_material:
		_show(picture)


func _half_width(along: float) -> float:
	return 0.5 * width * (1.0 + 2.0 * raggedness * _noise.get_noise_1d(along))


## Draws round stamps along `curve`, bright in the middle of the trail.
func _stamp(curve: Curve3D, picture: PackedByteArray) -> void:
	var length := curve.get_baked_length()
	for index in ceili(length / STAMP_STEP) + 1:
		var along := minf(index * STAMP_STEP, length)
		var place := curve.sample_baked(along)
		_stamp_once(Vector2(place.x, place.z), _half_width(along), picture)


func _stamp_once(place: Vector2, half_width: float, picture: PackedByteArray) -> void:
	var pixels_per_metre := PIXELS / (2.0 * reach)
	var middle := (place + Vector2(reach, reach)) * pixels_per_metre
	var radius := (half_width + FRINGE) * pixels_per_metre
	var low := Vector2i((middle - Vector2(radius, radius)).floor()).maxi(0)
	var high := Vector2i((middle + Vector2(radius, radius)).ceil()).mini(PIXELS - 1)
	for y in range(low.y, high.y + 1):
		for x in range(low.x, high.x + 1):
			var away := middle.distance_to(Vector2(x + 0.5, y + 0.5)) / pixels_per_metre
			var worn := 1.0 - smoothstep(half_width - FRINGE, half_width + FRINGE, away)
			var at := y * PIXELS + x
			picture[at] = maxi(picture[at], int(worn * 255.0))


func _show(picture: PackedByteArray) -> void:
	var image := Image.create_from_data(PIXELS, PIXELS, false, Image.FORMAT_L8, picture)
	image.generate_mipmaps()
	ground_material.set_shader_parameter(&"worn_mask", ImageTexture.create_from_image(image))
	var side := 2.0 * reach
	ground_material.set_shader_parameter(&"worn_area", Vector4(-reach, -reach, side, side))
