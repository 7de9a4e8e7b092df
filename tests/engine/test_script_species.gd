## Species written in GDScript: optional methods, and the reports of their errors.
extends "res://tests/engine/harness.gd"

const WHOLE := """
func _get_base_shape(lod: int) -> PackedVector3Array:
	var points := PackedVector3Array()
	for i in lod:
		var angle := TAU * i / lod
		points.append(Vector3(-cos(angle), 0.0, sin(angle)) * 0.25)
	return points

func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(2.0, 3.0)

func _calculate_curve_point(offset: float) -> float:
	return 2.0 - offset

func _calculate_color_at_point(offset: float) -> Color:
	return Color(offset, 0.5, 0.0)
"""
const UNTYPED := """
func _get_base_shape(lod):
	return PackedVector3Array([Vector3(-1, 0, 0), Vector3(0, 0, 1), Vector3(1, 0, 0)])

func _generate_height(_rng):
	return 2

func _calculate_curve_point(_offset):
	return 1

func _calculate_color_at_point(_offset):
	return Color.RED
"""

var _plant: Plant3D
var _function: PlantFunction


func after_each() -> void:
	if _plant:
		_plant.free()
		_plant = null
	_function = null


func test_four_typed_overrides_make_a_species() -> void:
	_write(WHOLE)
	check_equal(_function.get_base_shape(7).size(), 7, "points")
	check_near(_function.calculate_curve_point(0.5), 1.5, 1e-6, "width")
	check_equal(_function.calculate_color_at_point(1.0), Color(1.0, 0.5, 0.0), "color")
	var mesh := _function.generate_mesh(0.0, 8, 4)
	var box := mesh.get_aabb()
	check(box.size.y >= 2.0 and box.size.y < 3.0, "its height, %f" % box.size.y)
	check_near(box.size.x, 1.0, 1e-5, "twice its radius of 0.5 at the ground")
	check_equal(mesh.surface_get_array_len(0), 9 * 9 + 16, "vertices")


func test_equal_seeds_give_equal_heights() -> void:
	_write(WHOLE)
	var first := _function.generate_mesh(0.0, 4, 9).get_aabb().size.y
	check_equal(_function.generate_mesh(0.0, 4, 9).get_aabb().size.y, first, "height")
	check(_function.generate_mesh(0.0, 4, 8).get_aabb().size.y != first, "another seed's")


func test_four_untyped_overrides_make_a_species() -> void:
	_write(UNTYPED)
	var mesh := _function.generate_mesh(0.0, 2)
	check_near(mesh.get_aabb().size.y, 2.0, 1e-6, "height from a whole number")
	check_equal(mesh.surface_get_array_len(0), 3 * 4 + 6, "vertices")
	check_equal(_function.calculate_curve_point(0.5), 1.0, "width from a whole number")


func test_a_script_may_override_one_method_of_a_ready_species() -> void:
	_write("func _calculate_curve_point(offset: float) -> float:\n\treturn 0.5\n", "TulipFunction")
	var tulip := TulipFunction.new()
	check_equal(_function.calculate_curve_point(0.9), 0.5, "its own width")
	check_equal(_function.calculate_color_at_point(0.9), tulip.calculate_color_at_point(0.9))
	check_equal(_function.get_base_shape(9), tulip.get_base_shape(9), "the tulip's shape")
	var box := _function.generate_mesh(0.0, 8, 3).get_aabb()
	check_near(box.size.x, 0.3, 1e-5, "its width is drawn")
	check_near(box.size.y, tulip.generate_mesh(0.0, 8, 3).get_aabb().size.y, 1e-6, "height")


func test_a_script_may_generate_meshes_of_itself() -> void:
	_write(WHOLE + "func twin() -> ArrayMesh:\n\treturn generate_mesh(1.0, 4)\n")
	var mesh: ArrayMesh = _function.call("twin")
	check_near(mesh.get_aabb().size.y, 1.0, 1e-6, "height")


func test_a_script_may_use_properties_and_signal_changes() -> void:
	_write(
		(
			"@export var width := 1.0:\n\tset(value):\n\t\twidth = value\n\t\temit_changed()\n"
			+ "func _calculate_curve_point(_offset: float) -> float:\n\treturn width\n"
		)
	)
	await _make_plant()
	var narrow := _plant.get_mesh().get_aabb().size.x
	_function.set("width", 2.0)
	await frames(2)
	check_near(_plant.get_mesh().get_aabb().size.x, 2.0 * narrow, 1e-5, "width")


func test_a_script_that_returns_nothing_is_reported_once() -> void:
	for method: String in _signatures():
		await _check_fault("func %s:\n\tpass\n" % method, "returned nothing")


func test_a_script_that_returns_the_wrong_type_is_reported_once() -> void:
	for method: String in _signatures():
		await _check_fault('func %s:\n\treturn "wide"\n' % method, "returned String")
	await _check_fault("func _get_base_shape(_lod):\n\treturn [Vector3.ZERO]\n", "returned Array")
	await _check_fault("func _calculate_curve_point(_offset):\n\treturn null\n", "returned nothing")


func test_a_script_that_raises_an_error_is_reported_once() -> void:
	for method: String in _signatures():
		var code := "func %s:\n\tvar nothing = null\n\treturn nothing.size\n" % method
		await _check_fault(code, "returned nothing", 1)


func test_a_typed_script_that_raises_an_error_is_reported_once() -> void:
	var raise := "\tvar nothing = null\n\treturn nothing.size\n"
	await _check_fault(
		"func _get_base_shape(_lod: int) -> PackedVector3Array:\n" + raise, "fewer than 3 points", 1
	)
	await _check_fault(
		"func _generate_height(_rng: RandomNumberGenerator) -> float:\n" + raise, "Return metres", 1
	)
	# It is called at each of the 13 rings. A single 0 would be valid.
	await _check_fault(
		"func _calculate_curve_point(_offset: float) -> float:\n" + raise, "gave 0 at every", 13
	)


