@tool
extends RefCounted
## The species of a mix in words.

const SpeciesEntry := preload("species_entry.gd")
const Translations := preload("../translations/translations.gd")


## Returns the titles of the species of [param field], and the percentage of each.
static func find_shares(field: PlantField3D) -> Array[Array]:
	var sum := 0.0
	for listed in field.species:
		sum += listed.weight * listed.density_factor
	var shares: Array[Array] = []
	for listed in field.species:
		var percent := 100.0 * listed.weight * listed.density_factor / sum
		shares.append([SpeciesEntry.title_of(listed.species), percent])
	return shares


## Returns one line per species of [param shares], as returned by [method find_shares].
static func describe(shares: Array[Array]) -> String:
	var lines: PackedStringArray = []
	for share in shares:
		var title: String = share[0]
		var percent: float = share[1]
		var number := String.num(percent, 0 if percent >= 1.0 else 1)
		lines.append("%s · %s %%" % [Translations.text(title), number])
	return "\n".join(lines)
