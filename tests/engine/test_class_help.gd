## Every class of the add-on and each of its members has a text in the help that F1 shows.
extends "res://tests/engine/harness.gd"

## Internal members of the library, which neither the editor nor a script shows.
const INTERNAL: Array[String] = ["DeferredError", "OldNameWarning"]
const CLASSES: PackedStringArray = [
	"PlantFunction",
	"PlantStem",
	"PlantPart",
	"PlantAxis",
	"PlantBlade",
	"PlantBead",
	"PlantArrangement",
	"PlantGrowth",
	"GrassFunction",
	"ReedFunction",
	"CattailFunction",
	"TulipFunction",
	"BellflowerFunction",
	"CurvePlantFunction",
	"MeshPlantFunction",
	"PlantWind",
	"PlantWindSource3D",
	"Plant3D",
	"PlantClimber3D",
	"PlantField3D",
	"PlantFieldSpecies",
	"PlantFieldLevel",
	"PlantHabitat",
	"PlantMap",
	"PlantSimulation",
]
## Relative to the tests' project in build/test, or to a project in the root folder.
const FOLDERS: PackedStringArray = [
	"../../../extension/doc_classes", "../../../../extension/doc_classes", "extension/doc_classes"
]
const SHORTEST_TEXT := 15
## Elements of the help that contain descriptions, by the element with the name.
const NAMED: PackedStringArray = ["method", "member", "signal", "constant"]


func test_every_class_is_described() -> void:
	for type in CLASSES:
		var help := _read(type)
		check_equal(help.get("inherits"), String(ClassDB.get_parent_class(type)), "base of " + type)
		_check_text(help, "brief_description", type)
		_check_text(help, "description", type)


func test_every_method_is_described() -> void:
	for type in CLASSES:
		var help := _read(type)
		var accessors := _accessors(type)
		for method in ClassDB.class_get_method_list(type, true):
			var method_name: String = method["name"]
			var is_virtual: bool = method["flags"] & METHOD_FLAG_VIRTUAL != 0
			var is_hidden := method_name.begins_with("_") and not is_virtual
			if not method_name in accessors and not is_hidden:
				_check_text(help, "method " + method_name, type)


func test_every_property_is_described() -> void:
	for type in CLASSES:
		var help := _read(type)
		for property in _properties(type):
			_check_text(help, "member " + property, type)


func test_every_signal_is_described() -> void:
	for type in CLASSES:
		var help := _read(type)
		check(help.size() > 0, type + " has help")
		for a_signal in ClassDB.class_get_signal_list(type, true):
			_check_text(help, "signal " + String(a_signal["name"]), type)


func test_every_constant_is_described() -> void:
	for type in CLASSES:
		var help := _read(type)
		for constant in ClassDB.class_get_integer_constant_list(type, true):
			_check_text(help, "constant " + constant, type)


func test_nothing_is_described_that_does_not_exist() -> void:
	for type in CLASSES:
		for key: String in _read(type):
			var words := key.split(" ")
			if words.size() == 2:
				check(_exists(type, words[0], words[1]), "%s has the %s" % [type, key])


func test_defaults_are_those_of_the_library() -> void:
	for type in CLASSES:
		var help := _read(type)
		check(help.size() > 0, type + " has help")
		for property in _properties(type, false):
			var reported: String = help.get("default of member " + property, "")
			var value: Variant = ClassDB.class_get_property_default_value(type, property)
			if not reported.is_empty() and value is float:
				check_near(reported.to_float(), value, 1e-4, "default of %s.%s" % [type, property])
			elif not reported.is_empty() and value != null:
				check_equal(reported, var_to_str(value), "default of %s.%s" % [type, property])


func test_every_class_of_the_library_is_listed_here() -> void:
	for type in ClassDB.get_class_list():
		var is_ours := ClassDB.class_get_api_type(type) == ClassDB.APIType.API_EXTENSION
		if is_ours and not type in INTERNAL:
			check(type in CLASSES, type + " is tested for help")


func _check_text(help: Dictionary, key: String, type: String) -> void:
	var text: String = help.get(key, "")
	check(text.length() >= SHORTEST_TEXT, "%s: %s is described" % [type, key])


func _properties(type: String, own_only := true) -> PackedStringArray:
	var names := PackedStringArray()
	for property in ClassDB.class_get_property_list(type, own_only):
		if not property["usage"] & (PROPERTY_USAGE_GROUP | PROPERTY_USAGE_CATEGORY):
			names.append(property["name"])
	return names


func _accessors(type: String) -> PackedStringArray:
	var names := PackedStringArray()
	for property in _properties(type):
		names.append(ClassDB.class_get_property_getter(type, property))
		names.append(ClassDB.class_get_property_setter(type, property))
	return names


func _exists(type: String, kind: String, member: String) -> bool:
	match kind:
		"method":
			var methods := ClassDB.class_get_method_list(type, true)
			return methods.any(
				func(method: Dictionary) -> bool: return String(method["name"]) == member
			)
		"member":
			return member in _properties(type, false)
		"signal":
			return ClassDB.class_has_signal(type, member)
	return ClassDB.class_has_integer_constant(type, member)


## Returns the help of a class: "kind name" → text for its members, "description" and similar keys
## for itself.
func _read(type: String) -> Dictionary:
	var parser := XMLParser.new()
	var help := {}
	if not _open(parser, type + ".xml"):
		check(false, "there is help for " + type)
		return help
	var key := ""
	while parser.read() == OK:
		match parser.get_node_type():
			XMLParser.NODE_ELEMENT:
				var element := parser.get_node_name()
				if element == "class":
					help["inherits"] = parser.get_named_attribute_value("inherits")
				elif element in NAMED:
					key = "%s %s" % [element, parser.get_named_attribute_value("name")]
					help[key] = ""
					if parser.has_attribute("default"):
						help["default of " + key] = parser.get_named_attribute_value("default")
				elif element in ["brief_description", "description"] and key.is_empty():
					key = element
			XMLParser.NODE_TEXT:
				if not key.is_empty():
					help[key] = help.get(key, "") + parser.get_node_data().strip_edges()
			XMLParser.NODE_ELEMENT_END:
				if parser.get_node_name() in NAMED or not " " in key:
					key = ""
	return help


func _open(parser: XMLParser, file: String) -> bool:
	for folder in FOLDERS:
		var path := ProjectSettings.globalize_path("res://").path_join(folder).simplify_path()
		if FileAccess.file_exists(path.path_join(file)):
			return parser.open(path.path_join(file)) == OK
	return false
