@tool
extends "actions_test.gd"
## Baking: files for MultiMesh, for terrain tools and for projects without the add-on.

const Bake := preload("res://addons/undergrowth/editor/actions/bake.gd")
const BakeOptions := preload("res://addons/undergrowth/editor/actions/bake_options.gd")
const FOLDER := "res://baked"
const TITLE := "Crveni šaš"
const STEM := "crveni_sas"
const BLOCKER := "res://bake_blocker"
## Runs in a project without the add-on.
const ALONE := """extends SceneTree


func _initialize() -> void:
	var plant := (load("res://plant.tscn") as PackedScene).instantiate()
	root.add_child(plant)
	var skeleton := plant.find_children("*", "Skeleton3D")[0] as Skeleton3D
	var shown := plant.find_children("*", "MeshInstance3D")[0] as MeshInstance3D
	var tip := skeleton.find_bone("tip")
	skeleton.set_bone_pose_rotation(tip, Quaternion(Vector3.RIGHT, 0.5))
	var field := MultiMesh.new()
	field.transform_format = MultiMesh.TRANSFORM_3D
	field.mesh = load("res://plant_lod0.res")
	field.instance_count = 100
	var facts := [
		skeleton.get_bone_count(),
		skeleton.get_bone_parent(tip),
		shown.skin.get_bind_count(),
		shown.get_node(shown.skeleton) == skeleton,
		shown.mesh.get_surface_count(),
		field.mesh.get_surface_count(),
		shown.mesh.surface_get_material(0) is StandardMaterial3D,
		ClassDB.class_exists(&"Plant3D"),
	]
	print("ALONE ", JSON.stringify(facts))
	quit()
"""


func test_bake_writes_the_files_that_the_dialog_lists() -> void:
	await _choose("Reed")
	await _use("Bake")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	check(dialog != null, "the dialog opens")
	check_equal((dialog.get_node("%Title") as LineEdit).text, "Reed", "suggested name")
	await _fill(dialog, TITLE, FOLDER)
	await click(dialog.get_node("%Scene") as Control)
	check(_hint(dialog).begins_with("5 files"), "the dialog counts: " + _hint(dialog))
	check(_hint(dialog).contains(STEM), "and names them: " + _hint(dialog))
	await take_dialog_picture(dialog, "bake")
	await click(dialog.get_ok_button())
	check(await until(func() -> bool: return _message().begins_with("Baked 5 ")), _message())
	for file: String in ["_lod0.res", "_lod1.res", "_lod2.res", "_lod3.res", ".tscn"]:
		check(FileAccess.file_exists(_path(file)), file)


func test_a_button_shows_the_baked_files() -> void:
	await _choose("Grass")
	await _use("Bake")
	await _fill(_dialog("ConfirmationDialog"), "Shown", FOLDER)
	var height := tiles().size.y
	await click((_dialog("ConfirmationDialog") as ConfirmationDialog).get_ok_button())
	var button := part("Status/ShowFile") as LinkButton
	check(await until(func() -> bool: return button.visible), "the button: " + _message())
	await frames(2)
	check_equal(tiles().size.y, height, "height of the tiles")
	await files_are_known()
	await click(button)
	await frames(5)
	check(EditorInterface.get_file_system_dock().is_visible_in_tree(), "the dock is in front")
	check_equal(EditorInterface.get_current_path(), FOLDER.path_join("shown_lod0.res"), "file")
	await _choose("Tulip")
	check(not button.visible, "it is gone with its message")


func test_a_model_has_the_skeleton_and_linear_colors() -> void:
	var options := _options("Model", "24", 1)
	options.with_meshes = false
	options.with_model = true
	check_equal(options.get_files(), PackedStringArray([FOLDER.path_join("model.glb")]), "files")
	var poppy: PlantFunction = load("res://addons/undergrowth/species/poppy.tres")
	check_equal(Bake.bake(poppy, options), "", "problem")
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	var read := document.append_from_file(options.get_files()[0], state)
	check_equal(read, OK, "reading the file")
	var scene := document.generate_scene(state)
	var skeleton := scene.find_children("*", "Skeleton3D", true, false)[0] as Skeleton3D
	check(skeleton.find_bone("tip") >= 0, "it has a tip")
	var shown := scene.find_children("*", "ImporterMeshInstance3D", true, false)[0]
	var mesh := (shown as ImporterMeshInstance3D).mesh.get_mesh()
	var wanted := poppy.generate_mesh(0.0, 24, 1)
	check(mesh.get_aabb().is_equal_approx(wanted.get_aabb()), "%s" % mesh.get_aabb())
	var mean := _mean_color(wanted, true)
	var read_mean := _mean_color(mesh, false)
	check(read_mean.distance_to(mean) < 0.01, "%s, not %s" % [read_mean, mean])
	scene.free()
	DirAccess.remove_absolute(options.get_files()[0])  # Its import would go on in later tests.


func _mean_color(mesh: Mesh, is_srgb: bool) -> Vector3:
	var colors: PackedColorArray = mesh.surface_get_arrays(0)[Mesh.ARRAY_COLOR]
	var sum := Vector3.ZERO
	for color in colors:
		var linear := color.srgb_to_linear() if is_srgb else color
		sum += Vector3(linear.r, linear.g, linear.b)
	return sum / colors.size()


