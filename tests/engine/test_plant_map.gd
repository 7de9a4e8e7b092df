## Painting and saving of a map, and its errors for invalid input.
extends "res://tests/engine/harness.gd"

const FILES: PackedStringArray = ["user://painted.tres", "user://painted.res"]
const BED := Vector3(2.0, 7.0, -5.0)

var map: PlantMap
var rects: Array[Rect2] = []
var changes := 0


func before_each() -> void:
	map = PlantMap.new()
	rects = []
	changes = 0
	map.area_changed.connect(func(rect: Rect2) -> void: rects.append(rect))
	map.changed.connect(func() -> void: changes += 1)


func test_a_new_map_is_empty() -> void:
	check_equal(map.get_density(Vector3.ZERO, "Poppy"), 0.0, "density")
	check_equal(map.get_height_factor(Vector3.ZERO, "Poppy"), 1.0, "height")
	check_equal(map.get_painted_species(), PackedStringArray(), "species")
	check_equal(map.get_painted_rect(), Rect2(), "rectangle")
	check_equal(map.cell_size, 0.5, "cells")


func test_a_stroke_is_painted_and_emits_its_rectangle() -> void:
	map.paint(BED, 3.0, "Poppy", 0.8, 0.0)
	check_near(map.get_density(BED, "Poppy"), 0.8, 0.003, "density in the middle")
	check_near(map.get_density(BED + Vector3(2.7, 0, 0), "Poppy"), 0.8, 0.003, "at the edge")
	check_equal(map.get_density(BED + Vector3(3.3, 0, 0), "Poppy"), 0.0, "beside it")
	check_equal(map.get_density(BED, "Grass"), 0.0, "of another species")
	check_equal(rects, [Rect2(-1, -8, 6, 6)] as Array[Rect2], "what changed")
	check_equal(changes, 1, "changes")
	check(map.get_painted_rect().encloses(Rect2(-1, -8, 6, 6)), "the painted rectangle holds it")


func test_a_stroke_without_effect_emits_nothing() -> void:
	map.erase(BED, 3.0)
	map.smooth(BED, 3.0, "Poppy")
	map.paint(BED, 3.0, "Poppy", 0.0)
	check_equal(rects.size(), 0, "signals")


func test_erasing_without_a_name_is_of_all() -> void:
	for title: String in ["Poppy", "Grass", "Fern"]:
		map.paint(BED, 4.0, title, 1.0, 0.0)
	map.erase(BED, 2.0, "Poppy", 1.0, 0.0)
	check_equal(map.get_density(BED, "Poppy"), 0.0, "poppies")
	check_equal(map.get_density(BED, "Grass"), 1.0, "grass")
	map.erase(BED, 6.0, "", 1.0, 0.0)
	check_equal(map.get_painted_species(), PackedStringArray(), "species then")


func test_density_and_height_reach_their_properties() -> void:
	map.paint(BED, 4.0, "Poppy", 1.0, 0.0)
	map.paint_towards(BED, 4.0, "Poppy", 0.5, 0.5, 0.0)
	check_near(map.get_density(BED, "Poppy"), 0.75, 0.005, "density half the way")
	map.paint_towards(BED, 4.0, "Poppy", 0.5, 1.0, 0.0)
	check_near(map.get_density(BED, "Poppy"), 0.5, 0.005, "density")
	map.paint_height(BED, 4.0, "Poppy", 1.5, 1.0, 0.0)
	check_equal(map.get_height_factor(BED, "Poppy"), 1.5, "height")
	map.smooth(BED + Vector3(4, 0, 0), 2.0, "", 1.0, 0.0)
	var edge := map.get_density(BED + Vector3(3.9, 0, 0), "Poppy")
	check(edge > 0.05 and edge < 0.45, "the edge is smooth: %f" % edge)


func test_an_image_is_a_mask_and_comes_back() -> void:
	var image := Image.create_empty(4, 2, false, Image.FORMAT_RGBA8)
	for x in 4:
		for y in 2:
			image.set_pixel(x, y, Color(0.0, x / 4.0, float(y), 1.0))
	map.set_from_image(image, Rect2(-1, 3, 2, 1), "Poppy", 1)
	check_equal(rects, [Rect2(-1, 3, 2, 1)] as Array[Rect2], "what changed")
	check_near(map.get_density(Vector3(-0.9, 0, 3.1), "Poppy"), 0.0, 0.003, "left")
	check_near(map.get_density(Vector3(0.9, 0, 3.9), "Poppy"), 0.75, 0.003, "right")
	map.set_from_image(image, Rect2(-1, 3, 2, 1), "Grass", 2)
	check_near(map.get_density(Vector3(0.9, 0, 3.9), "Grass"), 1.0, 0.003, "lower")
	check_near(map.get_density(Vector3(0.9, 0, 3.1), "Grass"), 0.0, 0.003, "upper")
	var back := map.to_image(Rect2(-1, 3, 2, 1), "Poppy")
	check_equal(back.get_size(), Vector2i(4, 2), "size")
	for x in 4:
		check_near(back.get_pixel(x, 1).r, x / 4.0, 0.005, "pixel %d" % x)


func test_a_polygon_is_filled() -> void:
	var points := PackedVector3Array([Vector3(0, 0, 0), Vector3(4, 0, 0), Vector3(0, 0, 4)])
	map.fill_polygon(points, "Poppy", 0.4)
	check_near(map.get_density(Vector3(1, 0, 1), "Poppy"), 0.4, 0.003, "inside")
	check_equal(map.get_density(Vector3(3, 0, 3), "Poppy"), 0.0, "outside")


