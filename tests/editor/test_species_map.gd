@tool
extends "brush_test.gd"
## The map of a field's species in its inspector.

const SpeciesPicture := preload("res://addons/undergrowth/editor/field/species_picture.gd")
const MAP := "res://addons/undergrowth/editor/inspector/species_map.gd"
const SPECIES: Array[String] = ["meadow_grass", "oxeye_daisy"]
## Largest difference of a channel from that of a species' colour.
const TOLERANCE := 0.02


func test_each_species_is_drawn_where_it_grows() -> void:
	var field := await _field_of_halves()
	await _press_map()
	var picture := _part("Picture") as TextureRect
	check(await until(func() -> bool: return picture.texture != null), "a picture")
	var image := picture.texture.get_image()
	check(picture.is_visible_in_tree(), "it is visible")
	var shape := float(image.get_width()) / image.get_height() * field.size.y / field.size.x
	check(absf(shape - 1.0) < 0.15, "it has the shape of the field: %.2f" % shape)
	# The first species grows at x < 0 and z < 0, the second one everywhere else.
	check_equal(_entry_at(image, 0.25, 0.25), 0, "at the upper left")
	for other: Vector2 in [Vector2(0.75, 0.25), Vector2(0.25, 0.75), Vector2(0.75, 0.75)]:
		check_equal(_entry_at(image, other.x, other.y), 1, "at %s" % other)
	check_equal(_legend(), _counted(field), "titles and numbers")
	await take_picture("species_map")
	field.species[0].habitat = null
	field.species = [field.species[0]] as Array[PlantFieldSpecies]
	var is_new := func() -> bool:
		return _entry_at((_part("Picture") as TextureRect).texture.get_image(), 0.75, 0.75) == 0
	check(await until(is_new), "it follows a change of the species")
	await _press_map()
	check(not _part("Picture").visible, "a second click hides it")


func _field_of_halves() -> PlantField3D:
	var field := await _edited_field()
	await open_inspector()
	await frames(20)
	var entries: Array[PlantFieldSpecies] = []
	for i in SPECIES.size():
		var file := "res://addons/undergrowth/species/%s.tres" % SPECIES[i]
		var entry := PlantFieldSpecies.of(load(file) as PlantFunction, 1.0)
		entry.habitat = PlantHabitat.new()
		entry.habitat.texture = _corner(i == 0)
		entry.habitat.texture_size = field.size
		entry.habitat.texture_repeat = false
		entry.habitat.texture_curve = PlantHabitat.make_curve([Vector2(0.49, 0), Vector2(0.51, 1)])
		entries.append(entry)
	field.species = entries
	field.density = 40.0
	await _rested(field)
	return field


## White at its upper left and black elsewhere, or the reverse.
func _corner(is_white: bool) -> ImageTexture:
	var image := Image.create_empty(64, 64, false, Image.FORMAT_L8)
	image.fill(Color.BLACK if is_white else Color.WHITE)
	image.fill_rect(Rect2i(0, 0, 32, 32), Color.WHITE if is_white else Color.BLACK)
	return ImageTexture.create_from_image(image)


func _part(name: String) -> Control:
	return find_by_script(MAP).get_node(name) as Control


func _press_map() -> void:
	await click(_part("Button"))


## Returns the species whose colour most pixels around a place of the picture have, or -1.
func _entry_at(image: Image, x: float, y: float) -> int:
	var votes: Array[int] = [0, 0]
	for column in range(-1, 2):
		for row in range(-1, 2):
			var at := Vector2i(int(x * image.get_width()), int(y * image.get_height()))
			var color := image.get_pixelv(at + Vector2i(column, row))
			for i in 2:
				var own := SpeciesPicture.color_of(i)
				var differs := absf(color.r - own.r) + absf(color.g - own.g) + absf(color.b - own.b)
				votes[i] += 1 if color.a > 0.0 and differs < 3.0 * TOLERANCE else 0
	if votes[0] + votes[1] < 3 or mini(votes[0], votes[1]) > 0:
		return -1
	return 0 if votes[0] > 0 else 1


func _legend() -> PackedStringArray:
	var titles: PackedStringArray = []
	for row in _part("Legend").get_children():
		titles.append((row.get_child(1) as Label).text)
	return titles


func _counted(field: PlantField3D) -> PackedStringArray:
	var counts: Array[int] = [0, 0]
	for id in field.get_plant_ids():
		counts[0 if field.get_plant_species(id) == field.species[0].species else 1] += 1
	return ["Meadow Grass (%d)" % counts[0], "Ox-eye Daisy (%d)" % counts[1]]
