@tool
extends "actions_test.gd"
## The actions of the plant page: into the scene, into a file, and a species of one's own.

const Ground := preload("res://addons/undergrowth/editor/actions/ground.gd")
const FileNames := preload("res://addons/undergrowth/editor/actions/file_names.gd")
const SCENE := "res://actions_scene.tscn"
const CONTROL_SCENE := "res://actions_control.tscn"
const SAVED := "res://my species/Ševar vlažni.tres"
const BLOCKER := "res://not_a_folder"
const READ_ONLY := "res://read_only"
const MAY_READ := FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_EXECUTE_OWNER
const NEW_TITLE := "Šaš uz rijeku"
const NEW_SCRIPT := "res://sas_uz_rijeku.gd"
const NEW_CLASS := "SasUzRijekuFunction"
## Height of the box that stands under the view's centre.
const TABLE_TOP := 1.5


func test_without_a_scene_the_dock_says_what_to_do() -> void:
	await open_page("Plant")
	await _close_all_scenes()
	check(EditorInterface.get_edited_scene_root() == null, "no scene is open")
	await _use("Add")
	check(_message().contains("no scene"), "add: " + _message())
	await _use("Assign")
	check(_message().contains("no scene"), "assign: " + _message())


func test_add_is_one_step() -> void:
	await _open_scene(SCENE, _make_scene())
	await open_page("Plant")
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


func test_add_puts_plants_on_what_the_view_looks_at() -> void:
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


func test_ground_is_whatever_a_ray_meets() -> void:
	var root := EditorInterface.get_edited_scene_root() as Node3D
	var away := Vector3(500.0, 0.0, 0.0)
	var things: Dictionary[String, Node3D] = {
		"plane": _with_mesh(PlaneMesh.new()),
		"sphere": _with_mesh(SphereMesh.new()),
		"geometry": CSGBox3D.new(),
		"collider": _make_collider(),
	}
	var tops: Dictionary[String, float] = {
		"plane": 3.0, "sphere": 3.5, "geometry": 3.5, "collider": 3.5
	}
	for kind in things:
		root.add_child(things[kind])
		things[kind].global_position = away + Vector3.UP * 3.0
		await frames(10)
		check_near_ground(away + Vector3.UP * 9.0, Vector3.DOWN, tops[kind], kind)
		things[kind].free()
		await frames(2)
	check_near_ground(away + Vector3.UP * 9.0, Vector3.DOWN, 0.0, "nothing")
	check_near_ground(away + Vector3.UP * 9.0, Vector3.UP, 0.0, "the sky")


func test_before_a_wall_the_ground_is_at_its_foot() -> void:
	var root := EditorInterface.get_edited_scene_root() as Node3D
	var wall := CSGBox3D.new()
	wall.size = Vector3(0.2, 10.0, 10.0)
	root.add_child(wall)
	await frames(5)
	var point := Ground.find_along(
		root.get_world_3d(), Vector3(-4.0, 2.0, 0.0), Vector3(1.0, -0.1, 0.0).normalized()
	)
	check(point.is_equal_approx(Vector3(-0.15, 0.0, 0.0)), "foot of the wall: %s" % point)
	wall.free()


func test_add_goes_below_the_selected_node() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var bed := root.get_node("Bed") as Node3D
	_select([bed])
	await _use("Add")
	check_equal(bed.get_child_count(), 1, "plants in the bed")
	var plant := bed.get_child(0) as Plant3D
	check(plant.global_basis.is_equal_approx(Basis.IDENTITY), "it is upright at its own size")
	check(absf(plant.global_position.y) < 1e-3, "it stands on the ground of the world")
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
	await open_page("Plant")
	await _use("Add")
	check_equal(EditorInterface.get_edited_scene_root().get_child_count(), 1, "children")
	await undo()
	check_equal(EditorInterface.get_edited_scene_root().get_child_count(), 0, "after undo")


