## Plants created and freed while the simulation runs, from all places where scripts can free them.
extends "res://tests/engine/harness.gd"

var _stage: Node3D
var _plants: Array[Plant3D] = []


func before_each() -> void:
	_stage = Node3D.new()
	root.add_child(_stage)
	_plants = []
	for i in 30:
		_plants.append(_add_plant(i))
	await frames(2)


func after_each() -> void:
	_stage.free()
	_plants = []
	check_equal(PlantSimulation.get_plant_count(), 0, "plants left in the simulation")


func test_freed_in_the_process_of_another_node() -> void:
	var gardener := _make_gardener("_process")
	gardener.set("plants", _plants.slice(0, 20))
	await frames(25)
	check_equal(PlantSimulation.get_plant_count(), 10)
	check_equal(gardener.get("plants").size(), 0, "plants to free")


func test_freed_in_the_physics_process_of_another_node() -> void:
	var gardener := _make_gardener("_physics_process")
	gardener.set("plants", _plants.slice(0, 5))
	await physics_frames(8)
	check_equal(PlantSimulation.get_plant_count(), 25)


func test_freed_by_handlers_of_the_frames_signal() -> void:
	var free_one := func() -> void:
		if not _plants.is_empty():
			_plants.pop_back().free()
	process_frame.connect(free_one)
	await frames(40)
	process_frame.disconnect(free_one)
	check_equal(PlantSimulation.get_plant_count(), 0)
	check_equal(_plants.size(), 0)


func test_freed_by_a_signal_of_the_functions_change() -> void:
	var function := _plants[0].species
	var victim := _plants[3]
	victim.species = function
	function.changed.connect(func() -> void: victim.queue_free())
	function.mass = 0.5
	await frames(3)
	check(not is_instance_valid(victim), "it is gone")
	check_equal(PlantSimulation.get_plant_count(), 29)


func test_freed_at_once_by_a_signal_of_the_functions_change() -> void:
	var function := TulipFunction.new()
	var victim := _plants[3]
	# Connected before the plant, so that it is freed before the plant receives the signal.
	function.changed.connect(func() -> void: victim.free(), CONNECT_ONE_SHOT)
	victim.species = function
	function.mass = 0.5
	check(not is_instance_valid(victim), "it is gone")
	check_equal(PlantSimulation.get_plant_count(), 29)


func test_freed_as_it_leaves_the_tree() -> void:
	for plant in _plants:
		plant.tree_exited.connect(plant.queue_free)
		_stage.remove_child(plant)
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 0)


func test_the_others_keep_their_own_motion_when_one_goes() -> void:
	for i in _plants.size():
		_plants[i].apply_impulse(Vector3(0.01 * i, 0, 0))
	await frames(5)
	while _plants.size() > 1:
		var tips: Array = _plants.map(
			func(plant: Plant3D) -> Vector3: return plant.get_tip_position()
		)
		var index := _plants.size() >> 1
		_plants[index].free()
		_plants.remove_at(index)
		tips.remove_at(index)
		for i in _plants.size():
			check_near(_plants[i].get_tip_position(), tips[i], 1e-5, "tip of a neighbour")


func test_each_plant_answers_for_itself_when_others_went() -> void:
	for i in 10:
		_plants.pop_at(i).free()
	for pushed in _plants:
		for plant in _plants:
			plant.reset_motion()
		pushed.apply_impulse(Vector3(0.02, 0, 0))
		for i in 1000:
			await frames(1)
			if pushed.get_deflection() > 1e-3:
				break
		check(pushed.get_deflection() > 1e-3, "the pushed one moves")
		for plant in _plants:
			check(plant == pushed or plant.get_deflection() < 1e-3, "only the pushed one moves")


func test_a_thousand_plants_come_and_go() -> void:
	for i in 1000:
		_add_plant(i)
	check_equal(PlantSimulation.get_plant_count(), 1030)
	await frames(3)
	for child in _stage.get_children():
		child.queue_free()
	await frames(2)
	check_equal(PlantSimulation.get_plant_count(), 0)


func test_a_changed_scene_leaves_nothing() -> void:
	for i in 3:
		var scene := PackedScene.new()
		var meadow := Node3D.new()
		var plant := _make_plant(i)
		meadow.add_child(plant)
		plant.owner = meadow
		scene.pack(meadow)
		meadow.free()
		change_scene_to_packed(scene)
		await frames(4)
		check_equal(PlantSimulation.get_plant_count(), 31, "plants of the new scene only")
	current_scene.free()


func test_a_wind_outlives_its_plants_and_its_plants_a_wind() -> void:
	var wind := PlantWind.new()
	var weak: WeakRef = weakref(wind)
	for plant in _plants:
		plant.wind = wind
	await frames(2)
	for plant in _plants:
		plant.wind = null
	wind = null
	await frames(2)
	check(weak.get_ref() == null, "an unused wind is freed")
	check_equal(PlantSimulation.get_plant_count(), 30)


func test_freed_plants_free_their_function_and_mesh() -> void:
	var plant := _make_plant(0)
	_stage.add_child(plant)
	await frames(2)
	var weak: Array[WeakRef] = [weakref(plant.species), weakref(plant.get_mesh())]
	var skeleton := plant.get_skeleton()
	plant.free()
	await frames(2)
	check(weak[0].get_ref() == null, "the function goes")
	check(weak[1].get_ref() == null, "the mesh goes")
	check(not is_instance_valid(skeleton), "the skeleton goes")


func _make_plant(index: int) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = GrassFunction.new()
	plant.species.law = (index % 2) as PlantFunction.MotionLaw
	plant.segments = 2
	plant.height = 1.0
	return plant


func _add_plant(index: int) -> Plant3D:
	var plant := _make_plant(index)
	_stage.add_child(plant)
	return plant


## A node that frees one plant in each call of [param method].
func _make_gardener(method: String) -> Node:
	var script := GDScript.new()
	script.source_code = (
		"extends Node\nvar plants: Array = []\nfunc %s(_delta: float) -> void:\n" % method
		+ "\tif not plants.is_empty():\n\t\tplants.pop_back().free()\n"
	)
	check_equal(script.reload(), OK, "compiling")
	var gardener: Node = script.new()
	_stage.add_child(gardener)
	return gardener
