## Resources of C++ classes: saved and loaded properties, defaults, reverts, groups, enums.
extends "res://tests/engine/harness.gd"

const FILE := "user://probe_resource.tres"


func test_a_resource_is_saved_and_loaded() -> void:
	var saved := ProbeResource.new()
	saved.kind = ProbeResource.KIND_ROUND
	saved.count = 7
	saved.ratio = 0.125
	saved.label = "läbel"
	saved.tint = Color(0.5, 0.25, 0.75, 0.5)
	saved.curve = Curve.new()
	saved.curve.add_point(Vector2(0.5, 1.0))
	saved.points = PackedVector3Array([Vector3(1, 2, 3), Vector3.UP])
	check_equal(ResourceSaver.save(saved, FILE), OK)
	var loaded: ProbeResource = ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE)
	for property: String in ["kind", "count", "ratio", "label", "tint", "points"]:
		check_equal(loaded.get(property), saved.get(property), property)
	check_equal(loaded.curve.point_count, 1)
	DirAccess.remove_absolute(FILE)


func test_defaults_are_the_values_of_a_new_object() -> void:
	check_equal(ClassDB.class_get_property_default_value("ProbeResource", "count"), 3)
	check_equal(ClassDB.class_get_property_default_value("ProbeResource", "label"), "none")


func test_reverts_use_the_class() -> void:
	var resource := ProbeResource.new()
	check(resource.property_can_revert("label"), "the label")
	check_equal(resource.property_get_revert("label"), "reverted")
	check(not resource.property_can_revert("no_such_property"), "nothing else")


func test_setters_emit_signals_and_print_errors() -> void:
	var resource := ProbeResource.new()
	var changes: Array = []
	resource.changed.connect(changes.append.bind(1))
	resource.count = 5
	check_equal(changes.size(), 1)
	resource.count = -1
	check_error("The count must not be negative.")
	check_equal(resource.count, 5)


func test_properties_are_validated() -> void:
	var resource := ProbeResource.new()
	check(_property(resource, "points")["usage"] & PROPERTY_USAGE_EDITOR > 0, "shown")
	resource.kind = ProbeResource.KIND_ROUND
	check(_property(resource, "points")["usage"] & PROPERTY_USAGE_EDITOR == 0, "hidden")


func test_properties_have_groups_and_hints() -> void:
	var resource := ProbeResource.new()
	check(_property(resource, "Numbers")["usage"] & PROPERTY_USAGE_GROUP > 0, "a group")
	check(_property(resource, "Parts")["usage"] & PROPERTY_USAGE_SUBGROUP > 0, "a subgroup")
	check_equal(_property(resource, "count")["hint_string"], "0,10,1")
	check_equal(_property(resource, "curve")["class_name"], &"Curve")


func test_enums_are_bound_by_name() -> void:
	check("Kind" in ClassDB.class_get_enum_list("ProbeResource", true), "Kind")
	check(ClassDB.is_class_enum_bitfield("ProbeResource", "Parts"), "Parts are flags")
	check_equal(ClassDB.class_get_integer_constant("ProbeResource", "KIND_ROUND"), 5)
	var kind: ProbeResource.Kind = ProbeResource.KIND_ROUND
	check_equal(int(kind), 5)


func test_virtuals_of_the_engine_return_values() -> void:
	check_equal(ProbeResource.new().get_rid().get_id(), 77)


func test_a_duplicate_is_independent() -> void:
	var resource := ProbeResource.new()
	resource.points = PackedVector3Array([Vector3.UP])
	var copy: ProbeResource = resource.duplicate()
	copy.points = PackedVector3Array()
	check_equal(resource.points.size(), 1)
	check_equal(copy.label, "none")


func _property(resource: Resource, title: String) -> Dictionary:
	for property in resource.get_property_list():
		if property["name"] == title:
			return property
	return {}
