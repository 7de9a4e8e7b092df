## A field with painted densities of its species in plants/m²: sixty of grass and three tulips.
extends "res://tests/engine/field_map_harness.gd"

const DENSITY := 12.0
const RADIUS := 12.0
const PAINTED := 5.0
## The area in which plants are counted: inside the hard edge of the stroke for any grid of cells.
const COUNTED := RADIUS - 0.5
## Plants up to half a metre beside the stroke may be in cells that it touches.
const EDGE := RADIUS + 0.5
## Saved by 0.2.0: tulips as mixed, and 0.2 of grass, in the square of 4 m around the origin.
const MAP_OF_0_2 := (
	"VUdETQEA2AEAAAAAAD8CAAVUdWxpcAQAAAD///////////8A/wD/AP8A/wD/AP8AiwCB/5kAgf+ZAIH/mQCB//9A"
	+ "/0D/QP9A/0D/QP9A70D/////AAAAAJkAgf+ZAIH/mQCB/5kAgf//AP8A/wD/AP8A/wDxAP9A/0D/QP9A/0D/QP9A"
	+ "70AAAAAA//////8A/wD/AP8A/wD/APEAgf+ZAIH/mQCB/5kAgf+ZAP9A/0D/QP9A/0D/QP9A70AAAAAAAAAAAIH/"
	+ "mQCB/5kAgf+ZAIH//wD/AP8A/wD/AP8A/wCLAP9A/0D/QP9A/0D/QP9A70AFR3Jhc3MEAAAA////////////AP8A"
	+ "/wD/AP8A/wD/AIsAgTOZAIEzmQCBM5kAgTP/QP9A/0D/QP9A/0D/QO9A/////wAAAACZAIEzmQCBM5kAgTOZAIEz"
	+ "/wD/AP8A/wD/AP8A8QD/QP9A/0D/QP9A/0D/QO9AAAAAAP//////AP8A/wD/AP8A/wDxAIEzmQCBM5kAgTOZAIEz"
	+ "mQD/QP9A/0D/QP9A/0D/QO9AAAAAAAAAAACBM5kAgTOZAIEzmQCBM/8A/wD/AP8A/wD/AP8AiwD/QP9A/0D/QP9A"
	+ "/0D/QO9AOTKyOQ=="
)


func before_each() -> void:
	super()
	field.species[0].weight = 3.0
	field.species[1].weight = 60.0
	field.size = Vector2(40, 40)
	field.density = DENSITY
	for title: String in [TULIP, GRASS]:
		map.fill_polygon(field.get_outline_points(), title)
	field.map = map


func test_a_species_grows_as_densely_as_it_is_painted() -> void:
	for clumping: float in [0.0, 0.7]:
		field.clumping = clumping
		await _start_again()
		var before := all_plants()
		map.paint_plants(Vector3.ZERO, RADIUS, TULIP, PAINTED, 1.0, 0.0)
		await rested()
		check_near(_density_of(true), PAINTED, 0.3, "tulips/m² at clumping %s" % clumping)
		check_near(_density_of(true) + _density_of(false), DENSITY, 0.5, "plants/m²")
		_check_same_beside(before)
		map.paint_towards(Vector3.ZERO, RADIUS, TULIP, 1.0, 1.0, 0.0)
		await rested()
		check_equal(all_plants(), before, "its plants as mixed")


func test_a_stroke_and_a_full_build_give_the_same_plants() -> void:
	field.clumping = 0.7
	await _start_again()
	map.paint_plants(Vector3(3, 0, -2), 6.0, TULIP, 4.0, 0.6, 0.8)
	await rested()
	var painted := all_plants()
	field.rebuild()
	await filled(field)
	check_equal(all_plants(), painted, "plants after fill()")


func test_a_polygon_and_an_image_take_plants_per_square_metre() -> void:
	await _start_again()
	var square := Rect2(-12, -12, 24, 24)
	var corners := PackedVector3Array(
		[Vector3(-12, 0, -12), Vector3(12, 0, -12), Vector3(12, 0, 12), Vector3(-12, 0, 12)]
	)
	map.fill_polygon_plants(corners, TULIP, 3.0)
	await rested()
	check_near(_density_of(true), 3.0, 0.3, "tulips/m² of a polygon")
	var image := Image.create_empty(1, 1, false, Image.FORMAT_L8)
	image.fill(Color(0.4, 0.4, 0.4))
	map.set_from_image(image, square, TULIP, 0, 20.0)
	await rested()
	check_near(_density_of(true), 8.0, 0.35, "tulips/m² of an image")
	check_near(map.to_image(square, TULIP, 20.0).get_pixel(3, 3).r, 0.4, 0.005, "the image back")


