## Outlines of all ready species where their levels begin.
extends "res://tests/engine/field_harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
## At 1080 lines and a vertical angle of view of 75°.
const PIXELS_OF_RADIAN := 703.7
const MAX_ERROR := 2.0  # Pixels.
const ROUNDING := 1.01
const MIN_SPECIES := 27
const NEAREST := 0.5  # m: levels that end nearer are not used.


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
