## Fields of the user's meshes do what fields of other species do.
extends "res://tests/engine/field_harness.gd"

const Maker := preload("res://tests/engine/model_maker.gd")
const Files := preload("res://tests/engine/model_files.gd")

var _species: MeshPlantFunction


func before_each() -> void:
	_species = MeshPlantFunction.of(Files.flower(Maker.plain(Color.GREEN)).mesh())
	_species.resource_name = "Flower"
	field = PlantField3D.from_species([_species])
	field.size = Vector2(4, 4)
	field.density = 10.0
	field.wind = PlantWind.new()


func test_a_field_of_a_mesh_is_built_moves_and_keeps_its_ids() -> void:
	await start()
	check_near(field.get_plant_count(), 160, 24, "plants")
	var ids := field.get_plant_ids()
	var id := ids[0]
	check_near(field.get_plant_height(id) / _scale_of(id), 0.61, 0.05)
	var before := field.get_tip_position(id)
	await step(30)
	check(field.get_tip_position(id).distance_to(before) > 1e-3, "it moves")
	_species.height = 0.9
	await settled(field)
	check_equal(field.get_plant_ids(), ids, "ids after a change of the height")
	check_near(field.get_plant_height(id) / _scale_of(id), 0.9, 0.01)


func test_plants_are_mown_pushed_and_removed() -> void:
	field.simulation_enabled = false
	await start()
	var id := field.get_plant_ids()[0]
	var place := field.get_plant_transform(id).origin
	field.set_height_in_sphere(place, 0.3, 0.1)
	check_near(field.get_plant_height(id), 0.1, 0.01)
	var other := field.get_plant_ids()[80]
	var before := field.get_tip_position(other)
	field.apply_impulse_in_sphere(field.get_plant_transform(other).origin, 0.5, Vector3(3, 0, 0))
	step_once()
	check(field.get_tip_position(other).distance_to(before) > 1e-3, "the blow bends it")
	var count := field.get_plant_count()
	field.remove_in_sphere(place, 0.3)
	check(field.get_plant_count() < count, "plants are removed")


func test_painted_density_is_followed() -> void:
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 1.5, "Flower")
	await start()
	check(field.get_plant_count() > 10, "%d plants" % field.get_plant_count())
	for id in field.get_plant_ids():
		var root := field.get_plant_transform(id).origin
		check(Vector2(root.x, root.z).length() < 1.6, "no plant is where nothing was painted")


func test_models_are_mixed_by_weight() -> void:
	_species.models = [Files.flower(null).mesh(), Files.tree(20).mesh()]
	_species.weights = PackedFloat32Array([3.0, 1.0])
	field.species[0].variants = 32
	await start()
	var trees := 0
	for id in field.get_plant_ids():
		trees += 1 if field.get_plant_height(id) / _scale_of(id) > 1.2 else 0
	var share := float(trees) / field.get_plant_count()
	check(share > 0.1 and share < 0.45, "%.2f are trees" % share)
	check_equal(Array(field.get_statistics()["levels"][0].variants).max(), 32, "meshes of a level")


func test_a_field_with_a_broken_model_keeps_its_other_species() -> void:
	field.species = [
		PlantFieldSpecies.of(MeshPlantFunction.new()), PlantFieldSpecies.of(GrassFunction.new())
	]
	await start()
	check(field.get_plant_count() > 40, "grass grows")
	check_error("no model")


func test_levels_of_a_mesh_are_chosen_by_the_error_of_their_outline() -> void:
	var sphere := SphereMesh.new()
	sphere.height = 1.0
	sphere.radius = 0.5
	_species.models = [sphere]
	await start()
	var levels: Dictionary = field.get_statistics()["levels"][0]
	var errors: PackedFloat32Array = levels.errors
	check(errors[-1] > errors[0] and errors[0] == 0.0, "errors %s" % errors)
	check(levels.segments.size() >= 3, "segments %s" % levels.segments)
	check_equal(Array(levels.variants).max(), 1, "meshes of a level")


func step_once() -> void:
	field._preview(STEP, field.wind)


func _scale_of(id: int) -> float:
	return field.get_plant_transform(id).basis.y.length()
