@tool
extends RefCounted
## How a field of one species begins: as dense, as large and as uneven as suits its plants.

## Plants of one metre stand so densely that they cover the ground, a square metre; others by their
## height, and no closer than their breadth allows.
const DENSITY_AT_ONE_METRE := 18.0
const HEIGHT_POWER := 1.1
## Times a plant's breadth squared: how many overlap.
const OVERLAP := 4.0
const LEAST_DENSITY := 0.5
const MOST_DENSITY := 400.0
## What is dense gets a smaller field, down to so many metres.
const MOST_PLANTS := 12000.0
const LEAST_SIDE := 5.0
## Radians. Plants of a field that stand quite upright look like a brush.
const LEAN := 0.09
const SEEDS := 3
## Enough to measure a plant.
const SEGMENTS := 6


## A field of [param function], which can be built, without a name and without wind.
static func make_field(function: PlantFunction) -> PlantField3D:
	var field := PlantField3D.from_species([function])
	field.density = find_density(function)
	var side := sqrt(MOST_PLANTS / field.density)
	if side < field.size.x:
		field.size = Vector2.ONE * maxf(floorf(side), LEAST_SIDE)
	field.species = [make_entry(function)]
	return field


## An entry of [param function] for a field: its plants lean a little, unless they lean by themselves.
static func make_entry(function: PlantFunction) -> PlantFieldSpecies:
	var entry := PlantFieldSpecies.of(function)
	if function.law != PlantFunction.LAW_ELASTICITY:
		entry.lean_deviation = LEAN
	return entry


## Plants per square metre that cover the ground: many of a lawn, few reeds, fewer broad ferns.
static func find_density(function: PlantFunction) -> float:
	var size := _measure(function)
	var by_height := DENSITY_AT_ONE_METRE / pow(size.y, HEIGHT_POWER)
	var by_breadth := OVERLAP / (size.x * size.x)
	var density := clampf(minf(by_height, by_breadth), LEAST_DENSITY, MOST_DENSITY)
	return snappedf(density, 0.5 if density < 10.0 else 5.0)


# Breadth and height of a plant in metres, the mean of a few.
static func _measure(function: PlantFunction) -> Vector2:
	var sum := Vector2.ZERO
	for i in SEEDS:
		var size := function.generate_mesh(0.0, SEGMENTS, i + 1).get_aabb().size
		sum += Vector2((size.x + size.z) * 0.5, size.y)
	return (sum / SEEDS).maxf(1e-3)
