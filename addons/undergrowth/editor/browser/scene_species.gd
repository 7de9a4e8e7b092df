@tool
extends RefCounted
## Follows the species selected in the edited scene: that of a plant, or the first of a field.

## Emitted when another plant or field with this species was selected.
signal selected(species: PlantFunction)

var _page: Control
var _is_pending := false
# Id of the node that the dock has added. 0: none.
var _own_id := 0


## Reports the selection while [param page] is visible, and when it becomes visible.
func setup(page: Control) -> void:
	_page = page
	page.visibility_changed.connect(_on_visibility_changed)
	EditorInterface.get_selection().selection_changed.connect(_on_selection_changed)


## Ignores the selection of [param node], which the dock adds itself, until another one is selected.
func skip(node: Node) -> void:
	_own_id = node.get_instance_id()


static func find() -> PlantFunction:
	for node in EditorInterface.get_selection().get_selected_nodes():
		if node is Plant3D:
			return (node as Plant3D).species
		if node is PlantField3D:
			for listed in (node as PlantField3D).species:
				if listed and listed.species:
					return listed.species
	return null


func _on_selection_changed() -> void:
	var nodes := EditorInterface.get_selection().get_selected_nodes()
	if nodes.size() == 1 and nodes[0].get_instance_id() == _own_id:
		_is_pending = false
		return
	_own_id = 0 if nodes else _own_id
	_is_pending = not _page.is_visible_in_tree()
	var found := null if _is_pending else find()
	if found:
		selected.emit(found)


func _on_visibility_changed() -> void:
	if _is_pending and _page.is_visible_in_tree():
		_on_selection_changed()