func test_save_as_keeps_edits_and_is_listed() -> void:
	await _choose("Tulip")
	_state().function.natural_frequency = 1.25
	await _use("Save")
	var dialog := _dialog("EditorFileDialog") as EditorFileDialog
	check(dialog != null and dialog.visible, "the file dialog opens")
	check_equal(dialog.current_file, "tulip.tres", "suggested name")
	DirAccess.make_dir_recursive_absolute(SAVED.get_base_dir())
	await _type_into(dialog, dialog.get_line_edit(), SAVED)
	await click(dialog.get_ok_button())
	await frames(3)
	check(FileAccess.file_exists(SAVED), "the file is there: " + _message())
	check_equal(_state().path, SAVED, "it is chosen")
	var read := ResourceLoader.load(SAVED, "", ResourceLoader.CACHE_MODE_IGNORE) as TulipFunction
	check_equal(read.natural_frequency, 1.25, "its frequency")
	var list := part("Plant/List/ProjectList") as ItemList
	check(await until(func() -> bool: return _lists(list, SAVED)), "the list finds it")


func test_saving_over_a_species_changes_it_where_it_is_used() -> void:
	var used := load(SAVED) as TulipFunction
	await _choose("Tulip")
	_state().function.natural_frequency = 2.5
	part("Plant/Actions").call(&"save_as", SAVED)
	check_equal(used.natural_frequency, 2.5, "frequency where it was in use")
	check(_state().function == used, "the same is chosen")
	var plant := Plant3D.new()
	plant.species = used
	check(plant.get_mesh() != null, "it can be drawn")
	plant.free()


func test_what_cannot_be_written_is_told_and_nothing_is_lost() -> void:
	_write(BLOCKER, "keep me")
	await _choose("Reed")
	var function := _state().function
	for path: String in [BLOCKER + "/reed.tres", "/proc/reed.tres", "user://reed.tres"]:
		part("Plant/Actions").call(&"save_as", path)
		check(
			_message().length() > 20 and not FileAccess.file_exists(path), path + ": " + _message()
		)
	check(_state().function == function, "the species is still chosen")
	check_equal(FileAccess.get_file_as_string(BLOCKER), "keep me", "the file in the way")
	await _check_read_only_folder()


func test_new_species_is_written_opened_and_chosen() -> void:
	await click(part("Plant/List/New") as Control)
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	check(dialog.get_ok_button().disabled, "nothing to create without a name")
	var title := dialog.get_node("%Title") as LineEdit
	await _type_into(dialog, title, "9 lives")
	check(dialog.get_ok_button().disabled, "a class does not begin with a digit")
	check(_hint(dialog).contains("letter"), "and the dialog says so: " + _hint(dialog))
	await _type_into(dialog, title, "Grass")
	check(dialog.get_ok_button().disabled and _hint(dialog).contains("GrassFunction"), "taken name")
	await _type_into(dialog, title, NEW_TITLE)
	await take_dialog_picture(dialog, "new_species")
	await click(dialog.get_ok_button())
	await frames(10)
	check(not dialog.visible, "the dialog closes: " + _hint(dialog))
	check(FileAccess.file_exists(NEW_SCRIPT), "the script is there")
	check_equal(_state().path, NEW_SCRIPT, "it is chosen")
	check_equal(_state().problem, "", "its problem")
	var open := EditorInterface.get_script_editor().get_current_script()
	check(open and open.resource_path == NEW_SCRIPT, "it is open in the script editor")
	var source := FileAccess.get_file_as_string(NEW_SCRIPT)
	check(source.contains("class_name " + NEW_CLASS), "its class")
	var list := part("Plant/List/ProjectList") as ItemList
	check(await until(func() -> bool: return _lists(list, NEW_SCRIPT)), "the list finds it")


