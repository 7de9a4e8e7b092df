## PlantFieldSpecies and PlantFieldLevel: rejected values, signals, saved values and names.
extends "res://tests/engine/harness.gd"

const PATH := "user://saved_entry.tres"

## The kind of change of each received signal.
var _signals := []


func before_each() -> void:
	_signals = []


func test_numbers_out_of_range_give_one_error_and_are_not_kept() -> void:
	_refuse(
		PlantFieldSpecies.new(),
		{
			"weight": [-0.1, 1e7, NAN, INF],
			"density_factor": [-0.1, 1001.0, NAN],
			"height_deviation": [-0.1, 0.91, INF],
			"lean_deviation": [-0.1, deg_to_rad(80.1), 45.0, NAN],
			"variants": [0, -1, 65],
			"lod_bias": [0.0, 11.0, NAN],
		}
	)
	_refuse(PlantFieldLevel.new(), {"segments": [0, -1, 257], "end": [-0.1, 1e7, NAN, INF]})


func test_scales_go_from_the_smaller_to_the_larger() -> void:
	var entry := PlantFieldSpecies.new()
	for bad: Vector2 in [Vector2(0.0, 1.0), Vector2(1.0, NAN), Vector2(1.0, 2000.0)]:
		entry.scale_range = bad
		check_error("scale_range cannot be ")
	entry.scale_range = Vector2(1.0, 0.5)
	check_error("Set the smaller number first")
	check_equal(entry.scale_range, Vector2(0.8, 1.2))


func test_degrees_instead_of_radians_are_reported() -> void:
	var entry := PlantFieldSpecies.new()
	entry.lean_deviation = 45.0
	check_error("lean_deviation cannot be 45.0 rad, which is 2578.3°")
	entry.lean_deviation = deg_to_rad(80.0)
	check_equal(entry.lean_deviation, deg_to_rad(80.0))


func test_values_come_back_as_written() -> void:
	var entry := PlantFieldSpecies.new()
	for tenths in 801:
		var written := deg_to_rad(tenths / 10.0)
		entry.lean_deviation = written
		check_equal(entry.lean_deviation, written, "%.1f°" % (tenths / 10.0))
	entry.weight = 0.3
	check_equal(entry.weight, 0.3)
	var level := PlantFieldLevel.of(5, 12.3)
	check_equal(level.segments, 5)
	check_equal(level.end, 12.3)


func test_each_real_change_is_signalled_once() -> void:
	_count_changes(PlantFieldLevel.new(), {"segments": 7, "end": 20.0})
	_count_changes(
		PlantFieldSpecies.new(),
		{
			"species": TulipFunction.new(),
			"weight": 0.5,
			"density_factor": 2.0,
			"scale_range": Vector2(0.5, 0.75),
			"height_deviation": 0.25,
			"lean_deviation": 0.125,
			"variants": 9,
			"lod_bias": 2.0,
		}
	)


func test_a_change_states_its_kind() -> void:
	var tulip := TulipFunction.new()
	var entry := _listened(PlantFieldSpecies.of(tulip))
	entry.weight = 0.5
	tulip.mass = 0.5
	tulip.flower_color = Color.RED
	entry.species = GrassFunction.new()
	entry.lod_bias = 2.0
	var placement := PlantFieldSpecies.CHANGE_PLACEMENT
	var motion := PlantFieldSpecies.CHANGE_MOTION
	var appearance := PlantFieldSpecies.CHANGE_APPEARANCE
	check_equal(_signals, [placement, motion, appearance, placement, appearance])
	check_equal(entry.get_change_kind(), PlantFieldSpecies.CHANGE_NONE, "nothing is emitted now")


func test_a_species_that_was_replaced_is_no_longer_followed() -> void:
	var tulip := TulipFunction.new()
	var entry := _listened(PlantFieldSpecies.of(tulip))
	entry.species = null
	_signals = []
	tulip.mass = 0.5
	check_equal(_signals, [])


