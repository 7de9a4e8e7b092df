@tool
extends RefCounted
## One species more for a field that grows others. It becomes as dense as suits its plants, and
## nothing of the others is thinned out for it: the field's density grows by as much.

const FieldDefaults := preload("field_defaults.gd")
const SameResource := preload("same_resource.gd")

## What a field has room for without waiting long, and without being refused.
const MOST_PLANTS := 2.0e6


## The entry of [param field] that grows [param function] already, or what equals it; else null.
static func find(field: PlantField3D, function: PlantFunction) -> PlantFieldSpecies:
	for entry in field.species:
		if entry and entry.species and SameResource.are_equal(entry.species, function):
			return entry
	return null


## An entry of [param function] for [param field], which has none of it, with a layer of its own.
static func make(field: PlantField3D, function: PlantFunction) -> PlantFieldSpecies:
	var entry := FieldDefaults.make_entry(function)
	var own := entry.get_layer_name()
	var taken := layers_of(field)
	var number := 2
	while entry.get_layer_name() in taken:
		entry.layer = "%s %d" % [own, number]
		number += 1
	return entry


## Adds [param entry]; its share follows from the density that suits it.
static func add(field: PlantField3D, entry: PlantFieldSpecies) -> void:
	field.density = suit(field, entry)
	field.species = field.species + ([entry] as Array[PlantFieldSpecies])


## Gives [param entry] the share that suits its plants beside those of [param field]. The density
## that the field then needs, so that the others stay as dense as they are.
static func suit(field: PlantField3D, entry: PlantFieldSpecies) -> float:
	var wanted := minf(FieldDefaults.find_density(entry.species), _room_of(field))
	var shares := 0.0
	for other in field.species:
		shares += other.weight if other and other.species else 0.0
	if field.density <= 0.0:
		return wanted
	if shares <= 0.0:
		return field.density
	entry.weight = shares * wanted / field.density
	return field.density + wanted


## The names by which a map knows what [param field] grows.
static func layers_of(field: PlantField3D) -> PackedStringArray:
	var names: PackedStringArray = []
	for entry in field.species:
		var title := entry.get_layer_name() if entry else ""
		if title and not title in names:
			names.append(title)
	return names


# How much denser it may become.
static func _room_of(field: PlantField3D) -> float:
	var area := field.size.x * field.size.y
	if field.map:
		area = maxf(area, field.map.get_painted_rect().get_area())
	return maxf(MOST_PLANTS / maxf(area, 1.0) - field.density, FieldDefaults.LEAST_DENSITY)
