## The visible level of detail of a field by distance, in pictures.
extends "res://tests/engine/picture_harness.gd"

var _field: PlantField3D


func before_each() -> void:
	make_stage()
	_field = PlantField3D.new()
	_field.density = 0.0  # Added plants only.
	_field.simulation_enabled = false
	stage.add_child(_field)


func after_each() -> void:
	stage.free()


func test_levels_dissolve_into_each_other_without_holes() -> void:
	# The plant is at a distance where both levels show a part of it.
	var function := TulipFunction.new()
	_field.levels = [PlantFieldLevel.of(12, 3.5), PlantFieldLevel.of(12)]
	_field.visibility_range_end = 100.0
	_field.fade_ratio = 0.57
	var id := _field.add_plants([Transform3D.IDENTITY], function)[0]
	await frames(5)
	var drawn := count_different(await picture(), empty_picture())
	_field.hide()
	var plant := Plant3D.new()
	plant.species = function
	plant.height = _field.get_plant_height(id)
	plant.seed = _field.get_plant_seed(id)
	stage.add_child(plant)
	await frames(3)
	var whole := count_different(await picture(), empty_picture())
	check_near(float(drawn), float(whole), 0.05 * whole, "pixels of the plant")


func test_nothing_is_drawn_beyond_the_visibility_range() -> void:
	_field.visibility_range_end = 2.0
	_field.fade_ratio = 0.25
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await frames(5)
	check_equal(count_different(await picture(), empty_picture()), 0, "pixels of a plant too far")
	stage.get_camera_3d().position.z = 1.4
	var near := count_different(await picture(), empty_picture())
	check(near > MIN_PLANT, "%d pixels of a near plant" % near)


func test_plants_cast_shadows_within_the_shadow_distance_only() -> void:
	cast_shadows_on_ground(6.0)
	_field.shadow_distance = 30.0
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await frames(5)
	var with_shadow := await picture()
	_field.shadow_distance = 0.0
	var without_shadow := await picture()
	_field.hide()
	var bare := await picture()
	var plant := count_different(without_shadow, bare)
	check(plant > MIN_PLANT, "the plant is drawn: %d pixels" % plant)
	var shadow := count_different(with_shadow, without_shadow)
	check(shadow > 50, "its shadow is: %d pixels" % shadow)


func test_squares_beyond_the_shadow_distance_cast_no_shadows() -> void:
	cast_shadows_on_ground(6.0)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 3, 12), Vector3.ZERO)
	_field.add_plants([Transform3D(Basis(), Vector3(1, 0, 0))], TulipFunction.new())
	var casters: Array[int] = []
	for distance: float in [20.0, 6.0, 20.0]:
		_field.shadow_distance = distance
		await frames(12)
		await picture()
		casters.append(_shadow_draws())
	check(casters[1] < casters[0], "%d and %d shadow draws" % [casters[0], casters[1]])
	check_equal(casters[2], casters[0], "shadow draws at the first distance again")


func test_shadows_become_narrower_before_their_end() -> void:
	cast_shadows_on_ground(6.0)
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	var away := stage.get_camera_3d().global_position.length()
	var dark: Array[int] = []
	for end: float in [20.0 * away, 1.1 * away, 1.0 * away]:
		_field.shadow_distance = end
		await frames(12)
		var now := await picture()
		_field.shadow_distance = 0.0
		dark.append(count_different(now, await picture()))
	check(dark[0] > 50 and dark[1] > 10 and dark[1] < dark[0], "%s pixels of shadow" % [dark])
	check_equal(dark[2], 0, "pixels of shadow at its end")


func test_lod_bias_multiplies_the_shadow_distance() -> void:
	cast_shadows_on_ground(6.0)
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	_field.lod_bias = 5.0
	var away := stage.get_camera_3d().global_position.length()
	for share: float in [0.19, 0.4]:
		_field.shadow_distance = share * away
		await frames(12)
		var now := await picture()
		_field.shadow_distance = 0.0
		var shadow := count_different(now, await picture())
		check(shadow > 50 if share > 0.2 else shadow == 0, "%d pixels at %f" % [shadow, share])


func test_turning_the_camera_changes_no_level() -> void:
	# The level depends on the distance to each plant, not on its position in the picture.
	_field.species = [PlantFieldSpecies.of(TulipFunction.new())]
	_field.size = Vector2(6, 6)
	_field.density = 4.0
	_field.levels = [PlantFieldLevel.of(12, 3.5), PlantFieldLevel.of(2)]
	await _field.build_finished
	await frames(3)
	var before := await picture()
	var camera := stage.get_camera_3d()
	var turn := camera.rotation
	camera.rotation.y += 0.4
	await frames(3)
	check(count_different(before, await picture()) > MIN_PLANT, "it looks elsewhere")
	camera.rotation = turn
	check_equal(count_different(before, await picture()), 0, "pixels after turning back")


func test_lod_bias_multiplies_the_distances_of_all_levels() -> void:
	const UNTIL_SEEN := 12  # Frames: the field polls values without a signal at intervals.
	_field.levels = [PlantFieldLevel.of(12, 20.0), PlantFieldLevel.of(2)]
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await frames(5)
	var fine := await picture()
	_field.lod_bias = 0.1
	await frames(UNTIL_SEEN)
	var coarse := await picture()
	check(count_different(fine, coarse) > 50, "it is coarser")
	_field.lod_bias = 1.0
	_field.levels = [PlantFieldLevel.of(12, 2.0), PlantFieldLevel.of(2)]
	await frames(UNTIL_SEEN)
	check_equal(count_different(coarse, await picture()), 0, "pixels beside levels that end there")


func test_a_bent_plant_is_not_culled_where_only_its_tip_is_seen() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean = deg_to_rad(80.0)
	_field.add_plants([Transform3D(Basis(Vector3.UP, PI / 2), Vector3(-2.2, 1.0, 0))], function)
	await frames(5)
	check(count_different(await picture(), empty_picture()) > MIN_PLANT, "the tip of it is drawn")


## Shadow draws of the last frame. Compatibility counts them together with all others.
func _shadow_draws() -> int:
	var sum := 0
	for kind: Viewport.RenderInfoType in [
		Viewport.RENDER_INFO_TYPE_VISIBLE, Viewport.RENDER_INFO_TYPE_SHADOW
	]:
		sum += stage.get_viewport().get_render_info(kind, Viewport.RENDER_INFO_DRAW_CALLS_IN_FRAME)
	return sum
