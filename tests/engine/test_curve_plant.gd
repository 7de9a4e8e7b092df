## CurvePlantFunction: a species from a curve, a gradient and a few numbers.
extends "res://tests/engine/harness.gd"

const PATH := "user://saved_curve_plant.tres"

var _function: CurvePlantFunction
var _changes := 0


func before_each() -> void:
	_function = CurvePlantFunction.new()
	_changes = 0


func after_each() -> void:
	_function = null


func test_without_parts_it_is_a_green_cone() -> void:
	check_near(_function.calculate_curve_point(0.0), 1.0, 1e-6)
	check_near(_function.calculate_curve_point(0.25), 0.75, 1e-6)
	check_near(_function.calculate_curve_point(1.0), 0.0, 1e-6)
	check(_function.calculate_color_at_point(0.5).g > 0.5, "green")


func test_width_and_color_follow_the_parts() -> void:
	_function.width_curve = _curve(0.5, 2.0)
	_function.color_gradient = _gradient(Color.BLACK, Color.WHITE)
	check_near(_function.calculate_curve_point(0.0), 0.5, 1e-3)
	check_near(_function.calculate_curve_point(1.0), 2.0, 1e-3)
	check_near(_function.calculate_color_at_point(0.5), Color(0.5, 0.5, 0.5), 1e-3)


func test_a_change_of_a_part_is_a_change_of_the_function() -> void:
	var curve := _curve(0.5, 1.0)
	var gradient := _gradient(Color.BLACK, Color.WHITE)
	_function.width_curve = curve
	_function.color_gradient = gradient
	_function.changed.connect(func() -> void: _changes += 1)
	curve.set_point_value(0, 0.25)
	check(_changes > 0, "the curve's change is passed on")
	_changes = 0
	gradient.set_color(0, Color.RED)
	check(_changes > 0, "the gradient's change is passed on")


func test_a_part_that_was_replaced_is_no_longer_followed() -> void:
	var curve := _curve(0.5, 1.0)
	_function.width_curve = curve
	_function.width_curve = _curve(1.0, 1.0)
	_function.width_curve = null
	_function.changed.connect(func() -> void: _changes += 1)
	curve.set_point_value(0, 0.25)
	check_equal(_changes, 0)


func test_a_part_may_be_set_twice() -> void:
	var curve := _curve(0.5, 1.0)
	_function.width_curve = curve
	_function.width_curve = curve
	check(_function.width_curve == curve, "the curve is kept")


func test_setting_what_is_set_already_is_no_change() -> void:
	_function.changed.connect(func() -> void: _changes += 1)
	var values := {
		"cross_section": CurvePlantFunction.CROSS_SECTION_LOBED,
		"radius": 0.3,
		"lobes": 7,
		"lobe_depth": 0.6,
		"height_min": 0.3,
		"height_max": 0.7,
		"width_curve": _curve(0.5, 1.0),
		"color_gradient": _gradient(Color.BLACK, Color.WHITE),
	}
	for property: String in values:
		for expected: int in [1, 0]:
			_changes = 0
			_function.set(property, values[property])
			check_equal(_changes, expected, "signals for " + property)


func test_a_curve_below_zero_counts_as_zero() -> void:
	var curve := Curve.new()
	curve.min_value = -1.0
	curve.add_point(Vector2(0.0, 1.0))
	curve.add_point(Vector2(1.0, -1.0))
	_function.width_curve = curve
	check_equal(_function.calculate_curve_point(1.0), 0.0)
	check(_function.generate_mesh(1.0, 8) != null, "it is built")


func test_a_curve_of_zeros_gives_one_error() -> void:
	_function.width_curve = _curve(0.0, 0.0)
	check(_function.generate_mesh(1.0, 8) == null, "nothing to see")
	check_error("returned 0 at every height")


func test_empty_parts_are_no_fault() -> void:
	_function.width_curve = Curve.new()
	_function.color_gradient = Gradient.new()
	check(_function.generate_mesh(1.0, 8) != null, "it is built")