func test_erasing_takes_painted_plants_away() -> void:
	await _start_again()
	map.paint_plants(Vector3.ZERO, RADIUS, TULIP, PAINTED, 1.0, 0.0)
	map.erase(Vector3.ZERO, RADIUS, TULIP, 0.5, 0.0)
	check_near(map.get_plant_density(Vector3.ZERO, TULIP), 0.5 * PAINTED, 0.01, "half of them")
	map.erase(Vector3.ZERO, RADIUS, TULIP, 1.0, 0.0)
	await rested()
	check_equal(_density_of(true), 0.0, "tulips/m²")
	check_near(_density_of(false), DENSITY * 60.0 / 63.0, 0.5, "grass/m²")


func test_a_file_keeps_painted_plants() -> void:
	map.paint_plants(Vector3.ZERO, RADIUS, TULIP, 5000.0, 1.0, 0.0)
	map.paint_plants(Vector3(4, 0, 0), 2.0, GRASS, 0.01, 1.0, 0.0)
	check_equal(ResourceSaver.save(map, "user://plants.tres"), OK, "saving")
	var loaded: PlantMap = ResourceLoader.load(
		"user://plants.tres", "", ResourceLoader.CACHE_MODE_IGNORE
	)
	check_equal(loaded.data, map.data, "data")
	check_near(loaded.get_plant_density(Vector3.ZERO, TULIP), 5000.0, 1.0, "dense")
	check_near(loaded.get_plant_density(Vector3(4, 0, 0), GRASS), 0.01, 2e-4, "sparse")


func test_a_map_of_0_2_0_is_as_it_was() -> void:
	var old := PlantMap.new()
	old.data = Marshalls.base64_to_raw(MAP_OF_0_2)
	check_equal(old.get_density(Vector3.ONE, TULIP), 1.0, "tulips")
	check_near(old.get_density(Vector3.ONE, GRASS), 0.2, 0.003, "grass")
	check_equal(old.get_plant_density(Vector3.ONE, TULIP), 0.0, "plants/m²")
	check_equal(Marshalls.raw_to_base64(old.data), MAP_OF_0_2, "its data when saved again")


func test_bad_densities_are_one_error_each_and_change_nothing() -> void:
	var before := map.data
	map.paint_plants(Vector3.ZERO, 3.0, TULIP, -1.0)
	check_error("density")
	map.paint_plants(Vector3.ZERO, 3.0, TULIP, NAN)
	check_error("density")
	map.paint_plants(Vector3.ZERO, 3.0, TULIP, 1.0, 2.0)
	check_error("paint_plants() needs finite numbers, and a strength")
	map.fill_polygon_plants(field.get_outline_points(), TULIP, 2e4)
	check_error("density")
	map.fill_polygon_plants(PackedVector3Array([Vector3.ZERO, Vector3.ONE]), TULIP, 2.0)
	check_error("fill_polygon_plants(): The area has fewer than three points")
	check_equal(map.data, before, "data")


func _start_again() -> void:
	if not field.is_inside_tree():
		root.add_child(field)
	field.rebuild()
	await filled(field)


# Returns tulips, or all remaining plants, per square metre in the stroke.
func _density_of(tulips: bool) -> float:
	var count := 0
	for id in field.get_plant_ids():
		var is_tulip := field.get_plant_species(id) is TulipFunction
		var distance := field.get_plant_transform(id).origin.length()
		count += int(is_tulip == tulips and distance < COUNTED)
	return count / (PI * COUNTED * COUNTED)


func _check_same_beside(before: Dictionary) -> void:
	var now := all_plants()
	var compared := 0
	for id: int in before:
		var place: Transform3D = before[id][0]
		if place.origin.length() > EDGE:
			check_equal(now.get(id), before[id], "plant %d beside the stroke" % id)
			compared += 1
	check(compared > 5000, "%d plants beside the stroke" % compared)
