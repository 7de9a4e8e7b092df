@tool
extends "actions_test.gd"
## A field warns of habitats that have no effect, as long as they have none.

const SCENE := "res://habitat_warnings.tscn"
const FLAT := "depends on slope or height, but this field is flat"
const BARE := "depends on the distance to the group 'water', which has no Path3D"


func test_habitats_without_effect_have_warnings() -> void:
	var field := await _open_field()
	var habitat := PlantHabitat.new()
	field.species[0].habitat = habitat
	habitat.slope_curve = PlantHabitat.make_curve([Vector2(0, 1), Vector2(20, 0)])
	check(
		await until(func() -> bool: return find_warning(field, "habitat").contains(FLAT)),
		"flat field"
	)
	check(find_warning(field, "habitat").contains("species[0]"), "it names the entry")
	habitat.slope_curve = null
	habitat.distance_group = &"water"
	habitat.distance_curve = PlantHabitat.make_curve([Vector2(0, 1), Vector2(2, 0)])
	check(
		await until(func() -> bool: return find_warning(field, "habitat").contains(BARE)),
		"empty group"
	)
	check(not find_warning(field, "habitat").contains(FLAT), "the first one is gone")
	habitat.distance_curve = null
	check(await until(func() -> bool: return find_warning(field, "habitat") == ""), "none is left")


func test_a_curve_that_is_dragged_changes_the_field() -> void:
	var field := await _open_field()
	var habitat := PlantHabitat.new()
	habitat.height_curve = PlantHabitat.make_curve([Vector2(-1, 1), Vector2(1, 1)])
	field.species[0].habitat = habitat
	check(await until(func() -> bool: return field.get_plant_count() > 40), "plants")
	var before := field.get_plant_count()
	for point in 2:
		habitat.height_curve.set_point_value(point, 0.5)
	var is_thin := func() -> bool: return field.get_plant_count() < 0.7 * before
	check(await until(is_thin), "%d of %d plants" % [field.get_plant_count(), before])


func _open_field() -> PlantField3D:
	var root := Node3D.new()
	root.name = "Land"
	var field := PlantField3D.new()
	field.name = "Meadow"
	field.species = [PlantFieldSpecies.of(GrassFunction.new())]
	field.size = Vector2(4.0, 4.0)
	field.density = 6.0
	root.add_child(field)
	field.owner = root
	return (await _open_alone(SCENE, root)).get_node(^"Meadow")
