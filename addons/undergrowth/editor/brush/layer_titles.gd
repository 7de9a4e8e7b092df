@tool
extends RefCounted
## Titles of a field's species for the map layers that they use: the same as in the dock.

const SpeciesEntry := preload("../browser/species_entry.gd")
const Translations := preload("../translations/translations.gd")


## Returns the title of the species of [param field] with the layer [param layer]. A layer that the
## user has named is its own title.
static func of(field: PlantField3D, layer: String) -> String:
	for entry in field.species if is_instance_valid(field) else []:
		if entry and entry.species and entry.layer.is_empty() and entry.get_layer_name() == layer:
			return of_species(entry.species)
	return layer


## Returns the titles of several layers, separated by commas.
static func join(field: PlantField3D, layers: PackedStringArray) -> String:
	var titles: PackedStringArray = []
	for layer in layers:
		titles.append(of(field, layer))
	return ", ".join(titles)


## Returns the title of [param species] in the editor's language.
static func of_species(species: PlantFunction) -> String:
	return Translations.text(SpeciesEntry.title_of(species))
