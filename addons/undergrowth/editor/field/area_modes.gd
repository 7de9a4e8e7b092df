@tool
extends RefCounted
## The three areas of a field, of which one is in use: its rectangle, the outline of a path, and the
## painted map. A change of the mode keeps the others in metadata of the node.

enum Mode { RECTANGLE, PATH, PAINTED }

const FieldEntries := preload("../actions/field_entries.gd")
const ScenePlants := preload("../wind/scene_plants.gd")
const Translations := preload("../translations/translations.gd")
## Hidden in the inspector and saved with the scene.
const KEPT_OUTLINE := &"_undergrowth_outline"
const KEPT_MAP := &"_undergrowth_map"


static func find(field: PlantField3D) -> Mode:
	if field.map:
		return Mode.PAINTED
	return Mode.PATH if field.outline else Mode.RECTANGLE


## Uses the area [param mode] of [param field] in one step of undo. A field without a path or a map
## gets one with its present area.
static func choose(undo: EditorUndoRedoManager, field: PlantField3D, mode: Mode) -> void:
	if mode == find(field):
		return
	undo.create_action(_title(mode), UndoRedo.MERGE_DISABLE, field)
	var kept_map := field.map if field.map else _get_kept(field, KEPT_MAP) as PlantMap
	var kept_outline := field.outline
	if kept_outline.is_empty() and field.has_meta(KEPT_OUTLINE):
		kept_outline = field.get_meta(KEPT_OUTLINE)
	if mode == Mode.PATH and kept_outline.is_empty():
		kept_outline = _add_path(undo, field)
	if mode == Mode.PAINTED and not kept_map:
		kept_map = make_map(field)
	change(undo, field, &"map", kept_map if mode == Mode.PAINTED else null)
	change(undo, field, &"outline", NodePath() if mode == Mode.RECTANGLE else kept_outline)
	_keep(undo, field, KEPT_MAP, null if mode == Mode.PAINTED else kept_map)
	var is_kept := mode == Mode.RECTANGLE and not kept_outline.is_empty()
	_keep(undo, field, KEPT_OUTLINE, kept_outline if is_kept else null)
	undo.commit_action()


## Returns a map that is painted within the outline of [param field] for all its species.
static func make_map(field: PlantField3D) -> PlantMap:
	var map := PlantMap.new()
	for title in FieldEntries.layers_of(field):
		map.fill_polygon(field.get_outline_points(), title)
	return map


static func _title(mode: Mode) -> String:
	match mode:
		Mode.PATH:
			return Translations.text("Use a Path as Area")
		Mode.PAINTED:
			return Translations.text("Use a Painted Area")
	return Translations.text("Use a Rectangle as Area")


## Adds a changed property to a step of undo.
static func change(
	undo: EditorUndoRedoManager, field: PlantField3D, property: StringName, value: Variant
) -> void:
	var before: Variant = field.get(property)
	if typeof(value) != typeof(before) or value != before:
		undo.add_do_property(field, property, value)
		undo.add_undo_property(field, property, before)


static func _get_kept(field: PlantField3D, key: StringName) -> Variant:
	return field.get_meta(key) if field.has_meta(key) else null


# Metadata that is null is removed.
static func _keep(
	undo: EditorUndoRedoManager, field: PlantField3D, key: StringName, value: Variant
) -> void:
	var before: Variant = _get_kept(field, key)
	if typeof(value) != typeof(before) or value != before:
		undo.add_do_method(field, &"set_meta", key, value)
		undo.add_undo_method(field, &"set_meta", key, before)


## Adds to a step of undo that [param path] is the area of [param field]. Its map is kept.
static func use_path(undo: EditorUndoRedoManager, field: PlantField3D, path: NodePath) -> void:
	if field.map:
		_keep(undo, field, KEPT_MAP, field.map)
	_keep(undo, field, KEPT_OUTLINE, null)
	change(undo, field, &"map", null)
	change(undo, field, &"outline", path)


## Returns the path that only marks the area of [param field]: its child, without children, a script
## or another use. Null: there is none.
static func find_own_path(field: PlantField3D) -> Path3D:
	var outline := field.outline
	if outline.is_empty() and field.has_meta(KEPT_OUTLINE):
		outline = field.get_meta(KEPT_OUTLINE)
	var path := field.get_node_or_null(outline) as Path3D if outline else null
	if not path or path.get_parent() != field or path.get_script() or path.get_child_count() > 0:
		return null
	var root := EditorInterface.get_edited_scene_root()
	for other: PlantField3D in ScenePlants.all(root).filter(_is_field):
		var paths := other.exclusions.duplicate()
		if other != field:
			paths.append(other.outline)
		for used in paths:
			if used and other.get_node_or_null(used) == path:
				return null
	return path


static func _is_field(plant: Node) -> bool:
	return plant is PlantField3D


## Adds to a step of undo that [param path] returns into [param field]. Its name must be free then.
static func restore_child(undo: EditorUndoRedoManager, field: PlantField3D, path: Node) -> void:
	undo.add_undo_method(field, &"add_child", path, true)
	undo.add_undo_method(field, &"move_child", path, path.get_index())
	undo.add_undo_property(path, &"owner", path.owner)
	undo.add_undo_reference(path)


## Adds to a step of undo a new [param node] below [param field], called [param title]. It may have
## the name of [param replaced].
static func add_child(
	undo: EditorUndoRedoManager,
	field: PlantField3D,
	node: Node,
	title: String,
	replaced: Node = null
) -> void:
	node.name = title
	var number := 2
	while field.has_node(NodePath(node.name)) and field.get_node(NodePath(node.name)) != replaced:
		node.name = "%s%d" % [title, number]
		number += 1
	undo.add_do_method(field, &"add_child", node, true)
	undo.add_do_property(node, &"owner", EditorInterface.get_edited_scene_root())
	undo.add_do_reference(node)
	undo.add_undo_method(field, &"remove_child", node)


# A closed path with the corners of the present area, as a child of the field.
static func _add_path(undo: EditorUndoRedoManager, field: PlantField3D) -> NodePath:
	var path := Path3D.new()
	path.curve = Curve3D.new()
	for corner in field.get_outline_points():
		path.curve.add_point(corner)
	path.curve.closed = true
	add_child(undo, field, path, "Outline")
	return NodePath(path.name)