func test_levels_are_plain_meshes_that_a_multimesh_draws() -> void:
	var before := 1 << 30
	for level in 4:
		var mesh := _read(_path("_lod%d.res" % level)) as ArrayMesh
		check_equal(mesh.get_surface_count(), 1, "surfaces of level %d" % level)
		var format := mesh.surface_get_format(0)
		check(format & Mesh.ARRAY_FORMAT_BONES == 0, "level %d has no bones" % level)
		check(format & Mesh.ARRAY_FORMAT_NORMAL != 0, "level %d has normals" % level)
		check(format & Mesh.ARRAY_FORMAT_COLOR != 0, "level %d has colours" % level)
		check(format & Mesh.ARRAY_FORMAT_CUSTOM0 != 0, "level %d has the tip's weights" % level)
		check(mesh.surface_get_material(0) is StandardMaterial3D, "level %d is lit" % level)
		var indices := mesh.surface_get_array_index_len(0)
		check(indices < before, "level %d is coarser than the one before" % level)
		before = indices
		_check_multimesh(mesh)


func test_the_scene_needs_nothing_of_the_add_on() -> void:
	var folder := OS.get_cache_dir().path_join("undergrowth_bake_test")
	DirAccess.make_dir_recursive_absolute(folder)
	_copy(_path(".tscn"), folder.path_join("plant.tscn"))
	_copy(_path("_lod0.res"), folder.path_join("plant_lod0.res"))
	_write(folder.path_join("project.godot"), "config_version=5\n")
	_write(folder.path_join("alone.gd"), ALONE)
	var words := _engine_words()
	words.append_array(["--headless", "--path", folder, "--script", "res://alone.gd"])
	var output: Array = []
	OS.execute(words[0], words.slice(1), output, true)
	var text := "".join(output)
	check(text.contains("ALONE [2,0,2,true,1,1,true,false]"), text.right(400))
	check(not text.contains("ERROR"), text.right(400))


func test_baking_over_files_requires_confirmation() -> void:
	var path := _path("_lod0.res")
	var used := load(path) as ArrayMesh
	var old := FileAccess.get_md5(path)
	await _choose("Tulip")
	await _start_bake()
	var question := _dialog("ConfirmationDialog") as ConfirmationDialog
	check(question and question.dialog_text.contains(path), "it asks and names the files")
	await take_dialog_picture(question, "replace")
	await click(question.get_cancel_button())
	await frames(5)
	check_equal(FileAccess.get_md5(path), old, "the file after Cancel")
	await _start_bake()
	question = _dialog("ConfirmationDialog") as ConfirmationDialog
	await click(question.get_ok_button())
	check(await until(func() -> bool: return _message().begins_with("Baked")), _message())
	check(FileAccess.get_md5(path) != old, "the file is replaced")
	var now := _read(path) as ArrayMesh
	check_equal(
		used.surface_get_array_len(0), now.surface_get_array_len(0), "vertices where it is in use"
	)


func test_variants_have_seeds_of_their_own_and_keep_their_size() -> void:
	var options := _options("Two reeds", "12", 2)
	options.height = 1.5
	check_equal(Bake.bake(ReedFunction.new(), options), "", "problem")
	var first := _read(FOLDER.path_join("two_reeds_1_lod0.res")) as ArrayMesh
	var second := _read(FOLDER.path_join("two_reeds_2_lod0.res")) as ArrayMesh
	for mesh: ArrayMesh in [first, second]:
		check(absf(mesh.get_aabb().end.y - 1.5) < 0.05, "height %f" % mesh.get_aabb().end.y)
	options.height = 0.0
	Bake.bake(ReedFunction.new(), options)
	first = _read(FOLDER.path_join("two_reeds_1_lod0.res")) as ArrayMesh
	second = _read(FOLDER.path_join("two_reeds_2_lod0.res")) as ArrayMesh
	check(first.get_aabb() != second.get_aabb(), "own heights differ")


func test_own_materials_stay_and_unsaved_ones_come_along() -> void:
	var options := _options("Painted", "3", 1)
	var function := GrassFunction.new()
	var own := StandardMaterial3D.new()
	own.albedo_color = Color.BLUE
	function.material = own
	check_equal(Bake.bake(function, options), "", "problem")
	var mesh := _read(options.get_mesh_path(0, 0)) as ArrayMesh
	check_equal((mesh.surface_get_material(0) as StandardMaterial3D).albedo_color, Color.BLUE, "it")
	ResourceSaver.save(own, FOLDER.path_join("blue.tres"))
	own.take_over_path(FOLDER.path_join("blue.tres"))
	check_equal(Bake.bake(function, options), "", "problem")
	mesh = _read(options.get_mesh_path(0, 0)) as ArrayMesh
	check_equal(mesh.surface_get_material(0).resource_path, own.resource_path, "its file")