func test_heights_lie_in_their_range_either_way_round() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 2
	for ends: Vector2 in [Vector2(0.25, 0.75), Vector2(0.75, 0.25)]:
		_function.height_min = ends.x
		_function.height_max = ends.y
		for i in 100:
			var height := _function.generate_height(rng)
			check(height >= 0.25 and height <= 0.75, "%f in its range" % height)


func test_cross_sections() -> void:
	_function.radius = 0.5
	for point in _function.get_base_shape(16):
		check_near(point.length(), 0.5, 1e-6, "radius of the circle")
	_function.cross_section = CurvePlantFunction.CROSS_SECTION_PARALLELOGRAM
	check_equal(_function.get_base_shape(16).size(), 4, "points of the parallelogram")
	_function.cross_section = CurvePlantFunction.CROSS_SECTION_LOBED
	_function.lobes = 3
	_function.lobe_depth = 0.5
	var minimum := INF
	var maximum := 0.0
	for point in _function.get_base_shape(48):
		minimum = minf(minimum, point.length())
		maximum = maxf(maximum, point.length())
	check_near(maximum, 0.75, 1e-3, "a lobe's tip")
	check_near(minimum, 0.25, 1e-3, "between two lobes")


func test_numbers_out_of_range_give_one_error_and_are_not_kept() -> void:
	var bad := {
		"radius": [0.0, -1.0, 101.0, NAN, INF],
		"lobes": [0, 1, -5, 65],
		"lobe_depth": [-0.1, 1.0, NAN],
		"height_min": [0.0, -1.0, 1001.0, NAN],
		"height_max": [0.0, -1.0, 1001.0, INF],
	}
	for property: String in bad:
		var before: Variant = _function.get(property)
		for value: Variant in bad[property]:
			_function.set(property, value)
			check_error(property + " cannot be ")
			check_equal(_function.get(property), before, property)
	_function.set("cross_section", 3)
	check_error("cross_section 3 does not exist")


func test_any_number_of_segments_of_every_cross_section_is_built() -> void:
	for shape in 3:
		_function.set("cross_section", shape)
		for segments in range(1, 65):
			check(_function.generate_mesh(1.0, segments) != null, "%d, %d" % [shape, segments])


func test_saved_it_loads_equal() -> void:
	_function.cross_section = CurvePlantFunction.CROSS_SECTION_LOBED
	_function.radius = 0.125
	_function.lobes = 7
	_function.lobe_depth = 0.5
	_function.height_min = 0.25
	_function.height_max = 2.5
	_function.width_curve = _curve(0.5, 1.0)
	_function.color_gradient = _gradient(Color.RED, Color.BLUE)
	check_equal(ResourceSaver.save(_function, PATH), OK, "saving")
	var loaded: CurvePlantFunction = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	for property in ClassDB.class_get_property_list("CurvePlantFunction", true):
		var name: String = property["name"]
		if property["type"] != TYPE_OBJECT and property["usage"] & PROPERTY_USAGE_STORAGE:
			check_equal(loaded.get(name), _function.get(name), name)
	check_equal(_bytes(loaded), _bytes(_function), "mesh")
	DirAccess.remove_absolute(PATH)


func _curve(from: float, to: float) -> Curve:
	var curve := Curve.new()
	curve.max_value = 2.0
	curve.add_point(Vector2(0.0, from), 0.0, to - from)
	curve.add_point(Vector2(1.0, to), to - from, 0.0)
	return curve


func _gradient(from: Color, to: Color) -> Gradient:
	var gradient := Gradient.new()
	gradient.set_color(0, from)
	gradient.set_color(1, to)
	return gradient


func _bytes(function: PlantFunction) -> PackedByteArray:
	return var_to_bytes(function.generate_mesh(0.0, 9, 3).surface_get_arrays(0))
