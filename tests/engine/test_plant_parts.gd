## Plants of parts: scripts and files define a mesh of sheets and tubes.
extends "res://tests/engine/harness.gd"

const TULIP := "res://addons/undergrowth/species/garden_tulip.tres"
const FERN := "res://addons/undergrowth/species/male_fern.tres"
const DAISY := "res://addons/undergrowth/species/oxeye_daisy.tres"


class Daisy:
	extends PlantFunction
	static var grown := 0
	var rays := 22
	var ray := PlantBlade.of({length = 0.016, width = 0.0045, profile = PlantBlade.PROFILE_RAY})
	var stalk := PlantAxis.of({length = Vector2(0.3, 0.6), diameter = Vector2(0.003, 0.002)})

	func _grow(plant: PlantGrowth) -> void:
		grown += 1
		var stems := plant.scatter(stalk, plant.rng.randi_range(1, 3), {radius = 0.01})
		plant.whorl(ray, stems, rays, {radius = 0.007, angle = 1.4})


class Faulty:
	extends PlantFunction
	var deed: Callable

	func _grow(plant: PlantGrowth) -> void:
		deed.call(plant)


class Lobed:
	extends PlantBlade

	func _calculate_width(offset: float) -> float:
		return 0.5 if offset < 0.5 else 1.0

	func _calculate_color(_offset: float, across: float) -> Color:
		return Color(across, 0, 0)


func test_a_script_grows_a_plant_once_for_each_seed() -> void:
	Daisy.grown = 0
	var species := Daisy.new()
	var mesh := species.generate_mesh(0.0, 6, 1)
	check(mesh.get_aabb().size.y > 0.25, "as high as its stems")
	check_equal(Daisy.grown, 1, "grown")
	Daisy.grown = 0
	var field := PlantField3D.from_species([species])
	field.size = Vector2(2, 2)
	field.density = 5.0
	root.add_child(field)
	await field.build_finished
	await frames(1)
	check_equal(Daisy.grown, 5, "sampled once for each of four variants and for the stem")
	check(field.get_plant_ids().size() > 5, "plants exist")
	field.free()


func test_the_inspector_shows_what_matters_of_a_blade() -> void:
	var blade := PlantBlade.new()
	blade.teeth = 0
	blade.wave = 0.0
	check(not is_shown(blade, "tooth_depth") and not is_shown(blade, "wave_count"), "it is plain")
	blade.teeth = 5
	check(is_shown(blade, "tooth_depth") and not is_shown(blade, "wave_count"), "it has teeth")
	blade.wave = 0.3
	check(is_shown(blade, "wave_count"), "it waves")


func test_a_script_grows_once_for_all_levels_and_heights() -> void:
	Daisy.grown = 0
	var species := Daisy.new()
	for segments: int in [12, 6, 3, 2, 1]:
		species.generate_mesh(0.0, segments, 1)
	species.generate_mesh(0.7, 6, 1)
	species.find_problem(0.0, 6, 1)
	check_equal(Daisy.grown, 1, "grown")
	species.generate_mesh(0.0, 6, 2)
	check_equal(Daisy.grown, 2, "another seed")
	species.mass = 0.5
	species.material = StandardMaterial3D.new()
	species.generate_mesh(0.0, 6, 1)
	check_equal(Daisy.grown, 2, "motion and material")


func test_a_script_grows_again_when_it_has_changed() -> void:
	Daisy.grown = 0
	var species := Daisy.new()
	var before := species.generate_mesh(0.0, 6, 1).get_aabb()
	species.stalk.length = Vector2(1.0, 1.2)
	check(species.generate_mesh(0.0, 6, 1).get_aabb().size.y > before.size.y, "a part's length")
	check_equal(Daisy.grown, 2, "grown")
	species.rays = 3  # A variable of the script, without a signal.
	species.generate_mesh(0.0, 6, 1)
	check_equal(Daisy.grown, 3, "a variable")
	species.emit_changed()
	species.generate_mesh(0.0, 6, 1)
	check_equal(Daisy.grown, 4, "a change with a signal")
	species.stalk = PlantAxis.of({length = 0.2})
	check(species.generate_mesh(0.0, 6, 1).get_aabb().size.y < before.size.y, "another part")


