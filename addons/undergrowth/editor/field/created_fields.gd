@tool
extends RefCounted
## Lays fields of the Create Node dialog on the ground at their position, and gives them the wind of
## the scene. This belongs to the step of undo that creates them.

const EditorState := preload("../editor_state.gd")
const FieldPlacing := preload("field_placing.gd")
const SceneActions := preload("../actions/scene_actions.gd")
const DOCK_CLASS := "SceneTreeDock"
## The dock emits it with each node of the dialog, also when the creation is redone.
const CREATED := &"node_created"

var _state: EditorState
# Ids of the fields so far. Redo restores their properties itself.
var _known: Dictionary[int, bool] = {}


## Follows the dialog. Fields of a scene without a wind get that of [param state].
func setup(state: EditorState) -> void:
	_state = state
	for dock in _find_docks():
		dock.connect(CREATED, _on_node_created)


func close() -> void:
	for dock in _find_docks():
		dock.disconnect(CREATED, _on_node_created)


static func _find_docks() -> Array[Node]:
	var docks := EditorInterface.get_base_control().find_children("*", DOCK_CLASS, true, false)
	return docks.filter(func(dock: Node) -> bool: return dock.has_signal(CREATED))


# The editor sets the properties of a new node itself at first.
func _on_node_created(node: Node) -> void:
	var field := node as PlantField3D
	if field and not _known.has(field.get_instance_id()):
		_known[field.get_instance_id()] = true
		_complete.call_deferred(field)


# Undo removes the node, and redo adds the same node: its properties need no step of their own.
func _complete(field: PlantField3D) -> void:
	var root := EditorInterface.get_edited_scene_root()
	if not is_instance_valid(field) or not root or not field.is_inside_tree():
		return
	field.wind = SceneActions.to_scene_wind(_state.own_wind, root)
	# A field that was created around other nodes stays with them.
	var is_alone := field != root and field.get_child_count() == 0
	var place := FieldPlacing.find(root, field) if is_alone else null
	if place:
		place.lay(field, field.get_parent())
		field.global_position = place.point
	_state.show_new_plants_move()
