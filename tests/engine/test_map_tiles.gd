## Maps in files in tiles: which files a save writes, and the merge of two copies.
extends "res://tests/engine/harness.gd"

const MapTiles := preload("res://addons/undergrowth/maps/map_tiles.gd")
const FOLDER := "user://map_tiles"
const LoaderScript := preload("res://addons/undergrowth/maps/plant_map_loader.gd")
const SaverScript := preload("res://addons/undergrowth/maps/plant_map_saver.gd")
## Places in four tiles of 32 m.
const HERE := Vector3(5, 0, 5)
const THERE := Vector3(100, 0, -70)
const ELSEWHERE := Vector3(-40, 0, 40)
const EMPTY := Vector3(300, 0, 300)

var loader := LoaderScript.new()
var saver := SaverScript.new()


func before_each() -> void:
	_remove(FOLDER)
	ResourceLoader.add_resource_format_loader(loader)
	ResourceSaver.add_resource_format_saver(saver)


func after_each() -> void:
	ResourceLoader.remove_resource_format_loader(loader)
	ResourceSaver.remove_resource_format_saver(saver)
	_remove(FOLDER)


func test_a_map_in_tiles_is_read_as_it_was_written() -> void:
	var map := _painted([HERE, THERE, ELSEWHERE])
	map.paint_height(HERE, 2.0, "Poppy", 1.5)
	map.paint_plants(Vector3(32, 0, 0), 4.0, "Oat", 3.0, 1.0, 0.0)
	map.paint_scale_jitter(HERE, 2.0, "Poppy", 0.5, 1.0, 0.0)
	map.paint_color_jitter(THERE, 2.0, "Poppy", 0.75, 1.0, 0.0)
	_save(map, "a")
	var read := _load("a")
	check_equal(read.get_painted_rect(), map.get_painted_rect(), "painted rectangle")
	check_near(read.get_scale_jitter(HERE, "Poppy"), 0.5, 0.01, "jitter of scale")
	check_near(read.get_color_jitter(THERE, "Poppy"), 0.75, 0.01, "jitter of color")
	var names := ["Poppy", "Oat"]
	for title: String in names:
		for x in range(-50, 110, 1):
			for z in range(-75, 50, 5):
				var place := Vector3(x + 0.25, 0, z + 0.25)
				check_equal(_values(read, place, title), _values(map, place, title), str(place))


func test_a_tile_has_a_file_and_the_index_stays() -> void:
	var map := _painted([HERE, THERE])
	_save(map, "a")
	check_equal(_tiles("a"), PackedStringArray(["tile_0_0.res", "tile_3_-3.res"]), "files")
	var index := FileAccess.get_file_as_bytes(_index("a"))
	check(index.size() > 0, "it has content")
	map.paint(ELSEWHERE, 3.0, "Poppy")
	_save(map, "a")
	check_equal(_tiles("a").size(), 3, "files")
	check_equal(FileAccess.get_file_as_bytes(_index("a")), index, "the index")


func test_a_tile_contains_its_own_cells_only() -> void:
	_save(_painted([Vector3(32, 0, 32)]), "a")
	check_equal(_tiles("a").size(), 4, "files")
	for file in _tiles("a"):
		var numbers := file.get_basename().split("_")
		var corner := Vector2(numbers[1].to_int(), numbers[2].to_int()) * 32.0
		var tile := load(FOLDER.path_join("a/map_tiles").path_join(file)) as PlantMap
		check(Rect2(corner, Vector2(32, 32)).encloses(tile.get_painted_rect()), file)


func test_only_changed_tiles_are_written() -> void:
	var map := _painted([HERE, THERE])
	_save(map, "a")
	var file := FOLDER.path_join("a/map_tiles/tile_3_-3.res")
	DirAccess.remove_absolute(file)
	map.paint(HERE, 3.0, "Poppy", 0.2)
	_save(map, "a")
	check(not FileAccess.file_exists(file), "the tile without a change was written")
	map.paint(THERE, 3.0, "Poppy", 0.2)
	_save(map, "a")
	check(FileAccess.file_exists(file), "the tile with a change was not written")


