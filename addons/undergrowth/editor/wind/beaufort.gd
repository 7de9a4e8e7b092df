@tool
extends RefCounted
## Beaufort's scale in words.

const Translations := preload("../translations/translations.gd")


## Returns the number and the description of a wind of [constant PlantWind.KIND_AIR].
static func describe(wind: PlantWind) -> String:
	return "%d · %s" % [wind.get_beaufort(), _words()[wind.get_beaufort()]]


static func _words() -> PackedStringArray:
	return [
		Translations.text("Calm"),
		Translations.text("Light air"),
		Translations.text("Light breeze"),
		Translations.text("Gentle breeze"),
		Translations.text("Moderate breeze"),
		Translations.text("Fresh breeze"),
		Translations.text("Strong breeze"),
		Translations.text("Near gale"),
		Translations.text("Gale"),
		Translations.text("Strong gale"),
		Translations.text("Storm"),
		Translations.text("Violent storm"),
		Translations.text("Hurricane"),
	]
