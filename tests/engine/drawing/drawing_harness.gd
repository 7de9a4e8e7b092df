## Base of the tests of a field's data for the renderer: instances of multimeshes, and texels of
## poses. README.md of this folder describes the record.
extends "res://tests/engine/field_harness.gd"

const STRIDE := 16  # Floats of an instance of a field without colours.
const SIDE := 64  # Texels of a row.
const TEXEL_BYTES := 8
const HALVES_COUNT_FROM := -2048
const HIDDEN := 65504.0


## A plant of a multimesh.
class DrawnPlant:
	## In the field's axes.
	var root: Vector3
	## Texel in the texture of poses.
	var texel: int
	var layer: int
	var rank: float
	## Length of its mesh's up axis.
	var scale: float
	## Ratio of its height to the mesh's, without that scale.
	var ratio: float


## Returns the visible multimesh instances.
func drawn_instances() -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	for one: Dictionary in DrawingRecord.get_instances():
		if one["visible"] and not one["buffer"].is_empty():
			found.append(one)
	return found


## Returns all plants of an instance, by rank.
func plants_of(instance: Dictionary) -> Array[DrawnPlant]:
	var buffer: PackedFloat32Array = instance["buffer"]
	var found: Array[DrawnPlant] = []
	for at in range(0, buffer.size(), STRIDE):
		var plant := DrawnPlant.new()
		plant.root = Vector3(buffer[at + 3], buffer[at + 7], buffer[at + 11])
		plant.scale = buffer[at + 5]
		plant.texel = int(buffer[at + 12]) - HALVES_COUNT_FROM
		plant.layer = int(buffer[at + 13]) - HALVES_COUNT_FROM
		plant.rank = buffer[at + 14]
		plant.ratio = buffer[at + 15]
		found.append(plant)
	return found


## Returns each plant of the visible instances once, by its root. A plant has the same texel at all
## levels.
func drawn_plants() -> Dictionary[Vector3, DrawnPlant]:
	var found: Dictionary[Vector3, DrawnPlant] = {}
	for instance in drawn_instances():
		for plant in plants_of(instance):
			found[plant.root] = plant
	return found


## Returns the bytes of the layers of the only texture with several.
func poses() -> Array:
	for layers: Array in DrawingRecord.get_textures().values():
		if layers.size() > 1:
			return layers
	return []


## Returns the bytes of the texture with four floats per row of [method poses].
func beats(layer_count: int) -> PackedByteArray:
	for layers: Array in DrawingRecord.get_textures().values():
		if layers.size() == 1 and layers[0].size() == SIDE * layer_count * 16:
			return layers[0]
	return PackedByteArray()


## Returns the drawn share of each plant's own height, by its root. Hidden plants are not included.
func drawn_shares() -> Dictionary[Vector3, float]:
	var layers := poses()
	var rows := beats(layers.size())
	var shares: Dictionary[Vector3, float] = {}
	for plant: DrawnPlant in drawn_plants().values():
		if is_hidden(layers, plant):
			continue
		var row := plant.layer * SIDE + plant.texel / SIDE
		var heights := int(rows.decode_float(16 * row + 12))
		var lost := 0.0 if heights < 0 else half(layers, heights, plant.texel, 0)
		shares[plant.root] = 1.0 + lost
	return shares


func is_hidden(layers: Array, plant: DrawnPlant) -> bool:
	return half(layers, plant.layer, plant.texel, 0) == HIDDEN


## Returns one of the four numbers of a texel.
func half(layers: Array, layer: int, texel: int, channel: int) -> float:
	return layers[layer].decode_half(texel * TEXEL_BYTES + 2 * channel)


## Returns tulips of one mesh on level ground, at rest.
func make_field(side: float, density: float) -> PlantField3D:
	var made := PlantField3D.from_species([TulipFunction.new()])
	made.size = Vector2(side, side)
	made.density = density
	made.wind = PlantWind.new()
	made.wind.strength = 0.0
	return made
