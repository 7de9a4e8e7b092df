## The drawn width of a field's plants at changes of level and at lower density, in pictures.
extends "res://tests/engine/picture_harness.gd"

const STYLE := "res://addons/undergrowth/shaders/plant_parts.gdshader"
const MEADOW_GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
const OXEYE_DAISY := "res://addons/undergrowth/species/oxeye_daisy.tres"
const MARGIN := 1.0

var _field: PlantField3D


func before_each() -> void:
	make_stage()
	_field = PlantField3D.new()
	_field.combed = 0.0  # Placement changes no widths.
	_field.density = 0.0  # Added plants only.
	_field.simulation_enabled = false
	stage.add_child(_field)


func after_each() -> void:
	stage.free()


func test_a_lathe_covers_as_much_while_its_level_changes() -> void:
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await _check_transition(0.03, 0.1)


func test_a_plant_of_parts_covers_as_much_while_its_level_changes() -> void:
	var scaled := Basis.from_scale(Vector3.ONE * 4.0)
	_field.add_plants([Transform3D(scaled)], load(MEADOW_GRASS))
	await _check_transition(0.35, 0.2)  # Both levels, with different leaves, are visible.


func test_a_thinned_field_covers_as_much_as_the_whole() -> void:
	# A third of the plants, with three times the width.
	for function: PlantFunction in [load(MEADOW_GRASS), _blade()]:
		_sow(function, 60.0, 1.2)
		await settled(_field)
		var whole := _count_covered(await picture())
		_field.levels[0].density = 0.4
		var thinned := _count_covered(await picture())
		check(whole > 10 * MIN_PLANT, "plants are drawn")
		check_near(float(thinned), float(whole), 0.2 * whole, "pixels of %s" % function)


func test_a_plant_that_is_left_away_draws_nothing() -> void:
	_field.add_plants([Transform3D.IDENTITY], load(MEADOW_GRASS))
	_field.add_plants([Transform3D(Basis.IDENTITY, Vector3(0.3, 0, 0))], TulipFunction.new())
	_field.levels = [PlantFieldLevel.of(6, 0.0, 0.0)]
	check_equal(_count_covered(await picture()), 0, "pixels of plants that are left away")
	_field.levels[0].density = 1.0
	check(_count_covered(await picture()) > MIN_PLANT, "they are drawn again")


func test_few_wide_leaves_cover_no_more_than_many_from_above() -> void:
	var scaled := Basis.from_scale(Vector3.ONE * 3.0)
	_field.add_plants([Transform3D(scaled)], load(MEADOW_GRASS))
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(Vector3(0, 4.0, 0.0), Vector3.ZERO, Vector3.FORWARD)
	_field.levels = [PlantFieldLevel.of(24)]
	var fine := _count_covered(await picture())
	_field.levels = [PlantFieldLevel.of(24, 0.5), PlantFieldLevel.of(3)]
	var coarse := _count_covered(await picture())
	check(fine > MIN_PLANT, "%d pixels of the finest level" % fine)
	check_near(float(coarse), float(fine), 0.35 * fine, "pixels of few leaves from above")


func test_a_plant_in_an_orthogonal_view_is_as_wide_at_all_distances() -> void:
	_field.add_plants([Transform3D.IDENTITY], load(MEADOW_GRASS))
	_field.levels = [PlantFieldLevel.of(24, 0.5), PlantFieldLevel.of(12)]
	var camera := stage.get_camera_3d()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 0.8
	var counts: Array[float] = []
	for distance: float in [5.0, 40.0]:
		camera.look_at_from_position(Vector3(0, 0.3, distance), Vector3(0, 0.3, 0))
		counts.append(_count_covered(await picture()))
	check(counts[0] > MIN_PLANT, "a plant is drawn")
	check_near(counts[1], counts[0], 0.05 * counts[0], "pixels from 40 m")


func test_widened_far_plants_are_not_brighter() -> void:
	_field.material_override = ShaderMaterial.new()
	(_field.material_override as ShaderMaterial).shader = load(STYLE)
	for tone: StringName in [&"patchiness", &"clumpiness"]:  # Tones of places.
		(_field.material_override as ShaderMaterial).set_shader_parameter(tone, 0.0)
	_sow(load(OXEYE_DAISY), 40.0, 1.5)
	var whole := _brightest(await picture())
	_field.levels[0].density = 0.4
	var thinned := _brightest(await picture())
	check(whole > 0.5, "flowers are seen")
	check(thinned < 0.95 * whole, "%.2f after %.2f" % [thinned, whole])


