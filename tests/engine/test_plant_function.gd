## PlantFunction's properties: their ranges, signals, and saved values.
extends "res://tests/engine/harness.gd"

const PATH := "user://saved_function.tres"
## For properties in single precision.
const RELATIVE_TOLERANCE := 1e-6

## Properties of all functions, with values that differ from the defaults.
var _common := {
	"law": PlantFunction.LAW_ELASTICITY,
	"elasticity": 7.5,
	"inner_friction": 0.625,
	"stays_above_ground": false,
	"natural_frequency": 2.5,
	"damping_ratio": 0.5,
	"lean": deg_to_rad(30.0),
	"mass": 2.25,
	"wind_weight": 0.875,
	"collision_radius": 0.125,
	"shading": PlantFunction.SHADING_FLAT,
	"shape_deviation": 0.5,
	"color_deviation": 0.25,
}
## Numbers with their invalid values.
var _out_of_range := {
	"elasticity": [-1.0, 1.1e4],
	"inner_friction": [-0.1, 1.1e6],
	"natural_frequency": [0.0, -1.0, 1001.0],
	"damping_ratio": [-0.1, 101.0],
	"lean": [-0.01, deg_to_rad(80.1), 45.0],
	"mass": [0.0, -1.0, 1.1e6],
	"wind_weight": [-1.1, 1001.0],
	"collision_radius": [-0.1, 1001.0],
	"shape_deviation": [-0.1, 1.1],
	"color_deviation": [-0.1, 1.1],
}
var _changes := 0


func test_properties_keep_what_they_are_set_to() -> void:
	for species in _all_species():
		_change_all(species)
		_check_all_changed(species, species.get_class())


func test_numbers_as_written_come_back_as_written() -> void:
	var function := PlantFunction.new()
	function.mass = 0.3
	check_equal(function.mass, 0.3)


func test_angles_written_in_tenths_of_a_degree_come_back_as_written() -> void:
	var function := PlantFunction.new()
	for tenths in 801:
		var written := deg_to_rad(tenths / 10.0)
		function.lean = written
		check_equal(function.lean, written, "%.1f°" % (tenths / 10.0))
	function.lean = 0.5
	check_equal(function.lean, 0.5, "what was written in radians")


func test_an_angle_stays_what_it_is_however_often_it_is_saved() -> void:
	for tenths in range(1, 800, 7):
		var function := PlantFunction.new()
		function.lean = deg_to_rad(tenths / 10.0)
		ResourceSaver.save(function, PATH)
		var text := FileAccess.get_file_as_string(PATH)
		var loaded := ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
		check_equal((loaded as PlantFunction).lean, function.lean, "%.1f°" % (tenths / 10.0))
		ResourceSaver.save(loaded, PATH)
		check_equal(_without_uid(FileAccess.get_file_as_string(PATH)), _without_uid(text))
	DirAccess.remove_absolute(PATH)


func test_degrees_instead_of_radians_are_reported() -> void:
	PlantFunction.new().lean = 45.0
	check_error("lean cannot be 45.0 rad, which is 2578.3°")


func test_species_lean_by_whole_tenths_of_a_degree() -> void:
	check_equal(GrassFunction.new().lean, deg_to_rad(14.0))
	check_equal(ReedFunction.new().lean, deg_to_rad(3.5))
	check_equal(BellflowerFunction.new().lean, deg_to_rad(42.0))


func test_numbers_out_of_range_give_one_error_and_are_not_kept() -> void:
	var function := PlantFunction.new()
	for property: String in _out_of_range:
		var before: float = function.get(property)
		for value: float in _out_of_range[property] + [NAN, INF, -INF]:
			function.set(property, value)
			check_error(property + " cannot be ")
			check_equal(function.get(property), before, property)


func test_own_sizes_of_species_have_a_range() -> void:
	for species in _all_species():
		for property in _own_properties(species):
			if species.get(property) is float:
				var before: float = species.get(property)
				for value: float in [0.0, -1.0, NAN, INF, 1e6]:
					species.set(property, value)
					check_error(property + " cannot be ")
					check_equal(species.get(property), before, property)


func test_constants_that_do_not_exist_give_one_error() -> void:
	var function := PlantFunction.new()
	for value: int in [-1, 3, 1000, 1 << 32]:
		function.set("law", value)
		check_error("law %d does not exist" % value)
		function.set("shading", value)
		check_error("shading %d does not exist" % value)
	check_equal(function.law, PlantFunction.LAW_STEM)
	check_equal(function.shading, PlantFunction.SHADING_SMOOTH)


func test_each_change_is_signalled_once() -> void:
	for species in _all_species():
		species.changed.connect(_count_change)
		for property: String in _common:
			_check_signals(species, property, _another_of(species, property))
		for property in _own_properties(species):
			_check_signals(species, property, _another(species.get(property)))
		_check_signals(species, "material", StandardMaterial3D.new())


