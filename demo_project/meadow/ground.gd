@tool
extends MeshInstance3D
## Gently rolling ground with a pond, as one generated mesh.
##
## The vertex colour's red channel says how wet the ground is: 1 in the pond, 0 where grass grows.

const WATER_LEVEL := 0.0
const POND_DEPTH := 0.6
const RIDGE_START := 16.0
const RIDGE_END := 70.0

## Half the side of the mesh.
@export_range(10.0, 400.0, 1.0, "suffix:m") var half_size := 160.0
## Squares along one side. They are small in the middle and grow outwards.
@export_range(16, 256) var squares := 128
## Middle of the pond.
@export var pond_center := Vector2(3.2, -4.0)
## Half the pond's length along x and z.
@export var pond_radii := Vector2(3.6, 2.6)
## How much the ground rolls.
@export_range(0.0, 3.0, 0.01, "suffix:m") var roll_height := 0.3

## The wind that runs over what grows here, seen where plants are too far to be seen one by one.
@export var wind: PlantWind

var _noise := FastNoiseLite.new()


func _init() -> void:
	_noise.seed = 5
	_noise.frequency = 0.09
	_noise.fractal_octaves = 3


func _ready() -> void:
	mesh = _make_mesh()


func _process(_delta: float) -> void:
	var material := material_override as ShaderMaterial
	if wind == null or material == null or Engine.is_editor_hint():
		return
	if wind.kind == PlantWind.KIND_AIR:
		wind.apply_to_material(material)
	else:
		material.set_shader_parameter(&"undergrowth_canopy_air", Vector4.ZERO)


# The mesh follows from the other properties: a scene that was saved in the editor does without it.
func _validate_property(property: Dictionary) -> void:
	if property.name == &"mesh":
		property.usage &= ~PROPERTY_USAGE_STORAGE


## Height of the ground (m) at a place of the scene.
func height_at(x: float, z: float) -> float:
	var away := Vector2(x, z).length()
	var ridge := smoothstep(RIDGE_START, RIDGE_END, away)
	var rolling := _noise.get_noise_2d(x, z) * roll_height
	var hills := (0.6 + _noise.get_noise_2d(x * 0.25 + 40.0, z * 0.25)) * ridge * 7.0
	return lerpf(WATER_LEVEL - POND_DEPTH, 0.38 + rolling + hills, dryness_at(x, z))


## 0 in the middle of the pond, 1 well away from its shore.
func dryness_at(x: float, z: float) -> float:
	var place := (Vector2(x, z) - pond_center) / pond_radii
	var wobble := _noise.get_noise_2d(x * 4.0, z * 4.0) * 0.25
	return smoothstep(0.5, 1.5, place.length() + wobble)


func _make_mesh() -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for row in squares + 1:
		for column in squares + 1:
			_add_vertex(tool, _coordinate(column), _coordinate(row))
	for row in squares:
		for column in squares:
			var corner := row * (squares + 1) + column
			for step: int in [0, 1, squares + 2, 0, squares + 2, squares + 1]:
				tool.add_index(corner + step)
	return tool.commit()


func _add_vertex(tool: SurfaceTool, x: float, z: float) -> void:
	const REACH := 0.1
	var slope_x := height_at(x + REACH, z) - height_at(x - REACH, z)
	var slope_z := height_at(x, z + REACH) - height_at(x, z - REACH)
	tool.set_normal(Vector3(-slope_x, 2.0 * REACH, -slope_z).normalized())
	tool.set_color(Color(1.0 - dryness_at(x, z), 0.0, 0.0))
	tool.add_vertex(Vector3(x, height_at(x, z), z))


func _coordinate(index: int) -> float:
	var share := 2.0 * index / squares - 1.0
	return half_size * lerpf(share * share * share, share, 0.12)
