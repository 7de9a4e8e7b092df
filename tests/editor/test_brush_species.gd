@tool
extends "brush_test.gd"
## Painting with the species picked in the dock's list, for fields with and without it.

const POPPY := "Poppy"
const POPPY_FILE := "res://addons/undergrowth/species/poppy.tres"
## Position of the stroke of these tests, and radius of its brush.
const FROM := Vector3(-0.5, 0, 1)
const TO := Vector3(0.5, 0, 1)
const REACH := 0.8


func test_a_picked_species_comes_into_the_field_with_a_stroke() -> void:
	var field := await _edited_field()
	var density := field.density
	await _pick(POPPY)
	check(_is_painted("+ " + POPPY), "it is offered")
	check_equal(field.species.size(), 1, "nothing is added before a stroke")
	await _choose_tool("Paint")
	var version := _history().get_version()
	await drag(_view(), _place_of(field, FROM), _place_of(field, TO))
	await _rested(field)
	check_equal(_history().get_version(), version + 1, "steps of undo")
	_check_added(field)
	check(_is_painted(POPPY), "it is one of the field's now")
	await undo()
	check_equal(field.species.size(), 1, "species after undo")
	check_equal(field.density, density, "density after undo")
	check(field.map == null, "it has no map after undo")
	check(_is_painted("+ " + POPPY), "it is offered again")
	await redo()
	await _rested(field)
	_check_added(field)
	await _choose_tool("Paint")


func test_several_picked_species_come_in_with_one_stroke() -> void:
	var field := await _edited_field()
	await _pick(POPPY)
	await reveal_tile(find_tile("Yarrow"))
	holds_ctrl = true
	await click(tiles(), place_of_tile(find_tile("Yarrow")))
	holds_ctrl = false
	for title: String in [POPPY, "Yarrow"]:
		check(_is_painted("+ " + title), title + " is offered")
	await _choose_tool("Paint")
	var version := _history().get_version()
	await drag(_view(), _place_of(field, FROM), _place_of(field, TO))
	await _rested(field)
	check_equal(_history().get_version(), version + 1, "steps of undo")
	check_equal(field.species.size(), 3, "species")
	for title: String in [POPPY, "Yarrow"]:
		check(field.map.get_density((FROM + TO) * 0.5, title) > 0.3, title + " is painted")
	check_equal(field.map.get_density((FROM + TO) * 0.5, GRASS), 1.0, "grass was not chosen")
	await undo()
	check_equal(field.species.size(), 1, "species after undo")
	await _choose_tool("Paint")


func test_the_other_species_have_the_same_density() -> void:
	var field := await _edited_field()
	var grass := field.density
	await _pick(POPPY)
	await _choose_tool("Paint")
	await click(_view(), _place_of(field, FROM))
	var all := field.species[0].weight + field.species[1].weight
	var now := field.density * field.species[0].weight / all
	check(absf(now - grass) < 1e-3 * grass, "%f of %f grasses a square metre" % [now, grass])
	var poppies := field.density * field.species[1].weight / all
	check(poppies > 1.0 and poppies < 100.0, "%f poppies a square metre" % poppies)
	check_equal(field.map.get_density(Vector3(0.5, 0, -1.5), GRASS), 1.0, "grass beside the stroke")
	await _choose_tool("Paint")


func test_what_grows_there_already_is_only_chosen() -> void:
	var field := await _edited_field()
	await _pick(GRASS)
	check(_is_painted(GRASS), "it is chosen")
	check(_species_tile("+ " + GRASS) < 0, "and not offered once more")
	await _choose_tool("Paint")
	await click(_view(), _place_of(field, FROM))
	check_equal(field.species.size(), 1, "species")
	await _choose_tool("Paint")
	await _choose_tool("Paint")
	await _paint_only([])
	await _choose_tool("Paint")


func test_species_are_chosen_by_tiles_several_with_ctrl() -> void:
	var field := await _edited_field()
	var entries: Array[PlantFieldSpecies] = []
	for file: String in ["poppy", "yarrow", "wheat", "barley"]:
		var path := "res://addons/undergrowth/species/%s.tres" % file
		entries.append(PlantFieldSpecies.of(load(path) as PlantFunction))
	await _choose_only(field.get_parent())
	field.species = entries
	field.map = PlantMap.new()
	await _choose_only(field)
	await _choose_tool("Paint")
	var menu := _settings().get_node("%SpeciesMenu") as Button
	var list := _species_tiles()
	check_equal(list.item_count, 5, "tiles, with that of all species")
	var size := list.fixed_icon_size.x / EditorInterface.get_editor_scale()
	check_equal(size, 64.0, "side of a picture")
	check_equal(menu.text, "All Species", "none is chosen")
	await _paint_only([POPPY])
	check_equal(menu.text, POPPY, "one is chosen")
	await _paint_only([POPPY, "Wheat"])
	check_equal(menu.text, "2 Species", "two are chosen")
	await click(_view(), _place_of(field, FROM))
	var painted := field.map.get_painted_species()
	check_equal(painted, PackedStringArray(["Poppy", "Wheat"]), "what is painted")
	await _paint_only([])
	check_equal(menu.text, "All Species", "none is chosen again")
	await _choose_tool("Paint")


func test_only_painting_adds_a_species() -> void:
	var field := await _edited_field()
	await _pick(POPPY)
	var version := _history().get_version()
	await _choose_tool("Erase")
	await click(_view(), _place_of(field, FROM))
	check_equal(field.species.size(), 1, "species")
	check(field.map == null, "of what is not there nothing can be erased")
	check_equal(_history().get_version(), version, "no step of undo")
	await _choose_tool("Erase")


func test_painting_from_the_list_is_seen() -> void:
	var field := await _edited_field()
	field.size = Vector2(12, 12)
	field.species = [
		PlantFieldSpecies.of(load("res://addons/undergrowth/species/meadow_grass.tres"))
	]
	await _rested(field)
	await _pick(POPPY)
	await _choose_tool("Paint")
	await drag(_view(), _place_of(field, Vector3(-3, 0, 0)), _place_of(field, Vector3(3, 0, 2)))
	await _rested(field)
	await frames(40)
	await take_picture("painted")
	check_equal(field.species.size(), 2, "species")
	await _choose_tool("Paint")


func _check_added(field: PlantField3D) -> void:
	check_equal(field.species.size(), 2, "species")
	check_equal(field.species[-1].species.resource_path, POPPY_FILE, "the file of the add-on")
	check(field.map.get_density((FROM + TO) * 0.5, POPPY) > 0.3, "painted in the stroke")
	check_equal(field.map.get_density(Vector3(0, 0, -1.5), POPPY), 0.0, "and nowhere else")
	var seen := 0
	for id in field.get_plant_ids():
		if field.get_plant_species(id) == field.species[-1].species:
			var root := field.get_plant_transform(id).origin
			var nearest := Geometry3D.get_closest_point_to_segment(root, FROM, TO)
			check(root.distance_to(nearest) < REACH + 0.5, "a poppy at %s" % root)
			seen += 1
	check(seen > 0, "poppies exist")


func _pick(title: String) -> void:
	await choose_tile(title)
