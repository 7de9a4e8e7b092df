## Plants that are rotated, upside down, on walls, scaled, leaning or hidden.
extends "res://tests/engine/harness.gd"

const STEP := 1.0 / 60.0

var _plant: Plant3D
var _mover: Node3D


func before_each() -> void:
	_mover = Node3D.new()
	root.add_child(_mover)
	_plant = Plant3D.new()
	_plant.species = TulipFunction.new()
	_plant.simulation_enabled = false
	_mover.add_child(_plant)


func after_each() -> void:
	_mover.free()


func test_upright_plants_sway_with_the_wind_whatever_their_turn() -> void:
	for turn: float in [0.0, 45.0, 90.0, 180.0, 270.0]:
		_plant.rotation_degrees = Vector3(0, turn, 0)
		await frames(1)
		_check_sway(Vector3(1, 0, 0), "turned by %f" % turn)
		_check_sway(Vector3(0, 0, -1), "turned by %f" % turn)


func test_tilted_plants_sway_with_the_wind() -> void:
	for law: PlantFunction.MotionLaw in _laws():
		_plant.species.law = law
		_plant.rotation_degrees = Vector3(0, 0, 30)
		await frames(1)
		_check_sway(Vector3(1, 0, 0), "tilted, law %d" % law)
		_check_sway(Vector3(0, 0, 1), "tilted, law %d" % law)


func test_plants_on_a_wall_sway_with_the_wind() -> void:
	_plant.rotation_degrees = Vector3(90, 0, 0)
	await frames(1)
	check_near(_tip_in_world().normalized(), Vector3(0, 0, 1), 1e-5, "it grows away from the wall")
	_check_sway(Vector3(1, 0, 0), "on a wall")
	_plant.rotation_degrees = Vector3(0, 0, 90)
	await frames(1)
	_plant.reset_motion()
	check_near(_tip_in_world().normalized(), Vector3(-1, 0, 0), 1e-5, "it grows away from the wall")
	_check_sway(Vector3(0, 0, 1), "on another wall")


func test_plants_on_a_ceiling_sway_with_the_wind() -> void:
	_plant.rotation_degrees = Vector3(180, 30, 0)
	await frames(1)
	check_near(_tip_in_world().normalized(), Vector3(0, -1, 0), 1e-5, "it hangs")
	_check_sway(Vector3(1, 0, 0), "on a ceiling")
	_check_sway(Vector3(0, 0, 1), "on a ceiling")


func test_a_leaning_species_rests_at_its_lean_on_every_slope() -> void:
	var species := BellflowerFunction.new()
	species.damping_ratio = 1.0
	_plant.species = species
	var lean := Vector3.UP.angle_to(_plant.get_tip_position())
	var last := Vector3.ZERO
	for simulated: bool in [false, true]:
		for slope in 180:
			_plant.simulation_enabled = simulated
			_plant.rotation_degrees = Vector3(slope, 0, 0)
			await frames(1)
			_plant.reset_motion()
			check_near(_plant.get_deflection(), 0.0, 2e-4, "deflection at %d degrees" % slope)
			var own := _plant.get_tip_position().normalized()
			check_near(own, Vector3(0, cos(lean), sin(lean)), 2e-4, "rest at %d degrees" % slope)
			if slope > 0:
				var moved := last.angle_to(_tip_in_world())
				check_near(moved, deg_to_rad(1.0), 1e-3, "way to %d degrees" % slope)
			last = _tip_in_world()


func test_a_plant_that_turns_over_slowly_never_jumps() -> void:
	var species := BellflowerFunction.new()
	species.damping_ratio = 1.0
	species.natural_frequency = 5.0
	_plant.species = species
	var last := _tip_in_world()
	for tenth in 1800:
		_plant.rotation_degrees = Vector3(tenth / 10.0, 0, 0)
		await frames(1)
		_plant.advance(STEP)
		var tip := _tip_in_world()
		check(tip.angle_to(last) < deg_to_rad(1.0), "tip at %f degrees" % (tenth / 10.0))
		last = tip


func test_a_law_that_changes_below_an_overhang_keeps_the_plant_there() -> void:
	_plant.species.law = PlantFunction.LAW_ELASTICITY
	_plant.rotation_degrees = Vector3(120, 0, 0)
	await frames(1)
	_plant.species.law = PlantFunction.LAW_SPRING
	_run(10.0)
	var hanging := Vector3(0, cos(deg_to_rad(120.0)), sin(deg_to_rad(120.0)))
	check_near(_tip_in_world().normalized(), hanging, 1e-3, "it hangs aslant")
	var grass := GrassFunction.new()
	grass.lean = 0.0
	_plant.species = grass
	_run(10.0)
	check_near(_tip_in_world().normalized(), hanging, 1e-3, "so does its successor")


func test_a_simulating_plant_moved_to_the_ceiling_settles_there() -> void:
	_plant.simulation_enabled = true
	_plant.species.damping_ratio = 1.0
	_plant.species.natural_frequency = 20.0
	await frames(2)
	_plant.rotation_degrees = Vector3(180, 0, 0)
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 1, "plants in the simulation")
	for i in 1000:
		await frames(1)
		if _plant.get_deflection() < 0.01:
			break
	check(_plant.get_deflection() < 0.01, "it hangs, %f from rest" % _plant.get_deflection())


