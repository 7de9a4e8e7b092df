@tool
extends RefCounted
## Writes files of the project without loss of data. It checks that a file can be written before it
## changes anything, and updates an open resource in place.

const Translations := preload("../translations/translations.gd")
const PROJECT := "res://"
const NOT_COPIED: Array[StringName] = [&"script", &"resource_path", &"resource_scene_unique_id"]
## Mask of the format of CUSTOM0 to CUSTOM3 in a mesh: three bits each.
const CUSTOM_FORMATS := 0xfff << Mesh.ARRAY_FORMAT_CUSTOM0_SHIFT


## Returns the reason that prevents writing [param path] and its solution, or an empty text. Creates
## a missing folder.
static func find_problem(path: String) -> String:
	var folder := path.get_base_dir()
	if not path.begins_with(PROJECT):
		return Translations.text("%s is not in the project. Choose a folder in res://.") % path
	if FileAccess.file_exists(folder):
		return Translations.text("%s is a file. Choose a folder.") % folder
	if not DirAccess.dir_exists_absolute(folder):
		if not _can_make(folder):
			return _refusal(folder)
		DirAccess.make_dir_recursive_absolute(folder)
	return "" if _can_write(path) else _refusal(path)


## Saves [param mesh]. A mesh that scenes have loaded from that file changes in these scenes too.
static func save_mesh(mesh: ArrayMesh, path: String) -> String:
	var known := _get_known(path) as ArrayMesh
	if known:
		known.clear_surfaces()
		for i in mesh.get_surface_count():
			known.add_surface_from_arrays(
				mesh.surface_get_primitive_type(i),
				mesh.surface_get_arrays(i),
				[],
				{},
				mesh.surface_get_format(i) & CUSTOM_FORMATS
			)
			known.surface_set_material(i, mesh.surface_get_material(i))
		mesh = known
	return save(mesh, path)


## Saves the branch below [param root] as a scene.
static func save_scene(root: Node, path: String) -> String:
	var known := _get_known(path) as PackedScene
	var scene := known if known else PackedScene.new()
	scene.pack(root)
	var problem := save(scene, path)
	if problem.is_empty() and path in EditorInterface.get_open_scenes():
		EditorInterface.reload_scene_from_path(path)
	return problem


## Saves the branch below [param root] as a glTF file.
static func save_model(root: Node, path: String) -> String:
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	var error := document.append_from_scene(root, state)
	if error == OK:
		error = document.write_to_filesystem(state, path)
	return "" if error == OK else _refusal(path)


## Saves a copy of [param function], or the function itself if the file is its own. Returns the
## content of the file, or null if it could not be written.
static func save_function(function: PlantFunction, path: String) -> PlantFunction:
	var target := function
	if function.resource_path != path:
		target = function.duplicate(true)
		var known := _get_known(path) as PlantFunction
		if known and _is_same_type(known, function):
			_copy_properties(target, known)
			target = known
	if not save(target, path).is_empty():
		return null
	if target.resource_path != path:
		target.take_over_path(path)
	return target


## Saves [param resource]. Returns the error and its solution, or an empty text.
static func save(resource: Resource, path: String) -> String:
	if ResourceSaver.save(resource, path, ResourceSaver.FLAG_COMPRESS) != OK:
		return _refusal(path)
	return ""


## Reports a new or changed file to the editor.
static func announce(path: String) -> void:
	var files := EditorInterface.get_resource_filesystem()
	if files.get_filesystem_path(path.get_base_dir()):
		files.update_file(path)
	else:
		announce_all()


## Starts the editor's scan for new and changed files, in its own thread.
static func announce_all() -> void:
	var files := EditorInterface.get_resource_filesystem()
	if not files.is_scanning():
		files.scan()
	elif not files.filesystem_changed.is_connected(files.scan):
		files.filesystem_changed.connect(files.scan, CONNECT_ONE_SHOT | CONNECT_DEFERRED)


static func _refusal(path: String) -> String:
	return (
		Translations.text("Cannot write %s. Choose another folder, or make this one writable.")
		% path
	)


static func _can_make(folder: String) -> bool:
	var existing := folder.get_base_dir()
	while existing != PROJECT and not DirAccess.dir_exists_absolute(existing):
		if FileAccess.file_exists(existing):
			return false
		existing = existing.get_base_dir()
	return _can_write(existing.path_join(".undergrowth"))


## Checks that the file can be written. An existing file keeps its content, a new one is removed.
static func _can_write(path: String) -> bool:
	if FileAccess.file_exists(path):
		return FileAccess.open(path, FileAccess.READ_WRITE) != null
	var probe := FileAccess.open(path, FileAccess.WRITE)
	if not probe:
		return false
	probe.close()
	DirAccess.remove_absolute(path)
	return true


static func _get_known(path: String) -> Resource:
	return ResourceLoader.get_cached_ref(path) if ResourceLoader.has_cached(path) else null


static func _is_same_type(a: Resource, b: Resource) -> bool:
	return a.get_class() == b.get_class() and a.get_script() == b.get_script()


static func _copy_properties(from: Resource, to: Resource) -> void:
	for property: Dictionary in from.get_property_list():
		var name: StringName = property["name"]
		if property["usage"] & PROPERTY_USAGE_STORAGE and name not in NOT_COPIED:
			to.set(name, from.get(name))
