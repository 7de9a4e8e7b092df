@tool
extends RefCounted
## Bakes a species to files that do not need the add-on: meshes for MultiMesh and terrain tools, and
## scenes and glTF files with a skeleton.
##
## Each step writes one file in a few milliseconds, so that the editor stays responsive.

const BakeOptions := preload("bake_options.gd")
const FileNames := preload("file_names.gd")
const ProjectFiles := preload("project_files.gd")
const ADD_ON_FOLDER := "res://addons/undergrowth/"
const BONES: Array[String] = ["root", "tip"]
## Light through leaves, in place of that of the add-on's own shader.
const BACKLIGHT := Color(0.3, 0.34, 0.2)

## Files written so far.
var written: PackedStringArray = []

var _function: PlantFunction
var _options: BakeOptions
## Number of files tried so far.
var _next := 0
var _material: Material
# Mesh formats of CUSTOM0 to CUSTOM3: the weight of the tip, for shaders that bend meshes without a
# skeleton, and the attributes of parts.
var _custom_formats := 0


## Bakes the current state of [param function]. Later changes of it have no effect.
func _init(function: PlantFunction, options: BakeOptions) -> void:
	_function = function.duplicate(true)
	_options = options


## Bakes all files at once. Returns the error and its solution, or an empty text.
static func bake(function: PlantFunction, options: BakeOptions) -> String:
	var work := new(function, options)
	while not work.is_done():
		var problem: String = work.bake_next()
		if not problem.is_empty():
			return problem
	return ""


## Returns the number of remaining files.
func get_pieces_left() -> int:
	return _options.count_files() - _next


func is_done() -> bool:
	return get_pieces_left() == 0


## Writes one more file. Returns the error and its solution, or an empty text.
func bake_next() -> String:
	var meshes := _options.levels.size() if _options.with_meshes else 0
	var per_variant := _options.count_per_variant()
	var variant := floori(float(_next) / per_variant)
	var part := _next % per_variant
	_next += 1
	if part < meshes:
		return _bake_level(variant, part)
	return _bake_scene(variant, part > meshes or not _options.with_scene)


## Returns the plain mesh of one level: one surface with its material and without bones.
func make_level_mesh(variant: int, level: int) -> ArrayMesh:
	var arrays := _generate(variant, level).surface_get_arrays(0)
	arrays[Mesh.ARRAY_BONES] = null
	arrays[Mesh.ARRAY_WEIGHTS] = null
	return _make_mesh(arrays, "%s lod%d" % [_options.title, level])


## Returns the scene of one variant: a skeleton of two bones, with the finest level as its skin. The
## bone "tip" bends the plant. The caller frees the scene. [param for_model]: as glTF has it, with
## linear colours and without the attributes of shaders.
func make_scene(variant: int, for_model := false) -> Node3D:
	var root := Node3D.new()
	root.name = FileNames.to_node_name(_options.title)
	var skeleton := Skeleton3D.new()
	skeleton.name = "Skeleton3D"
	for bone in BONES.size():
		skeleton.add_bone(BONES[bone])
		skeleton.set_bone_parent(bone, bone - 1)
	root.add_child(skeleton)
	skeleton.owner = root
	var shown := MeshInstance3D.new()
	shown.name = "Plant"
	var arrays := _generate(variant, 0).surface_get_arrays(0)
	shown.mesh = _make_model_mesh(arrays) if for_model else _make_mesh(arrays, _options.title)
	shown.skin = _make_skin()
	shown.custom_aabb = _reach_of(shown.mesh)
	skeleton.add_child(shown)
	shown.owner = root
	shown.skeleton = ^".."
	return root


func _bake_level(variant: int, level: int) -> String:
	var path := _options.get_mesh_path(variant, level)
	var problem := _prepare(variant, level, path)
	if problem.is_empty():
		problem = ProjectFiles.save_mesh(make_level_mesh(variant, level), path)
	return _note(path, problem)


func _bake_scene(variant: int, for_model: bool) -> String:
	var path := _options.get_model_path(variant) if for_model else _options.get_scene_path(variant)
	var problem := _prepare(variant, 0, path)
	if problem.is_empty():
		var root := make_scene(variant, for_model)
		var save := ProjectFiles.save_model if for_model else ProjectFiles.save_scene
		problem = save.call(root, path)
		root.free()
	return _note(path, problem)


func _prepare(variant: int, level: int, path: String) -> String:
	var problem := _function.find_problem(
		_options.height, _options.levels[level], _options.first_seed + variant
	)
	return problem if not problem.is_empty() else ProjectFiles.find_problem(path)


func _note(path: String, problem: String) -> String:
	if problem.is_empty():
		written.append(path)
	return problem


func _generate(variant: int, level: int) -> ArrayMesh:
	var mesh := _function.generate_mesh(
		_options.height, _options.levels[level], _options.first_seed + variant
	)
	_custom_formats = mesh.surface_get_format(0) & ProjectFiles.CUSTOM_FORMATS
	if not _material:
		_material = _portable(mesh.surface_get_material(0))
	return mesh


func _make_mesh(arrays: Array, title: String) -> ArrayMesh:
	var mesh := ArrayMesh.new()
	mesh.resource_name = title
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {}, _custom_formats)
	mesh.surface_set_material(0, _material)
	return mesh


func _make_model_mesh(arrays: Array) -> ArrayMesh:
	var colors: PackedColorArray = arrays[Mesh.ARRAY_COLOR]
	for i in colors.size():
		colors[i] = colors[i].srgb_to_linear()
	arrays[Mesh.ARRAY_COLOR] = colors
	for custom in range(Mesh.ARRAY_CUSTOM0, Mesh.ARRAY_CUSTOM3 + 1):
		arrays[custom] = null
	_custom_formats = 0
	return _make_mesh(arrays, _options.title)


## References a material of the project and copies one of the library or the add-on. Replaces a
## shader of the add-on with a plain material.
func _portable(material: Material) -> Material:
	var shaded := material as ShaderMaterial
	if shaded and shaded.shader and shaded.shader.resource_path.begins_with(ADD_ON_FOLDER):
		return _make_plain()
	var stays := (
		not material.is_built_in() and not material.resource_path.begins_with(ADD_ON_FOLDER)
	)
	return material if stays else material.duplicate(true)


func _make_plain() -> StandardMaterial3D:
	var plain := StandardMaterial3D.new()
	plain.vertex_color_use_as_albedo = true
	plain.vertex_color_is_srgb = true
	plain.cull_mode = BaseMaterial3D.CULL_DISABLED
	plain.backlight_enabled = true
	plain.backlight = BACKLIGHT
	return plain


func _make_skin() -> Skin:
	var skin := Skin.new()
	for bone in BONES.size():
		skin.add_bind(bone, Transform3D())
	return skin


## Returns a box around the plant in every bend.
func _reach_of(mesh: Mesh) -> AABB:
	var box := mesh.get_aabb()
	var radius := box.position.abs().max(box.end.abs()).length()
	return AABB(Vector3.ONE * -radius, Vector3.ONE * radius * 2.0)
