@tool
extends RefCounted
## Adds one species to a field of other species. Its density follows from its plants. The field's
## density increases by the same amount, so that the other species do not become sparser.

const FieldDefaults := preload("field_defaults.gd")
const SameResource := preload("same_resource.gd")

## Maximum number of plants for a short build without an error.
const MAX_PLANTS := 2.0e6


## Returns the entry of [param field] with [param function] or an equal one, or null.
static func find(field: PlantField3D, function: PlantFunction) -> PlantFieldSpecies:
	for entry in field.species:
		if entry and entry.species and SameResource.are_equal(entry.species, function):
			return entry
	return null


## Returns a new entry of [param function] with a layer that is not in [param taken].
static func make(function: PlantFunction, taken: PackedStringArray) -> PlantFieldSpecies:
	var entry := FieldDefaults.make_entry(function)
	var own := entry.get_layer_name()
	var number := 2
	while entry.get_layer_name() in taken:
		entry.layer = "%s %d" % [own, number]
		number += 1
	return entry


## Adds [param entry] with the weight for its density.
static func add(field: PlantField3D, entry: PlantFieldSpecies) -> void:
	field.density = suit(field, entry)
	field.species = field.species + ([entry] as Array[PlantFieldSpecies])


## Sets the weight of [param entry] for the density that suits its plants. Returns the field density
## that preserves the density of the other species.
static func suit(field: PlantField3D, entry: PlantFieldSpecies) -> float:
	var wanted := minf(FieldDefaults.find_density(entry.species), _room_of(field))
	var weights := 0.0
	for other in field.species:
		weights += other.weight if other and other.species else 0.0
	if field.density <= 0.0:
		return wanted
	if weights <= 0.0:
		return field.density
	entry.weight = weights * wanted / field.density
	return field.density + wanted


## Returns the map layers of the species of [param field].
static func layers_of(field: PlantField3D) -> PackedStringArray:
	var names: PackedStringArray = []
	for entry in field.species:
		var title := entry.get_layer_name() if entry else ""
		if title and not title in names:
			names.append(title)
	return names


# Maximum factor of the density.
static func _room_of(field: PlantField3D) -> float:
	var area := field.size.x * field.size.y
	if field.map:
		area = maxf(area, field.map.get_painted_rect().get_area())
	return maxf(MAX_PLANTS / maxf(area, 1.0) - field.density, FieldDefaults.MIN_DENSITY)
