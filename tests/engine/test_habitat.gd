## PlantHabitat: where the species of a field grow.
extends "res://tests/engine/field_harness.gd"

const HALF := 10.0  # Metres, half of the field's side.
const HILL := 4.0  # Metres, height of the ground's waves.
const POLLING_FRAMES := 10  # Moved nodes are found every 8 frames.

var _habitat: PlantHabitat


## Hills without normals.
class Hills:
	extends Node3D

	func get_height(place: Vector3) -> float:
		return HILL * sin(0.3 * place.x)


func before_each() -> void:
	_habitat = PlantHabitat.new()
	field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	field.size = Vector2.ONE * 2.0 * HALF
	field.density = 12.0
	field.species[0].habitat = _habitat


func test_plants_follow_the_height_of_the_ground() -> void:
	_lay_on_hills()
	await start()
	var all := places_of(0)
	var others := places_of(1)
	_habitat.height_curve = PlantHabitat.make_curve([Vector2(0.0, 0.0), Vector2(0.02, 1.0)])
	await rested()
	var left := places_of(0)
	var expected := 0
	for id in all:
		expected += 1 if all[id].y > 0.01 else 0
	check(absi(left.size() - expected) <= 5, "%d plants, not %d" % [left.size(), expected])
	for id in left:
		check(left[id].y > -1e-4, "height %f" % left[id].y)
		check_equal(left[id], all.get(id), "place of a plant that stays")
	check_equal(places_of(1), others, "plants of the other species")
	_habitat.height_curve = null
	await rested()
	check_equal(places_of(0), all, "plants without the curve")


func test_plants_follow_the_slope_in_degrees() -> void:
	_lay_on_hills()
	_habitat.slope_curve = PlantHabitat.make_curve(
		[Vector2(0.0, 1.0), Vector2(30.0, 1.0), Vector2(30.1, 0.0)]
	)
	await start()
	var places := places_of(0)
	check(places.size() > 100, "%d plants" % places.size())
	for id in places:
		check(_slope(places[id].x) < 32.5, "slope %f" % _slope(places[id].x))
	for id in places_of(1):
		if _slope(places_of(1)[id].x) > 40.0:
			return
	check(false, "the other species does not grow on steep ground")


func test_a_texture_lies_on_the_field() -> void:
	var image := Image.create_empty(4, 2, false, Image.FORMAT_RGBA8)
	image.set_pixel(3, 1, Color(0.0, 1.0, 0.0))
	_habitat.texture = ImageTexture.create_from_image(image)
	_habitat.texture_size = Vector2(16, 8)
	_habitat.texture_offset = Vector2(1, 2)
	_habitat.texture_channel = PlantHabitat.CHANNEL_GREEN
	_habitat.texture_repeat = false
	_habitat.texture_curve = PlantHabitat.make_curve([Vector2(0.5, 0.0), Vector2(0.52, 1.0)])
	await start()
	# The pixel's centre is at (7, 4). Beyond the texture its border continues.
	var left := places_of(0)
	check(left.size() > 20, "%d plants" % left.size())
	for id in left:
		check(left[id].x > 5.0 and left[id].z > 2.0, "at %v" % left[id])
	_habitat.texture_channel = PlantHabitat.CHANNEL_RED
	await rested()
	check_equal(places_of(0).size(), 0, "in the channel without the pixel")


func test_noise_counts_when_it_is_generated() -> void:
	var noise := NoiseTexture2D.new()
	noise.width = 64
	noise.height = 64
	noise.seamless = true
	noise.noise = FastNoiseLite.new()
	_habitat.texture = noise
	await start()
	await until(func() -> bool: return noise.get_image() != null, "the noise is generated")
	await rested()
	var count := places_of(0).size()
	_habitat.texture = null
	await rested()
	var all := places_of(0).size()
	check(count > 0.25 * all and count < 0.75 * all, "%d of %d plants" % [count, all])


func test_plants_keep_a_distance_from_a_group() -> void:
	add_path("Brook", [Vector3(-20, 0, 0), Vector3(20, 0, 0)])
	var brook := field.get_node("Brook") as Path3D
	brook.add_to_group(&"water")
	_habitat.distance_group = &"water"
	_habitat.distance_curve = PlantHabitat.make_curve(
		[Vector2(0.0, 1.0), Vector2(2.0, 1.0), Vector2(2.01, 0.0)]
	)
	await start()
	_check_along(0.0)
	brook.position.z = 4.0
	await frames(POLLING_FRAMES)
	await rested()
	_check_along(4.0)
	brook.curve.set_point_position(0, Vector3(-20, 0, 2))
	brook.curve.set_point_position(1, Vector3(20, 0, 2))
	await rested()
	_check_along(6.0)


func test_the_inside_of_a_closed_path_is_near() -> void:
	var corners: Array[Vector3] = [
		Vector3(-6, 0, -6),
		Vector3(6, 0, -6),
		Vector3(6, 0, 6),
		Vector3(-6, 0, 6),
		Vector3(-6, 0, -6)
	]
	add_path("Pond", corners)
	field.get_node("Pond").add_to_group(&"water")
	_habitat.distance_group = &"water"
	_habitat.distance_curve = PlantHabitat.make_curve([Vector2(0.0, 1.0), Vector2(0.02, 0.0)])
	await start()
	var left := places_of(0)
	check(left.size() > 300, "%d plants" % left.size())
	for id in left:
		check(maxf(absf(left[id].x), absf(left[id].z)) < 6.1, "at %v" % left[id])


