## Slow species in scripts: a field calls them over many frames and builds afterwards.
extends "res://tests/engine/harness.gd"

const SLOW_USEC := 5000  # More than their time limit in a frame.
const LONG_MSEC := 1050

var _field: PlantField3D


class Slow:
	extends PlantFunction
	static var asked: Array[int] = []  # Frames of the calls.
	var blade := PlantBlade.of({length = 0.3, width = 0.01})

	func _grow(plant: PlantGrowth) -> void:
		asked.append(Engine.get_process_frames())
		OS.delay_usec(SLOW_USEC)
		plant.scatter(blade, 3, {radius = 0.01})


class SlowStem:
	extends PlantFunction
	static var asked: Array[int] = []

	func _generate_height(_rng: RandomNumberGenerator) -> float:
		asked.append(Engine.get_process_frames())
		OS.delay_usec(SLOW_USEC)
		return 0.5


class Quick:
	extends PlantFunction
	static var asked: Array[int] = []
	var blade := PlantBlade.of({length = 0.3, width = 0.01})

	func _grow(plant: PlantGrowth) -> void:
		asked.append(Engine.get_process_frames())
		plant.scatter(blade, 3, {radius = 0.01})


class Long:
	extends PlantFunction

	func _grow(plant: PlantGrowth) -> void:
		OS.delay_msec(LONG_MSEC)
		plant.add(PlantBlade.new())


class Stem:
	extends PlantFunction
	static var asked: Array[int] = []  # Segments of the calls.

	func _get_base_shape(lod: int) -> PackedVector3Array:
		asked.append(lod)
		return PackedVector3Array(
			[Vector3(0, 0, -0.1), Vector3(-0.1, 0, 0.1), Vector3(0.1, 0, 0.1)]
		)


func after_each() -> void:
	if _field:
		_field.free()
		_field = null


func test_a_frame_samples_at_most_one_slow_plant() -> void:
	Slow.asked.clear()
	await _grow_field([Slow.new(), Slow.new()])
	check_equal(Slow.asked.size(), 10, "asks of two species with four variants and a stem")
	check_equal(_max_per_frame(Slow.asked), 1, "asks in a frame")
	check(_field.get_plant_count() > 0, "plants exist")


func test_a_frame_samples_at_most_one_slow_stem() -> void:
	SlowStem.asked.clear()
	await _grow_field([SlowStem.new()])
	check(_max_per_frame(SlowStem.asked) <= 4, "only one variant's levels in a frame")
	check(_field.get_plant_count() > 0, "plants exist")


func test_quick_scripts_are_sampled_at_once() -> void:
	Quick.asked.clear()
	await _grow_field([Quick.new()])
	check_equal(Quick.asked.size(), 5, "asks of four variants and a stem")
	check_equal(_field.get_plant_count() > 0, true, "plants exist")


func test_a_species_of_more_detail_has_more_segments_at_each_level() -> void:
	Stem.asked.clear()
	_field = _make_field([Stem.new()])
	_field.levels = [PlantFieldLevel.of(6, 5.0), PlantFieldLevel.of(3)]
	_field.species[0].variants = 1
	_field.species[0].lod_bias = 2.0
	root.add_child(_field)
	await _field.build_finished
	await frames(1)
	check(Stem.asked.has(12) and Stem.asked.has(6), "twice the segments: %s" % [Stem.asked])
	check(not Stem.asked.has(3), "not those of the levels: %s" % [Stem.asked])


func test_a_field_that_samples_species_is_building() -> void:
	_field = _make_field([Slow.new()])
	root.add_child(_field)
	await frames(1)
	check(_field.is_building(), "while it asks")
	_field.density = 6.0
	await _field.build_finished
	await frames(1)
	check(not _field.is_building(), "afterwards")
	check(_field.get_plant_count() > 0, "plants exist")


func test_a_field_may_be_freed_while_it_samples_species() -> void:
	_field = _make_field([Slow.new()])
	root.add_child(_field)
	await frames(1)
	_field.free()
	_field = null
	await frames(2)
	check(true, "nothing crashed")


func test_plants_added_while_species_are_sampled_stay() -> void:
	_field = _make_field([Slow.new()])
	root.add_child(_field)
	await frames(1)
	var added := _field.add_plants([Transform3D.IDENTITY], GrassFunction.new())
	await _field.build_finished
	await frames(2)
	check(_field.has_plant(added[0]), "the added plant")


func test_a_species_of_weight_0_is_sampled_before_it_is_added() -> void:
	Slow.asked.clear()
	var slow := Slow.new()
	_field = _make_field([GrassFunction.new(), slow])
	_field.species[1].weight = 0.0
	root.add_child(_field)
	await _field.build_finished
	await frames(1)
	var before := Slow.asked.size()
	check_equal(_max_per_frame(Slow.asked), 1, "asks in a frame")
	var ids := _field.add_plants([Transform3D.IDENTITY], slow)
	check_equal(ids.size(), 1, "plants that came")
	check_equal(Slow.asked.size(), before, "asks")


func test_a_slow_script_is_reported_once() -> void:
	var species := Long.new()
	species.resource_name = "Sleepyhead"
	species.generate_mesh(0.0, 3, 1)
	check_error("Sleepyhead")
	species.emit_changed()
	species.generate_mesh(0.0, 3, 1)
	check_error_count("`_grow` took", 0)


func _make_field(species: Array[PlantFunction]) -> PlantField3D:
	var field := PlantField3D.from_species(species)
	field.size = Vector2(2, 2)
	field.density = 5.0
	return field


func _grow_field(species: Array[PlantFunction]) -> void:
	_field = _make_field(species)
	root.add_child(_field)
	await _field.build_finished
	await frames(1)


func _max_per_frame(asked: Array[int]) -> int:
	var maximum := 0
	for frame in asked:
		maximum = maxi(maximum, asked.count(frame))
	return maximum
