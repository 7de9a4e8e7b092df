## Outlines of all ready species where their levels begin.
extends "res://tests/engine/field_harness.gd"

const FieldDefaults := preload("res://addons/undergrowth/editor/actions/field_defaults.gd")
const FOLDER := "res://addons/undergrowth/species/"
## At 1080 lines and a vertical angle of view of 75°.
const PIXELS_OF_RADIAN := 703.7
const MAX_ERROR := 2.0  # Pixels.
const ROUNDING := 1.01
const MIN_SPECIES := 32
const NEAREST := 0.5  # m: levels that end nearer are not used.
const NEAREST_CARDS := 0.549  # m.
const CLOSE_CARDS: Array[String] = [
	"bamboo", "bramble", "common_reed", "dog_rose", "hazel", "heather", "male_fern"
]
const FINEST := 33  # Segments.
const LAST_OF_DENSE := 4.5  # m.
const MAX_DENSE_ERROR := 5.0  # Pixels, at the density of Add as Field.
## The same of species whose coarse forms are the least exact.
const MAX_DENSE_ERRORS: Dictionary[String, float] = {
	"barley": 6.5,
	"buttercup": 5.4,
	"field_horsetail": 7.1,
	"heather": 9.4,
	"lavender": 13.6,
	"lawn_grass": 5.9,
	"moss_cushion": 12.5,
	"plantain": 6.5,
	"red_clover": 12.5,
	"seedlings": 10.4,
	"white_clover": 9.5,
	"wild_strawberry": 7.1,
}


## A plant alone: fields of many plants change levels nearer, because their triangles are limited.
func test_levels_begin_where_their_outline_is_within_two_pixels() -> void:
	var all: Array[PlantFunction] = []
	for file in DirAccess.get_files_at(FOLDER):
		if file.get_extension() == "tres":
			all.append(load(FOLDER + file))
	check(all.size() >= MIN_SPECIES, "%d species" % all.size())
	field = PlantField3D.from_species(all)
	for entry in field.species:
		entry.variants = 1
	field.density = 0.2
	field.size = Vector2(20, 20)
	field.simulation_enabled = false
	await start()
	for listed: Dictionary in field.get_statistics()["levels"]:
		var errors: PackedFloat32Array = listed["errors"]
		var ends: PackedFloat32Array = listed["ends"]
		check(ends.size() >= 2, "%s" % listed)
		for i in range(1, ends.size()):
			var pixels := errors[i] * PIXELS_OF_RADIAN / ends[i - 1]
			check(pixels <= MAX_ERROR * ROUNDING, "%.2f px at level %d: %s" % [pixels, i, listed])
			check(ends[i - 1] >= NEAREST, "%s" % listed)


## Holes and teeth of a few texels are seen in the cards of the nearest plants. Plumes and fronds
## have too many parts.
func test_the_nearest_plants_are_geometry() -> void:
	var all: Array[PlantFunction] = []
	for file in DirAccess.get_files_at(FOLDER):
		if file.get_extension() == "tres" and not file.get_basename() in CLOSE_CARDS:
			all.append(load(FOLDER + file))
	field = PlantField3D.from_species(all)
	field.density = 0.2
	field.simulation_enabled = false
	await start()
	for listed: Dictionary in field.get_statistics()["levels"]:
		_check_nearest(listed)
	field.free()
	field = FieldDefaults.make_field(load(FOLDER + "yarrow.tres") as PlantFunction)
	field.simulation_enabled = false
	await start()
	var yarrow: Dictionary = field.get_statistics()["levels"][0]
	_check_nearest(yarrow)
	check(yarrow["segments"][0] == FINEST, "florets of yarrow have rays: %s" % yarrow)


func _check_nearest(listed: Dictionary) -> void:
	check(not listed["are_carded"][0], "%s" % listed)
	for i in range(1, listed["ends"].size()):
		if listed["are_carded"][i]:
			check(listed["ends"][i - 1] >= NEAREST_CARDS, "%s" % listed)


## A field of many plants changes its levels nearer, because its triangles are limited.
func test_dense_fields_have_bounded_errors() -> void:
	var checked := 0
	for file in DirAccess.get_files_at(FOLDER):
		if file.get_extension() != "tres":
			continue
		field = FieldDefaults.make_field(load(FOLDER + file) as PlantFunction)
		field.simulation_enabled = false
		await start()
		_check_dense(file.get_basename(), field.get_statistics()["levels"][0])
		checked += 1
		field.free()
	field = PlantField3D.new()
	field.simulation_enabled = false
	await start()
	_check_dense("default field", field.get_statistics()["levels"][0])
	check(checked >= MIN_SPECIES, "%d species" % checked)


## Wheat with solid leaves and ears does not look like wheat between cards and the last level.
func test_a_small_field_of_dense_wheat_is_on_cards() -> void:
	field = FieldDefaults.make_field(load(FOLDER + "wheat.tres") as PlantFunction)
	field.size = Vector2(10, 10)
	field.density = 90.0
	field.simulation_enabled = false
	await start()
	var listed: Dictionary = field.get_statistics()["levels"][0]
	var last: int = listed["ends"].size() - 1
	for i in last:
		check(listed["are_carded"][i] == 1, "%s" % listed)
	check(listed["ends"][last - 1] >= LAST_OF_DENSE, "%s" % listed)


func _check_dense(species: String, listed: Dictionary) -> void:
	var max_error: float = MAX_DENSE_ERRORS.get(species, MAX_DENSE_ERROR)
	var ends: PackedFloat32Array = listed["ends"]
	var largest := 0.0
	for i in range(1, ends.size()):
		largest = maxf(largest, listed["errors"][i] * PIXELS_OF_RADIAN / ends[i - 1])
	check(largest <= max_error, "%.1f px of %s: %s" % [largest, species, listed])