func test_plants_below_moved_nodes_follow() -> void:
	_mover.rotation_degrees = Vector3(0, 90, 0)
	_mover.scale = Vector3.ONE * 2.0
	_mover.position = Vector3(10, 0, 0)
	await frames(1)
	_check_sway(Vector3(1, 0, 0), "below a turned and scaled node")


func test_scaled_plants_swing_like_plants_of_their_real_height() -> void:
	_plant.height = 1.0
	_plant.species.law = PlantFunction.LAW_ELASTICITY
	_plant.scale = Vector3.ONE * 2.0
	var tall := Plant3D.new()
	tall.species = _plant.species
	tall.height = 2.0
	tall.simulation_enabled = false
	root.add_child(tall)
	await frames(1)
	_plant.apply_impulse(Vector3(0.2, 0, 0))
	tall.apply_impulse(Vector3(0.2, 0, 0))
	for i in 100:
		_plant.advance(STEP)
		tall.advance(STEP)
		check_near(_plant.get_tip_position() * 2.0, tall.get_tip_position(), 1e-4, "tip")
	tall.free()


func test_a_plant_scaled_to_nothing_stays_finite() -> void:
	for scale: Vector3 in [Vector3.ONE * 1e-6, Vector3(1, 1e-6, 1), Vector3(1, 1e6, 1)]:
		_plant.scale = scale
		await frames(1)
		_plant.apply_impulse(Vector3.RIGHT)
		_run(1.0)
		check(_plant.get_tip_position().is_finite(), "tip at scale %s" % str(scale))


func test_a_leaning_species_leans_with_the_node() -> void:
	var grass := GrassFunction.new()
	grass.lean = deg_to_rad(40.0)
	_plant.species = grass
	for turn: float in [0.0, 90.0, 200.0]:
		_plant.rotation_degrees = Vector3(0, turn, 0)
		await frames(1)
		_plant.reset_motion()
		_run(0.5)
		check_near(_plant.get_deflection(), 0.0, 1e-4, "deflection from rest")
		var leaning := Vector3(0, cos(deg_to_rad(40.0)), sin(deg_to_rad(40.0)))
		check_near(_plant.get_tip_position().normalized(), leaning, 1e-4, "turned by %f" % turn)


func test_a_change_of_lean_moves_the_rest_and_not_the_tip() -> void:
	var grass := GrassFunction.new()
	grass.lean = 0.0
	grass.damping_ratio = 1.0
	_plant.species = grass
	_run(0.1)
	var tip := _plant.get_tip_position()
	grass.lean = deg_to_rad(30.0)
	check_near(_plant.get_tip_position(), tip, 1e-5, "tip")
	check_near(_plant.get_deflection(), deg_to_rad(30.0), 1e-4, "deflection")
	_run(5.0)
	check_near(_plant.get_deflection(), 0.0, 1e-3, "deflection later")


func test_a_hidden_plant_moves_and_shows_its_pose_again() -> void:
	var bone := _plant.get_skeleton().get_bone_pose_rotation(1)
	_plant.hide()
	_plant.apply_impulse(Vector3(0.5, 0, 0))
	_run(0.2)
	check(_plant.get_deflection() > 0.05, "it moved")
	_plant.show()
	check(_plant.get_skeleton().get_bone_pose_rotation(1) != bone, "the bone is turned")
	_check_bone_points_to_the_tip()


func test_a_plant_below_a_hidden_node_shows_its_pose_again() -> void:
	_mover.hide()
	_plant.apply_impulse(Vector3(0.5, 0, 0))
	_run(0.2)
	_mover.show()
	_check_bone_points_to_the_tip()


func _laws() -> Array[PlantFunction.MotionLaw]:
	return [PlantFunction.LAW_ELASTICITY, PlantFunction.LAW_SPRING]


func _run(seconds: float) -> void:
	for i in roundi(seconds / STEP):
		_plant.advance(STEP)


func _tip_in_world() -> Vector3:
	return _plant.global_transform * _plant.get_tip_position() - _plant.global_position


## Pushes towards [param way] and checks that the tip moves there, and not sideways.
func _check_sway(way: Vector3, label: String) -> void:
	_plant.reset_motion()
	_plant.wind = PlantWind.new()
	_plant.wind.kind = PlantWind.KIND_CONSTANT
	_plant.wind.strength = 0.5
	_plant.wind.direction = atan2(way.x, way.z)
	var before := _tip_in_world()
	_run(0.3)
	var moved := _tip_in_world() - before
	check(moved.dot(way) > 0.01, "%s: it moves with the wind, by %s" % [label, str(moved)])
	var aside := moved.slide(way)
	aside.y = 0.0
	check(aside.length() < 0.35 * moved.length(), "%s: and not aside, %s" % [label, str(moved)])
	_check_bone_points_to_the_tip()


func _check_bone_points_to_the_tip() -> void:
	# Waits, because the drawn bone is between two steps.
	var wind := _plant.wind
	_plant.wind = null
	_plant.advance(0.0)
	_plant.wind = wind
	var turned := _plant.get_skeleton().get_bone_pose_rotation(1) * Vector3.UP
	check(turned.angle_to(_plant.get_tip_position()) < 0.1, "the bone points to the tip")