func test_files_bring_back_what_was_painted() -> void:
	map.cell_size = 0.25
	map.paint(BED, 3.0, "Poppy", 0.8, 0.7)
	map.paint(Vector3(-900, 0, 1200), 3.0, "Mädesüß", 0.3)
	map.paint_height(BED, 2.0, "Poppy", 0.5)
	for file in FILES:
		check_equal(ResourceSaver.save(map, file), OK, "saving " + file)
		var loaded: PlantMap = ResourceLoader.load(file, "", ResourceLoader.CACHE_MODE_IGNORE)
		check_equal(loaded.cell_size, 0.25, "cells")
		check_equal(loaded.data, map.data, "data")
		check_equal(
			loaded.get_density(BED, "Poppy"), map.get_density(BED, "Poppy"), "density of " + file
		)
		check_equal(loaded.get_painted_species().size(), 2, "species")


func test_a_painted_hectare_takes_no_more_than_100_kib() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for i in 1000:
		var place := Vector3(rng.randf_range(-50, 50), 0, rng.randf_range(-50, 50))
		map.paint(place, rng.randf_range(2, 6), "Poppy", 0.3)
	for file in FILES:
		ResourceSaver.save(map, file)
		var length := FileAccess.get_file_as_bytes(file).size()
		check(length <= 100 * 1024, "%s has %d bytes" % [file, length])
		print("hectare: %s %d bytes" % [file, length])


func test_data_that_are_no_map_are_one_error_and_stay() -> void:
	map.paint(BED, 3.0, "Poppy")
	var whole := map.data
	var later := whole.duplicate()
	later[4] = 9
	for faulty: Array in [
		[whole.slice(0, whole.size() - 9), "cut off or damaged"],
		[later, "saved by a later release"],
		[PackedByteArray([1, 2, 3]), "not those of a map"],
	]:
		var other := PlantMap.new()
		other.data = faulty[0]
		check_error(faulty[1])
		check_equal(other.data, faulty[0], "data")
		other.paint(BED, 3.0, "Poppy")
		other.erase(BED, 3.0)
		check_error("cannot be changed: ")
		check_equal(other.data, faulty[0], "data after a stroke")
		check_equal(ResourceSaver.save(other, FILES[0]), OK, "saving")
		var text := FileAccess.get_file_as_string(FILES[0])
		check(text.contains("data = "), "its data are saved again")
		other.clear()
		other.paint(BED, 3.0, "Poppy")
		check_equal(other.get_density(BED, "Poppy"), 1.0, "density after clear()")


func test_bad_strokes_are_one_error_each_and_change_nothing() -> void:
	map.paint(Vector3(1e6, 0, 0), 3.0, "Poppy")
	check_error("paint() needs a centre within 100 km")
	map.paint(Vector3(NAN, 0, 0), 3.0, "Poppy")
	check_error("paint() needs a centre within 100 km")
	map.erase(BED, -1.0)
	check_error("erase() needs a centre within 100 km")
	map.paint(BED, 101.0, "Poppy")
	check_error("a radius above 0 and up to 100 m")
	map.paint(BED, 3.0, "")
	check_error("paint() needs the name of a species")
	map.paint(BED, 3.0, "Poppy", 2.0)
	check_error("amount")
	map.paint_towards(BED, 3.0, "Poppy", NAN)
	check_error("paint_towards() needs finite numbers")
	map.smooth(BED, 3.0, "", 5.0)
	check_error("smooth() needs finite numbers, and a strength")
	map.set_from_image(null, Rect2(0, 0, 1, 1), "Poppy")
	check_error("set_from_image() needs an image")
	map.set_from_image(
		Image.create_empty(1, 1, false, Image.FORMAT_L8), Rect2(0, 0, 9e4, 9e4), "Poppy"
	)
	check_error("up to 16 million cells")
	map.fill_polygon(PackedVector3Array([Vector3.ZERO, Vector3.ONE]), "Poppy")
	check_error("fill_polygon(): The area has fewer than three points")
	map.cell_size = 7.0
	check_error("cell_size")
	check_equal(rects.size(), 0, "signals")


func test_cells_keep_their_size_once_something_is_painted() -> void:
	map.cell_size = 1.0
	map.paint(BED, 3.0, "Poppy")
	map.cell_size = 2.0
	check_error("keeps its cell_size")
	check_equal(map.cell_size, 1.0, "size")


func test_a_snapshot_stays_and_brings_back_what_was() -> void:
	map.paint(BED, 3.0, "Poppy", 1.0, 0.0)
	var before := map.snapshot()
	map.erase(BED, 3.0, "Poppy", 1.0, 0.0)
	map.paint(BED, 3.0, "Grass", 1.0, 0.0)
	check_equal(before.get_density(BED, "Poppy"), 1.0, "density of the snapshot")
	rects = []
	map.restore(before, Rect2(BED.x - 4, BED.z - 4, 4, 8))
	check_equal(map.get_density(BED - Vector3(1, 0, 0), "Poppy"), 1.0, "density that came back")
	check_equal(map.get_density(BED - Vector3(1, 0, 0), "Grass"), 0.0, "density that went")
	check_equal(map.get_density(BED + Vector3(1, 0, 0), "Poppy"), 0.0, "density beside it")
	check_equal(rects.size(), 1, "signals")
	map.restore(before, Rect2(BED.x - 4, BED.z - 4, 4, 8))
	check_equal(rects.size(), 1, "signals where nothing changes")
