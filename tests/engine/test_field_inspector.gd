## The inspector shows only the properties of a field that have an effect.
extends "res://tests/engine/harness.gd"

var _field: PlantField3D


func before_each() -> void:
	_field = PlantField3D.new()


func after_each() -> void:
	_field.free()


func test_the_inspector_shows_what_counts_for_the_ground() -> void:
	check_equal(
		_shown_of(["ground_collision_mask", "ground_mesh", "slope_alignment", "height_limits"]), []
	)
	_field.ground_mode = PlantField3D.GROUND_COLLIDERS
	check_equal(
		_shown_of(["ground_collision_mask", "ground_mesh", "slope_alignment", "slope_limits"]),
		["ground_collision_mask", "slope_limits", "slope_alignment"]
	)
	_field.ground_mode = PlantField3D.GROUND_MESH
	check_equal(_shown_of(["ground_collision_mask", "ground_mesh"]), ["ground_mesh"])


func test_the_inspector_shows_a_size_where_no_path_is_the_outline() -> void:
	check_equal(_shown_of(["size", "outline"]), ["size", "outline"])
	_field.outline = NodePath("Area")
	check_equal(_shown_of(["size", "outline"]), ["outline"])


func test_the_inspector_shows_a_falloff_where_a_field_has_edges() -> void:
	check_equal(_shown_of(["edge_falloff"]), ["edge_falloff"])
	_field.map = PlantMap.new()
	check_equal(_shown_of(["edge_falloff"]), [], "a painted field")
	_field.exclusions = [NodePath("Road")]
	check_equal(_shown_of(["edge_falloff"]), ["edge_falloff"], "a painted field with a road")


func test_what_is_not_shown_is_saved_all_the_same() -> void:
	for property: Dictionary in _field.get_property_list():
		if property["name"] == "ground_collision_mask":
			check(property["usage"] & PROPERTY_USAGE_STORAGE != 0, "it is stored")


func test_the_inspector_groups_what_a_species_is_and_offers_both_kinds_of_material() -> void:
	var groups := {}
	var group := ""
	for property: Dictionary in TulipFunction.new().get_property_list():
		if property["usage"] & PROPERTY_USAGE_GROUP != 0:
			group = property["name"]
		groups[property["name"]] = group
		if property["name"] == "material":
			check_equal(property["hint_string"], "BaseMaterial3D,ShaderMaterial", "materials")
	check_equal(groups["shading"], "Look", "group of shading")
	check_equal(groups["material"], "Look", "group of material")
	check(groups["mass"] != "Look", "mass is not in the group Look")


## Returns those of these properties that the inspector shows, in its order.
func _shown_of(names: Array[String]) -> Array:
	var shown := []
	for property: Dictionary in _field.get_property_list():
		if property["name"] in names and property["usage"] & PROPERTY_USAGE_EDITOR != 0:
			shown.append(property["name"])
	return shown
