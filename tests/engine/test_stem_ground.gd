## The ground stops the stems of ready species in any strong wind, in fields and alone.
extends "res://tests/engine/field_harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
const BLAST_STEPS := 60
const STORM_STEPS := 240
## Tolerance (m per m) of a drawn tip, by texels of half floats.
const ROUNDED := 2e-3


func before_each() -> void:
	field = null


func test_no_blast_takes_ready_species_below_the_ground() -> void:
	for species in _ready_species():
		await _grow(species, null)
		for impulse: float in [0.1, 6.0]:
			field.reset_motion()
			field.apply_blast(Vector3.ZERO, 3.0, impulse)
			_check_above(species, "a blast of %.1f N·s" % impulse, BLAST_STEPS)
		field.free()


func test_no_storm_takes_ready_species_below_the_ground() -> void:
	var storm: PlantWind = load("res://addons/undergrowth/winds/storm.tres").duplicate()
	var waves := PlantWind.new()
	waves.strength = 20.0
	for species in _ready_species():
		await _grow(species, null)
		for wind: PlantWind in [storm, waves]:
			field.reset_motion()
			_check_above(species, "a storm", STORM_STEPS, wind)
		field.free()


func test_no_impulse_moves_an_isolated_plant_below_the_ground() -> void:
	var plant := Plant3D.new()
	plant.simulation_enabled = false
	root.add_child(plant)
	for species in _ready_species():
		plant.species = load(FOLDER + species)
		await frames(1)
		var lowest := 1.0
		plant.apply_impulse(Vector3(6, 1, 2))
		for i in BLAST_STEPS:
			plant.advance(STEP)
			lowest = minf(lowest, plant.to_local(plant.get_tip_position()).y)
		check(lowest > -ROUNDED, "%s: %.3f m" % [species, lowest])
	plant.free()


func test_a_species_without_ground_falls_below_it() -> void:
	var species: PlantFunction = load(FOLDER + "common_reed.tres").duplicate()
	var plant := Plant3D.new()
	plant.simulation_enabled = false
	plant.species = species
	root.add_child(plant)
	await frames(1)
	for above: bool in [true, false]:
		species.stays_above_ground = above
		plant.reset_motion()
		plant.apply_impulse(Vector3(6, 0, 0))
		var lowest := 1.0
		for i in BLAST_STEPS:
			plant.advance(STEP)
			lowest = minf(lowest, plant.to_local(plant.get_tip_position()).y)
		check((lowest < -0.1) != above, "%s: %.3f m" % [above, lowest])
	plant.free()


func _ready_species() -> Array[String]:
	var files: Array[String] = []
	for file in DirAccess.get_files_at(FOLDER):
		if file.ends_with(".tres"):
			files.append(file)
	check(files.size() >= 18, "%d species" % files.size())
	return files


func _grow(species: String, wind: PlantWind) -> void:
	field = PlantField3D.from_species([load(FOLDER + species)])
	field.size = Vector2(6, 6)
	field.density = 2.0
	field.levels = [PlantFieldLevel.of(2)]  # The search for levels takes longer than the motion.
	field.simulation_enabled = false
	field.wind = wind
	await start()


func _check_above(species: String, what: String, steps: int, wind: PlantWind = null) -> void:
	var ids := field.get_plant_ids()
	var lowest := 1.0
	for i in steps:
		if wind:
			wind.advance(STEP)
		field._preview(STEP, wind)
		for tip in field.get_tip_positions(ids):
			lowest = minf(lowest, tip.y)
	check(lowest > -ROUNDED, "%s in %s: %.3f m" % [species, what, lowest])
