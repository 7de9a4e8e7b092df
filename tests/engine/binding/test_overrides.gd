## Methods of C++ classes that scripts override: each type of argument and result.
extends "res://tests/engine/harness.gd"


class Full:
	extends ProbeResource
	var notes: PackedStringArray = []

	func _get_flag(flag: bool) -> bool:
		return not flag

	func _get_count(count: int) -> int:
		return count * 2

	func _get_ratio(ratio: float) -> float:
		return ratio / 2.0

	func _get_width(width: float) -> float:
		return width + 0.25

	func _get_label(label: String) -> String:
		return label + "!"

	func _get_tint(tint: Color) -> Color:
		return tint.inverted()

	func _get_direction(from: Vector3, scale: float) -> Vector3:
		return from * scale

	func _get_points(points: PackedVector3Array) -> PackedVector3Array:
		points.append(Vector3.ONE)
		return points

	func _get_resource(random: RandomNumberGenerator) -> Resource:
		var made := Resource.new()
		made.resource_name = str(random.seed)
		return made

	func _get_node(node: Node) -> Node:
		return node.get_child(0) if node else null

	func _get_anything() -> Variant:
		return {"a": 1}

	func _note(text: String) -> void:
		notes.append(text)


## Without types, because the engine does not accept wrong ones.
class Wrong:
	extends ProbeResource

	func _get_count(_count):
		return Vector3.ONE

	func _get_label(_label):
		return null

	func _get_points(_points):
		return "points"

	func _get_resource(_random):
		return 5

	func _get_node(_node):
		return Resource.new()


func test_without_a_script_the_caller_gets_its_own_answer() -> void:
	var plain := ProbeResource.new()
	check_equal(plain.ask_count(4), 4)
	check_equal(plain.ask_label("l"), "l")
	check_equal(plain.ask_anything(), "nothing")
	check(plain.ask_resource(null) == null, "no resource")
	check(not plain.note("n"), "none notes")
	check(not plain.is_count_overridden(), "not overridden")


func test_numbers_pass_both_ways() -> void:
	var full := Full.new()
	check_equal(full.ask_flag(true), false)
	check_equal(full.ask_flag(false), true)
	check_equal(full.ask_count(-21), -42)
	check_equal(full.ask_ratio(0.3), 0.15)
	check_equal(full.ask_width(0.5), 0.75)
	check(full.is_count_overridden(), "overridden")


func test_values_pass_both_ways() -> void:
	var full := Full.new()
	check_equal(full.ask_label("grün"), "grün!")
	check_equal(full.ask_tint(Color(0.25, 0.5, 1.0)), Color(0.75, 0.5, 0.0))
	check_equal(full.ask_direction(Vector3(1, 2, 3), 2.0), Vector3(2, 4, 6))
	check_equal(full.ask_anything(), {"a": 1})
	check(full.note("first") and full.note("second"), "the script was called")
	check_equal(full.notes, PackedStringArray(["first", "second"]))


func test_packed_arrays_are_copied() -> void:
	var given := PackedVector3Array([Vector3.UP])
	check_equal(Full.new().ask_points(given), PackedVector3Array([Vector3.UP, Vector3.ONE]))
	check_equal(given.size(), 1, "the given array's size")


func test_references_keep_their_count() -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 12
	var full := Full.new()
	for i in 3:
		var made := full.ask_resource(random)
		check_equal(made.resource_name, "12")
		check_equal(made.get_reference_count(), 1)
	check_equal(random.get_reference_count(), 1)


func test_objects_pass_both_ways() -> void:
	var parent := Node.new()
	var child := ProbeNode.new()
	parent.add_child(child)
	var full := Full.new()
	check(full.ask_node(parent) == child, "the child")
	check(full.ask_node(null) == null, "null")
	parent.free()


func test_results_of_the_wrong_type_arrive_empty() -> void:
	var wrong := Wrong.new()
	check_equal(wrong.ask_count(4), 0)
	check_equal(wrong.ask_label("l").length() < 7, true, "an empty label, or the text of null")
	check_equal(wrong.ask_points(PackedVector3Array([Vector3.UP])), PackedVector3Array())
	check(wrong.ask_resource(RandomNumberGenerator.new()) == null, "no resource")
	check(wrong.ask_node(null) == null, "no node")


func test_overridable_methods_are_listed() -> void:
	var found := 0
	for method in ClassDB.class_get_method_list("ProbeResource", true):
		if method["name"] == "_get_direction":
			found += 1
			check(method["flags"] & METHOD_FLAG_VIRTUAL > 0, "virtual")
			check_equal(method["args"][1]["name"], "scale")
			check_equal(method["args"][0]["type"], TYPE_VECTOR3)
			check_equal(method["return"]["type"], TYPE_VECTOR3)
	check_equal(found, 1)