func test_refused_values_are_not_signalled() -> void:
	var function := PlantFunction.new()
	function.changed.connect(_count_change)
	_changes = 0
	function.mass = NAN
	function.shape_deviation = 2.0
	check_error("mass cannot be")
	check_error("shape_deviation cannot be")
	check_equal(_changes, 0)


func test_saved_functions_load_equal() -> void:
	for species in _all_species():
		_change_all(species)
		species.material = ShaderMaterial.new()
		check_equal(ResourceSaver.save(species, PATH), OK, "saving")
		var loaded: PlantFunction = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
		check_equal(loaded.get_class(), species.get_class())
		check(loaded.material is ShaderMaterial, "the material is kept")
		_check_all_changed(loaded, "loaded " + species.get_class())
		check_equal(_bytes(loaded), _bytes(species), "mesh of " + species.get_class())
	DirAccess.remove_absolute(PATH)


func test_defaults_are_not_saved() -> void:
	for species in _all_species():
		check_equal(ResourceSaver.save(species, PATH), OK, "saving")
		var text := FileAccess.get_file_as_string(PATH)
		check(not text.contains(" = "), "only defaults: " + text)
	DirAccess.remove_absolute(PATH)


func test_only_the_chosen_laws_numbers_are_shown() -> void:
	var function := PlantFunction.new()
	check(is_shown(function, "natural_frequency"), "the spring's frequency")
	check(not is_shown(function, "elasticity"), "no elasticity")
	function.law = PlantFunction.LAW_ELASTICITY
	check(not is_shown(function, "natural_frequency"), "no frequency")
	check(is_shown(function, "elasticity"), "the elasticity")


func test_meshes_use_the_functions_material() -> void:
	var tulip := TulipFunction.new()
	var standard := tulip.generate_mesh(1.0, 4).surface_get_material(0)
	check(standard is StandardMaterial3D, "a material of its own")
	check(standard.vertex_color_use_as_albedo, "which shows vertex colours")
	var grass := GrassFunction.new().generate_mesh(1.0, 4)
	check(grass.surface_get_material(0) == standard, "one for all plants")
	var own := ShaderMaterial.new()
	tulip.material = own
	check(tulip.generate_mesh(1.0, 4).surface_get_material(0) == own, "the user's own")
	tulip.material = null
	check(tulip.generate_mesh(1.0, 4).surface_get_material(0) == standard, "the first again")


func test_heights_need_a_random_number_generator() -> void:
	check_equal(TulipFunction.new().generate_height(null), 0.0)
	check_error("needs a RandomNumberGenerator")


func test_base_shapes_outside_the_lods_are_the_nearest() -> void:
	var tulip := TulipFunction.new()
	check_equal(tulip.get_base_shape(-5).size(), 4, "points")
	check_equal(tulip.get_base_shape(1000000).size(), 256, "points")


func _all_species() -> Array[PlantFunction]:
	return [
		PlantFunction.new(),
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new(),
	]


## Returns the properties that the species' own class adds to PlantFunction: colours and sizes.
func _own_properties(species: PlantFunction) -> PackedStringArray:
	var names := PackedStringArray()
	if species.get_class() == "PlantFunction":
		return names
	for property in ClassDB.class_get_property_list(species.get_class(), true):
		if property["usage"] & PROPERTY_USAGE_STORAGE:
			names.append(property["name"])
	check(not names.is_empty(), species.get_class() + " has properties of its own")
	return names


func _another(value: Variant) -> Variant:
	return Color(0.25, 0.5, 0.75, 0.5) if value is Color else 0.0625


func _change_all(species: PlantFunction) -> void:
	for property: String in _common:
		species.set(property, _common[property])
	for property in _own_properties(species):
		species.set(property, _another(species.get(property)))


func _check_all_changed(species: PlantFunction, label: String) -> void:
	for property: String in _common:
		check_equal(species.get(property), _common[property], "%s of %s" % [property, label])
	for property in _own_properties(species):
		var value: Variant = species.get(property)
		check_near(value, _another(value), RELATIVE_TOLERANCE, "%s of %s" % [property, label])


## Checks that a new [param value] is a change and an equal one is not.
func _check_signals(species: PlantFunction, property: String, value: Variant) -> void:
	for expected: int in [1, 0]:
		_changes = 0
		species.set(property, value)
		check_equal(_changes, expected, "signals for " + property)


## Returns a value of [param property] that differs from this species' own.
func _another_of(species: PlantFunction, property: String) -> Variant:
	var value: Variant = _common[property]
	if value != species.get(property):
		return value
	return 1 - value if value is int else not value if value is bool else value * 0.5


func _without_uid(text: String) -> String:
	return text.get_slice("[resource]", 1)


func _count_change() -> void:
	_changes += 1


func _bytes(species: PlantFunction) -> PackedByteArray:
	return var_to_bytes(species.generate_mesh(1.0, 8, 3).surface_get_arrays(0))
