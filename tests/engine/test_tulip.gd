## The tulip of the thesis's section 2.5, to the digit, in scripts and meshes.
extends "res://tests/engine/harness.gd"

## More than the rounding of a float of 32 bits near 1.
const FLOAT_TOLERANCE := 1e-6
## The engine stores a component of a vertex colour in 8 bits.
const COLOR_TOLERANCE := 0.0045
const FLOWER_START := 0.75

var _tulip: TulipFunction


func before_each() -> void:
	_tulip = TulipFunction.new()


func after_each() -> void:
	_tulip = null


func test_width_is_a_stem_below_and_a_flattened_sine_above() -> void:
	for step in 101:
		var offset := step / 100.0
		check_near(
			_tulip.calculate_curve_point(offset), _width(offset), FLOAT_TOLERANCE, str(offset)
		)


func test_color_is_green_below_and_red_above() -> void:
	var stem := Color(0.2, 0.85, 0.2)
	var flower := Color(0.8, 0.1, 0.1)
	check_equal(_tulip.calculate_color_at_point(0.0), stem)
	check_equal(_tulip.calculate_color_at_point(0.74), stem)
	check_equal(_tulip.calculate_color_at_point(FLOWER_START), flower)
	check_equal(_tulip.calculate_color_at_point(1.0), flower)


func test_base_shape_is_a_circle_of_four_or_more_points() -> void:
	for lod: int in [1, 4, 5, 12, 64]:
		var shape := _tulip.get_base_shape(lod)
		var count := maxi(4, lod)
		check_equal(shape.size(), count, "points at lod %d" % lod)
		for i in shape.size():
			var angle := TAU * i / count
			var point := Vector3(-cos(angle), 0.0, sin(angle)) * 0.3
			check_near(shape[i], point, FLOAT_TOLERANCE, "point %d of lod %d" % [i, lod])


func test_height_is_spread_over_one_metre_from_1_2() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 1
	var minimum := INF
	var maximum := 0.0
	var sum := 0.0
	for i in 1000:
		var height := _tulip.generate_height(rng)
		minimum = minf(minimum, height)
		maximum = maxf(maximum, height)
		sum += height
	check(minimum >= 1.2 and minimum < 1.22, "the lowest is near 1.2, not %f" % minimum)
	check(maximum < 2.2 and maximum > 2.18, "the highest is near 2.2, not %f" % maximum)
	# The mean of 1000 uniform heights has a standard deviation of 0.009.
	check_near(sum / 1000.0, 1.7, 0.04, "mean height")


func test_equal_seeds_give_equal_heights() -> void:
	var heights := {}
	for seed_value in 20:
		var first := _height_of_seed(seed_value)
		check_equal(_height_of_seed(seed_value), first, "seed %d" % seed_value)
		heights[first] = true
	check_equal(heights.size(), 20, "different heights of 20 seeds")


func test_mesh_has_the_tulips_rings() -> void:
	const LOD := 16
	var mesh := _tulip.generate_mesh(1.6, LOD)
	var arrays := mesh.surface_get_arrays(0)
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var colors: PackedColorArray = arrays[Mesh.ARRAY_COLOR]
	for i in positions.size():
		var offset := roundf(positions[i].y / 1.6 * LOD) / LOD
		check_near(positions[i].y, offset * 1.6, FLOAT_TOLERANCE, "height of a ring")
		var radius := Vector2(positions[i].x, positions[i].z).length()
		check_near(radius, 0.3 * _width(offset), FLOAT_TOLERANCE, "radius at %f" % offset)
		var color := Color(0.8, 0.1, 0.1) if offset >= FLOWER_START else Color(0.2, 0.85, 0.2)
		check_near(colors[i], color, COLOR_TOLERANCE, "color at %f" % offset)


func test_height_zero_calls_the_function_with_the_seed() -> void:
	for seed_value: int in [0, 1, 7]:
		var box := _tulip.generate_mesh(0.0, 8, seed_value).get_aabb()
		check_near(box.size.y, _height_of_seed(seed_value), FLOAT_TOLERANCE, "height of the mesh")


func _height_of_seed(seed_value: int) -> float:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_value
	return _tulip.generate_height(rng)


func _width(offset: float) -> float:
	if offset < FLOWER_START:
		return 0.1
	return 0.5 + sin((offset - FLOWER_START) / 0.3 * PI) / 3.0