func test_the_same_seed_gives_the_same_bytes() -> void:
	var species: PlantFunction = load(DAISY)
	var one := species.generate_mesh(0.0, 6, 9).surface_get_arrays(0)
	var again := species.generate_mesh(0.0, 6, 9).surface_get_arrays(0)
	var other := species.generate_mesh(0.0, 6, 10).surface_get_arrays(0)
	check_equal(one[Mesh.ARRAY_VERTEX], again[Mesh.ARRAY_VERTEX], "the same seed")
	check(one[Mesh.ARRAY_VERTEX] != other[Mesh.ARRAY_VERTEX], "another seed")


func test_a_species_without_parts_has_its_lathe() -> void:
	var plain := TulipFunction.new().generate_mesh(1.5, 8, 3).surface_get_arrays(0)
	var emptied := TulipFunction.new()
	emptied.arrangements = [PlantArrangement.of({part = PlantBead.new()})]
	emptied.arrangements = []
	var again := emptied.generate_mesh(1.5, 8, 3).surface_get_arrays(0)
	for array: int in [Mesh.ARRAY_VERTEX, Mesh.ARRAY_NORMAL, Mesh.ARRAY_COLOR, Mesh.ARRAY_CUSTOM0]:
		check_equal(again[array], plain[array], "array %d" % array)


func test_leaves_on_a_stem_of_four_functions() -> void:
	var species := TulipFunction.new()
	var leaf := PlantBlade.of({length = 0.3, width = 0.05})
	species.arrangements = [PlantArrangement.of({part = leaf, count = 3, to = 0.3, angle = 0.6})]
	var mesh := species.generate_mesh(0.0, 12, 1)
	check(mesh.get_aabb().size.x > 0.2, "leaves point away from the stem")
	var arrays := mesh.surface_get_arrays(0)
	check_equal(arrays[Mesh.ARRAY_TANGENT].size(), 4 * mesh.surface_get_array_len(0), "tangents")
	check(arrays[Mesh.ARRAY_CUSTOM2] != null, "half-widths")


func test_some_plants_lack_what_others_have() -> void:
	var species := PlantFunction.new()
	species.has_stem = false
	var flower := PlantArrangement.of({part = PlantBlade.new()})
	var stalk := PlantArrangement.of({part = PlantAxis.of({length = 0.5}), count = Vector2i(0, 1)})
	stalk.layout = PlantArrangement.LAYOUT_GROUND
	stalk.carries = [flower]
	var leaf := PlantArrangement.of({part = PlantBlade.of({length = 0.1}), count = 3})
	leaf.layout = PlantArrangement.LAYOUT_GROUND
	species.arrangements = [stalk, leaf]
	var tall := 0
	for plant_seed in 20:
		for segments: int in [12, 3, 1]:
			var mesh := species.generate_mesh(0.0, segments, plant_seed)
			check(mesh != null, "a plant with or without a stalk")
			tall += 1 if mesh.get_aabb().end.y > 0.3 else 0
	check(tall > 12 and tall < 48, "%d of 60 have a stalk" % tall)


func test_flat_parts_lie_in_the_plane_of_what_carries_them() -> void:
	var leaflet := PlantArrangement.of({part = PlantBlade.of({width = 0.04}), count = 8})
	leaflet.per_node = 2
	leaflet.turn = 0.0
	leaflet.phase = 0.5 * PI
	leaflet.angle = Vector2(1.4, 1.4)
	var frond := PlantArrangement.of(
		{part = PlantAxis.new(), layout = PlantArrangement.LAYOUT_GROUND}
	)
	frond.carries = [leaflet]
	var species := PlantFunction.new()
	species.has_stem = false
	species.arrangements = [frond]
	check(species.generate_mesh(0.0, 12).get_aabb().size.z > 0.03, "leaflets point sideways")
	leaflet.flat = true
	check(species.generate_mesh(0.0, 12).get_aabb().size.z < 0.01, "leaflets lie flat")


func test_weights_are_the_stem_offsets() -> void:
	var species: PlantFunction = load(TULIP)
	var arrays := species.generate_mesh(0.0, 12, 1).surface_get_arrays(0)
	var offsets: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM0]
	var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
	var worst := 0.0
	for i in arrays[Mesh.ARRAY_VERTEX].size():
		worst = maxf(worst, absf(offsets[4 * i] - weights[4 * i + 1]))
		worst = maxf(worst, absf(weights[4 * i] + weights[4 * i + 1] - 1.0))
	check_near(worst, 0.0, 1e-4, "weights")


