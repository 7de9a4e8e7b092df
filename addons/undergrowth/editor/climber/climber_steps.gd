@tool
extends RefCounted
## Changes of a climber, each in one step of undo.

const Translations := preload("../translations/translations.gd")


## Lets [param climber] follow [param points] in its axes. Without points it grows by itself.
static func change_path(
	undo: EditorUndoRedoManager, climber: PlantClimber3D, points: PackedVector3Array
) -> void:
	_change(undo, climber, Translations.text("Draw Path"), &"path", points)


static func change_seed(undo: EditorUndoRedoManager, climber: PlantClimber3D, value: int) -> void:
	_change(undo, climber, Translations.text("Grow Another"), &"seed", value)


static func _change(
	undo: EditorUndoRedoManager,
	climber: PlantClimber3D,
	title: String,
	property: StringName,
	value: Variant
) -> void:
	undo.create_action(title, UndoRedo.MERGE_DISABLE, climber)
	undo.add_do_property(climber, property, value)
	undo.add_undo_property(climber, property, climber.get(property))
	undo.commit_action()
