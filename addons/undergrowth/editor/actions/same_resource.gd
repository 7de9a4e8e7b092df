@tool
extends RefCounted
## Compares the values of two resources, regardless of their files.

## Properties of a resource's location, which do not count.
const NOT_COMPARED: Array[StringName] = [
	&"script", &"resource_path", &"resource_name", &"resource_scene_unique_id"
]


## True if both are the same object, or embedded and equal.
static func are_equal(a: Resource, b: Resource) -> bool:
	if a == b:
		return true
	if not a or not b:
		return false
	if a.get_class() != b.get_class() or a.get_script() != b.get_script():
		return false
	return a.is_built_in() and b.is_built_in() and has_equal_properties(a, b)


## True if all saved values of both are equal.
static func has_equal_properties(a: Resource, b: Resource) -> bool:
	for property: Dictionary in a.get_property_list():
		var name: StringName = property["name"]
		if not property["usage"] & PROPERTY_USAGE_STORAGE or name in NOT_COMPARED:
			continue
		if not _is_equal_value(a.get(name), b.get(name)):
			return false
	return true


static func _is_equal_value(a: Variant, b: Variant) -> bool:
	if a is Resource and b is Resource:
		return are_equal(a as Resource, b as Resource)
	if a is Array and b is Array:
		return _is_equal_list(a as Array, b as Array)
	if typeof(a) != typeof(b):
		return false
	# A setter can change the last bit of an angle.
	if a is float:
		return is_equal_approx(a as float, b as float)
	return a == b or (a is Vector2 and (a as Vector2).is_equal_approx(b as Vector2))


static func _is_equal_list(a: Array, b: Array) -> bool:
	if a.size() != b.size():
		return false
	for i in a.size():
		if not _is_equal_value(a[i], b[i]):
			return false
	return true
