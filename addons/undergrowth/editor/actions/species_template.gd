@tool
extends RefCounted
## The script of a new species: four functions to change, each with a comment.

const Translations := preload("../translations/translations.gd")
const FileNames := preload("file_names.gd")
const ProjectFiles := preload("project_files.gd")

const TEMPLATE := '''@tool
class_name {class}
extends PlantFunction
## {title}: what this species looks like and how it grows.


## The cross-section at width 1, in metres: points around the stem, in the plane y = 0.
## More points look rounder; [param lod] is the level of detail, fewer for plants far away.
func _get_base_shape(lod: int) -> PackedVector3Array:
	var ring := PackedVector3Array()
	var points := clampi(lod, 3, 12)
	for i in points:
		ring.append(Vector3.LEFT.rotated(Vector3.UP, TAU * i / points) * 0.02)
	return ring


## The height of one plant in metres. Take chance only from [param rng]: the same seed then gives
## the same plant.
func _generate_height(rng: RandomNumberGenerator) -> float:
	return rng.randf_range(0.5, 0.8)


## How wide the plant is at [param offset], from 0 at the root to 1 at the tip. The cross-section is
## scaled by it.
func _calculate_curve_point(offset: float) -> float:
	return 1.0 - offset * offset


## The colour at [param offset], from 0 at the root to 1 at the tip.
func _calculate_color_at_point(offset: float) -> Color:
	return Color("3f6b24").lerp(Color("b7cf6a"), offset)
'''


## Returns the file of a species called [param title].
static func path_of(title: String, folder: String) -> String:
	return folder.path_join(FileNames.to_stem(title.trim_suffix(FileNames.CLASS_ENDING)) + ".gd")


## Returns the reason that prevents a species called [param title] in [param folder] and its
## solution, or an empty text. Writes nothing.
static func find_problem(title: String, folder: String) -> String:
	var class_title := FileNames.to_class_title(title)
	if class_title.is_empty():
		return Translations.text("Give the species a name with letters.")
	if not class_title.is_valid_unicode_identifier():
		return Translations.text("%s is no name for a class. Begin with a letter.") % class_title
	if _is_taken(class_title):
		return Translations.text("A class %s exists already. Choose another name.") % class_title
	var path := path_of(title, folder)
	if FileAccess.file_exists(path):
		return Translations.text("%s exists already. Choose another name or folder.") % path
	if not path.begins_with(ProjectFiles.PROJECT):
		return Translations.text("%s is not in the project. Choose a folder in res://.") % folder
	return ""


## Writes the script. Returns the error and its solution, or an empty text.
static func write(title: String, folder: String) -> String:
	var problem := find_problem(title, folder)
	var path := path_of(title, folder)
	if problem.is_empty():
		problem = ProjectFiles.find_problem(path)
	if not problem.is_empty():
		return problem
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(make_source(title))
	file.close()
	return ""


## Returns the script's text.
static func make_source(title: String) -> String:
	var heading := " ".join(title.strip_edges().split("\n", false))
	return TEMPLATE.format({"class": FileNames.to_class_title(title), "title": heading})


static func _is_taken(class_title: String) -> bool:
	if ClassDB.class_exists(class_title) or ProjectSettings.has_setting("autoload/" + class_title):
		return true
	for global: Dictionary in ProjectSettings.get_global_class_list():
		if global["class"] == class_title:
			return true
	return false