func test_a_script_sets_width_and_color_of_a_part() -> void:
	var species := PlantFunction.new()
	species.has_stem = false
	species.arrangements = [
		PlantArrangement.of({part = Lobed.new(), layout = PlantArrangement.LAYOUT_GROUND})
	]
	var colors: PackedColorArray = species.generate_mesh(0.0, 12).surface_get_arrays(0)[
		Mesh.ARRAY_COLOR
	]
	var reds: Array = Array(colors).map(func(color: Color) -> float: return color.r)
	check_near(reds.min(), 0.0, 0.2, "at the midrib")
	check_near(reds.max(), 1.0, 0.2, "at the edges")


func test_setters_are_quiet_and_keep_degrees() -> void:
	var blade := PlantBlade.new()
	var reported := [0]
	blade.changed.connect(func() -> void: reported[0] += 1)
	blade.bend = deg_to_rad(75.0)
	blade.bend = deg_to_rad(75.0)
	blade.width = 0.009
	blade.width = 0.009
	check_equal(reported[0], 2, "changes")
	check_equal(rad_to_deg(blade.bend), 75.0, "degrees")
	check_equal(blade.width, 0.009, "width")


func test_a_change_deep_inside_reaches_the_species() -> void:
	var bead := PlantBead.new()
	var inner := PlantArrangement.of({part = bead})
	var outer := PlantArrangement.of({part = PlantAxis.new()})
	outer.carries = [inner]
	var species := PlantFunction.new()
	species.arrangements = [outer]
	var reported := [0]
	species.changed.connect(func() -> void: reported[0] += 1)
	bead.diameter = 0.01
	check_equal(reported[0], 1, "one change")


func test_hidden_parts_and_what_they_carry_are_not_drawn() -> void:
	var fern := (load(FERN) as PlantFunction).duplicate(true) as PlantFunction
	var all := fern.generate_mesh(0.0, 12, 1).surface_get_array_len(0)
	var heard := [0]
	fern.changed.connect(func() -> void: heard[0] += 1)
	var first := fern.arrangements[0]
	first.visible = false
	check_equal(heard[0], 1, "changes")
	first.visible = false
	check_equal(heard[0], 1, "changes after the same value")
	var rest := fern.generate_mesh(0.0, 12, 1).surface_get_array_len(0)
	check(rest < all, "%d vertices of %d are drawn" % [rest, all])
	fern.arrangements = fern.arrangements.filter(
		func(one: PlantArrangement) -> bool: return one != first
	)
	var without := fern.generate_mesh(0.0, 12, 1).surface_get_array_len(0)
	check_equal(rest, without, "vertices, as without that arrangement")


func test_a_part_has_the_veins_that_it_is_given() -> void:
	var blade := PlantBlade.new()
	check_equal(blade.venation, PlantPart.VENATION_AUTOMATIC, "venation")
	var counter := [0]
	blade.changed.connect(func() -> void: counter[0] += 1)
	blade.venation = PlantPart.VENATION_PALMATE
	blade.venation = PlantPart.VENATION_PALMATE
	check_equal(counter[0], 1, "changes")
	blade.set("venation", 9)
	check_error("PlantBlade: venation 9 does not exist")
	check_equal(blade.venation, PlantPart.VENATION_PALMATE, "venation")


func test_values_out_of_range_keep_the_last() -> void:
	var blade := PlantBlade.new()
	blade.width = -1.0
	check_error("PlantBlade: width cannot be -1")
	blade.fold = NAN
	check_error("PlantBlade: fold cannot be nan")
	var arrangement := PlantArrangement.new()
	arrangement.count = Vector2i(0, 0)
	check_error("PlantArrangement: count cannot be 0 to 0")
	arrangement.count = Vector2i(1, 1000000)
	check_error("PlantArrangement: count cannot be 1 to 1000000")
	check_equal(arrangement.count, Vector2i(1, 1), "count")
	PlantBlade.of({colour = Color.RED})
	check_error("PlantBlade: has no 'colour'")
	var usual := PlantBlade.new().length
	check_equal(PlantBlade.of({length = "long"}).length, usual, "its length")
	check_error("PlantBlade: 'length' cannot be of type String. Give it a Vector2.")
	var at_once := PlantArrangement.of(
		{part = PlantBlade.new(), carries = [arrangement], count = 2}
	)
	check_equal(at_once.carries, [arrangement], "what it carries, in an array that is not typed")


