## Parts of plants swing in a field as those of a Plant3D in the same state do.
extends "res://tests/engine/picture_harness.gd"

const STEP := 1.0 / 60.0
## Of the outline of a plant with swinging leaves: the accuracy of linear blend skinning.
const MAX_PART_PIXELS := 20
## Without additional brightness of bent plants, and with much of it.
const LIGHTS: Array[float] = [0.0, 3.0]
const LEAN := deg_to_rad(20.0)

## After the last drops on two leaves of this tulip.
const RAIN_STEPS := 6
const MAX_PACKED_PIXELS := 20  # Rounded positions move an edge over the centre of a pixel.
const UNPACKED := """shader_type spatial;
render_mode blend_mix, depth_draw_opaque, cull_disabled;
#include "res://addons/undergrowth/shaders/undergrowth_bend.gdshaderinc"
#include "res://addons/undergrowth/shaders/undergrowth_parts.gdshaderinc"
"""

var _field: PlantField3D
var _wind: PlantWind


func before_each() -> void:
	make_stage()
	_wind = make_crossing_wind()
	_wind.strength = 20.0
	_field = await make_added_field(_wind)


func after_each() -> void:
	stage.free()


func test_a_tulip_in_the_middle_of_a_gust() -> void:
	await _compare(_tulip(), Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3.ONE * 2.5)), 13)


func test_a_tulip_that_swings_back_in_a_turned_field() -> void:
	_field.rotation.y = 1.9
	await _compare(_tulip(), Transform3D(Basis(Vector3.UP, -2.1).scaled(Vector3.ONE * 2.5)), 38)


func test_twigs_of_a_shrub_swing_on_its_branches() -> void:
	await _compare(_shrub(), Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3.ONE * 1.2)), 13)


## Without its twigs' own swing, the plant has another picture.
func test_the_default_shader_draws_the_swing_of_each_order() -> void:
	var orders := await _picture_of(_shrub())
	var own := UNPACKED.replace("cull_disabled;", "cull_disabled;\n#define UNDERGROWTH_PACKED")
	var rigid := await _picture_of(_shrub_with(own))
	var again := await _picture_of(
		_shrub_with(own.replace("PACKED", "PACKED\n#define UNDERGROWTH_ORDERS"))
	)
	check_equal(count_different(orders, again), 0, "pixels that differ with the macro")
	var moved := count_different(orders, rigid)
	check(moved > 3 * MAX_PART_PIXELS, "%d pixels show the swing of twigs" % moved)


func test_a_mown_tulip_swings_about_its_own_pivots() -> void:
	await _compare(_tulip(), Transform3D(Basis.from_scale(Vector3.ONE * 2.5)), 38, 0.6)


func test_a_tulip_that_leans() -> void:
	var species := _tulip()
	species.lean = deg_to_rad(20.0)
	await _compare(species, Transform3D(Basis(Vector3.UP, 2.0).scaled(Vector3.ONE * 2.5)), 20)


func test_a_leaning_tulip_in_heavy_rain_without_wind() -> void:
	_wind.strength = 0.0
	_wind.rain = 1000.0
	var species := _tulip()
	species.lean = deg_to_rad(20.0)
	var id := _field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], species)[0]
	_step_field(RAIN_STEPS)
	var in_field := await picture()
	_field.hide()
	var place := _field.get_plant_transform(id)
	var plant := await make_twin(_field, id, species, place, RAIN_STEPS)
	var different := count_different(in_field, await picture())
	plant.free()
	_field.show()
	_wind.rain = 0.0
	_step_field(1)
	var still := count_different(in_field, await picture())
	check(still > 2 * different, "%d pixels show the drops, %d differ" % [still, different])
	check(different <= MAX_PART_PIXELS, "%d pixels differ" % different)


func test_water_makes_leaves_darker_and_snow_makes_them_lighter() -> void:
	_wind.strength = 0.0
	_field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], _tulip())
	_step_field(1)
	var dry := _mean_light(await picture())
	_wind.wetness = 1.0
	await frames(2)
	var wet := _mean_light(await picture())
	_wind.wetness = 0.0
	_wind.snow = 1.0
	await frames(2)
	var white := _mean_light(await picture())
	_wind.snow = 0.0
	await frames(2)
	check(wet < dry - 1e-3, "wet %.4f, dry %.4f" % [wet, dry])
	check(white > dry + 1e-3, "in snow %.4f, dry %.4f" % [white, dry])
	check_near(_mean_light(await picture()), dry, 1e-4, "dry again")


func test_clumps_of_colour_move_with_their_field() -> void:
	var species := _tulip()
	for tone: StringName in [&"patchiness", &"dead_leaves"]:  # Tones of places in the world.
		species.material.set_shader_parameter(tone, 0.0)
	species.material.set_shader_parameter(&"clumpiness", 2.0)
	var places: Array[Transform3D] = []
	for i in 36:
		places.append(Transform3D(Basis(), Vector3(0.35 * (i % 6) - 0.9, 0, 0.5 - 0.4 * (i / 6))))
	_field.add_plants(places, species)
	var before := await picture()
	for node: Node3D in [_field, stage.get_camera_3d()]:
		node.position += Vector3(7.3, 0, 4.1)
	var after := await picture()
	check(count_different(before, empty_picture()) > MIN_PLANT, "plants are drawn")
	var different := count_different(before, after)
	check(different <= MAX_PART_PIXELS, "%d pixels differ" % different)


