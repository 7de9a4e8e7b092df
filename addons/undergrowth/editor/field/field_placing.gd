@tool
extends RefCounted
## Places an existing field on the ground below or above it.

const NewPlace := preload("../actions/new_place.gd")
const Translations := preload("../translations/translations.gd")
## Metres above the field at which the search begins. Without ground below, it begins at the highest
## point.
const STARTS: Array[float] = [0.5, 1000.0]
## Metadata, hidden in the inspector and saved with the scene.
const KEPT_FLAT := &"_undergrowth_keep_flat"
const LAID: Array[StringName] = [
	&"ground_mode", &"ground_mesh", &"ground_object", &"ground_collision_mask"
]


## Moves [param field] to the ground at its centre and sets its ground mode, as one step of undo.
## Returns false if the scene of [param root] has no ground there.
static func place(undo: EditorUndoRedoManager, root: Node, field: PlantField3D) -> bool:
	var found := find(root, field)
	if not found:
		return false
	var laid := PlantField3D.new()
	laid.ground_collision_mask = field.ground_collision_mask
	found.lay(laid, field.get_parent())
	undo.create_action(Translations.text("Place on Ground"), UndoRedo.MERGE_DISABLE, field)
	for property in LAID:
		undo.add_do_property(field, property, laid.get(property))
		undo.add_undo_property(field, property, field.get(property))
	undo.add_do_property(field, &"global_position", found.point)
	undo.add_undo_property(field, &"global_position", field.global_position)
	undo.commit_action()
	laid.free()
	return true


## Returns true if [param field] is meant to be off the ground, such as plants at the level of a
## lake.
static func is_kept_flat(field: PlantField3D) -> bool:
	return field.has_meta(KEPT_FLAT)


## Sets whether [param field] is meant to be off the ground, as one step of undo.
static func keep_flat(undo: EditorUndoRedoManager, field: PlantField3D, on: bool) -> void:
	undo.create_action(Translations.text("Keep Flat"), UndoRedo.MERGE_DISABLE, field)
	undo.add_do_method(field, &"set_meta", KEPT_FLAT, true if on else null)
	undo.add_undo_method(field, &"set_meta", KEPT_FLAT, null if on else true)
	undo.commit_action()


## Returns the ground below [param field], or above it, or null.
static func find(root: Node, field: PlantField3D) -> NewPlace:
	for start in STARTS:
		var from := field.global_position + Vector3.UP * start
		var found: NewPlace = NewPlace.find_along(field.get_world_3d(), root, from, Vector3.DOWN)
		if found.has_ground:
			return found
	return null
