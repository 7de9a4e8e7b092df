## The species that the add-on ships as data: they grow at any level, depend on their seed, and
## sway.
extends "res://tests/engine/harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
const PROMISED: PackedStringArray = [
	"bamboo",
	"barley",
	"bellflower",
	"bramble",
	"buttercup",
	"cattail",
	"common_reed",
	"cornflower",
	"dandelion",
	"dead_leaves",
	"dog_rose",
	"field_horsetail",
	"garden_tulip",
	"hazel",
	"heather",
	"ivy_carpet",
	"lavender",
	"lawn_grass",
	"male_fern",
	"meadow_grass",
	"moss_cushion",
	"oxeye_daisy",
	"plantain",
	"poppy",
	"red_clover",
	"seedlings",
	"straw",
	"twigs",
	"wheat",
	"white_clover",
	"wild_strawberry",
	"yarrow",
]
## What lies on the ground or clings to it.
const STILL: PackedStringArray = ["dead_leaves", "moss_cushion", "straw", "twigs"]
## Metres: the lowest layer.
const LOW: Dictionary = {
	"dead_leaves": 0.1,
	"ivy_carpet": 0.12,
	"moss_cushion": 0.07,
	"seedlings": 0.08,
	"straw": 0.1,
	"twigs": 0.12,
	"white_clover": 0.16,
	"wild_strawberry": 0.17,
}
const BUDGETS: Dictionary = {12: 792, 6: 198, 3: 50, 2: 22, 1: 12}
## Metres: tolerance of the tips of hanging leaves below the ground.
const DEEPEST := 0.03
## Newtons: the wind of a new PlantWind.
const WIND := 5.0
## Frames until they are at rest, with critical damping.
const SETTLING := 300


func test_what_is_promised_is_there() -> void:
	var files := PackedStringArray()
	for file in DirAccess.get_files_at(FOLDER):
		if file.ends_with(".tres"):
			files.append(file.trim_suffix(".tres"))
	files.sort()
	check_equal(files, PROMISED, "species")


func test_each_grows_without_a_word_of_complaint() -> void:
	for file in PROMISED:
		for seed_of_plant in 4:
			check_equal(_species(file).find_problem(0.0, 12, seed_of_plant), "", file)


func test_each_fits_its_budgets() -> void:
	for file in PROMISED:
		for segments: int in BUDGETS:
			for seed_of_plant in 3:
				var mesh := _species(file).generate_mesh(0.0, segments, seed_of_plant)
				var count := mesh.surface_get_array_len(0)
				check(count > 0 and count <= BUDGETS[segments], "%s, %d" % [file, segments])


func test_each_is_whole_at_all_levels() -> void:
	for file in PROMISED:
		var fine := _species(file).generate_mesh(0.0, 12, 3).get_aabb()
		for segments: int in BUDGETS:
			var mesh := _species(file).generate_mesh(0.0, segments, 3)
			var box := mesh.get_aabb()
			var what := "%s at %d" % [file, segments]
			check(_all_finite(mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]), what + " is finite")
			check(box.end.y > 0.5 * fine.end.y, what + " keeps its height")
			check(box.end.y < 2.0 * fine.end.y, what + " does not grow")
		check(fine.position.y > -DEEPEST, "%s begins at %.3f" % [file, fine.position.y])


func test_no_two_plants_are_the_same_and_each_seed_gives_one() -> void:
	for file in PROMISED:
		var one := _points(file, 8)
		check_equal(_points(file, 8), one, file + " of the same seed")
		check(_points(file, 9) != one, file + " of another seed")


func test_each_bends_as_a_stem_in_the_wind_and_none_lies_down() -> void:
	for file in PROMISED:
		var species := _species(file).duplicate() as PlantFunction
		check_equal(species.law, PlantFunction.LAW_STEM, file + "'s law")
		check(species.stem.head_mass >= 0.0 and species.stem.leaf_mass >= 0.0, file + "'s load")
		species.damping_ratio = 1.0  # It does not affect the rest position.
		var degrees := rad_to_deg(_bend_in_wind(species))
		if file in STILL:
			check(degrees < 0.5, "%s bends by %.1f degrees" % [file, degrees])
			continue
		check(degrees > 2.0 and degrees < 30.0, "%s bends by %.1f degrees" % [file, degrees])


func test_parts_and_arrangements_have_names_that_users_read() -> void:
	for file in PROMISED:
		for arrangement: PlantArrangement in _species(file).arrangements:
			_check_names(arrangement, file)


func test_the_lowest_layer_is_low() -> void:
	for file: String in LOW:
		for seed_of_plant in 4:
			var top := _species(file).generate_mesh(0.0, 12, seed_of_plant).get_aabb().end.y
			check(top <= LOW[file] and top > 0.01, "%s is %.3f m tall" % [file, top])


func test_parts_of_litter_and_moss_are_stiff() -> void:
	for file in STILL:
		for arrangement: PlantArrangement in _species(file).arrangements:
			check_equal(arrangement.part.frequency, 0.0, "%s: %s" % [file, arrangement.part])


func test_some_flowers_fade_or_are_buds() -> void:
	var others: Dictionary[String, PackedStringArray] = {
		"buttercup": ["Bud", "Seed"],
		"cornflower": ["Bud"],
		"dandelion": ["Bud", "Clock"],
		"oxeye_daisy": ["Bud", "Faded"],
		"plantain": ["Ripe"],
		"poppy": ["Bud", "Capsule"],
		"red_clover": ["Faded"],
		"white_clover": ["Faded"],
		"wild_strawberry": ["Berry"],
	}
	for file in others:
		var names := PackedStringArray()
		for arrangement: PlantArrangement in _species(file).arrangements:
			names.append(arrangement.resource_name)
			for carried: PlantArrangement in arrangement.carries:
				names.append(carried.resource_name)
		for begin in others[file]:
			var found := Array(names).any(
				func(name: String) -> bool: return name.begins_with(begin)
			)
			check(found, "%s has %s: %s" % [file, begin, names])


func test_some_dandelions_have_a_clock() -> void:
	var tallest := 0.0
	var lowest := INF
	for seed_of_plant in 12:
		var height := _species("dandelion").generate_mesh(0.0, 12, seed_of_plant).get_aabb().end.y
		tallest = maxf(tallest, height)
		lowest = minf(lowest, height)
	check(tallest > 0.2 and lowest < 0.2, "clocks are above flowers, from %.2f m" % lowest)


func _species(file: String) -> PlantFunction:
	return load(FOLDER + file + ".tres")


## Radians, from root to tip.
func _bend_in_wind(species: PlantFunction) -> float:
	var plant := Plant3D.new()
	plant.species = species
	plant.seed = 1
	plant.simulation_enabled = false
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_CONSTANT
	plant.wind.strength = WIND
	root.add_child(plant)
	for frame in SETTLING:
		plant.advance(1.0 / 60.0)
	var bend := Vector3.UP.angle_to(plant.get_tip_position())
	plant.free()
	return bend


func _points(file: String, seed_of_plant: int) -> PackedVector3Array:
	var mesh := _species(file).generate_mesh(0.0, 6, seed_of_plant)
	return mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]


func _all_finite(points: PackedVector3Array) -> bool:
	for point in points:
		if not point.is_finite():
			return false
	return true


func _check_names(arrangement: PlantArrangement, file: String) -> void:
	check(arrangement.resource_name != "", file + ": an arrangement's name")
	check(arrangement.part.resource_name != "", file + ": a part's name")
	for other: PlantArrangement in arrangement.carries:
		_check_names(other, file)
