## Drafts: the first plants of a field whose species are not measured have one coarse level. Finer
## levels replace it before the build ends.
extends "res://tests/engine/field_harness.gd"

const SPECIES: Array[String] = ["oxeye_daisy", "meadow_grass"]
const SIDE := 20.0  # m
const LARGE_SIDE := 80.0  # m: more plants than one part of a build has.
const DENSITY := 8.0  # Plants/m².
const DRAFT_SEGMENTS := 5

var _camera: Camera3D
var _ends := 0


func before_each() -> void:
	_camera = Camera3D.new()
	_camera.position = Vector3(0, 1.6, 6)
	root.add_child(_camera)
	_ends = 0
	field = _make_field(SIDE, _unmeasured_species())


func after_each() -> void:
	super()
	_camera.free()
	await process_frame


func test_drafts_come_first_and_are_refined_before_the_build_ends() -> void:
	for side: float in [SIDE, LARGE_SIDE]:
		for streams: bool in [false, true]:
			field.free()
			field = _make_field(side, _unmeasured_species())
			field.view_distance = 30.0 if streams else 0.0
			await _show_drafts()
			var drafted := PackedInt64Array(field.get_plant_ids())
			await filled(field)
			check(_has_final_levels(), "levels %s" % [_segments()])
			check_equal(_ends, 1, "ends of the build")
			var all := PackedInt64Array(field.get_plant_ids())
			for id in drafted:
				if not all.has(id):
					check(false, "plant %d has another id now" % id)
					break
			_ends = 0


func test_measured_species_need_no_drafts() -> void:
	await filled_from_start()
	var other := _make_field(SIDE, field.species)
	root.add_child(other)
	await until(func() -> bool: return other.get_plant_count() > 0, "plants come")
	check_equal(other.is_building(), false, "is building")
	check(_has_final_levels(other), "levels")
	other.free()


func test_build_now_leaves_no_drafts() -> void:
	root.add_child(field)
	var drafts: Array[int] = [0]
	field.build_progressed.connect(
		func(_share: float) -> void:
			drafts[0] += int(field.get_plant_count() > 0 and not _has_final_levels())
	)
	check(field.build_now(), "is built")
	check(_has_final_levels(), "levels %s" % [_segments()])
	check_equal(drafts[0], 0, "reports of drafts")
	field.free()
	field = _make_field(SIDE, _unmeasured_species())
	await _show_drafts()
	check(field.build_now(), "is built from drafts on")
	check(_has_final_levels(), "levels %s after drafts" % [_segments()])


func test_changes_of_drafts_hold() -> void:
	for side: float in [SIDE, LARGE_SIDE]:
		for change: Callable in [_change_seed, _change_density, _change_species, _change_levels]:
			field.free()
			field = _make_field(side, _unmeasured_species())
			var other := _make_field(side, field.species)
			await _show_drafts()
			change.call(field)
			await filled(field)
			change.call(other)
			root.add_child(other)
			await filled(other)
			var what := "%s at %d m" % [change.get_method(), side]
			check_equal(field.get_plant_count(), other.get_plant_count(), "plants of %s" % what)
			check_equal(_segments(), _segments(other), "levels of %s" % what)
			other.free()


func test_a_change_of_appearance_while_drafts_are_refined_places_nothing_again() -> void:
	field.free()
	field = _make_field(LARGE_SIDE, _unmeasured_species())
	await _show_drafts()
	var count := field.get_plant_count()
	var daisy: PlantFunction = field.species[0].species
	(daisy.arrangements[0].part as PlantBlade).base_color = Color.RED
	while not _has_final_levels():
		check_equal(field.get_plant_count(), count, "plants until they are refined")
		await process_frame
	await filled(field)
	check(field.get_plant_count() > 2 * count, "the rest follows")


func test_drafts_that_are_removed_stay_removed() -> void:
	await _show_drafts()
	var place := Vector3(0, 0, 6)
	var count: int = field.remove_in_sphere(place, 2.0)
	check(count > 50, "%d plants are removed" % count)
	await filled(field)
	check_equal(field.find_plants_in_sphere(place, 1.9).size(), 0, "plants there")


func test_a_field_that_leaves_the_tree_with_drafts_is_refined_when_it_returns() -> void:
	await _show_drafts()
	root.remove_child(field)
	await frames(5)
	root.add_child(field)
	await filled(field)
	check(_has_final_levels(), "levels %s" % [_segments()])


func filled_from_start() -> void:
	root.add_child(field)
	await filled(field)


func _show_drafts() -> void:
	field.build_finished.connect(func() -> void: _ends += 1)
	root.add_child(field)
	await until(func() -> bool: return field.get_plant_count() > 0, "the first plants come")
	check(field.is_building(), "drafts are refined")
	for levels: PackedInt32Array in _segments():
		check_equal(levels, PackedInt32Array([DRAFT_SEGMENTS]), "segments of a draft")


func _change_seed(of: PlantField3D) -> void:
	of.seed = 4


func _change_density(of: PlantField3D) -> void:
	of.density = 0.5 * DENSITY


func _change_species(of: PlantField3D) -> void:
	of.species = of.species.slice(0, 1)


func _change_levels(of: PlantField3D) -> void:
	of.lod_bias = 0.5


func _segments(of := field) -> Array[PackedInt32Array]:
	var all: Array[PackedInt32Array] = []
	for species: Dictionary in of.get_statistics()["levels"]:
		all.append(PackedInt32Array(species["segments"]))
	return all


func _has_final_levels(of := field) -> bool:
	return _segments(of).all(func(levels: PackedInt32Array) -> bool: return levels.size() > 1)


## Copies, because a loaded species is measured once.
func _unmeasured_species() -> Array[PlantFieldSpecies]:
	var list: Array[PlantFieldSpecies] = []
	for title in SPECIES:
		var function: PlantFunction = load("res://addons/undergrowth/species/%s.tres" % title)
		list.append(PlantFieldSpecies.of(function.duplicate(true)))
	return list


func _make_field(side: float, list: Array[PlantFieldSpecies]) -> PlantField3D:
	var made := PlantField3D.new()
	made.size = Vector2.ONE * side
	made.density = DENSITY
	made.species = list
	return made
