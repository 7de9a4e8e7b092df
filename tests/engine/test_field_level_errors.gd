## Levels of species of parts, which are chosen by the error of their outlines.
extends "res://tests/engine/field_harness.gd"

const FERN := "res://addons/undergrowth/species/male_fern.tres"
const MEADOW := "res://addons/undergrowth/mixes/meadow.tscn"
const SPECIES := "res://addons/undergrowth/species/%s.tres"
const LAWN := "res://addons/undergrowth/mixes/lawn.tscn"
const WHEAT := "res://addons/undergrowth/mixes/wheat_field.tscn"
const GRASS := "res://addons/undergrowth/species/meadow_grass.tres"


func before_each() -> void:
	field = PlantField3D.from_species([load(FERN), load(GRASS)])
	field.species[0].weight = 0.05
	field.density = 5.0
	field.size = Vector2(6, 6)
	field.simulation_enabled = false


func test_each_species_has_its_own_distances() -> void:
	await start()
	for listed: Dictionary in _levels():
		var ends: PackedFloat32Array = listed["ends"]
		var segments: PackedInt32Array = listed["segments"]
		var errors: PackedFloat32Array = listed["errors"]
		check(ends.size() >= 3, "%s" % listed)
		check_equal(ends[-1], 0.0, "the last one has no end")
		for i in ends.size() - 1:
			check(segments[i + 1] < segments[i], "segments %s" % segments)
			check(errors[i + 1] >= errors[i], "errors %s" % errors)
			check(i == ends.size() - 2 or ends[i + 1] > ends[i], "ends %s" % ends)
	check(_end_of_finest(0) != _end_of_finest(1), "a fern is not a grass")


func test_the_distance_is_the_error_over_the_allowed_pixels() -> void:
	field.pixel_error = 2.0
	await start()
	var listed: Dictionary = _levels()[0]
	var ends: PackedFloat32Array = listed["ends"]
	var errors: PackedFloat32Array = listed["errors"]
	check_near(ends[0], errors[1] * 703.7 / 2.0, 0.01 * ends[0], "end of the first level")
	field.pixel_error = 4.0
	await rested()
	listed = _levels()[0]
	ends = listed["ends"]
	errors = listed["errors"]
	check_near(ends[0], errors[1] * 703.7 / 4.0, 0.01 * ends[0], "with twice the error")


func test_a_bias_of_a_species_multiplies_its_distances_only() -> void:
	await start()
	var before := [_levels()[0]["ends"], _levels()[1]["ends"]]
	var builds := [0]
	field.build_finished.connect(func() -> void: builds[0] += 1)
	field.species[0].lod_bias = 1.5
	await rested()
	check_equal(builds[0], 0, "builds: no plant is placed again")
	var after := [_levels()[0]["ends"], _levels()[1]["ends"]]
	check_near(after[0][-2], 1.5 * before[0][-2], 0.01 * after[0][-2], "of the fern")
	check_equal(after[1], before[1], "of the grass")


func test_dense_species_change_their_levels_nearer() -> void:
	field.size = Vector2(100, 100)
	field.density = 0.5
	await start()
	var sparse: PackedFloat32Array = _levels()[1]["ends"]
	field.size = Vector2(20, 20)
	field.density = 60.0
	await rested()
	var dense: PackedFloat32Array = _levels()[1]["ends"]
	check(dense[-2] < 0.8 * sparse[-2], "%s, sparse %s" % [dense, sparse])


func test_plants_near_the_camera_keep_their_form_from_level_to_level() -> void:
	field.free()
	field = (load(MEADOW) as PackedScene).instantiate()
	field.simulation_enabled = false
	field.size = Vector2(10, 10)
	await start()
	for listed: Dictionary in _levels():
		var begin := 0.0
		for i in listed["ends"].size():
			var end: float = listed["ends"][i]
			if begin < 4.0 and end > 0.0 and end < 20.0:
				check(listed["variants"][i] >= 2, "from %.1f m on: %s" % [begin, listed])
			begin = end


