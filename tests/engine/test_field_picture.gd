## The picture of a plant in a field equals that of a Plant3D in the same state, with a real
## renderer.
extends "res://tests/engine/picture_harness.gd"

## Time of the wind (s) when it turns, after it has settled.
const TURNS_AT := 50.0
## Pixels that may differ while the wind turns.
const MAX_TURNING := 80

var _field: PlantField3D
# Of the wind, in the last moment before a picture (radians).
var _turn := 0.0


func before_each() -> void:
	make_stage()
	_turn = 0.0
	_field = PlantField3D.new()
	_field.density = 0.0  # Added plants only.
	_field.wind = PlantWind.new()
	_field.wind.kind = PlantWind.KIND_CONSTANT
	_field.wind.direction = deg_to_rad(60.0)
	stage.add_child(_field)


func after_each() -> void:
	stage.free()


func test_a_bent_plant_of_the_spring_law() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	_field.wind.strength = 4.0
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.7), Vector3(0.1, 0, 0.2)))


func test_a_bent_plant_of_the_elasticity_law() -> void:
	var function := BellflowerFunction.new()
	function.law = PlantFunction.LAW_ELASTICITY
	function.inner_friction = 3.0
	_field.wind.strength = 1.0
	await _compare(function, Transform3D(Basis(Vector3.UP, -2.0).scaled(Vector3.ONE * 1.5)))


func test_a_plant_at_rest_with_flat_shading_and_deviation() -> void:
	var function := TulipFunction.new()
	function.shading = PlantFunction.SHADING_FLAT
	function.shape_deviation = 1.0
	function.color_deviation = 1.0
	_field.wind.strength = 0.0
	await _compare(function, Transform3D(Basis.IDENTITY, Vector3(-0.2, 0.1, 0)))


func test_a_plant_of_a_turned_and_moved_field() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	_field.wind.strength = 4.0
	_field.transform = Transform3D(Basis(Vector3.UP, 2.2), Vector3(0.3, -0.1, 0.1))
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.4), Vector3(0.1, 0, 0)))


func test_a_plant_that_leans_on_a_slope() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	function.lean = deg_to_rad(15.0)
	_field.wind.strength = 2.0
	var tilt := Basis(Vector3(1, 0, 0.5).normalized(), -0.5)
	await _compare(function, Transform3D(tilt * Basis(Vector3.UP, 2.0).scaled(Vector3.ONE * 0.8)))


func test_a_field_below_parents_of_uneven_scale() -> void:
	var parent := Node3D.new()
	parent.scale = Vector3(1.3, 0.8, 0.9)
	parent.rotation.y = 0.5
	_field.reparent(parent, false)
	stage.add_child(parent)
	_field.rotation.y = 1.1
	_field.wind.strength = 4.0
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.4), Vector3(0.1, 0, 0)))


func test_a_mirrored_field() -> void:
	_field.scale = Vector3(-1, 1, 1)
	_field.wind.strength = 4.0
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.4), Vector3(0.1, 0, 0)))


func test_a_plain_material() -> void:
	var material := StandardMaterial3D.new()
	material.albedo_color = Color(0.9, 0.4, 0.7)
	material.roughness = 0.3
	var function := TulipFunction.new()
	function.material = material
	_field.wind.strength = 3.0
	function.damping_ratio = 1.0
	await _compare(function, Transform3D.IDENTITY)


func test_a_mown_plant_is_one_of_its_height() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	_field.wind.strength = 3.0
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.7)), Vector3.ZERO, 0.6)


func test_a_mown_plant_that_grew_back_is_whole() -> void:
	_field.wind.strength = 0.0
	_field.regrowth_rate = 0.1
	await _compare(TulipFunction.new(), Transform3D.IDENTITY, Vector3.ZERO, 0.6)


func test_followers_of_prototypes_are_drawn() -> void:
	_field.species = [PlantFieldSpecies.of(TulipFunction.new())]
	_field.prototypes = 4
	_field.size = Vector2(3, 3)
	_field.density = 10.0
	_field.wind.strength = 3.0
	_field.wind.kind = PlantWind.KIND_WAVES
	await _field.build_finished
	await frames(10)
	var first := await picture()
	await frames(20)
	var later := await picture()
	check(count_different(first, empty_picture()) > MIN_PLANT, "plants are drawn")
	check(count_different(first, later) > 50, "they move")


## The build prepared its plants while their motion became too large.
func test_a_refused_build_draws_nothing() -> void:
	_field.wind = null
	_field.species = [PlantFieldSpecies.of(TulipFunction.new())]
	_field.size = Vector2(3, 3)
	_field.density = 4.0
	await _field.build_finished
	var before := await picture()
	var many: Array[PlantFieldSpecies] = []
	for i in 130:
		many.append(PlantFieldSpecies.of(GrassFunction.new()))
		many[i].variants = 1
	_field.species = many
	_field.density = 100.0
	_field.prototypes = 1
	await frames(2)
	while _field.is_building():
		await process_frame
	check_error("texture layers")
	await frames(5)
	check(count_different(before, empty_picture()) > MIN_PLANT, "plants are drawn")
	check_equal(count_different(before, await picture()), 0, "pixels that are others")


