@tool
extends RefCounted
## A [PlantMap] in files: an index that never changes, and a folder with one file for each painted
## tile. Only changed tiles are written, so that painting in different places can be merged.
##
## The engine loads this script with the formats that use it, also where the library is missing or
## not yet loaded. So no code here names the class.

## Extension of the index.
const EXTENSION := "plantmap"
const TILE_EXTENSION := "res"
const FORMAT := 1
const MAP := &"PlantMap"
## Cells on each side of a tile: 32 m with the usual cells of 0.5 m.
const TILE_CELLS := 64
const SECTION := "plant_map"
const FOLDER_SUFFIX := "_tiles"
## The file of a tile, by its column and row.
const TILE_NAME := "tile_%d_%d." + TILE_EXTENSION


## Reads the index [param path] and all tiles. Returns null and reports an error if it is invalid.
static func read(path: String) -> Resource:
	var index := ConfigFile.new()
	var format := 0
	if index.load(path) == OK:
		format = index.get_value(SECTION, "format", 0)
	if format != FORMAT:
		var cause := "is from a later release" if format > FORMAT else "is not the index of a map"
		push_error("%s %s. Take it from your version control, or paint a new map." % [path, cause])
		return null
	var map: Resource = ClassDB.instantiate(MAP)
	map.cell_size = index.get_value(SECTION, "cell_size", map.cell_size)
	var folder := path.get_base_dir().path_join(index.get_value(SECTION, "folder", ""))
	for file in ResourceLoader.list_directory(folder):
		var key: Variant = _key_of(file)
		if key is Vector2i:
			_read_tile(map, key, folder.path_join(file))
	_watch(map, path)
	return map


## Writes [param map] to the index [param path] and its folder: the tiles that have changed since it
## was read or written there, or all. [param stays]: further changes belong to these files.
static func write(map: Resource, path: String, stays: bool) -> Error:
	var changed: Variant = _find_changes(map, path)
	var folder := path.get_base_dir().path_join(folder_of(path))
	var error := DirAccess.make_dir_recursive_absolute(folder)
	if error != OK:
		return error
	if not changed is Dictionary or not FileAccess.file_exists(path):
		error = _write_index(map, path)
		changed = _all_tiles(map, folder)
	var cells: Resource = map.snapshot()
	for key: Vector2i in (changed as Dictionary).keys():
		error = error if error != OK else _write_tile(cells, key, folder)
		if error == OK:
			changed.erase(key)
	if error == OK and stays:
		_watch(map, path)
	return error


## Returns true if [param resource] is a [PlantMap].
static func is_map(resource: Resource) -> bool:
	return resource != null and resource.is_class(MAP)


## Returns the files of all tiles of the index [param path].
static func list_files(path: String) -> PackedStringArray:
	var index := ConfigFile.new()
	if index.load(path) != OK:
		return []
	var folder := path.get_base_dir().path_join(index.get_value(SECTION, "folder", ""))
	var files: PackedStringArray = []
	for file in ResourceLoader.list_directory(folder):
		if _key_of(file) is Vector2i:
			files.append(folder.path_join(file))
	return files


## Returns the name of the folder with the tiles of [param path], in the same folder.
static func folder_of(path: String) -> String:
	var index := ConfigFile.new()
	var usual := path.get_file().get_basename() + FOLDER_SUFFIX
	return index.get_value(SECTION, "folder", usual) if index.load(path) == OK else usual


static func _read_tile(map: Resource, key: Vector2i, path: String) -> void:
	var tile := ResourceLoader.load(path, MAP, ResourceLoader.CACHE_MODE_IGNORE)
	if is_map(tile) and tile.cell_size == map.cell_size:
		map.restore(tile, _rect_of(map, key))
	else:
		push_error(path + " is not a tile of this map. Take it from your version control.")


static func _write_index(map: Resource, path: String) -> Error:
	var index := ConfigFile.new()
	index.set_value(SECTION, "format", FORMAT)
	index.set_value(SECTION, "cell_size", map.cell_size)
	index.set_value(SECTION, "folder", folder_of(path))
	return index.save(path)


# A tile without paint has no file.
static func _write_tile(cells: Resource, key: Vector2i, folder: String) -> Error:
	var path := folder.path_join(TILE_NAME % [key.x, key.y])
	var tile: Resource = ClassDB.instantiate(MAP)
	tile.cell_size = cells.cell_size
	tile.restore(cells, _rect_of(cells, key))
	var exists := FileAccess.file_exists(path)
	if not tile.get_painted_rect().has_area():
		return DirAccess.remove_absolute(path) if exists else OK
	if exists:
		var known := ResourceLoader.load(path, MAP, ResourceLoader.CACHE_MODE_IGNORE)
		if is_map(known) and known.data == tile.data:
			return OK
	return ResourceSaver.save(tile, path)


# The painted tiles, and those with a file.
static func _all_tiles(map: Resource, folder: String) -> Dictionary:
	var tiles := {}
	_add_tiles(map.get_painted_rect(), _side_of(map), tiles)
	for file in ResourceLoader.list_directory(folder):
		var key: Variant = _key_of(file)
		if key is Vector2i:
			tiles[key] = true
	return tiles


# The changed tiles are an argument of the connection: they exist as long as the map.
static func _watch(map: Resource, path: String) -> void:
	for connection in map.get_signal_connection_list(&"area_changed"):
		var listener: Callable = connection["callable"]
		if listener.get_method() == &"_add_tiles":
			map.area_changed.disconnect(listener)
	map.area_changed.connect(_add_tiles.bind(_side_of(map), {}, path))


# Returns null if the map was not read from or written to this index.
static func _find_changes(map: Resource, path: String) -> Variant:
	for connection in map.get_signal_connection_list(&"area_changed"):
		var listener: Callable = connection["callable"]
		var bound := listener.get_bound_arguments()
		if listener.get_method() == &"_add_tiles" and bound[2] == path:
			return bound[1]
	return null


static func _add_tiles(rect: Rect2, side: float, tiles: Dictionary, _path := "") -> void:
	if not rect.has_area():
		return
	var first := Vector2i((rect.position / side).floor())
	var last := Vector2i((rect.end / side).ceil()) - Vector2i.ONE
	for x in range(first.x, last.x + 1):
		for y in range(first.y, last.y + 1):
			tiles[Vector2i(x, y)] = true


static func _side_of(map: Resource) -> float:
	return map.cell_size * TILE_CELLS


# Half a cell smaller on each side: its border belongs to the next tile.
static func _rect_of(map: Resource, key: Vector2i) -> Rect2:
	var side := _side_of(map)
	return Rect2(Vector2(key) * side, Vector2.ONE * side).grow(-0.5 * map.cell_size)


static func _key_of(file: String) -> Variant:
	var parts := file.get_basename().split("_")
	var is_tile := (
		parts.size() == 3 and parts[0] == "tile" and file.get_extension() == TILE_EXTENSION
	)
	if not is_tile or not parts[1].is_valid_int() or not parts[2].is_valid_int():
		return null
	return Vector2i(parts[1].to_int(), parts[2].to_int())
