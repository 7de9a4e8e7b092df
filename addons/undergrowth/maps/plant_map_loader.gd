@tool
class_name PlantMapLoader
extends ResourceFormatLoader
## Loads a [PlantMap] from files in tiles, in the editor and in games.

const MapTiles := preload("map_tiles.gd")


func _get_recognized_extensions() -> PackedStringArray:
	return [MapTiles.EXTENSION]


func _handles_type(type: StringName) -> bool:
	return type == &"PlantMap" or type == &"Resource"


func _get_resource_type(path: String) -> String:
	return "PlantMap" if path.get_extension() == MapTiles.EXTENSION else ""


# The exporter takes them along.
func _get_dependencies(path: String, add_types: bool) -> PackedStringArray:
	var files := MapTiles.list_files(path)
	for i in files.size() if add_types else 0:
		files[i] += "::PlantMap"
	return files


func _load(path: String, _original_path: String, _sub_threads: bool, _cache_mode: int) -> Variant:
	var map := MapTiles.read(path)
	return map if map else ERR_FILE_CORRUPT
