@tool
extends "actions_test.gd"
## Fields take part in the actions of the plant page.

const SCENE := "res://actions_field.tscn"


func test_assign_lets_a_species_grow_in_a_field() -> void:
	await open_page("Plant")
	var field := await _open_field()
	await _choose("Reed")
	_select([field])
	await _use("Assign")
	check(_message().contains("Reed"), "it tells: " + _message())
	check_equal(field.species.size(), 2, "species after assigning")
	check(field.species[1] is ReedFunction, "the second is the chosen one")
	check_equal(field.shares, PackedFloat32Array([3.0, 1.0]), "shares")
	await undo()
	check_equal(field.species.size(), 1, "species after undo")
	check_equal(field.shares, PackedFloat32Array([3.0]), "shares after undo")
	await redo()
	check_equal(field.species.size(), 2, "species after redo")
	await _use("Assign")
	check_equal(field.species.size(), 2, "species after assigning again")
	check_equal(EditorInterface.save_scene(), OK, "saving")


func _open_field() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Yard"
	var field := PlantField3D.new()
	field.name = "Field"
	field.species = [GrassFunction.new()]
	field.shares = PackedFloat32Array([3.0])
	field.size = Vector2(2, 2)
	root.add_child(field)
	field.owner = root
	await _open_scene(SCENE, root)
	return EditorInterface.get_edited_scene_root().get_child(0) as PlantField3D