func test_tiles_of_a_streamed_field_have_the_plants_of_the_whole() -> void:
	_lay_on_hills()
	_habitat.height_curve = PlantHabitat.make_curve([Vector2(-4.0, 0.0), Vector2(4.0, 1.0)])
	await start()
	var whole := places_of(0)
	field.tile_size = 5.0
	field.view_distance = 40.0
	field.add_child(Camera3D.new())
	await rested()
	check_equal(places_of(0).keys().size(), whole.size(), "plants of tiles")
	for id in places_of(0):
		check(id in whole, "plant %d" % id)


func test_a_change_of_meshes_keeps_the_plants() -> void:
	_lay_on_hills()
	_habitat.height_curve = PlantHabitat.make_curve([Vector2(0.0, 0.0), Vector2(4.0, 1.0)])
	await start()
	var before := sorted_ids()
	field.tile_size = 7.0
	await rested()
	check_equal(sorted_ids(), before, "ids")


func test_a_painted_map_and_a_habitat_multiply() -> void:
	var map := PlantMap.new()
	map.fill_polygon(
		[Vector3(-10, 0, -10), Vector3(0, 0, -10), Vector3(0, 0, 10), Vector3(-10, 0, 10)],
		field.species[0].get_layer_name(),
		0.5
	)
	field.map = map
	await start()
	var painted := places_of(0)
	_habitat.height_curve = PlantHabitat.make_curve([Vector2(-1.0, 0.5), Vector2(1.0, 0.5)])
	await rested()
	var left := places_of(0)
	for id in left:
		check(id in painted, "plant %d is painted" % id)
	check_near(left.size() / float(painted.size()), 0.5, 0.06, "share of the painted plants")
	map.paint(Vector3(-5, 0, 0), 3.0, field.species[0].get_layer_name(), 1.0, 0.0)
	await rested()
	check(places_of(0).size() > left.size() + 20, "painting adds plants")
	field.rebuild()
	var strokes := places_of(0)
	await filled(field)
	check_equal(places_of(0).size(), strokes.size(), "plants of a whole build")


func test_a_new_curve_has_the_domain_of_its_factor() -> void:
	for pair: Array in [["slope_curve", 90.0], ["height_curve", 100.0], ["distance_curve", 10.0]]:
		var curve := Curve.new()
		_habitat.set(pair[0], curve)
		check_equal(curve.max_domain, pair[1], pair[0])
		check_equal(curve.sample(0.5 * curve.max_domain), 1.0, "suitability")
	var own := Curve.new()
	own.max_domain = 40.0
	own.add_point(Vector2(3, 0.5))
	_habitat.slope_curve = own
	check_equal(own.point_count, 1, "points of a curve that is not new")
	check_equal(own.max_domain, 40.0, "its domain")


func test_each_change_is_signalled_once() -> void:
	var counts := [0]
	field.species[0].changed.connect(func() -> void: counts[0] += 1)
	var settings := {
		"slope_curve": PlantHabitat.make_curve([Vector2(0, 0), Vector2(1, 1)]),
		"texture": PlaceholderTexture2D.new(),
		"texture_size": Vector2(5, 6),
		"texture_offset": Vector2(1, 2),
		"texture_channel": PlantHabitat.CHANNEL_ALPHA,
		"texture_repeat": false,
		"distance_group": &"water",
	}
	for property: String in settings:
		for again in 2:
			_habitat.set(property, settings[property])
		check_equal(counts[0], 1, property)
		counts[0] = 0
	var curve: Curve = settings["slope_curve"]
	curve.set_point_value(0, 0.25)
	check_equal(counts[0], 1, "a point of a curve")
	_habitat.slope_curve = null
	counts[0] = 0
	curve.set_point_value(0, 0.5)
	check_equal(counts[0], 0, "a curve that is no longer used")


func test_bad_values_are_errors_and_are_not_kept() -> void:
	for bad: Vector2 in [Vector2(0, 1), Vector2(1, -1), Vector2(NAN, 1), Vector2(1, 2e5)]:
		_habitat.texture_size = bad
		check_error("texture_size cannot be ")
	check_equal(_habitat.texture_size, Vector2(20, 20))
	_habitat.texture_offset = Vector2(INF, 0)
	check_error("texture_offset cannot be ")
	_habitat.set(&"texture_channel", 4)
	check_error("texture_channel cannot be ")
	for points: PackedVector2Array in [
		[], [Vector2(0, 1)], [Vector2(1, 0), Vector2(0, 1)], [Vector2(0, 2), Vector2(1, 1)]
	]:
		check(PlantHabitat.make_curve(points) == null, "a curve of %s" % points)
		check_error("PlantHabitat.make_curve() needs two or more points")


func _lay_on_hills() -> void:
	var hills := Hills.new()
	hills.name = "Hills"
	field.add_child(hills)
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = ^"Hills"


# Degrees.
func _slope(x: float) -> float:
	return rad_to_deg(atan(absf(0.3 * HILL * cos(0.3 * x))))


func _check_along(z: float) -> void:
	var places := places_of(0)
	check(places.size() > 200, "%d plants" % places.size())
	for id in places:
		check(absf(places[id].z - z) < 2.02, "at %v" % places[id])
