@tool
extends RefCounted
## Default density, size and variation of a field of one species, by the shape of its plants.

## Density of plants with a height of one metre: they cover the ground of one square metre. Other
## densities follow from height and are limited by breadth.
const DENSITY_AT_ONE_METRE := 18.0
const HEIGHT_POWER := 1.1
## Overlapping plants, in squares of a plant's breadth.
const OVERLAP := 4.0
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


## Returns a field of [param function] that can be built, without a name and without wind.
static func make_field(function: PlantFunction) -> PlantField3D:
	var field := PlantField3D.from_species([function])
	field.density = find_density(function)
	var side := sqrt(MAX_PLANTS / field.density)
	if side < field.size.x:
		field.size = Vector2.ONE * maxf(floorf(side), MIN_SIDE)
	field.species = [make_entry(function)]
	var falloff := clampf(FALLOFF * _measure(function).y, FALLOFF_RANGE.x, FALLOFF_RANGE.y)
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
	var size := _measure(function)
	var by_height := DENSITY_AT_ONE_METRE / pow(size.y, HEIGHT_POWER)
	var by_breadth := OVERLAP / (size.x * size.x)
	var density := clampf(minf(by_height, by_breadth), MIN_DENSITY, MAX_DENSITY)
	return snappedf(density, 0.5 if density < 10.0 else 5.0)


# Mean breadth and height (m) of a few plants.
static func _measure(function: PlantFunction) -> Vector2:
	var sum := Vector2.ZERO
	for i in SEEDS:
		var size := function.generate_mesh(0.0, SEGMENTS, i + 1).get_aabb().size
		sum += Vector2((size.x + size.z) * 0.5, size.y)
	return (sum / SEEDS).maxf(1e-3)