func test_a_cycle_of_carriers_and_a_missing_part_are_reported() -> void:
	var arrangement := PlantArrangement.of({part = PlantAxis.new()})
	arrangement.carries = [arrangement]
	var species := PlantFunction.new()
	species.arrangements = [arrangement]
	check(species.find_problem(0.0, 6).contains("levels, perhaps by itself"), "carries itself")
	arrangement.carries = []
	arrangement.part = null
	check(species.find_problem(0.0, 6).contains("has no part"), "no part")
	species.arrangements = []
	species.has_stem = false
	check(species.find_problem(0.0, 6).contains("has no stem and no parts"), "nothing")


func test_a_script_error_says_what_to_do() -> void:
	var blade := PlantBlade.new()
	var bare := PackedInt32Array([7])
	var deeds := {
		"has no stem and no parts": func(_plant: PlantGrowth) -> void: pass,
		"passed no part": func(plant: PlantGrowth) -> void: plant.scatter(null, 3),
		"count cannot be 0": func(plant: PlantGrowth) -> void: plant.scatter(blade, 0),
		"count cannot be -4": func(plant: PlantGrowth) -> void: plant.scatter(blade, -4),
		"count cannot be 1e+06": func(plant: PlantGrowth) -> void: plant.scatter(blade, 1000000),
		"another plant": func(plant: PlantGrowth) -> void: plant.along(blade, bare, 2),
		"the option 'size'": func(plant: PlantGrowth) -> void: plant.scatter(blade, 3, {size = 2}),
		"angle cannot be nan":
		func(plant: PlantGrowth) -> void: plant.along(blade, plant.ground, 1, {angle = NAN}),
	}
	for words: String in deeds:
		var species := Faulty.new()
		species.deed = deeds[words]
		var problem := species.find_problem(0.0, 6)
		check(problem.contains(words), "'%s' says: %s" % [words, problem])


func test_parts_are_added_on_the_ground_and_on_others_at_once() -> void:
	var counts: PackedInt32Array = []
	var species := Faulty.new()
	species.deed = func(plant: PlantGrowth) -> void:
		var stems := plant.scatter(PlantAxis.new(), 2)
		counts.append(plant.add(PlantBlade.new(), plant.ground + stems).size())
		counts.append(plant.add(PlantBlade.new(), plant.ground).size())
		counts.append(plant.add(PlantBlade.new()).size())
	check_equal(species.find_problem(0.0, 6), "", "its problem")
	check_equal(counts.slice(0, 3), PackedInt32Array([3, 1, 1]), "parts")


func test_options_are_integers_or_floats() -> void:
	var species := Faulty.new()
	species.deed = func(plant: PlantGrowth) -> void:
		var stems := plant.scatter(PlantAxis.new(), 2, {radius = 1, tilt = 1, deviation = 0})
		plant.whorl(PlantBlade.new(), stems, 3, {angle = 1, radius = 0.5})
	check_equal(species.find_problem(0.0, 6), "", "its problem")
	check(species.generate_mesh(0.0, 6, 1).get_aabb().size.x > 1.0, "the radius is used")


func test_a_plant_that_has_grown_takes_no_more_parts() -> void:
	var species := Faulty.new()
	var kept: Array[PlantGrowth] = []
	species.deed = func(plant: PlantGrowth) -> void:
		plant.add(PlantBlade.new())
		kept.append(plant)
	check(species.generate_mesh(0.0, 3) != null, "it grew")
	kept[0].add(PlantBlade.new())
	check_error("PlantGrowth: the plant is complete")


func test_the_last_good_plant_stays() -> void:
	var plant := Plant3D.new()
	plant.species = load(TULIP).duplicate()
	root.add_child(plant)
	var good := plant.get_mesh()
	plant.species.arrangements = [PlantArrangement.new()]
	await frames(2)
	check_error("has no part")
	check_equal(plant.get_mesh(), good, "the mesh")
	plant.free()
