@tool
extends "brush_test.gd"
## Painted densities of species that the field already contains, and their display in the settings.

const DensitySlider := preload("res://addons/undergrowth/editor/brush/density_slider.gd")
const POPPY := "Poppy"
const GRASS_LAYER := "Meadow Grass"
const SPECIES := "res://addons/undergrowth/species/%s.tres"
const DENSITY := 12.0
const SIDE := 24.0
## Large, because the number of plants of a density is random.
const RADIUS := 10.0
## Inside the hard edge of the brush, for any grid of cells.
const COUNTED := RADIUS - 0.5


func test_a_density_is_painted_in_plants_per_square_metre() -> void:
	var field := await _meadow()
	var before := _count_beside(field)
	var whole := field.get_plant_ids()
	await _choose_tool("Paint")
	_sharpen(RADIUS)
	await _paint_only([POPPY])
	check(absf(_density().value - DENSITY * 3.0 / 63.0) < 0.01, "as mixed: %f" % _density().value)
	check_equal(_density().max_value, DENSITY, "the slider's end")
	var slider := _density() as DensitySlider
	check(absf(slider.mark - slider.value) < 0.01, "the slider's mark: %f" % slider.mark)
	_density().value = 5.0
	check(not _as_mixed().button_pressed, "no longer as mixed")
	check(absf(slider.mark - DENSITY * 3.0 / 63.0) < 0.01, "the mark then: %f" % slider.mark)
	await click(_view(), _place_of(field, Vector3.ZERO))
	await _rested(field)
	var poppies := _density_in_stroke(field, true)
	var all := poppies + _density_in_stroke(field, false)
	print("brush: %.3f poppies/m² of %.3f plants/m²" % [poppies, all])
	check(absf(poppies - 5.0) < 0.3, "%f poppies/m²" % poppies)
	check(absf(all - DENSITY) < 0.5, "%f plants/m²" % all)
	check_equal(_count_beside(field), before, "plants beside the stroke")
	check_equal(_reported(), "", "what the bar says")
	var painted := [field.map.data, field.get_plant_ids()]
	await undo()
	await _rested(field)
	check(field.map == null, "no map after undo")
	check_equal(field.get_plant_ids(), whole, "plants after undo")
	await redo()
	await _rested(field)
	check_equal([field.map.data, field.get_plant_ids()], painted, "map and plants after redo")
	_as_mixed().button_pressed = true
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(field.map.get_plant_density(Vector3.ZERO, POPPY), 0.0, "plants/m² as mixed")
	check_equal(field.map.get_density(Vector3.ZERO, POPPY), 1.0, "density as mixed")
	await _put_down("Paint")


func test_a_stroke_is_visible_after_two_frames() -> void:
	var field := await _meadow()
	field.map = PlantMap.new()
	await _rested(field)
	await _choose_tool("Paint")
	_sharpen(2.0)
	await _paint_only([POPPY])
	_density().value = 5.0
	var at := _in_window(_view(), _place_of(field, Vector3.ZERO))
	await _point(_view(), at)
	await frames(2)
	_press(_view(), at, MOUSE_BUTTON_LEFT, true)
	await frames(2)
	check(field.get_plant_count() > 30, "%d poppies after two frames" % field.get_plant_count())
	_press(_view(), at, MOUSE_BUTTON_LEFT, false)
	await frames(2)
	await _put_down("Paint")


func test_the_bar_explains_a_stroke_without_effect() -> void:
	var field := await _meadow()
	await _choose_tool("Paint")
	_sharpen(1.0)
	await _paint_only([POPPY])
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(field.map == null, "there is nothing to change")
	check(
		_reported().contains("already has the density of the mix, 0.57"), "as mixed: " + _reported()
	)
	_density().value = 5.0
	check_equal(_reported(), "", "after another density")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check_equal(_reported(), "", "after a stroke that changes something")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(_reported().contains("5.0 plants/m² grow here already"), "once more: " + _reported())
	await _put_down("Paint")
	await _choose_tool("Erase")
	await click(_view(), _place_of(field, Vector3.ZERO))
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(_reported().contains("nothing to erase"), "erased twice: " + _reported())
	await _put_down("Erase")


func test_the_bar_explains_a_full_field() -> void:
	var field := await _meadow()
	field.map = PlantMap.new()
	field.map.fill_polygon_plants(field.get_outline_points(), GRASS_LAYER, 10.0)
	await _choose_tool("Paint")
	_sharpen(1.0)
	await _paint_only([POPPY])
	_density().value = 5.0
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(_reported().contains("14.99 plants/m² are painted"), "it says how many: " + _reported())
	check(_reported().contains("12.0 at most"), "and what there is room for: " + _reported())
	await _put_down("Paint")


func test_pick_takes_the_painted_density() -> void:
	var field := await _meadow()
	field.map = PlantMap.new()
	field.map.fill_polygon_plants(field.get_outline_points(), POPPY, 2.0)
	await _choose_tool("Pick")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(absf(_density().value - 2.0) < 0.02, "density: %f" % _density().value)
	check(not _as_mixed().button_pressed, "not as mixed")
	field.map.fill_polygon(field.get_outline_points(), POPPY)
	await _put_down("Paint")
	await _choose_tool("Pick")
	await click(_view(), _place_of(field, Vector3.ZERO))
	check(_as_mixed().button_pressed, "as mixed")
	(_settings().get_node("%PlantHeight") as EditorSpinSlider).value = 1.5  # Picked as well.
	await _put_down("Paint")


func _meadow() -> PlantField3D:
	var field := await _edited_field()
	field.size = Vector2(SIDE, SIDE)
	field.density = DENSITY
	await _choose_only(field.get_parent())
	field.species = [
		PlantFieldSpecies.of(load(SPECIES % "meadow_grass") as PlantFunction, 60.0),
		PlantFieldSpecies.of(load(SPECIES % "poppy") as PlantFunction, 3.0),
	]
	await _choose_only(field)
	await _rested(field)
	return field


func _put_down(tool: String) -> void:
	await _paint_only([])
	_as_mixed().button_pressed = true
	await _choose_tool(tool)


func _density() -> EditorSpinSlider:
	return _settings().get_node("%Density")


func _as_mixed() -> Button:
	return _settings().get_node("%AsMixed")


func _reported() -> String:
	return (_settings().get_node("%Message") as Label).text


func _density_in_stroke(field: PlantField3D, poppies: bool) -> float:
	var count := 0
	for id in field.get_plant_ids():
		var is_poppy := field.get_plant_species(id) == field.species[1].species
		var distance := field.get_plant_transform(id).origin.length()
		count += int(is_poppy == poppies and distance < COUNTED)
	return count / (PI * COUNTED * COUNTED)


func _count_beside(field: PlantField3D) -> Array[int]:
	var counts: Array[int] = [0, 0]
	for id in field.get_plant_ids():
		if field.get_plant_transform(id).origin.length() > RADIUS + 0.5:
			counts[int(field.get_plant_species(id) == field.species[1].species)] += 1
	return counts
