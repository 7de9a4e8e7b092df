@tool
extends RefCounted
## Converts titles of plants to names of files, nodes and classes.
##
## It removes accents and replaces spaces with underscores, so that a file has the same name on
## every system. Letters of other scripts stay.

const CLASS_ENDING := "Function"
const MAX_LENGTH := 64
## Base letters, and the letters they replace.
const BASE_LETTERS: Dictionary[String, String] = {
	"a": "àáâãäåāăą",
	"c": "çćĉċč",
	"d": "ďđð",
	"e": "èéêëēĕėęě",
	"g": "ĝğġģ",
	"h": "ĥħ",
	"i": "ìíîïĩīĭįı",
	"j": "ĵ",
	"k": "ķ",
	"l": "ĺļľŀł",
	"n": "ñńņňŋ",
	"o": "òóôõöøōŏő",
	"r": "ŕŗř",
	"s": "śŝşšș",
	"t": "ţťŧț",
	"u": "ùúûüũūŭůűų",
	"w": "ŵ",
	"y": "ýÿŷ",
	"z": "źżž",
	"ss": "ß",
	"ae": "æ",
	"oe": "œ",
	"th": "þ",
}


## Returns the stem of a file: "Šaš uz rijeku" becomes "sas_uz_rijeku". Empty if no letter remains.
static func to_stem(title: String) -> String:
	var stem := ""
	for letter in _without_accents(title.strip_edges().to_lower()):
		stem += letter if _is_letter_or_digit(letter) else "_"
	while stem.contains("__"):
		stem = stem.replace("__", "_")
	return stem.lstrip("_").left(MAX_LENGTH).rstrip("_")


## Returns the class name of a species: "Šaš uz rijeku" becomes "SasUzRijekuFunction".
static func to_class_title(title: String) -> String:
	var words := to_stem(title.strip_edges().trim_suffix(CLASS_ENDING).to_snake_case())
	return "" if words.is_empty() else words.to_pascal_case() + CLASS_ENDING


## Returns the name of a node as the editor names them: "Meadow Grass" becomes "MeadowGrass".
static func to_node_name(title: String) -> String:
	var name := ""
	var begins := true
	for letter in title:
		var is_kept := _is_letter_or_digit(letter)
		name += (letter.to_upper() if begins else letter) if is_kept else ""
		begins = not is_kept
	return name if not name.is_empty() else "Plant"


static func _without_accents(text: String) -> String:
	for base in BASE_LETTERS:
		for letter in BASE_LETTERS[base]:
			text = text.replace(letter, base)
	return text


static func _is_letter_or_digit(letter: String) -> bool:
	# An identifier must not start with a digit.
	return letter != "_" and ("a" + letter).is_valid_unicode_identifier()