func test_leaves_on_a_slope_are_still_without_wind() -> void:
	_wind.strength = 0.0
	var tilt := Basis(Vector3(1, 0, 0.5).normalized(), -0.4)
	_field.add_plants([Transform3D(tilt.scaled(Vector3.ONE * 2.5))], _tulip())
	_step_field(30)
	var before := await picture()
	_step_field(37)
	var after := await picture()
	check(count_different(before, empty_picture()) > MIN_PLANT, "a plant is drawn")
	check_equal(count_different(before, after), 0, "pixels that changed")


func test_packed_vertices_look_as_other_vertices_do() -> void:
	var packed := await _picture_of(_tulip())
	var unpacked := await _picture_of(_tulip_with(UNPACKED))
	check(count_different(packed, empty_picture()) > MIN_PLANT, "a plant is drawn")
	var different := count_different(packed, unpacked)
	check(different <= MAX_PACKED_PIXELS, "%d pixels differ" % different)


func test_a_shader_may_read_packed_vertices() -> void:
	var own := UNPACKED.replace("cull_disabled;", "cull_disabled;\n#define UNDERGROWTH_PACKED")
	var different := count_different(
		await _picture_of(_tulip()), await _picture_of(_tulip_with(own))
	)
	check_equal(different, 0, "pixels that differ from the default shader")


func test_leaves_move_in_steady_wind_and_stop_with_the_field() -> void:
	var species := _tulip()
	species.damping_ratio = 1.0
	_field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], species)
	_step_field(600)
	var before := await picture()
	var still := await picture()
	check_equal(
		count_different(before, still), 0, "pixels that changed in a field that does not move"
	)
	var maximum := 0
	for i in 4:
		_step_field(7)
		maximum = maxi(maximum, count_different(before, await picture()))
	check(maximum > 12, "leaves flutter: %d pixels changed" % maximum)


func test_parts_of_followers_move_with_the_wind() -> void:
	_field.prototypes = 4
	_field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], _tulip())
	_step_field(60)
	var before := await picture()
	_step_field(9)
	check(count_different(before, empty_picture()) > MIN_PLANT, "a plant is drawn")
	check(count_different(before, await picture()) > 20, "it moves")


func test_far_plants_do_not_swing() -> void:
	var species := _tulip()
	species.damping_ratio = 1.0
	_field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], species)
	stage.get_camera_3d().fov = 4.0
	stage.get_camera_3d().position = Vector3(0, 0.7, 40.0)
	stage.get_camera_3d().look_at(Vector3(0, 0.7, 0))
	_step_field(600)
	var before := await picture()
	_step_field(11)
	check(count_different(before, empty_picture()) > MIN_PLANT, "a plant is drawn")
	check_equal(count_different(before, await picture()), 0, "pixels that changed")


func test_what_the_wind_bends_alone_is_not_lighter() -> void:
	var plant := await _plant_alone(PlantFunction.LAW_SPRING)
	plant.height = 0.5
	_wind.strength = 150.0
	for i in 13:
		plant._preview(STEP, _wind)
	check(plant.get_deflection() > 0.03, "it is bent")
	_check_unlit(await _pictures_by_light(plant.species), PlantFunction.LAW_SPRING)


func test_an_isolated_plant_that_rests_leaning_is_not_lighter() -> void:
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_SPRING, PlantFunction.LAW_STEM]:
		var plant := await _plant_alone(law)
		plant.species.lean = LEAN  # It is drawn already.
		_check_unlit(await _pictures_by_light(plant.species), law)
		plant.free()


func test_a_field_plant_that_rests_leaning_is_not_lighter() -> void:
	_wind.strength = 0.0
	var tilt := Basis(Vector3(1, 0, 0.5).normalized(), -0.4).scaled(Vector3.ONE * 2.5)
	for law: PlantFunction.MotionLaw in [PlantFunction.LAW_SPRING, PlantFunction.LAW_STEM]:
		var pictures: Array[Image] = []
		for light: float in LIGHTS:
			var species := _lit_tulip(law)
			species.lean = LEAN
			species.material.set_shader_parameter(&"bent_brightness", light)
			_field.free()
			_field = await make_added_field(_wind)  # The first plant is the same in all fields.
			_field.add_plants([Transform3D(tilt)], species)
			_step_field(2)
			pictures.append(await picture())
		_check_unlit(pictures, law)


## Upright and drawn.
func _plant_alone(law: PlantFunction.MotionLaw) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = _lit_tulip(law)
	plant.simulation_enabled = false
	plant.scale = Vector3.ONE * 2.5
	stage.add_child(plant)
	await picture()
	return plant