func test_a_second_species_of_that_name_is_refused() -> void:
	await click(part("Plant/List/New") as Control)
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, NEW_TITLE)
	check(dialog.get_ok_button().disabled, "it cannot be created")
	check(_hint(dialog).contains("exists"), "the dialog says why: " + _hint(dialog))
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, "Other")
	var path := dialog.get_node("%Folder").get_node("%Path") as LineEdit
	await _type_into(dialog, path, BLOCKER)
	await click(dialog.get_ok_button())
	await frames(3)
	check(dialog.visible and _hint(dialog).contains(BLOCKER), "it stays open: " + _hint(dialog))
	check(_message().contains(BLOCKER), "the status line says it, too: " + _message())
	await click(dialog.get_cancel_button())


func test_a_species_of_one_s_own_goes_into_the_scene() -> void:
	EditorInterface.open_scene_from_path(SCENE)
	await frames(5)
	var root := EditorInterface.get_edited_scene_root()
	_select([root])
	await open_page("Plant")
	var list := part("Plant/List/ProjectList") as ItemList
	for i in list.item_count:
		if list.get_item_tooltip(i) == NEW_SCRIPT:
			await click_item(list, i)
	check_equal(_state().path, NEW_SCRIPT, "chosen species")
	await _use("Add")
	var plant := root.get_child(-1) as Plant3D
	check(plant.species.get_script() == load(NEW_SCRIPT), "its script")
	check(plant.get_mesh() != null, "its mesh")
	await undo()


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


func test_names_become_files_and_classes() -> void:
	check_equal(FileNames.to_stem("  Šaš uz rijeku / no. 2 "), "sas_uz_rijeku_no_2", "stem")
	check_equal(FileNames.to_stem('a:b*c?"<>|'), "a_b_c", "stem without illegal characters")
	check_equal(FileNames.to_stem("..."), "", "stem of nothing")
	check_equal(FileNames.to_stem("Straße"), "strasse", "stem of a sharp s")
	check_equal(FileNames.to_stem("芦苇"), "芦苇", "stem of another script")
	check_equal(FileNames.to_class_title("marsh Sedge"), "MarshSedgeFunction", "class")
	check_equal(FileNames.to_class_title("FoxtailFunction"), "FoxtailFunction", "class as typed")
	check_equal(FileNames.to_node_name("a.b:c/d"), "a_b_c_d", "node")


## Fails the test unless the ground along that ray is at [param height].
func check_near_ground(from: Vector3, along: Vector3, height: float, what: String) -> void:
	var root := EditorInterface.get_edited_scene_root() as Node3D
	var point := Ground.find_along(root.get_world_3d(), from, along)
	check(absf(point.y - height) < 0.02, "%s: %s, not at %f" % [what, point, height])


## The edited scene as its file has it after saving.
func _saved_text() -> String:
	check_equal(EditorInterface.save_scene(), OK, "saving")
	return FileAccess.get_file_as_string(SCENE)


func _with_mesh(mesh: Mesh) -> MeshInstance3D:
	var shown := MeshInstance3D.new()
	shown.mesh = mesh
	return shown


func _make_collider() -> StaticBody3D:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	body.add_child(shape)
	return body


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


## A folder whose rights forbid writing; who runs the tests as root may write there all the same.
func _check_read_only_folder() -> void:
	DirAccess.make_dir_recursive_absolute(READ_ONLY)
	var real := ProjectSettings.globalize_path(READ_ONLY)
	FileAccess.set_unix_permissions(real, MAY_READ)
	var path := READ_ONLY.path_join("reed.tres")
	var may_write := FileAccess.open(path, FileAccess.WRITE) != null
	DirAccess.remove_absolute(path)
	part("Plant/Actions").call(&"save_as", path)
	check(_message().begins_with("Saved" if may_write else "Cannot write"), _message())
	check(_message().contains(path), "the file is named: " + _message())
	FileAccess.set_unix_permissions(real, MAY_READ | FileAccess.UNIX_WRITE_OWNER)
