@tool
extends "actions_test.gd"
## The actions of the plant page with fields.

const SCENE := "res://actions_field.tscn"


func test_assign_lets_a_species_grow_in_a_field() -> void:
	await open_panel()
	var field := await _open_field()
	var density := field.density
	_select([field])
	await _choose("Reed")
	await _use("Assign")
	check(_message().contains("Reed"), "the message: " + _message())
	check_equal(field.species.size(), 2, "species after assigning")
	check(field.species[1].species is ReedFunction, "the second is the chosen one")
	check_equal(field.species[0].weight, 3.0, "share of the first")
	var stays := field.density * 3.0 / (3.0 + field.species[1].weight)
	check(absf(stays - density) < 1e-3, "the first stays as dense, not %f" % stays)
	check(field.density - density >= 0.5, "reeds are added at their own density")
	check(field.wind and field.wind != _state().own_wind, "it has a wind of its own now")
	await undo()
	check(not field.wind, "no wind after undo")
	check_equal(field.species.size(), 1, "species after undo")
	check_equal(field.density, density, "density after undo")
	await redo()
	check_equal(field.species.size(), 2, "species after redo")
	await _use("Assign")
	check_equal(field.species.size(), 2, "species after assigning again")
	check_equal(EditorInterface.save_scene(), OK, "saving")


func test_assign_leaves_the_wind_of_a_field() -> void:
	var field := await _open_field()
	var own := PlantWind.new()
	field.wind = own
	_select([field])
	await _choose("Tulip")
	await _use("Assign")
	check_equal(field.species.size(), 2, "species after assigning")
	check(field.wind == own, "it keeps its wind")
	await undo()


func test_assign_to_a_plant_and_a_field_changes_both_in_one_step() -> void:
	var field := await _open_field()
	var root := EditorInterface.get_edited_scene_root()
	var plant := Plant3D.new()
	plant.species = GrassFunction.new()
	root.add_child(plant)
	plant.owner = root
	_select([plant, field])
	await _choose("Reed")
	await _use("Assign")
	check(plant.species is ReedFunction, "the plant is of the species")
	check_equal(field.species.size(), 2, "species of the field")
	check_equal(_message(), "Reed grows in what is selected now.", "the message")
	await undo()
	check(plant.species is GrassFunction, "the plant after undo")
	check_equal(field.species.size(), 1, "species of the field after undo")


func test_add_as_field_is_one_step() -> void:
	await _open_field()
	var root := EditorInterface.get_edited_scene_root()
	_select([root.get_child(0)])
	await _choose("Tulip")
	await _use("AddField")
	check_equal(root.get_child_count(), 2, "children after adding")
	var field := root.get_child(-1) as PlantField3D
	check(field != null and field.owner == root, "it is a field, saved with the scene")
	check_equal(field.name, &"Tulip", "its name")
	check(field.species[0].species is TulipFunction, "tulips grow in it")
	check(
		field.species[0].species != _state().function,
		"the dock's own species stays out of the scene"
	)
	check(field.edge_falloff >= 0.2, "its soft border: %f m" % field.edge_falloff)
	check_equal(field.wind.strength, _state().wind.strength, "strength of its wind")
	check(field.wind != _state().own_wind, "the dock's own wind stays out of the scene")
	check_equal(
		EditorInterface.get_selection().get_selected_nodes(), [field] as Array[Node], "selected"
	)
	check(_message().contains("Tulip"), "the message: " + _message())
	check(await until(func() -> bool: return field.get_plant_count() > 0), "plants exist in it")
	await undo()
	check_equal(root.get_child_count(), 1, "children after undo")
	await redo()
	check_equal(root.get_child_count(), 2, "children after redo")
	await undo()


func test_add_as_field_needs_a_scene() -> void:
	await _close_all_scenes()
	await _use("AddField")
	check(_message().contains("no scene"), "add: " + _message())


func _open_field() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Yard"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [PlantFieldSpecies.of(GrassFunction.new(), 3.0)]
	field.size = Vector2(2, 2)
	root.add_child(field)
	field.owner = root
	if SCENE in EditorInterface.get_open_scenes():
		await _close_all_scenes()
	await _open_scene(SCENE, root)
	return EditorInterface.get_edited_scene_root().get_child(0) as PlantField3D
