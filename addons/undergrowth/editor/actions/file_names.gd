@tool
extends RefCounted
## Turns what people call a plant into names of files, nodes and classes.
##
## Accents are taken off and spaces become underscores, so that a file has the same name on every
## system. Letters of other scripts stay.

const CLASS_ENDING := "Function"
const MAX_LENGTH := 64
## Base letters, and what is written as them.
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


## The stem of a file: "Šaš uz rijeku" becomes "sas_uz_rijeku". Empty where nothing is left.
static func to_stem(title: String) -> String:
	var stem := ""
	for letter in _without_accents(title.strip_edges().to_lower()):
		stem += letter if _is_letter_or_digit(letter) else "_"
	while stem.contains("__"):
		stem = stem.replace("__", "_")
	return stem.lstrip("_").left(MAX_LENGTH).rstrip("_")


## The name of a species' class: "Šaš uz rijeku" becomes "SasUzRijekuFunction".
static func to_class_title(title: String) -> String:
	var words := to_stem(title.strip_edges().trim_suffix(CLASS_ENDING).to_snake_case())
	return "" if words.is_empty() else words.to_pascal_case() + CLASS_ENDING


## The name of a node: as people write it, without what Godot does not allow there.
static func to_node_name(title: String) -> String:
	var name := title.strip_edges().validate_node_name()
	return name if not name.is_empty() else "Plant"


static func _without_accents(text: String) -> String:
	for base in BASE_LETTERS:
		for letter in BASE_LETTERS[base]:
			text = text.replace(letter, base)
	return text


static func _is_letter_or_digit(letter: String) -> bool:
	# A digit may not begin an identifier, but may follow in one.
	return letter != "_" and ("a" + letter).is_valid_unicode_identifier()
