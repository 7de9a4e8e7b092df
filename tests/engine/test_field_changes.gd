## A change of a property in a built field affects only what depends on it.
extends "res://tests/engine/field_harness.gd"


class Painted:
	extends PlantFunction
	var requested: Array[Color] = []
	var paint := Color.GREEN:
		set(value):
			paint = value
			emit_changed()

	func _calculate_color_at_point(_offset: float) -> Color:
		requested.append(paint)
		return paint


## Tolerance of tips (m): the rounding of poses when motion is transferred.
const SAME := 2e-3


func before_each() -> void:
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.density = 5.0
	field.size = Vector2(16, 16)
	field.wind = PlantWind.new()
	field.wind.kind = PlantWind.KIND_CONSTANT
	field.wind.strength = 3.0


func test_graphics_settings_preserve_plants_edits_and_motion() -> void:
	var changes := {
		"shadow_distance": func() -> void: field.shadow_distance = 3.0,
		"no shadow_distance": func() -> void: field.shadow_distance = 0.0,
		"fade_ratio": func() -> void: field.fade_ratio = 0.5,
		"pixel_error": func() -> void: field.pixel_error = 5.0,
		"visibility_range_end": func() -> void: field.visibility_range_end = 20.0,
		"no visibility_range_end": func() -> void: field.visibility_range_end = 0.0,
		"lod_bias": func() -> void: field.lod_bias = 0.4,
		"levels":
		func() -> void: field.levels = [PlantFieldLevel.of(8, 9.0), PlantFieldLevel.of(2)],
		"end of a level": func() -> void: field.levels[0].end = 7.0,
		"share of a level": func() -> void: field.levels[1].density = 0.3,
		"segments of a level": func() -> void: field.levels[0].segments = 5,
		"tile_size": func() -> void: field.tile_size = 5.0,
		"cast_shadow":
		func() -> void: field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF,
		"layers": func() -> void: field.layers = 4,
		"transparency": func() -> void: field.transparency = 0.2,
		"material_override": func() -> void: field.material_override = StandardMaterial3D.new(),
		"skeleton_distance": func() -> void: field.skeleton_distance = 3.0,
	}
	await _check_kept(changes)


func test_styles_of_species_preserve_plants_edits_and_motion() -> void:
	var tulip := field.species[0].species as TulipFunction
	var changes := {
		"colour": func() -> void: tulip.flower_color = Color.BLUE,
		"material": func() -> void: tulip.material = StandardMaterial3D.new(),
		"shading": func() -> void: tulip.shading = PlantFunction.SHADING_FLAT,
		"shape_deviation": func() -> void: tulip.shape_deviation = 0.4,
		"color_deviation": func() -> void: tulip.color_deviation = 0.4,
	}
	await _check_kept(changes)


func test_motion_settings_preserve_plants_edits_and_motion() -> void:
	var tulip := field.species[0].species as TulipFunction
	var changes := {
		"update_interval": func() -> void: field.update_interval = 3,
		"far_distance": func() -> void: field.far_distance = 5.0,
		"max_threads": func() -> void: field.max_threads = 3,
		"bodies_group": func() -> void: field.bodies_group = &"walkers",
		"contact_enabled": func() -> void: field.contact_enabled = true,
		"wind": func() -> void: field.wind = PlantWind.new(),
		"no wind": func() -> void: field.wind = null,
		"mass": func() -> void: tulip.mass *= 3.0,
		"collision_radius": func() -> void: tulip.collision_radius = 0.1,
	}
	await _check_kept(changes)


func test_prototypes_preserve_plants_and_edits() -> void:
	await _start_mown()
	var ids := sorted_ids()
	for count: int in [8, 3, 0]:
		field.prototypes = count
		await rested()
		check_equal(sorted_ids(), ids, "plants with %d prototypes" % count)


func test_a_motion_property_set_during_a_build_counts() -> void:
	field.wind = null
	field.size = Vector2(100, 100)
	var tulip := field.species[0].species as TulipFunction
	tulip.law = PlantFunction.LAW_SPRING
	root.add_child(field)
	await catch_filling()
	tulip.lean = deg_to_rad(40.0)
	tulip.mass = 7.0
	await filled(field)
	await frames(2)
	var found := 0
	for id in field.get_plant_ids():
		if field.get_plant_species(id) == tulip and found < 20:
			found += 1
			var way := relative_tip(id).angle_to(Vector3.UP)
			check_near(way, deg_to_rad(40.0), 0.02, "lean of plant %d" % id)
	check_equal(found, 20, "tulips")
	var rest := all_tips()
	field.apply_impulse_in_sphere(Vector3.ZERO, 1000.0, Vector3(7.0 * 2.0, 0, 0))
	await frames(1)
	var maximum := 0.0
	var ids := field.get_plant_ids()
	var rates := field.get_motion_state(ids)
	for i in ids.size():
		if field.get_plant_species(ids[i]) == tulip:
			var rate := Vector3(rates[12 * i + 3], rates[12 * i + 4], rates[12 * i + 5])
			maximum = maxf(maximum, rate.length() * field.get_plant_height(ids[i]))
	check(maximum < 4.0, "a blow on so heavy a plant gives %f m/s" % maximum)
	check_equal(rest.size(), ids.size(), "tips")