func test_wrong_options_are_reported_before_writing() -> void:
	await _choose("Grass")
	await _use("Bake")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	var levels := dialog.get_node("%Levels") as LineEdit
	for text: String in ["", "0", "12, many", "1000000"]:
		await _type_into(dialog, levels, text)
		check(dialog.get_ok_button().disabled, "levels " + text)
		check(_hint(dialog).contains("24, 12, 6, 3"), _hint(dialog))
	await _type_into(dialog, levels, "24, 12, 6, 3")
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, "?!")
	check(dialog.get_ok_button().disabled, "a name without letters")
	await _fill(dialog, "Grass", "user://")
	check(dialog.get_ok_button().disabled, "a folder outside the project")
	_write(BLOCKER, "keep me")
	await _fill(dialog, "Grass", BLOCKER)
	await click(dialog.get_ok_button())
	await frames(5)
	check(_message().contains(BLOCKER), "a file is no folder: " + _message())
	check_equal(FileAccess.get_file_as_string(BLOCKER), "keep me", "the file in the way")
	check(not (part("Status/Work") as Control).visible, "no work is left")


func test_long_work_can_be_cancelled() -> void:
	await _use("Bake")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	await _fill(dialog, "Many", FOLDER)
	(dialog.get_node("%Variants") as EditorSpinSlider).value = 200
	await click(dialog.get_ok_button())
	await frames(3)
	check((part("Status/Work") as Control).visible, "progress is shown")
	check((part("Browser/Actions/Bake") as Button).disabled, "no second work begins")
	await take_picture("baking")
	await click(part("Status/Cancel") as Control)
	check(await until(func() -> bool: return _message().begins_with("Cancelled")), _message())
	check(not (part("Status/Work") as Control).visible, "progress is gone")
	check(
		not FileAccess.file_exists(FOLDER.path_join("many_200_lod3.res")), "the last is not there"
	)
	check(FileAccess.file_exists(FOLDER.path_join("many_1_lod0.res")), "the first is")
	check(not (part("Browser/Actions/Bake") as Button).disabled, "new work can begin")
	var files := EditorInterface.get_resource_filesystem()
	check(await until(func() -> bool: return not files.is_scanning()), "the editor knows the files")
	await frames(5)


func _start_bake() -> void:
	await _use("Bake")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	await _fill(dialog, TITLE, FOLDER)
	await click(dialog.get_ok_button())
	await frames(3)


func _fill(dialog: Window, title: String, folder: String) -> void:
	await _type_into(dialog, dialog.get_node("%Title") as LineEdit, title)
	var field := dialog.get_node("%Folder").get_node("%Path") as LineEdit
	await _type_into(dialog, field, folder)


func _options(title: String, levels: String, variants: int) -> BakeOptions:
	var options := BakeOptions.new()
	options.title = title
	options.folder = FOLDER
	options.variants = variants
	options.read_levels(levels)
	return options


func _path(ending: String) -> String:
	return FOLDER.path_join(STEM + ending)


func _read(path: String) -> Resource:
	return ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)


func _check_multimesh(mesh: Mesh) -> void:
	var field := MultiMesh.new()
	field.transform_format = MultiMesh.TRANSFORM_3D
	field.mesh = mesh
	field.instance_count = 2
	field.set_instance_transform(0, Transform3D.IDENTITY)
	field.set_instance_transform(1, Transform3D(Basis.IDENTITY, Vector3(10.0, 0.0, 0.0)))
	check(field.get_aabb().size.x > 10.0, "the field has two plants: %s" % field.get_aabb())


func _copy(from: String, to: String) -> void:
	check_equal(DirAccess.copy_absolute(ProjectSettings.globalize_path(from), to), OK, "copying")


## Returns the command of this engine without its options. It may include a loader.
func _engine_words() -> PackedStringArray:
	var words: PackedStringArray = []
	var file := FileAccess.open("/proc/self/cmdline", FileAccess.READ)
	var line := file.get_buffer(1 << 16) if file else PackedByteArray()
	while not line.is_empty():
		words.append(line.get_string_from_utf8())  # It ends with a zero.
		line = line.slice(line.find(0) + 1)
	var first := words.find("--editor")
	return words.slice(0, first) if first > 0 else PackedStringArray([OS.get_executable_path()])


func test_a_plant_of_parts_is_baked_whole() -> void:
	var options := BakeOptions.new()
	options.title = "Baked tulip"
	options.folder = FOLDER
	options.with_scene = true
	var tulip: PlantFunction = load("res://addons/undergrowth/species/garden_tulip.tres")
	check_equal(Bake.bake(tulip, options), "", "problem")
	var mesh := _read(FOLDER.path_join("baked_tulip_lod0.res")) as ArrayMesh
	var material := mesh.surface_get_material(0) as StandardMaterial3D
	check(material != null, "its material needs no shader of the add-on")
	check_equal(material.cull_mode, BaseMaterial3D.CULL_DISABLED, "leaves are seen from both sides")
	var colors: PackedColorArray = mesh.surface_get_arrays(0)[Mesh.ARRAY_COLOR]
	var redness := 0.0
	for color in colors:
		redness = maxf(redness, color.r - color.g)
	check(redness > 0.4, "its petals are red: %f" % redness)
