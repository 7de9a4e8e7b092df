## Plants of other add-ons, from files that the user has put beside. README.md says which.
extends RefCounted

## Metres of a side of a multimesh, so that the engine can cull.
const TILE := 5.0
const GODOT_GRASS := "res://assets/grass/"
## Metres: beyond it GodotGrass draws its coarse blade.
const GODOT_GRASS_NEAR := 40.0
const SIMPLE_GRASS := "res://addons/simplegrasstextured/grass.gd"
const SEED := 9


## Returns [param count] plants of the add-on [param kind] on a square.
static func make(kind: String, count: int, side: float) -> Node3D:
	var parent := Node3D.new()
	var tiles := maxi(roundi(side / TILE), 1)
	var random := RandomNumberGenerator.new()
	random.seed = SEED
	var left := count
	for i in tiles * tiles:
		var share := left / (tiles * tiles - i)
		left -= share
		var step := side / tiles
		var corner := Vector3(i % tiles, 0.0, i / tiles) * step - Vector3(side, 0.0, side) * 0.5
		var places := _scatter(random, share, step, kind == "simple_grass_textured")
		for node in _of(kind, places):
			node.position = corner
			parent.add_child(node)
	if kind == "godot_grass":
		RenderingServer.global_shader_parameter_set(&"heightmap_scale", 0.0)
		RenderingServer.global_shader_parameter_set(&"player_position", Vector3(0.0, -1e4, 0.0))
	return parent


static func _of(kind: String, places: Array[Transform3D]) -> Array[GeometryInstance3D]:
	if kind == "simple_grass_textured":
		var node: MultiMeshInstance3D = (load(SIMPLE_GRASS) as GDScript).new()
		node.multimesh = _instances(null, places)
		return [node]
	var near := _blades("grass_high.obj", places)
	near.visibility_range_end = GODOT_GRASS_NEAR
	var far := _blades("grass_low.obj", places)
	far.visibility_range_begin = GODOT_GRASS_NEAR
	return [near, far]


static func _blades(file: String, places: Array[Transform3D]) -> MultiMeshInstance3D:
	var node := MultiMeshInstance3D.new()
	node.multimesh = _instances(load(GODOT_GRASS + file), places)
	node.material_override = load(GODOT_GRASS + "mat_grass.tres")
	node.extra_cull_margin = 1.0
	return node


static func _instances(mesh: Mesh, places: Array[Transform3D]) -> MultiMesh:
	var made := MultiMesh.new()
	made.transform_format = MultiMesh.TRANSFORM_3D
	made.mesh = mesh
	made.instance_count = places.size()
	for i in places.size():
		made.set_instance_transform(i, places[i])
	return made


static func _scatter(
	random: RandomNumberGenerator, count: int, side: float, turns: bool
) -> Array[Transform3D]:
	var places: Array[Transform3D] = []
	for i in count:
		var basis := Basis(Vector3.UP, random.randf() * TAU) if turns else Basis.IDENTITY
		places.append(Transform3D(basis, Vector3(random.randf(), 0.0, random.randf()) * side))
	return places
