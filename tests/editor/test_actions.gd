@tool
extends "actions_test.gd"
## The actions of the plant page that change the edited scene.

const SCENE := "res://actions_scene.tscn"
const CONTROL_SCENE := "res://actions_control.tscn"
## Height of the box under the view's centre.
const TABLE_TOP := 1.5


func test_without_a_scene_the_dock_gives_advice() -> void:
	await open_panel()
	await _choose("Tulip")
	await _close_all_scenes()
	check(EditorInterface.get_edited_scene_root() == null, "no scene is open")
	await _use("Add")
	check(_message().contains("no scene"), "add: " + _message())
	await _use("Assign")
	check(_message().contains("no scene"), "assign: " + _message())


func test_add_is_one_step() -> void:
	await _open_scene(SCENE, _make_scene())
	await open_panel()
	await _choose("Tulip")
	var text_before := _saved_text()
	await _use("Add")
	var text_after := _saved_text()
	var root := EditorInterface.get_edited_scene_root()
	check_equal(root.get_child_count(), 2, "children after adding")
	var plant := root.get_child(-1) as Plant3D
	check(plant.species is TulipFunction, "the plant is a tulip")
	check_equal(plant.name, &"Tulip", "its name")
	check(plant.owner == root, "it is saved with the scene")
	check(plant.species != _state().function, "the dock's own species stays out of the scene")
	check(plant.wind != null, "wind blows on it")
	check_equal(
		EditorInterface.get_selection().get_selected_nodes(), [plant] as Array[Node], "selected"
	)
	await undo()
	check_equal(root.get_child_count(), 1, "children after undo")
	check_equal(_saved_text(), text_before, "the saved scene after undo")
	await redo()
	check_equal(root.get_child_count(), 2, "children after redo")
	check(root.get_child(-1) == plant and plant.owner == root, "redo brings the same plant back")
	check_equal(_saved_text(), text_after, "the saved scene after redo")
	check(text_after.contains('type="Plant3D"'), "the plant is saved")


func test_add_places_plants_at_the_centre_of_the_view() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var size := EditorInterface.get_editor_viewport_3d(0).get_visible_rect().size
	var plant := root.get_child(-1) as Plant3D
	var seen := camera.unproject_position(plant.global_position)
	check(seen.distance_to(size * 0.5) < 2.0, "at the centre: %s of %s" % [seen, size])
	check(absf(plant.global_position.y) < 1e-3, "on the plane: %s" % plant.global_position)
	var table := _make_table(plant.global_position)
	root.add_child(table)
	await frames(3)
	await _use("Add")
	var second := root.get_child(-1) as Plant3D
	check(absf(second.global_position.y - TABLE_TOP) < 1e-3, "on it: %s" % second.global_position)
	check(second.get_parent() == root, "a plant is not put below a plant")
	await undo()
	table.free()


func test_add_goes_below_the_selected_node() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var bed := root.get_node("Bed") as Node3D
	_select([bed])
	await _use("Add")
	check_equal(bed.get_child_count(), 1, "plants in the bed")
	var plant := bed.get_child(0) as Plant3D
	check(plant.global_basis.is_equal_approx(Basis.IDENTITY), "it is upright at its own size")
	check(absf(plant.global_position.y) < 1e-3, "it is on the ground of the world")
	check(plant.species == (root.get_child(-1) as Plant3D).species, "equal plants share a function")
	await undo()
	check_equal(bed.get_child_count(), 0, "plants in the bed after undo")


func test_assign_changes_all_selected_in_one_step() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var plants := _add_plants(root, 3)
	var before := plants.map(func(plant: Plant3D) -> PlantFunction: return plant.species)
	_select([])
	await _choose("Reed")
	await _use("Assign")
	check(_message().contains("selected"), "nothing selected: " + _message())
	_select(plants)
	await _choose("Reed")
	await _use("Assign")
	for plant: Plant3D in plants:
		check(plant.species is ReedFunction, plant.name + " is a reed")
	check(plants[0].species == plants[2].species, "they share it")
	await undo()
	var after := plants.map(func(plant: Plant3D) -> PlantFunction: return plant.species)
	check_equal(after, before, "functions after one undo")
	await redo()
	check(plants[2].species is ReedFunction, "redo assigns again")


func test_the_saved_scene_reads_back() -> void:
	check_equal(EditorInterface.save_scene(), OK, "saving")
	var scene := ResourceLoader.load(SCENE, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene
	var copy := scene.instantiate()
	var kinds: Array[String] = []
	for plant: Plant3D in copy.find_children("*", "Plant3D", true, false):
		kinds.append(plant.species.get_class())
		check(plant.get_mesh() != null, plant.name + " has a mesh")
	kinds.sort()
	var wanted: Array[String] = ["ReedFunction", "ReedFunction", "ReedFunction", "TulipFunction"]
	check_equal(kinds, wanted, "species")
	copy.free()


func test_a_root_that_is_no_node3d_takes_plants() -> void:
	var root := Control.new()
	root.name = "Menu"
	await _open_scene(CONTROL_SCENE, root)
	await open_panel()
	await _use("Add")
	check_equal(EditorInterface.get_edited_scene_root().get_child_count(), 1, "children")
	await undo()
	check_equal(EditorInterface.get_edited_scene_root().get_child_count(), 0, "after undo")


func test_a_species_that_fails_is_not_put_anywhere() -> void:
	var curves := CurvePlantFunction.new()
	curves.width_curve = Curve.new()
	curves.width_curve.add_point(Vector2.ZERO)
	_state().choose(curves, "", "Broken")
	check(not _state().problem.is_empty(), "it has a problem")
	var root := EditorInterface.get_edited_scene_root()
	var count := root.get_child_count()
	for button: String in ["Add", "Assign", "Bake"]:
		await _use(button)
		check(_message().begins_with("Broken: "), button + ": " + _message())
	check_equal(root.get_child_count(), count, "children")
	await _choose("Grass")


## Returns the edited scene from its saved file.
func _saved_text() -> String:
	check_equal(EditorInterface.save_scene(), OK, "saving")
	return FileAccess.get_file_as_string(SCENE)


func _make_scene() -> Node3D:
	var root := Node3D.new()
	root.name = "Garden"
	var bed := Node3D.new()
	bed.name = "Bed"
	bed.position = Vector3(2.0, 1.0, 0.0)
	bed.rotation.z = 0.5
	bed.scale = Vector3.ONE * 2.0
	root.add_child(bed)
	bed.owner = root
	return root


func _make_table(at: Vector3) -> MeshInstance3D:
	var table := MeshInstance3D.new()
	var box := BoxMesh.new()
	box.size = Vector3(8.0, TABLE_TOP, 8.0)
	table.mesh = box
	table.position = at + Vector3.UP * TABLE_TOP * 0.5
	return table


func _add_plants(root: Node, count: int) -> Array[Node]:
	var plants: Array[Node] = []
	for i in count:
		var plant := Plant3D.new()
		plant.name = "Plant%d" % i
		plant.species = BellflowerFunction.new()
		root.add_child(plant)
		plant.owner = root
		plants.append(plant)
	return plants
