@tool
extends RefCounted
## Adds drawn paths to a field, each in one step of undo with its node.

const AreaModes := preload("../field/area_modes.gd")
const DrawnPath := preload("drawn_path.gd")
const Translations := preload("../translations/translations.gd")


## Adds a trail without plants through [param field].
static func add_trail(undo: EditorUndoRedoManager, field: PlantField3D, drawn: DrawnPath) -> void:
	undo.create_action(Translations.text("Draw Trail"), UndoRedo.MERGE_DISABLE, field)
	var path := _add(undo, field, drawn, "Trail")
	var widths := field.exclusion_widths.duplicate()
	widths.resize(field.exclusions.size())
	widths.append(drawn.width)
	var exclusions := field.exclusions + ([NodePath(path.name)] as Array[NodePath])
	AreaModes.change(undo, field, &"exclusions", exclusions)
	AreaModes.change(undo, field, &"exclusion_widths", widths)
	undo.commit_action()


## Makes the path the area of [param field]: a closed one is a bed, an open one a hedge with a
## width. It replaces a path that is drawn like this.
static func set_area(undo: EditorUndoRedoManager, field: PlantField3D, drawn: DrawnPath) -> void:
	var closed := drawn.is_closed()
	var title := Translations.text("Draw Bed") if closed else Translations.text("Draw Hedge")
	undo.create_action(title, UndoRedo.MERGE_DISABLE, field)
	var replaced := AreaModes.find_own_path(field)
	if replaced:
		undo.add_do_method(field, &"remove_child", replaced)
	var path := _add(undo, field, drawn, "Bed" if closed else "Hedge", replaced)
	if replaced:
		AreaModes.restore_child(undo, field, replaced)
	AreaModes.use_path(undo, field, NodePath(path.name))
	AreaModes.change(undo, field, &"outline_width", 0.0 if closed else drawn.width)
	AreaModes.change(undo, field, &"endless", false)
	undo.commit_action()


static func _add(
	undo: EditorUndoRedoManager,
	field: PlantField3D,
	drawn: DrawnPath,
	title: String,
	replaced: Node = null
) -> Path3D:
	var path := Path3D.new()
	path.curve = drawn.make_curve()
	AreaModes.add_child(undo, field, path, title, replaced)
	return path