## The shown pose is in the history on the graphics card, up to the last step.
func test_a_follower_in_waves() -> void:
	var function := _make_follower()
	_field.wind.frequency = 0.02  # A difference of a fraction of a step is not visible.
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.7), Vector3(0.1, 0, 0.2)))


func test_a_follower_while_the_wind_turns() -> void:
	var function := _make_follower()
	_field.wind.frequency = 0.03
	_field.wind.travel_speed = 0.5
	_turn = PI
	# Afterwards waves come from this plant, which is not in view.
	_field.add_plants([Transform3D(Basis.IDENTITY, Vector3(2.6, 0, 1.5))], function)
	await _compare(function, Transform3D(Basis(Vector3.UP, 0.7), Vector3(0.1, 0, 0.2)))


## Lets the field's plants follow a prototype in waves, and returns their species.
func _make_follower() -> PlantFunction:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.damping_ratio = 1.0
	_field.prototypes = 1
	_field.wind.kind = PlantWind.KIND_WAVES
	_field.wind.strength = 10.0
	return function


func test_followers_at_rest_are_equal_in_another_material() -> void:
	await _check_follower_materials(false)


func test_followers_of_a_preview_are_equal_in_another_material() -> void:
	await _check_follower_materials(true)


func test_a_follower_that_was_pushed() -> void:
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.natural_frequency = 0.5
	function.damping_ratio = 20.0  # So slow that it does not move visibly during the picture.
	_field.prototypes = 3
	_field.wind.strength = 0.0
	await _compare(
		function,
		Transform3D(Basis(Vector3.UP, 0.7), Vector3.ZERO),
		function.mass * Vector3(60, 0, 30)
	)


## Compares instances of prototypes in slow waves, each with its own delay, before and after they
## get an equal material. The field is at rest or in a [param preview].
func _check_follower_materials(preview: bool) -> void:
	var function := TulipFunction.new()
	function.material = StandardMaterial3D.new()
	_field.species = [PlantFieldSpecies.of(function)]
	_field.prototypes = 1
	_field.size = Vector2(3, 3)
	_field.density = 10.0
	_field.wind.strength = 4.0
	_field.wind.kind = PlantWind.KIND_WAVES
	_field.wind.travel_speed = 1.0
	await _field.build_finished
	RenderingServer.render_loop_enabled = false
	await _settle()
	_field.simulation_enabled = false
	await frames(2)
	RenderingServer.render_loop_enabled = true
	var before := await picture()
	function.material = function.material.duplicate()
	if preview:
		_field._preview(0.0, _field.wind)
	await frames(4)
	var after := await picture()
	check(count_different(before, empty_picture()) > MIN_PLANT, "plants are drawn")
	var different := count_different(before, after)
	check(different <= MAX_DIFFERENT, "%d pixels differ" % different)


## [param mown]: height in metres that it is mown to before.
func _compare(
	function: PlantFunction, place: Transform3D, impulse := Vector3.ZERO, mown := 0.0
) -> void:
	while _field.is_building():  # The build can end at any time on a busy machine.
		await process_frame
	var id := _field.add_plants([place], function)[0]
	if mown > 0.0:
		_field.set_height_in_sphere(_field.global_position, 1.0, mown)
		check_near(_field.get_plant_height(id), mown, 0.01, "height of the stubble")
	RenderingServer.render_loop_enabled = false
	await _settle()
	if impulse != Vector3.ZERO:
		var before := _field.get_tip_position(id)
		_field.apply_impulse_in_sphere(Vector3.ZERO, 1.0, impulse)
		await create_timer(0.3).timeout
		check(_field.get_tip_position(id).distance_to(before) > 0.1, "the blow bends it")
	if _turn != 0.0:
		await _wait_until(TURNS_AT)
		_field.wind.direction += _turn
		await _wait_until(TURNS_AT + 0.3)  # Delays change in one second.
	_field.simulation_enabled = false
	await frames(2)
	RenderingServer.render_loop_enabled = true
	var in_field := await picture()
	_field.hide()
	# Beside the field's own node, which is hidden, and skewed as its parents are.
	var place_there := _field.global_transform * _field.get_plant_transform(id)
	var plant := await make_twin(_field, id, function, place_there, 0)
	var tip := plant.to_local(_field.to_global(_field.get_tip_position(id))).normalized()
	plant.get_skeleton().set_bone_pose_rotation(1, Quaternion(Vector3.UP, tip))
	await frames(2)
	var alone := await picture()
	check(count_different(alone, empty_picture()) > MIN_PLANT, "a plant is drawn")
	var different := count_different(in_field, alone)
	var maximum := MAX_DIFFERENT if _turn == 0.0 else MAX_TURNING
	check(different <= maximum, "%d pixels differ" % different)


func _wait_until(time: float) -> void:
	while _field.wind.get_time() < time:
		await process_frame


## Waits for the balance of wind and plant.
func _settle() -> void:
	Engine.time_scale = 20.0
	var time := _field.wind.get_time()
	while _field.wind.get_time() < time + 40.0:
		await process_frame
	Engine.time_scale = 1.0