func test_heights_out_of_range_are_reported_once() -> void:
	for value: String in ["NAN", "INF", "-1.0", "0.0", "1e9"]:
		await _check_fault("func _generate_height(_rng):\n\treturn %s\n" % value, "Plant")


func test_widths_out_of_range_are_reported_once() -> void:
	for value: String in ["NAN", "INF", "-INF", "-0.1", "1e9"]:
		var code := "func _calculate_curve_point(_offset):\n\treturn %s\n" % value
		await _check_fault(code, "_calculate_curve_point(0.0) gave")
	await _check_fault(
		"func _calculate_curve_point(offset):\n\treturn 1.0 if offset < 1.0 else -1.0\n",
		"_calculate_curve_point(1.0) gave -1"
	)


func test_colors_that_are_not_finite_are_reported_once() -> void:
	for value: String in ["Color(NAN, 0, 0)", "Color(0, INF, 0)", "Color(0, 0, 0, NAN)"]:
		var code := "func _calculate_color_at_point(_offset):\n\treturn %s\n" % value
		await _check_fault(code, "not finite")


func test_unusable_base_shapes_are_reported_once() -> void:
	var shapes := {
		"": "fewer than 3 points",
		"(0, 0, 0)": "fewer than 3 points",
		"(-1, 0, 0), (1, 0, 0)": "fewer than 3 points",
		"(-1, 0, 0), (0, 1, 1), (1, 0, 0)": "base shape",
		"(1, 0, 0), (0, 0, 1), (-1, 0, 0)": "clockwise",
		"(-1, 0, -1), (1, 0, 1), (1, 0, -1), (-1, 0, 1)": "base shape",
		"(0, 0, 0), (0, 0, 0), (0, 0, 0)": "base shape",
		"(-1, 0, 0), (0, 0, 0), (1, 0, 0)": "base shape",
		"(-1, 0, 0), (0, 0, NAN), (1, 0, 0)": "base shape",
		"(-1, 0, 0), (0, 0, INF), (1, 0, 0)": "base shape",
		"(-1e9, 0, 0), (0, 0, 1e9), (1e9, 0, 0)": "base shape",
	}
	for points: String in shapes:
		var vectors := points.replace("(", "Vector3(")
		var code := "func _get_base_shape(_lod):\n\treturn PackedVector3Array([%s])\n" % vectors
		await _check_fault(code, shapes[points])


func test_the_four_functions_report_errors_to_their_callers() -> void:
	_write("func _calculate_curve_point(_offset):\n\treturn []\n")
	check_equal(_function.calculate_curve_point(0.5), 0.0)
	check_error("returned Array")
	_write("func _get_base_shape(_lod):\n\tpass\n")
	check_equal(_function.get_base_shape(5).size(), 0)
	check_error("returned nothing")


func test_the_same_error_is_reported_once_for_many_builds() -> void:
	_write("func _generate_height(_rng):\n\treturn NAN\n")
	await _make_plant()
	for lod in range(1, 10):
		_plant.segments = lod
		await frames(1)
		_plant.rebuild()
		_plant.advance(0.1)
		_plant.apply_impulse(Vector3.RIGHT)
	check_error("_generate_height() gave nan")


func test_a_repaired_species_grows_again() -> void:
	_write("@export var bad := true\nfunc _generate_height(_rng):\n\treturn NAN if bad else 1.5\n")
	await _make_plant()
	check_error("_generate_height() gave nan")
	_function.set("bad", false)
	_function.emit_changed()
	await frames(2)
	check_near(_plant.get_plant_height(), 1.5, 1e-6, "height")
	_function.set("bad", true)
	_function.emit_changed()
	await frames(2)
	check_error("_generate_height() gave nan")


## Checks that a script with [param code] gives one error of the add-on with [param text], and
## [param raised] of the engine: for a mesh, and again for a plant of it. The plant stays the same,
## and later frames report nothing.
func _check_fault(code: String, text: String, raised := 0) -> void:
	_write(code)
	check(_function.generate_mesh(0.0, 12) == null, "no mesh of " + code)
	_check_messages(code, text, raised)
	var faulty := _function
	_function = TulipFunction.new()
	await _make_plant()
	var mesh := _plant.get_mesh()
	_plant.species = faulty
	await frames(10)
	check(_plant.get_mesh() == mesh, "the last good plant stays after " + code)
	check(_plant.get_skeleton() != null, "so does its skeleton")
	_check_messages(code, text, raised)
	_plant.free()


func _check_messages(code: String, text: String, raised: int) -> void:
	if raised > 0:
		check_error_count("Invalid access", raised)
	_errors.append_array(_listener.take())
	check_equal(_errors.size(), 1, "errors of " + code)
	check_error(text)


func _signatures() -> PackedStringArray:
	return [
		"_get_base_shape(_lod)",
		"_generate_height(_rng)",
		"_calculate_curve_point(_offset)",
		"_calculate_color_at_point(_offset)",
	]


func _write(code: String, base := "PlantFunction") -> void:
	var script := GDScript.new()
	script.source_code = "extends %s\n%s" % [base, code]
	check_equal(script.reload(), OK, "compiling")
	_function = script.new()


func _make_plant() -> void:
	_plant = Plant3D.new()
	_plant.species = _function
	_plant.simulation_enabled = false
	root.add_child(_plant)
	await frames(2)
