@tool
class_name PlantMapSaver
extends ResourceFormatSaver
## Saves a [PlantMap] as files in tiles; see [PlantMapLoader].

const MapTiles := preload("map_tiles.gd")


func _get_recognized_extensions(resource: Resource) -> PackedStringArray:
	return [MapTiles.EXTENSION] if MapTiles.is_map(resource) else []


func _recognize(resource: Resource) -> bool:
	return MapTiles.is_map(resource)


func _save(resource: Resource, path: String, flags: int) -> Error:
	var stays := flags & ResourceSaver.FLAG_CHANGE_PATH != 0 or resource.resource_path == path
	return MapTiles.write(resource, path, stays)