func test_ears_on_cards_do_not_become_solid_between_two_near_levels() -> void:
	field.free()
	field = (load(WHEAT) as PackedScene).instantiate()
	field.simulation_enabled = false
	var builds := [0]
	field.build_finished.connect(func() -> void: builds[0] += 1)
	await start()
	await rested()
	var carded: PackedByteArray = _levels()[0]["are_carded"]
	var ends: PackedFloat32Array = _levels()[0]["ends"]
	check_equal(carded[-1], 0, "the last level is solid")
	check_equal(carded[-2], 1, "the level before it has cards: %s" % _levels()[0])
	check(ends[-2] > 5.0, "ears end at %s" % ends)
	check_equal(builds[0], 1, "builds")


func test_plumes_and_flowers_are_on_cards_where_solid_ones_would_be_lumps() -> void:
	for known: Array in [["common_reed", 0], ["yarrow", -1], ["garden_tulip", -1]]:
		field.free()
		field = PlantField3D.from_species([load(SPECIES % known[0])])
		field.density = 0.5
		field.size = Vector2(6, 6)
		await start()
		check_equal(_levels()[0]["are_carded"][known[1]], 1, "cards of %s" % [known])


## A single variant of the grass in this mix has no panicle.
func test_a_species_has_cards_also_if_one_of_its_variants_has_none() -> void:
	field.free()
	field = (load(MEADOW) as PackedScene).instantiate()
	field.simulation_enabled = false
	await start()
	var carded: PackedByteArray = _levels()[0]["are_carded"]
	check_equal(carded[1], 1, "cards of meadow grass: %s" % _levels()[0])


func test_a_dense_lawn_has_levels_between_near_and_far_ones() -> void:
	field.free()
	field = (load(LAWN) as PackedScene).instantiate()
	field.simulation_enabled = false
	await start()
	var segments: PackedInt32Array = _levels()[0]["segments"]
	check(5 in segments, "of 8 and 2: %s" % segments)
	check(_levels()[0]["ends"][-2] > 5.0, "the coarsest one begins at %s" % _levels()[0]["ends"])


## Plants beside and behind a low camera are drawn too.
func test_few_triangles_of_a_dense_species_are_around_a_camera() -> void:
	field.free()
	field = (load(WHEAT) as PackedScene).instantiate()
	field.simulation_enabled = false
	await start()
	var segments: PackedInt32Array = _levels()[0]["segments"]
	var ends: PackedFloat32Array = _levels()[0]["ends"]
	var plants := 80.0  # Per m².
	for i in ends.size() - 2:
		var area := PI * (ends[i] + 0.3) * (ends[i] + 0.3)
		var triangles: float = _levels()[0]["triangles"][i] * plants * area
		check(
			triangles < 0.4e6, "%.0f with %d segments to %.1f m" % [triangles, segments[i], ends[i]]
		)


## Its last form has two of sixteen heads.
func test_lumps_in_place_of_many_heads_begin_far_away() -> void:
	field.free()
	field = PlantField3D.from_species([load(SPECIES % "lavender")])
	field.density = 20.0
	field.size = Vector2(19, 19)
	await start()
	var segments: PackedInt32Array = _levels()[0]["segments"]
	var ends: PackedFloat32Array = _levels()[0]["ends"]
	check_equal(segments.slice(-2), PackedInt32Array([3, 2]), "last levels of %s" % segments)
	check(ends[-2] > 15.0, "levels end at %s" % ends)


func test_levels_of_users_go_before_errors() -> void:
	field.levels = [PlantFieldLevel.of(12, 3.0), PlantFieldLevel.of(4)]
	await start()
	for listed: Dictionary in _levels():
		check_equal(listed["segments"], PackedInt32Array([12, 4]), "segments")
		check_equal(listed["ends"], PackedFloat32Array([3.0, 0.0]), "ends")


func test_all_plants_near_a_camera_are_counted_once_per_level() -> void:
	var camera := Camera3D.new()
	root.add_child(camera)
	camera.make_current()
	camera.position = Vector3(0, 0.5, 0)
	await start()
	await frames(3)
	var drawn: PackedInt32Array = field.get_statistics()["drawn_by_level"]
	var sum := 0
	for count in drawn:
		sum += count
	check(sum >= field.get_plant_count(), "%s of %d" % [drawn, field.get_plant_count()])
	camera.free()


func _levels() -> Array[Dictionary]:
	return field.get_statistics()["levels"]


func _end_of_finest(species: int) -> float:
	return _levels()[species]["ends"][0]
