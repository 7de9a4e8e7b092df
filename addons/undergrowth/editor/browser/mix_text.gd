@tool
extends RefCounted
## The species of a mix in words.

const SpeciesEntry := preload("species_entry.gd")
const Translations := preload("../translations/translations.gd")


## Returns one line per species of [param mix], with its share of all plants. Null: an empty text.
static func describe(mix: PackedScene) -> String:
	var field := mix.instantiate() as PlantField3D if mix else null
	if not field:
		return ""
	var sum := 0.0
	for listed in field.species:
		sum += listed.weight * listed.density_factor
	var lines: PackedStringArray = []
	for listed in field.species:
		var percent := 100.0 * listed.weight * listed.density_factor / sum
		var title := SpeciesEntry.title_of(listed.species)
		var number := String.num(percent, 0 if percent >= 1.0 else 1)
		lines.append("%s · %s %%" % [Translations.text(title), number])
	field.free()
	return "\n".join(lines)
