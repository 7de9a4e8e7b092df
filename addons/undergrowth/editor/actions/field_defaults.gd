@tool
extends RefCounted
## Default density, size and variation of a field of one species, by the shape of its plants.

## Density of plants with a height of one metre: they cover the ground of one square metre. Other
## densities follow from height and are limited by breadth and by the area of leaves.
const DENSITY_AT_ONE_METRE := 18.0
const HEIGHT_POWER := 1.1
## Overlapping plants, in squares of a plant's breadth.
const OVERLAP := 4.0
## Maximum of the plants' area from above per area of ground. More layers of leaves hide each other.
const MAX_LAYERS := 2.0
const MIN_DENSITY := 0.5
const MAX_DENSITY := 400.0
## Plants of the whole field. A dense field is smaller, down to the minimum side in metres.
const MAX_PLANTS := 12000.0
const MIN_SIDE := 5.0
## Radians. Exactly upright plants make a field look like a brush.
const LEAN := 0.09
## Width of the soft border in heights of a plant, and its range in metres.
const FALLOFF := 1.5
const FALLOFF_RANGE := Vector2(0.2, 1.0)
const SEEDS := 3
## Segments that suffice to measure a plant.
const SEGMENTS := 6
const MIN_MEASURE := 1e-3


## Returns a field of [param function] that can be built, without a name and without wind.
static func make_field(function: PlantFunction) -> PlantField3D:
	var field := PlantField3D.from_species([function])
	var plant := _measure(function)
	field.density = _density_of(plant)
	var side := sqrt(MAX_PLANTS / field.density)
	if side < field.size.x:
		field.size = Vector2.ONE * maxf(floorf(side), MIN_SIDE)
	field.species = [make_entry(function)]
	var falloff := clampf(FALLOFF * plant.height, FALLOFF_RANGE.x, FALLOFF_RANGE.y)
	field.edge_falloff = snappedf(falloff, 0.1)
	return field


## Returns an entry of [param function] for a field. Its plants lean a little, unless the species
## has its own lean.
static func make_entry(function: PlantFunction) -> PlantFieldSpecies:
	var entry := PlantFieldSpecies.of(function)
	if function.law != PlantFunction.LAW_ELASTICITY:
		entry.lean_deviation = LEAN
	return entry


## Returns the plants per square metre that cover the ground: high for a lawn, lower for reeds,
## lowest for broad ferns.
static func find_density(function: PlantFunction) -> float:
	return _density_of(_measure(function))


static func _density_of(plant: Dictionary[StringName, float]) -> float:
	var by_height := DENSITY_AT_ONE_METRE / pow(plant.height, HEIGHT_POWER)
	var by_breadth := OVERLAP / (plant.breadth * plant.breadth)
	var by_layers := MAX_LAYERS / plant.area
	var density := clampf(minf(by_height, minf(by_breadth, by_layers)), MIN_DENSITY, MAX_DENSITY)
	return snappedf(density, 0.5 if density < 10.0 else 5.0)


# Means of a few plants: breadth and height (m), and area from above (m²).
static func _measure(function: PlantFunction) -> Dictionary[StringName, float]:
	var sum: Dictionary[StringName, float] = {&"breadth": 0.0, &"height": 0.0, &"area": 0.0}
	for i in SEEDS:
		var mesh := function.generate_mesh(0.0, SEGMENTS, i + 1)
		var size := mesh.get_aabb().size
		sum.breadth += (size.x + size.z) * 0.5
		sum.height += size.y
		sum.area += _area_from_above(mesh)
	for key in sum:
		sum[key] = maxf(sum[key] / SEEDS, MIN_MEASURE)
	return sum


# Sum over all triangles (m²). Closed parts count twice.
static func _area_from_above(mesh: ArrayMesh) -> float:
	var area := 0.0
	var faces := mesh.get_faces()
	for i in range(0, faces.size(), 3):
		area += absf((faces[i + 1] - faces[i]).cross(faces[i + 2] - faces[i]).y) * 0.5
	return area
