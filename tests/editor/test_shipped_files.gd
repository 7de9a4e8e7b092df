@tool
extends "actions_test.gd"
## The add-on's own files: work with them and saved scenes do not change them.

const FOLDER := "res://addons/undergrowth"
const SCENE := "res://shipped_files.tscn"
const KINDS: Array[String] = ["species", "mixes", "winds", "grounds", "environments"]


func test_saving_a_scene_that_uses_all_of_them_changes_none() -> void:
	var before := _read_all(FOLDER)
	check(before.size() > 100, "%d files" % before.size())
	await _open_scene(SCENE, _make_scene())
	var root := EditorInterface.get_edited_scene_root()
	check_equal(root.find_children("*", "Plant3D").size(), 32, "species")
	check_equal(root.find_children("*", "PlantField3D").size(), 5 + 6, "mixes, and winds")
	for field: PlantField3D in root.find_children("*", "PlantField3D"):
		while field.is_building():
			await frames(1)
	(root.get_child(0) as Node3D).position.y = 1.0
	EditorInterface.mark_scene_as_unsaved()
	check_equal(EditorInterface.save_scene(), OK, "saving")
	await frames(10)
	await files_are_known()
	_check_same(before)
	var text := FileAccess.get_file_as_string(SCENE)
	var used := (
		_files_of("species") + _files_of("winds") + _files_of("mixes") + _files_of("grounds")
	)
	for path: String in used:
		var reference := 'uid="%s" path="%s"' % [_id_of(path), path]
		check(text.contains(reference), "the scene uses %s by its id" % path)


func test_saving_one_that_is_opened_itself_changes_none() -> void:
	var before := _read_all(FOLDER)
	for kind in KINDS:
		for path: String in _files_of(kind):
			if path.get_extension() == "tscn":
				await _save_scene(path)
			else:
				await _save_resource(path)
	await frames(10)
	await files_are_known()
	_check_same(before)


func test_each_of_them_has_an_id_of_its_own() -> void:
	var ids: Dictionary[String, String] = {}
	for kind in KINDS:
		for path: String in _files_of(kind):
			var id := _id_of(path)
			check(id.begins_with("uid://"), path + " has an id")
			check(not ids.has(id), "%s and %s have the same id" % [path, ids.get(id, "")])
			ids[id] = path


func _save_scene(path: String) -> void:
	EditorInterface.open_scene_from_path(path)
	await frames(5)
	check_equal(EditorInterface.get_edited_scene_root().scene_file_path, path, "open")
	EditorInterface.mark_scene_as_unsaved()
	check_equal(EditorInterface.save_scene(), OK, "saving " + path)
	await frames(5)
	EditorInterface.close_scene()
	await frames(3)


## As the inspector saves it.
func _save_resource(path: String) -> void:
	var resource := load(path)
	EditorInterface.edit_resource(resource)
	await frames(2)
	var flags := ResourceSaver.FLAG_REPLACE_SUBRESOURCE_PATHS
	check_equal(ResourceSaver.save(resource, path, flags), OK, "saving " + path)
	EditorInterface.edit_resource(null)


func _make_scene() -> Node3D:
	var root := Node3D.new()
	root.name = "All"
	for path: String in _files_of("species"):
		var plant := Plant3D.new()
		plant.species = load(path)
		_add(root, plant)
	for path: String in _files_of("winds"):
		var field := PlantField3D.new()
		field.species = [PlantFieldSpecies.of(load(FOLDER + "/species/poppy.tres"))]
		field.size = Vector2.ONE
		field.wind = load(path)
		_add(root, field)
	for path: String in _files_of("mixes"):
		var scene := load(path) as PackedScene
		var field := scene.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE) as PlantField3D
		field.size = Vector2.ONE
		_add(root, field)
	for path: String in _files_of("grounds"):
		var ground := MeshInstance3D.new()
		ground.mesh = PlaneMesh.new()
		ground.material_override = load(path)
		_add(root, ground)
	var sky := WorldEnvironment.new()
	sky.environment = load(FOLDER + "/environments/day.tres")
	root.add_child(sky)
	sky.owner = root
	return root


func _add(root: Node3D, node: Node3D) -> void:
	root.add_child(node, true)
	node.owner = root


func _files_of(kind: String) -> PackedStringArray:
	var paths: PackedStringArray = []
	for file in DirAccess.get_files_at(FOLDER.path_join(kind)):
		if file.get_extension() in ["tres", "tscn"]:
			paths.append(FOLDER.path_join(kind).path_join(file))
	return paths


func _id_of(path: String) -> String:
	var head := FileAccess.get_file_as_string(path).get_slice("\n", 0)
	return head.get_slice('uid="', 1).get_slice('"', 0)


func _read_all(folder: String) -> Dictionary[String, PackedByteArray]:
	var found: Dictionary[String, PackedByteArray] = {}
	for file in DirAccess.get_files_at(folder):
		if not "bin" in folder:
			found[folder.path_join(file)] = FileAccess.get_file_as_bytes(folder.path_join(file))
	for below in DirAccess.get_directories_at(folder):
		found.merge(_read_all(folder.path_join(below)))
	return found


func _check_same(before: Dictionary[String, PackedByteArray]) -> void:
	var now := _read_all(FOLDER)
	for path in before:
		check(
			now.get(path) == before[path], path + " is not as it was. Commit what the editor saves"
		)
	check_equal(now.size(), before.size(), "files")
