## The number of plants that distant cameras draw. Nothing else depends on it.
extends "res://tests/engine/field_harness.gd"

var _camera: Camera3D


func before_each() -> void:
	field = PlantField3D.from_species([load("res://addons/undergrowth/species/meadow_grass.tres")])
	field.density = 20.0
	field.size = Vector2(10, 10)
	field.simulation_enabled = false
	_camera = Camera3D.new()
	root.add_child(_camera)
	_camera.make_current()


func after_each() -> void:
	_camera.free()
	super()


func test_fewer_plants_are_drawn_the_farther_the_camera_is() -> void:
	field.levels = [PlantFieldLevel.of(3, 100.0, 0.2)]
	await start()
	var drawn := PackedInt32Array()
	for away: float in [0.0, 30.0, 60.0, 110.0]:
		drawn.append(await _drawn_from(away))
	check_equal(drawn[0], field.get_plant_count(), "plants beside the camera")
	for i in 3:
		check(drawn[i + 1] < drawn[i] * 0.9, "drawn from ever farther: %s" % drawn)
	check_near(drawn[3] / float(drawn[0]), 0.25, 0.06, "the density and the fading plants")
	check_equal(await _drawn_from(0.0), drawn[0], "back again")


func test_a_share_touches_no_plant() -> void:
	field.levels = [PlantFieldLevel.of(3, 40.0)]
	await start()
	field.remove_in_sphere(Vector3.ZERO, 1.0)
	var ids := field.get_plant_ids()
	var places := field.get_plant_transforms(ids)
	var all := await _drawn_from(40.0)
	var signals := []
	field.build_finished.connect(func() -> void: signals.append(true))
	field.levels[0].density = 0.3
	check(not field.is_building(), "it is not rebuilt")
	check(not field.get_statistics()["is_rebuilding_meshes"], "its meshes are not rebuilt")
	await frames(3)
	check(await _drawn_from(40.0) < all * 0.5, "fewer are drawn")
	check(signals.is_empty(), "no build_finished")
	check_equal(field.get_plant_ids(), ids, "ids")
	check_equal(field.get_plant_transforms(ids), places, "places")
	check_equal(field.find_plants_in_sphere(Vector3.ZERO, 20.0).size(), ids.size(), "found")
	check(
		not field.get_tip_position(ids[-1]).is_zero_approx(), "a tip of a plant that may be hidden"
	)


func test_added_plants_are_left_away_too() -> void:
	field.density = 0.0
	field.levels = [PlantFieldLevel.of(3, 40.0, 0.0)]
	await start()
	field.add_plants(
		[Transform3D.IDENTITY, Transform3D(Basis.IDENTITY, Vector3(1, 0, 0))],
		field.species[0].species
	)
	await frames(2)
	check_equal(await _drawn_from(0.0), 2)
	check(await _drawn_from(100.0) < 2, "none is left at the end")


func test_without_levels_only_plants_of_parts_are_thinned() -> void:
	await start()
	var tufts := await _drawn_from(120.0)
	check(tufts < field.get_plant_count() * 0.2, "%d tufts" % tufts)
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	await rested()
	check_equal(await _drawn_from(120.0), field.get_plant_count(), "single blades")


func test_a_field_without_species_grows_meadow_grass() -> void:
	field.species = []
	await start()
	var ids := field.get_plant_ids()
	check(ids.size() > 1000, "%d plants" % ids.size())
	var species := field.get_plant_species(ids[0])
	check_equal(species.resource_path, "res://addons/undergrowth/species/meadow_grass.tres")
	check(field.species.is_empty(), "its list stays empty")


func test_a_share_out_of_range_keeps_the_value() -> void:
	var level := PlantFieldLevel.of(3, 10.0, 0.4)
	check_equal(level.density, 0.4)
	level.density = 1.5
	check_error("density cannot be 1.5")
	check_equal(level.density, 0.4)


## Returns the number of drawn plants, at all levels, for a camera at this distance from the field's
## middle.
func _drawn_from(away: float) -> int:
	_camera.position = Vector3(away, 1.0, 0)
	await frames(2)
	var count := 0
	for drawn: int in field.get_statistics()["drawn_by_level"]:
		count += drawn
	return count
