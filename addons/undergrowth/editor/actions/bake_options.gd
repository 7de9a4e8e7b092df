@tool
extends RefCounted
## The options of a bake: content and file names.

const Translations := preload("../translations/translations.gd")
const FileNames := preload("file_names.gd")
const MAX_SEGMENTS := 256
const MAX_LEVELS := 8
const MAX_VARIANTS := 1000
const DEFAULT_LEVELS: Array[int] = [24, 12, 6, 3]

## Title of the baked plant. file_names.gd makes the stem of file names from it.
var title := "":
	set(value):
		title = value
		_stem = FileNames.to_stem(title)
var folder := "res://"
## Metres. 0: the species' own height.
var height := 0.0
var first_seed := 1
## Number of plants of the species, with consecutive seeds.
var variants := 1
## Vertical segments of each level of detail, finest first. Empty if [method read_levels] failed.
var levels := DEFAULT_LEVELS.duplicate()
## True for one mesh resource per level.
var with_meshes := true
## True for one scene with a skeleton per variant.
var with_scene := false
## True for one glTF file with a skeleton per variant, for other programs.
var with_model := false

var _stem := ""


## Reads levels from a text such as "24, 12, 6, 3".
func read_levels(text: String) -> void:
	levels.clear()
	for part in text.replace(";", ",").split(",", false):
		var number := part.strip_edges()
		if not number.is_valid_int() or number.to_int() < 1 or number.to_int() > MAX_SEGMENTS:
			levels.clear()
			return
		levels.append(number.to_int())


## Returns the error in these options and its solution, or an empty text.
func find_problem() -> String:
	if _stem.is_empty():
		return Translations.text("Give the plant a name with letters or digits.")
	if not folder.begins_with("res://"):
		return Translations.text("%s is not in the project. Choose a folder in res://.") % folder
	if levels.is_empty():
		return (
			Translations.text(
				"Enter the levels as segments from 1 to %d, for example 24, 12, 6, 3."
			)
			% MAX_SEGMENTS
		)
	if levels.size() > MAX_LEVELS:
		return Translations.text("Leave out some levels: %d are the most.") % MAX_LEVELS
	if count_per_variant() == 0:
		return Translations.text("Choose at least one kind of files.")
	return ""


## Returns the file of one level's mesh.
func get_mesh_path(variant: int, level: int) -> String:
	return folder.path_join("%s_lod%d.res" % [get_stem(variant), level])


## Returns the file of one variant's scene.
func get_scene_path(variant: int) -> String:
	return folder.path_join("%s.tscn" % get_stem(variant))


## Returns the glTF file of one variant.
func get_model_path(variant: int) -> String:
	return folder.path_join("%s.glb" % get_stem(variant))


## Returns the prefix of the files of one variant.
func get_stem(variant: int) -> String:
	return _stem if variants == 1 else "%s_%d" % [_stem, variant + 1]


## Returns the number of files to write.
func count_files() -> int:
	return variants * count_per_variant()


## Returns the number of files of one variant.
func count_per_variant() -> int:
	var meshes := levels.size() if with_meshes else 0
	return meshes + (1 if with_scene else 0) + (1 if with_model else 0)


## Returns the first and the last of [method get_files] without building the list.
func get_ends() -> PackedStringArray:
	return [_list(0)[0], _list(variants - 1)[-1]]


## Returns all files to write.
func get_files() -> PackedStringArray:
	var files: PackedStringArray = []
	for variant in variants:
		files.append_array(_list(variant))
	return files


# In the order of the bake.
func _list(variant: int) -> PackedStringArray:
	var files: PackedStringArray = []
	for level in levels.size() if with_meshes else 0:
		files.append(get_mesh_path(variant, level))
	if with_scene:
		files.append(get_scene_path(variant))
	if with_model:
		files.append(get_model_path(variant))
	return files


## Returns those of [method get_files] that exist already.
func get_existing_files() -> PackedStringArray:
	var existing: PackedStringArray = []
	for file in get_files():
		if FileAccess.file_exists(file):
			existing.append(file)
	return existing