func test_view_properties_set_during_a_build_count() -> void:
	field.size = Vector2(100, 100)
	root.add_child(field)
	await catch_filling()
	field.visibility_range_end = 5.0
	field.levels = [PlantFieldLevel.of(7, 3.0), PlantFieldLevel.of(3)]
	await rested()
	check_equal(field.get_statistics()["drawn_by_level"].size(), 2, "levels")
	await catch_filling()
	field.levels = [PlantFieldLevel.of(7, 3.0), PlantFieldLevel.of(5, 4.0), PlantFieldLevel.of(3)]
	await rested()
	check_equal(field.get_statistics()["drawn_by_level"].size(), 3, "levels")


func test_a_style_that_changes_in_every_frame_is_applied_in_between() -> void:
	await _start_mown()
	var grass := field.species[1].species as GrassFunction
	var states := {}
	for i in 60:
		grass.tip_color = Color(0.01 * i, 0.5, 0)
		await process_frame
		states[field.get_statistics()["is_rebuilding_meshes"]] = true
	await rested()
	check(not field.is_building(), "it rebuilds nothing")
	check(states.has(true), "its meshes were rebuilt")


func test_a_style_that_changes_during_a_mesh_rebuild_is_applied_in_the_end() -> void:
	var painted := Painted.new()
	field.species = [PlantFieldSpecies.of(painted)]
	field.size = Vector2(100, 100)
	await start()
	var once := painted.requested.size()
	for attempt in 50:
		painted.paint = Color.RED
		await process_frame
		if field.get_statistics()["is_rebuilding_meshes"]:
			break
	check(field.get_statistics()["is_rebuilding_meshes"], "it gets the first colour")
	painted.paint = Color.BLUE
	await rested()
	var blues := painted.requested.count(Color.BLUE)
	check(blues >= once, "requested the last colour %d times, of %d for a style" % [blues, once])


func test_a_species_changes_its_lean_while_its_field_runs() -> void:
	field.wind = null
	var tulip := TulipFunction.new()
	tulip.law = PlantFunction.LAW_SPRING
	tulip.damping_ratio = 1.0
	field.species = [PlantFieldSpecies.of(tulip)]
	await start()
	Engine.time_scale = 10.0
	await _check_lean(tulip.lean, "before")
	tulip.lean = deg_to_rad(60.0)
	await _check_lean(tulip.lean, "of another lean")
	tulip.law = PlantFunction.LAW_ELASTICITY
	await frames(30)
	tulip.law = PlantFunction.LAW_SPRING
	await _check_lean(tulip.lean, "after another law")


func test_thicker_tips_of_added_plants_part() -> void:
	field.density = 0.0
	field.wind = null
	field.contact_enabled = true
	root.add_child(field)
	var tulip := TulipFunction.new()
	tulip.law = PlantFunction.LAW_SPRING
	tulip.lean = 0.0
	tulip.collision_radius = 0.01
	# The first and the fifth have the same height.
	var places: Array[Transform3D] = []
	for x: float in [0.0, 20.0, 40.0, 60.0, 0.4]:
		places.append(Transform3D(Basis.IDENTITY, Vector3(x, 0, 0)))
	var all := field.add_plants(places, tulip)
	var ids := PackedInt64Array([all[0], all[4]])
	check_near(field.get_plant_height(ids[0]), field.get_plant_height(ids[1]), 1e-6, "height")
	await frames(10)
	var thin := await _nearest_in_swing(ids, tulip.mass)
	check(thin < 0.2, "thin tips come as near as %f m" % thin)
	tulip.collision_radius = 0.15
	var thick := await _nearest_in_swing(ids, tulip.mass)
	check(thick > 0.26, "thick tips come no nearer than %f m" % thick)


## Returns the minimum distance (m) of two tips after a blow on the first one towards the other.
func _nearest_in_swing(ids: PackedInt64Array, mass: float) -> float:
	field.reset_motion()
	field.apply_impulse_in_sphere(Vector3.ZERO, 0.1, Vector3(3.0 * mass, 0, 0))
	var nearest := 1.0
	for i in 60:
		await process_frame
		var tips := field.get_tip_positions(ids)
		nearest = minf(nearest, tips[0].distance_to(tips[1]))
	return nearest


func _check_lean(lean: float, what: String) -> void:
	await frames(90)
	for id in field.get_plant_ids().slice(0, 20):
		check_near(relative_tip(id).angle_to(Vector3.UP), lean, 0.03, "lean %s" % what)


## Returns plants at rest that a wind bends, some of them mown and one added.
func _start_mown() -> void:
	await start()
	check(field.remove_in_sphere(Vector3(2, 0, 2), 2.0) > 10, "plants are mown")
	var bell := BellflowerFunction.new()
	field.add_plants([Transform3D(Basis.IDENTITY, Vector3(2, 0, 2))], bell)
	await step(40)
	field.simulation_enabled = false
	await frames(2)


func _check_kept(changes: Dictionary) -> void:
	await _start_mown()
	var ids := sorted_ids()
	var tips := field.get_tip_positions(ids)
	for what: String in changes:
		(changes[what] as Callable).call()
		await frames(1)
		check(not field.is_building(), "%s fills nothing" % what)
		await frames(10)  # The field polls the engine's own properties at intervals.
		check(not field.is_building(), "%s fills nothing" % what)
		await rested()
		check_equal(sorted_ids(), ids, "plants after %s" % what)
		var now := field.get_tip_positions(ids)
		var maximum := 0.0
		for i in tips.size():
			maximum = maxf(maximum, now[i].distance_to(tips[i]))
		check(maximum < SAME, "tips went %f m by %s" % [maximum, what])
