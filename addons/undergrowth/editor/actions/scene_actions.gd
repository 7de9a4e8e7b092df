@tool
extends RefCounted
## Changes of the edited scene. Each is one step of Godot's undo.

const Translations := preload("../translations/translations.gd")
const FieldDefaults := preload("field_defaults.gd")
const FieldEntries := preload("field_entries.gd")
const FileNames := preload("file_names.gd")
const SameResource := preload("same_resource.gd")
const ScenePlants := preload("../wind/scene_plants.gd")


## Adds [param plant], a single one or a field, below [param parent] in the scene of [param root],
## upright at [param point] in world axes. Adds [param others] below the root in the same step.
static func add(
	undo: EditorUndoRedoManager,
	root: Node,
	parent: Node,
	plant: Node3D,
	point: Vector3,
	others: Array[Node] = []
) -> void:
	var title := "Add Field" if plant is PlantField3D else "Add Plant"
	plant.transform = _local_place(parent as Node3D, point)
	undo.create_action(Translations.text(title), UndoRedo.MERGE_DISABLE, root)
	for other in others:
		_add_node(undo, root, root, other)
	_add_node(undo, root, parent, plant)
	undo.commit_action()


## Returns a plant that is ready to be added.
static func make_plant(function: PlantFunction, wind: PlantWind, title: String) -> Plant3D:
	var plant := Plant3D.new()
	plant.name = FileNames.to_node_name(title)
	plant.species = function
	plant.wind = wind
	return plant


## Returns a field of that species that is ready to be added, with the density for its size.
static func make_field(function: PlantFunction, wind: PlantWind, title: String) -> PlantField3D:
	var field := FieldDefaults.make_field(function)
	field.name = FileNames.to_node_name(title)
	field.wind = wind
	return field


## Returns the field of a mix that is ready to be added. The scene owns the field: its changes do
## not affect other fields of that mix. Its species stay in their files.
static func make_mix(mix: PackedScene, wind: PlantWind) -> PlantField3D:
	var field := mix.instantiate() as PlantField3D
	field.scene_file_path = ""
	var species: Array[PlantFieldSpecies] = []
	for listed in field.species:
		species.append(listed.duplicate())
	field.species = species
	var levels: Array[PlantFieldLevel] = []
	for level in field.levels:
		levels.append(level.duplicate())
	field.levels = levels
	field.wind = wind
	return field


## Gives all [param plants] of the scene of [param root] the same function. Single plants change to
## that species. Fields get it in addition to their species, whose densities stay the same. Fields
## without wind get [param wind].
static func assign(
	undo: EditorUndoRedoManager,
	root: Node,
	plants: Array[Node3D],
	function: PlantFunction,
	wind: PlantWind
) -> void:
	undo.create_action(Translations.text("Use Species for Selected"), UndoRedo.MERGE_DISABLE, root)
	for plant in plants:
		if plant is PlantField3D:
			_add_species(undo, plant as PlantField3D, function)
			_add_wind(undo, plant as PlantField3D, wind)
		else:
			undo.add_do_property(plant, &"species", function)
			undo.add_undo_property(plant, &"species", plant.get(&"species"))
	undo.commit_action()


## Returns the selected plants and fields that belong to the scene of [param root].
static func get_selected_plants(root: Node) -> Array[Node3D]:
	var plants: Array[Node3D] = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		if (node is Plant3D or node is PlantField3D) and _is_saved_with(node, root):
			plants.append(node)
	return plants


## Returns the parent for a new plant: the selected Node3D, except another plant or a field.
static func get_parent_for_new(root: Node) -> Node:
	for node in EditorInterface.get_selection().get_selected_nodes():
		var parent := node
		while ScenePlants.is_plant(parent) and parent != root:
			parent = parent.get_parent()
		if parent is Node3D and _is_saved_with(parent, root):
			return parent
	return root


## Returns [param function] if it has its own file, or its [param origin] file if both are equal.
## Otherwise returns an equal function of the scene of [param root], or a copy. A copy prevents
## later edits in the dock from changing the scene.
static func to_scene_function(
	function: PlantFunction, root: Node, origin: PlantFunction = null
) -> PlantFunction:
	if not function.is_built_in():
		return function
	if origin and SameResource.has_equal_properties(origin, function):
		return origin
	for known in _get_functions(root):
		if SameResource.are_equal(known, function):
			return known
	return function.duplicate(true)


## Returns the wind of the scene of [param root], or a copy of [param fallback] if it has none.
static func to_scene_wind(fallback: PlantWind, root: Node) -> PlantWind:
	for plant in ScenePlants.all(root):
		var wind: PlantWind = plant.get(&"wind")
		if wind and ScenePlants.is_wind_saved(root, wind):
			return wind
	return fallback.duplicate() as PlantWind


static func _get_functions(root: Node) -> Array[PlantFunction]:
	var functions: Array[PlantFunction] = []
	for plant in ScenePlants.all(root):
		if plant is PlantField3D:
			for listed in (plant as PlantField3D).species:
				functions.append(listed.species if listed else null)
		else:
			functions.append((plant as Plant3D).species)
	return functions.filter(func(function: PlantFunction) -> bool: return function != null)


static func _add_node(undo: EditorUndoRedoManager, root: Node, parent: Node, node: Node) -> void:
	undo.add_do_method(parent, &"add_child", node, true)
	undo.add_do_property(node, &"owner", root)
	undo.add_do_reference(node)
	undo.add_undo_method(parent, &"remove_child", node)


static func _add_species(
	undo: EditorUndoRedoManager, field: PlantField3D, function: PlantFunction
) -> void:
	if FieldEntries.find(field, function):
		return
	var new_entry := FieldEntries.make(function, FieldEntries.layers_of(field))
	var density := FieldEntries.suit(field, new_entry)
	undo.add_do_property(field, &"density", density)
	undo.add_undo_property(field, &"density", field.density)
	undo.add_do_property(
		field, &"species", field.species + ([new_entry] as Array[PlantFieldSpecies])
	)
	undo.add_undo_property(field, &"species", field.species)


static func _add_wind(undo: EditorUndoRedoManager, field: PlantField3D, wind: PlantWind) -> void:
	if field.wind:
		return
	undo.add_do_property(field, &"wind", wind)
	undo.add_undo_property(field, &"wind", null)


static func _is_saved_with(node: Node, root: Node) -> bool:
	return node == root or node.owner == root


static func _local_place(parent: Node3D, point: Vector3) -> Transform3D:
	var place := Transform3D(Basis.IDENTITY, point)
	if not parent or is_zero_approx(parent.global_basis.determinant()):
		return place
	return parent.global_transform.affine_inverse() * place
