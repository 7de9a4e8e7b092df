@tool
extends RefCounted
## The subject of a small picture: one plant of a species, or a group of plants of a mix.

const Traits := preload("../inspector/species_traits.gd")
const PLANT_SEED := 1
const SEGMENTS := 16
## Segments of a plant in a group.
const SEGMENTS_AMONG_OTHERS := 9
## Number of plants of a mix, and of different plants per species.
const COUNT := 24
const VARIANTS := 2
## Radius of the group, as a factor of the tallest plant's height.
const SPREAD := 0.55
## Direction of the next plant from the middle, never beside the previous one.
const GOLDEN_ANGLE := 2.399963
## Minimum breadth of a drawn stalk, as a fraction of its height.
const MIN_BREADTH := 0.2
const MAX_WIDENING := 3.5
## Minimum half-width of drawn thin parts, as a fraction of the plant's size.
const MIN_HALF_WIDTH := 0.008
const MAX_PART_WIDENING := 5.0
## CUSTOM2 has four numbers.
const WAY_SIZE := 4
const CUSTOM_FORMATS := 0xfff << Mesh.ARRAY_FORMAT_CUSTOM0_SHIFT


## Returns a node with the subject of a picture of [param sitter], or null if the build fails.
## [param sitter] is a [PlantFunction] or a [PlantField3D].
static func make(sitter: Object) -> Node3D:
	if sitter is PlantFunction:
		return _make_plant(sitter as PlantFunction)
	return _make_mix(sitter as PlantField3D) if sitter is PlantField3D else null


## Returns the bounding box of [param group] from [method make].
static func measure(group: Node3D) -> AABB:
	var box := AABB()
	for plant: MeshInstance3D in group.get_children():
		var own := plant.transform * plant.mesh.get_aabb()
		box = own if plant.get_index() == 0 else box.merge(own)
	return box


## Returns the height of the tallest species of [param field], in metres.
static func find_tallest(field: PlantField3D) -> float:
	var tallest := 0.0
	for listed in _grown(field):
		var mesh := build(listed.species, SEGMENTS_AMONG_OTHERS, PLANT_SEED)
		tallest = maxf(tallest, mesh.get_aabb().end.y * _scale_of(listed))
	return tallest


static func _make_plant(function: PlantFunction) -> Node3D:
	if not _can_build(function):
		return null
	var mesh := build(function, SEGMENTS, PLANT_SEED)
	var size := mesh.get_aabb().size
	var wider := 1.0
	if not Traits.has_parts(function) and not Traits.has_models(function):
		var breadth := maxf(maxf(size.x, size.z), 1e-6)
		wider = clampf(MIN_BREADTH * size.y / breadth, 1.0, MAX_WIDENING)
	var group := Node3D.new()
	_add(group, mesh, Transform3D(Basis.from_scale(Vector3(wider, 1.0, wider))))
	return group


static func _make_mix(field: PlantField3D) -> Node3D:
	var grown := _grown(field)
	var tallest := find_tallest(field)
	var meshes: Array[Array] = []
	for listed in grown:
		var variants: Array[Mesh] = []
		for i in VARIANTS:
			variants.append(build(listed.species, SEGMENTS_AMONG_OTHERS, PLANT_SEED + i))
		meshes.append(variants)
	if grown.is_empty():
		return null
	var group := Node3D.new()
	var order := _draw_order(grown)
	for i in COUNT:
		var turn := Basis(Vector3.UP, i * GOLDEN_ANGLE * 1.7)
		var away := SPREAD * tallest * sqrt(float(i) / COUNT)
		var place := Vector3.RIGHT.rotated(Vector3.UP, i * GOLDEN_ANGLE) * away
		var size := _scale_of(grown[order[i]])
		var mesh: Mesh = meshes[order[i]][i % VARIANTS]
		_add(group, mesh, Transform3D(turn.scaled(Vector3.ONE * size), place))
	return group


static func _grown(field: PlantField3D) -> Array[PlantFieldSpecies]:
	var grown: Array[PlantFieldSpecies] = []
	for listed in field.species:
		if listed and listed.species and _weight_of(listed) > 0.0 and _can_build(listed.species):
			grown.append(listed)
	return grown


# Returns the species of each plant: by their weights, with at least one plant of each.
static func _draw_order(grown: Array[PlantFieldSpecies]) -> PackedInt32Array:
	var sum := 0.0
	for listed in grown:
		sum += _weight_of(listed)
	var wanted := PackedFloat32Array()
	for listed in grown:
		wanted.append(maxf(_weight_of(listed) / sum * COUNT, 1.0))
	var order := PackedInt32Array()
	var had := PackedFloat32Array()
	had.resize(grown.size())
	for i in COUNT:
		var next := 0
		for kind in grown.size():
			if (
				wanted[kind] * (i + 1) / COUNT - had[kind]
				> wanted[next] * (i + 1) / COUNT - had[next]
			):
				next = kind
		had[next] += 1.0
		order.append(next)
	return order


static func _weight_of(listed: PlantFieldSpecies) -> float:
	return listed.weight * listed.density_factor


static func _scale_of(listed: PlantFieldSpecies) -> float:
	return (listed.scale_range.x + listed.scale_range.y) * 0.5


static func _can_build(function: PlantFunction) -> bool:
	return function.find_problem(0.0, SEGMENTS, PLANT_SEED).is_empty()


## Returns a mesh for small pictures: thin parts are wider than in the original.
static func build(function: PlantFunction, segments: int, plant_seed: int) -> Mesh:
	var mesh := function.generate_mesh(0.0, segments, plant_seed)
	return _widen_parts(mesh) if Traits.has_parts(function) else mesh


# A vertex stores its offset from the middle of its part.
static func _widen_parts(mesh: ArrayMesh) -> ArrayMesh:
	var arrays := mesh.surface_get_arrays(0)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var ways: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM2]
	var size := mesh.get_aabb().size
	var minimum := MIN_HALF_WIDTH * maxf(maxf(size.x, size.z), size.y)
	for i in points.size():
		var at := WAY_SIZE * i
		var way := Vector3(ways[at], ways[at + 1], ways[at + 2])
		var wider := clampf(minimum / maxf(way.length(), 1e-6), 1.0, MAX_PART_WIDENING)
		points[i] += way * (wider - 1.0)
	arrays[Mesh.ARRAY_VERTEX] = points
	var widened := ArrayMesh.new()
	var format := mesh.surface_get_format(0) & CUSTOM_FORMATS
	widened.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {}, format)
	widened.surface_set_material(0, mesh.surface_get_material(0))
	return widened


static func _add(group: Node3D, mesh: Mesh, place: Transform3D) -> void:
	var shown := MeshInstance3D.new()
	shown.mesh = mesh
	shown.transform = place
	group.add_child(shown)