func test_what_a_listener_sets_is_a_change_of_its_own() -> void:
	var tulip := TulipFunction.new()
	var entry := _listened(PlantFieldSpecies.of(tulip))
	var set_weight := func() -> void: entry.weight = 0.25
	entry.changed.connect(set_weight)
	tulip.mass = 0.5
	entry.changed.disconnect(set_weight)
	check_equal(_signals, [PlantFieldSpecies.CHANGE_MOTION, PlantFieldSpecies.CHANGE_PLACEMENT])
	check_equal(
		entry.get_change_kind(), PlantFieldSpecies.CHANGE_NONE, "the first emission is over"
	)


func test_an_entry_may_be_freed_while_it_emits_changed() -> void:
	var tulip := TulipFunction.new()
	var kept := [PlantFieldSpecies.of(tulip)]
	kept[0].changed.connect(kept.clear)
	tulip.mass = 0.5
	check_equal(kept, [])


func test_the_inspector_shows_what_an_entry_holds() -> void:
	var entry := PlantFieldSpecies.of(TulipFunction.new())
	check_equal(entry.resource_name, "Tulip")
	entry.species = CurvePlantFunction.new()
	check_equal(entry.resource_name, "Curve Plant")
	entry.species.resource_name = "Thistle"
	check_equal(entry.resource_name, "Thistle")
	entry.species = null
	check_equal(entry.resource_name, "")
	check_equal(PlantFieldLevel.of(12, 7.5).resource_name, "12 segments to 7.5 m")
	check_equal(PlantFieldLevel.of(1).resource_name, "1 segment")


func test_a_name_that_a_user_gave_stays() -> void:
	var entry := PlantFieldSpecies.new()
	entry.resource_name = "Lawn"
	entry.species = GrassFunction.new()
	check_equal(entry.resource_name, "Lawn")
	var level := PlantFieldLevel.of(3)
	level.resource_name = "Far"
	level.end = 4.0
	check_equal(level.resource_name, "Far")


func test_saved_entries_load_equal() -> void:
	var entry := PlantFieldSpecies.of(TulipFunction.new(), 0.25)
	entry.scale_range = Vector2(0.25, 0.5)
	entry.lean_deviation = deg_to_rad(0.9)
	check_equal(ResourceSaver.save(entry, PATH), OK, "saving")
	var text := FileAccess.get_file_as_string(PATH)
	check(not text.contains("resource_name"), "a name that was not set is not saved: " + text)
	var loaded: PlantFieldSpecies = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	for property in ["weight", "scale_range", "lean_deviation", "resource_name"]:
		check_equal(loaded.get(property), entry.get(property), property)
	check(loaded.species is TulipFunction, "the species is kept")
	entry.resource_name = "Lawn"
	ResourceSaver.save(entry, PATH)
	check(FileAccess.get_file_as_string(PATH).contains("Lawn"), "a user's name is saved")
	DirAccess.remove_absolute(PATH)


func _refuse(resource: Resource, bad: Dictionary) -> void:
	resource.changed.connect(_record.bind(resource))
	for property: String in bad:
		var before: Variant = resource.get(property)
		for value: Variant in bad[property]:
			resource.set(property, value)
			check_error(property + " cannot be ")
			check_equal(resource.get(property), before, property)
	check_equal(_signals, [], "no signal")


func _count_changes(resource: Resource, values: Dictionary) -> void:
	resource.changed.connect(_record.bind(resource))
	for property: String in values:
		for expected: int in [1, 0]:  # An equal value is no change.
			_signals = []
			resource.set(property, values[property])
			check_equal(_signals.size(), expected, "signals for " + property)


func _listened(entry: PlantFieldSpecies) -> PlantFieldSpecies:
	entry.changed.connect(_record.bind(entry))
	return entry


func _record(resource: Resource) -> void:
	var entry := resource as PlantFieldSpecies
	_signals.append(entry.get_change_kind() if entry else -1)