func _check_unlit(pictures: Array[Image], law: PlantFunction.MotionLaw) -> void:
	check(count_different(pictures[0], empty_picture()) > MIN_PLANT, "law %d is drawn" % law)
	var lighter := count_different(pictures[0], pictures[1])
	check_equal(lighter, 0, "law %d: pixels that are lighter" % law)


func _pictures_by_light(species: PlantFunction) -> Array[Image]:
	var material: ShaderMaterial = species.material
	var pictures: Array[Image] = []
	for light: float in LIGHTS:
		material.set_shader_parameter(&"bent_brightness", light)
		pictures.append(await picture())
	return pictures


func _mean_light(shown: Image) -> float:
	var mean := shown.duplicate() as Image
	mean.resize(1, 1, Image.INTERPOLATE_TRILINEAR)
	return mean.get_pixel(0, 0).get_luminance()


## Its stem is stiff. Other pictures test how stems bend.
func _tulip() -> PlantFunction:
	var species: PlantFunction = load("res://addons/undergrowth/species/garden_tulip.tres")
	species = species.duplicate()
	_set_spring(species)
	return species


func _set_spring(species: PlantFunction) -> void:
	species.law = PlantFunction.LAW_SPRING
	species.natural_frequency = 1.8
	species.damping_ratio = 0.08
	species.wind_weight = 1.0
	species.material = _material()


## A field compares the brightness of its plants. A single plant has none to compare with.
func _material() -> ShaderMaterial:
	var made := ShaderMaterial.new()
	made.shader = load("res://addons/undergrowth/shaders/plant_parts.gdshader")
	made.set_shader_parameter(&"bent_brightness", 0.0)
	return made


## Two branches with three twigs each: as many as have bones.
func _shrub() -> PlantFunction:
	var twig := PlantAxis.of({length = Vector2(0.2, 0.2), diameter = Vector2(0.03, 0.02)})
	twig.frequency = 2.2
	var twigs := _along(twig, 3)
	var branch := PlantAxis.of({length = Vector2(0.24, 0.24), diameter = Vector2(0.03, 0.02)})
	branch.frequency = 1.4
	var branches := _along(branch, 2)
	branches.carries = [twigs] as Array[PlantArrangement]
	var stem := PlantAxis.of({length = Vector2(0.6, 0.6), diameter = Vector2(0.04, 0.03)})
	var stems := PlantArrangement.new()
	stems.layout = PlantArrangement.LAYOUT_GROUND
	stems.part = stem
	stems.carries = [branches] as Array[PlantArrangement]
	var species := PlantFunction.new()
	species.has_stem = false
	species.arrangements = [stems] as Array[PlantArrangement]
	_set_spring(species)
	return species


func _along(part: PlantPart, count: int) -> PlantArrangement:
	var made := PlantArrangement.new()
	made.part = part
	made.count = Vector2i(count, count)
	made.from = 0.5
	made.angle = Vector2(0.9, 0.6)
	return made


func _shrub_with(code: String) -> PlantFunction:
	var species := _shrub()
	species.material.shader = Shader.new()
	species.material.shader.code = code
	return species


func _tulip_with(code: String) -> PlantFunction:
	var species := _tulip()
	species.material.shader = Shader.new()
	species.material.shader.code = code
	return species


## Returns the picture of a plant in a field of its own, 13 steps after it was added.
func _picture_of(species: PlantFunction) -> Image:
	_field.free()
	_field = await make_added_field(_wind)
	_field.add_plants([Transform3D(Basis.IDENTITY.scaled(Vector3.ONE * 2.5))], species)
	_step_field(13)
	return await picture()


func _lit_tulip(law: PlantFunction.MotionLaw) -> PlantFunction:
	var species := _tulip()
	species.law = law
	return species


func _step_field(count: int) -> void:
	for i in count:
		_field._preview(STEP, _wind)


func _compare(species: PlantFunction, place: Transform3D, steps: int, height_share := 1.0) -> void:
	var id := _field.add_plants([place], species)[0]
	if height_share < 1.0:
		var height := height_share * _field.get_plant_height(id)
		_field.set_height_in_sphere(_field.to_global(place.origin), 0.1, height)
	_step_field(steps)
	var in_field := await picture()
	_field.hide()
	var at := _field.global_transform * _field.get_plant_transform(id)
	var plant := await make_twin(_field, id, species, at, steps)
	var alone := await picture()
	check(plant.get_deflection() > 0.03, "it is bent")
	var different := count_different(in_field, alone)
	check(different <= MAX_PART_PIXELS, "%d pixels differ" % different)
	var skeleton := plant.get_skeleton()
	for bone in range(2, skeleton.get_bone_count()):
		skeleton.set_bone_pose(bone, skeleton.get_bone_rest(bone))
	var stiff := count_different(alone, await picture())
	check(stiff > 5 * different, "%d pixels show the swing, %d differ" % [stiff, different])
