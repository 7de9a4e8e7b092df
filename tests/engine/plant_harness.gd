## Base of the engine tests of forces on single plants: plants, bodies, and their tips.
extends "res://tests/engine/harness.gd"

const GROUP := &"walkers"


func after_each() -> void:
	paused = false
	Engine.time_scale = 1.0
	for child in root.get_children():
		if child is Node3D or child is SubViewport:
			child.free()
	check_equal(PlantSimulation.get_plant_count(), 0, "plants left in the simulation")


## Returns a plant in the tree that bodies push.
func add_plant(species: PlantFunction, placed := Transform3D(), height := 1.2) -> Plant3D:
	var plant := make_plant(species, placed, height)
	plant.bodies_group = GROUP
	root.add_child(plant)
	return plant


func make_plant(species: PlantFunction, placed := Transform3D(), height := 1.2) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.transform = placed
	plant.height = height
	return plant


## Returns an upright species, 1.2 m high.
func make_species(law: PlantFunction.MotionLaw, radius := 0.05) -> PlantFunction:
	var species := CurvePlantFunction.new()
	species.height_max = 1.2
	species.height_min = 1.2
	species.law = law
	species.mass = 1.0
	species.natural_frequency = 0.6
	species.damping_ratio = 0.1
	species.lean = 0.0
	species.collision_radius = radius
	return species


## Returns the tip in world axes.
func tip_of(plant: Plant3D) -> Vector3:
	return plant.to_global(plant.get_tip_position())


func add_ball(at: Vector3, radius: float) -> StaticBody3D:
	var ball := SphereShape3D.new()
	ball.radius = radius
	return add_body(ball, at)


## Waits for that many seconds of the simulation.
func pass_time(seconds: float) -> void:
	var passed := 0.0
	while passed < seconds:
		await process_frame
		passed += root.get_process_delta_time()
