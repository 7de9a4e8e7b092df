@tool
extends EditorNode3DGizmoPlugin
## Base class of the gizmos of plants and fields. It prevents gizmos that outlive their node, and
## redraws the gizmo of a selected node after a change.
##
## The editor's viewport references the gizmo under the pointer or in a drag, also while its scene
## is reloaded. The gizmo stores its node as a plain address. When the plugin is removed, the engine
## reads the node of each gizmo, and a freed node crashes the editor. So the gizmo of a node that
## leaves the tree moves to a permanent node. Nodes that return get a new one.

const Translations := preload("../translations/translations.gd")

var _undo: EditorUndoRedoManager
var _placeholder: Node3D
# Gizmos of each node in the tree, by the node's id.
var _made: Dictionary[int, Array] = {}
# Drawn values of each selected node, by its id. Different values cause a redraw.
var _drawn: Dictionary[int, Array] = {}


func _init() -> void:
	set_translation_domain(Translations.DOMAIN)


## Changes are steps of [param undo]. Gizmos without a node belong to [param placeholder], which
## must outlive this object.
func setup(undo: EditorUndoRedoManager, placeholder: Node3D) -> void:
	_undo = undo
	_placeholder = placeholder
	(Engine.get_main_loop() as SceneTree).process_frame.connect(_follow)
	EditorInterface.get_selection().selection_changed.connect(_on_selection_changed)
	_request_gizmos.call_deferred()


## Releases the editor's objects. Call it before the plugin is removed.
func close() -> void:
	(Engine.get_main_loop() as SceneTree).process_frame.disconnect(_follow)
	EditorInterface.get_selection().selection_changed.disconnect(_on_selection_changed)


func _create_gizmo(node: Node3D) -> EditorNode3DGizmo:
	if not _has_gizmo(node):
		return null
	var gizmo := EditorNode3DGizmo.new()
	var id := node.get_instance_id()
	if not _made.has(id):
		_made[id] = []
		node.tree_exited.connect(_release_gizmos.bind(id), CONNECT_ONE_SHOT)
	_made[id].append(weakref(gizmo))
	return gizmo


## Returns the nodes with a detailed gizmo: the selected ones.
func _worked_on() -> Array[Node3D]:
	var nodes: Array[Node3D] = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		if node is Node3D and _has_gizmo(node as Node3D):
			nodes.append(node)
	return nodes


## Returns the values that the gizmo of a selected node shows. They can change at any time.
func _get_shown_values(_node: Node3D) -> Array:
	return []


# Runs in each frame.
func _follow() -> void:
	for node in _worked_on():
		var values := _get_shown_values(node)
		if _drawn.get(node.get_instance_id(), []) != values:
			_drawn[node.get_instance_id()] = values
			node.update_gizmos()


# Deselected nodes lose their details. Newly selected ones get theirs in the next frame.
func _on_selection_changed() -> void:
	for id in _drawn:
		var node := instance_from_id(id) as Node3D
		if node:
			node.update_gizmos()
	_drawn.clear()


## Uses the same brightness for all selected nodes. The editor's own materials brighten only one.
static func _line_material(color: Color, on_top: bool) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = color
	material.no_depth_test = on_top
	material.disable_fog = true
	return material


static func _is_selected(node: Node) -> bool:
	return EditorInterface.get_selection().get_selected_nodes().has(node)


func _release_gizmos(id: int) -> void:
	for reference: WeakRef in _made[id]:
		var gizmo := reference.get_ref() as EditorNode3DGizmo
		if gizmo:
			gizmo.set_node_3d(_placeholder)
	_made.erase(id)
	_drawn.erase(id)


# Nodes of a scene that was open before the plugin got no gizmo. They must request it again.
func _request_gizmos() -> void:
	var root := EditorInterface.get_edited_scene_root()
	if not root:
		return
	for node: Node in [root] + root.find_children("*", "Node3D", true, false):
		if node is Node3D and _has_gizmo(node as Node3D):
			(node as Node3D).clear_gizmos()
			(node as Node3D).update_gizmos()
