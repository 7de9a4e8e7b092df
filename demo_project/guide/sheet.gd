extends Control
## Base of the guide's pictures: cells beside one another, each a small world under the same sun.

const STAGE := preload("res://stage/stage.tscn")
## Thin plants are visible in front of it.
const EARTH := Color(0.2, 0.17, 0.13)
## All plants are near.
const SEGMENTS := 12
const FONT_SIZE := 34
const GAP := 4


func _ready() -> void:
	var row := HBoxContainer.new()
	row.set_anchors_preset(Control.PRESET_FULL_RECT)
	row.add_theme_constant_override(&"separation", GAP)
	add_child(row)
	_fill(row)


## Override it: adds the picture's cells to [param row].
func _fill(_row: HBoxContainer) -> void:
	pass


## A new cell that is called [param title], with a camera at [param from] that looks at
## [param at]; returns the root of its world.
func add_cell(
	row: HBoxContainer, title: String, from: Vector3, at: Vector3, degrees := 40.0
) -> Node3D:
	var container := SubViewportContainer.new()
	container.stretch = true
	container.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	var view := SubViewport.new()
	view.own_world_3d = true
	view.msaa_3d = Viewport.MSAA_2X
	container.add_child(view)
	var world := STAGE.instantiate() as Node3D
	view.add_child(world)
	var earth := StandardMaterial3D.new()
	earth.albedo_color = EARTH
	earth.roughness = 1.0
	(world.get_node("Ground") as MeshInstance3D).material_override = earth
	var camera := Camera3D.new()
	camera.fov = degrees
	camera.look_at_from_position(from, at)
	world.add_child(camera)
	row.add_child(container)
	container.add_child(_make_label(title))
	return world


## A field of ready species, by the names of their files and their shares.
func make_field(files: Dictionary[String, float], density: float, extent: Vector2) -> PlantField3D:
	var field := PlantField3D.new()
	var species: Array[PlantFieldSpecies] = []
	for file in files:
		species.append(PlantFieldSpecies.of(load_species(file), files[file]))
	field.species = species
	field.levels = [PlantFieldLevel.of(SEGMENTS)] as Array[PlantFieldLevel]
	field.density = density
	field.size = extent
	return field


## A species of the add-on.
func load_species(file: String) -> PlantFunction:
	return load("res://addons/undergrowth/species/%s.tres" % file)


func _make_label(title: String) -> Label:
	var label := Label.new()
	label.text = title
	label.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	label.vertical_alignment = VERTICAL_ALIGNMENT_BOTTOM
	label.add_theme_font_size_override(&"font_size", FONT_SIZE)
	label.add_theme_constant_override(&"outline_size", 6)
	label.add_theme_color_override(&"font_color", Color(0.97, 0.97, 0.93))
	label.add_theme_color_override(&"font_outline_color", Color(0.1, 0.12, 0.1, 0.85))
	return label
