## The shipped mixes: fields of several ready species, which load, build and contain their species.
extends "res://tests/engine/field_harness.gd"

const FOLDER := "res://addons/undergrowth/mixes"
const SPECIES_FOLDER := "res://addons/undergrowth/species/"
const LOWEST: PackedStringArray = [
	"dead_leaves",
	"ivy_carpet",
	"moss_cushion",
	"plantain",
	"seedlings",
	"straw",
	"twigs",
	"white_clover",
	"wild_strawberry",
]
## Factor of the weight's tolerance. A hundred square metres contain only a few drifts.
const MAX_DIFFERENCE := 2.0
## Within ten by ten metres.
const MAX_PLANTS := 9500


func test_every_mix_grows_its_species() -> void:
	var files := DirAccess.get_files_at(FOLDER)
	check(files.size() >= 5, "%d mixes" % files.size())
	for file in files:
		field = (load(FOLDER.path_join(file)) as PackedScene).instantiate()
		check_equal(field.get_class(), "PlantField3D", file)
		_check_what_it_says(file)
		_draw_coarsely()
		await start()
		_check_plants(file)
		field.free()


func test_every_mix_has_a_ground_layer() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		field = (load(FOLDER.path_join(file)) as PackedScene).instantiate()
		var low := 0.0
		for listed in field.species:
			if listed.species.resource_path.get_file().get_basename() in LOWEST:
				low += listed.weight
		check(low > 0.0, file + " has plants or litter of the lowest layer")
		field.free()


func test_a_mix_is_ready_to_be_dragged_into_a_scene() -> void:
	var scene: PackedScene = load(FOLDER.path_join("meadow.tscn"))
	var one: PlantField3D = scene.instantiate()
	check_equal(one.size, Vector2(10, 10), "size")
	check(one.wind != null, "wind blows on a mix that is dragged into a scene")
	for listed in one.species:
		var path := listed.species.resource_path
		check(path.begins_with(SPECIES_FOLDER), "a species of the add-on: " + path)
	one.free()


# Only positions matter here.
func _draw_coarsely() -> void:
	var levels: Array[PlantFieldLevel] = [PlantFieldLevel.of(1)]
	field.levels = levels


func _check_what_it_says(file: String) -> void:
	check(field.species.size() > 1, file + " has several species")
	check(field.clumping > 0.3, file + " grows in drifts")
	for listed in field.species:
		check(listed.species != null, file + " has all of its species")


func _check_plants(file: String) -> void:
	var counts: Dictionary[PlantFunction, int] = {}
	for id in field.get_plant_ids():
		var species := field.get_plant_species(id)
		counts[species] = counts.get(species, 0) + 1
	var total := float(field.get_plant_count())
	check(total > 500 and total < MAX_PLANTS, "%s has %d plants" % [file, total])
	var sum := 0.0
	for listed in field.species:
		sum += listed.weight * listed.density_factor
	for listed in field.species:
		var wanted := listed.weight * listed.density_factor / sum
		var apart: float = counts.get(listed.species, 0) / total / wanted
		var reported := (
			"%s: %s is %.2f times its share" % [file, listed.species.resource_path, apart]
		)
		check(apart < MAX_DIFFERENCE and apart > 1.0 / MAX_DIFFERENCE, reported)