func test_dull_parts_are_not_darkened_by_shiny_ones() -> void:
	# Colours blend to the plant's own mean, not to black.
	_sow(load(MEADOW_GRASS), 60.0, 1.2)
	var whole := _mean_light(await picture())
	_field.levels[0].density = 0.4
	var thinned := _mean_light(await picture())
	check_near(thinned, whole, 0.15 * whole, "light of a covered pixel")


func test_what_is_left_away_costs_no_vertices() -> void:
	_field.species = [PlantFieldSpecies.of(load(MEADOW_GRASS))]
	_field.density = 60.0
	_field.size = Vector2(2, 2)
	_field.levels = [PlantFieldLevel.of(3, 20.0, 0.1)]
	await settled(_field)
	var near := await _primitives_from(1.0)
	var far := await _primitives_from(20.0)
	check(near > 1000, "%d triangles" % near)
	check(far < near * 0.2, "%d triangles from afar, %d near" % [far, near])
	paused = true
	check_equal(await _primitives_from(1.0), near, "near in a game that is paused")
	paused = false
	_field.levels[0].density = 1.0
	check_equal(await _primitives_from(20.0), near, "with a share of all of them")


func _primitives_from(away: float) -> int:
	stage.get_camera_3d().look_at_from_position(Vector3(0, 0.5, 1.0 + away), Vector3.ZERO)
	await picture()
	return RenderingServer.viewport_get_render_info(
		stage.get_viewport_rid(),
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME
	)


## Fills a square of that many metres with one level.
func _sow(function: PlantFunction, density: float, side: float) -> void:
	_field.species = [PlantFieldSpecies.of(function)]
	_field.density = density
	_field.size = Vector2(side, side)
	_field.levels = [PlantFieldLevel.of(6)]


## Returns a lathe that is wider than a pixel.
func _blade() -> GrassFunction:
	return GrassFunction.new()


## Moves through the band between two levels. The covered area stays between those of the two
## levels, within [param tolerance]. It has no more edges than either, within [param ragged],
## because nothing is dissolved into dots.
func _check_transition(tolerance: float, ragged: float) -> void:
	var away := stage.get_camera_3d().position.length()
	var covered: Array[int] = []
	var edges: Array[int] = []
	for step in 9:
		var way := (step - 1) / 7.0 * 1.2 - 0.1
		var end := away + MARGIN * (1.0 - way)
		_field.fade_ratio = MARGIN / end
		_field.levels = [PlantFieldLevel.of(6, end), PlantFieldLevel.of(3)]
		await frames(2)
		var image := await picture()
		covered.append(_count_covered(image))
		edges.append(_count_edges(image))
	var minimum := mini(covered[0], covered[-1]) * (1.0 - tolerance)
	var maximum := maxi(covered[0], covered[-1]) * (1.0 + tolerance)
	check(minimum > MIN_PLANT, "a plant is drawn")
	for count in covered:
		check(count >= minimum and count <= maximum, "%s pixels" % [covered])
	var max_edges := maxi(edges[0], edges[-1]) * (1.0 + ragged)
	for count in edges:
		check(count <= max_edges, "%s edges" % [edges])


func _count_covered(image: Image) -> int:
	return count_different(image, empty_picture())


## Returns the amount of blue, which daisies have and grass does not: the minimum of a few pixels.
func _brightest(image: Image) -> float:
	var blues: Array[float] = []
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			blues.append(image.get_pixel(x, y).b)
	blues.sort()
	return blues[-10]


## Returns the mean of covered pixels.
func _mean_light(image: Image) -> float:
	var sum := 0.0
	var count := 0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			if _is_covered(image, x, y):
				sum += image.get_pixel(x, y).srgb_to_linear().get_luminance()
				count += 1
	return sum / maxi(count, 1)


## Returns the number of neighbours in a row of which exactly one is covered.
func _count_edges(image: Image) -> int:
	var count := 0
	for y in PICTURE_SIZE.y:
		for x in range(1, PICTURE_SIZE.x):
			count += 1 if _is_covered(image, x, y) != _is_covered(image, x - 1, y) else 0
	return count


func _is_covered(image: Image, x: int, y: int) -> bool:
	var color := image.get_pixel(x, y)
	return maxf(color.r, maxf(color.g, color.b)) > TOLERANCE