func test_two_copies_painted_in_different_places_are_merged_by_their_files() -> void:
	_save(_painted([HERE]), "a")
	_copy("a", "b")
	for copy: Array in [["a", THERE], ["b", ELSEWHERE]]:
		var map := _load(copy[0])
		map.paint(copy[1], 3.0, "Poppy")
		_save(map, copy[0])
	check_equal(_changed("a", "b"), PackedStringArray(["tile_-2_1.res", "tile_3_-3.res"]), "differ")
	_copy("b", "a")
	var merged := _load("a")
	for place: Vector3 in [HERE, THERE, ELSEWHERE]:
		check(merged.get_density(place, "Poppy") > 0.9, "painted at %s" % place)
	check_equal(merged.get_density(EMPTY, "Poppy"), 0.0, "where none painted")


func test_tiles_that_others_added_stay_when_an_older_copy_is_saved() -> void:
	_save(_painted([HERE]), "a")
	var older := _load("a")
	var other := _load("a")
	other.paint(THERE, 3.0, "Poppy")
	_save(other, "a")
	older.paint(ELSEWHERE, 3.0, "Poppy")
	_save(older, "a")
	check(_load("a").get_density(THERE, "Poppy") > 0.9, "the tile of the other is gone")


func test_a_tile_that_is_empty_has_no_file() -> void:
	var map := _painted([HERE, THERE])
	_save(map, "a")
	map.erase(THERE, 20.0, "", 1.0, 0.0)
	_save(map, "a")
	check_equal(_tiles("a"), PackedStringArray(["tile_0_0.res"]), "files")


func test_undone_strokes_are_written_too() -> void:
	var map := _painted([HERE])
	_save(map, "a")
	var before := map.snapshot()
	map.paint(HERE, 3.0, "Oat")
	_save(map, "a")
	map.restore(before, Rect2(0, 0, 10, 10))
	_save(map, "a")
	check_equal(_load("a").get_density(HERE, "Oat"), 0.0, "density after undo")
	check(_load("a").get_density(HERE, "Poppy") > 0.9, "the older stroke is kept")


func test_a_damaged_index_is_one_error() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER.path_join("a"))
	FileAccess.open(_index("a"), FileAccess.WRITE).store_string("[plant_map]\nformat=7\n")
	check(MapTiles.read(_index("a")) == null, "a map was read")
	check_error("map.plantmap is from a later release")


func _painted(places: Array[Vector3]) -> PlantMap:
	var map := PlantMap.new()
	for place in places:
		map.paint(place, 3.0, "Poppy")
	return map


func _values(map: PlantMap, place: Vector3, title: String) -> Array:
	var plants := map.get_plant_density(place, title)
	return [map.get_density(place, title), map.get_height_factor(place, title), plants]


func _index(folder: String) -> String:
	return FOLDER.path_join(folder).path_join("map.plantmap")


func _save(map: PlantMap, folder: String) -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER.path_join(folder))
	var flags := ResourceSaver.FLAG_CHANGE_PATH if map.resource_path.is_empty() else 0
	check_equal(ResourceSaver.save(map, _index(folder), flags), OK, "saved")


func _load(folder: String) -> PlantMap:
	return ResourceLoader.load(_index(folder), "", ResourceLoader.CACHE_MODE_IGNORE) as PlantMap


func _tiles(folder: String) -> PackedStringArray:
	return DirAccess.get_files_at(FOLDER.path_join(folder).path_join("map_tiles"))


# Names of the tiles that only one of the folders has, or that differ.
func _changed(first: String, second: String) -> PackedStringArray:
	var names: PackedStringArray = []
	for file in _tiles(first) + _tiles(second):
		var bytes: Array[PackedByteArray] = []
		for folder: String in [first, second]:
			bytes.append(
				FileAccess.get_file_as_bytes("%s/%s/map_tiles/%s" % [FOLDER, folder, file])
			)
		if bytes[0] != bytes[1] and not file in names:
			names.append(file)
	names.sort()
	return names


func _copy(from: String, to: String) -> void:
	DirAccess.make_dir_recursive_absolute("%s/%s/map_tiles" % [FOLDER, to])
	DirAccess.copy_absolute(_index(from), _index(to))
	for file in _tiles(from):
		var path := "map_tiles/" + file
		DirAccess.copy_absolute("%s/%s/%s" % [FOLDER, from, path], "%s/%s/%s" % [FOLDER, to, path])


func _remove(folder: String) -> void:
	if not DirAccess.dir_exists_absolute(folder):
		return
	for inner in DirAccess.get_directories_at(folder):
		_remove(folder.path_join(inner))
	for file in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	DirAccess.remove_absolute(folder)
