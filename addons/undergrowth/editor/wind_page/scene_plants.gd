@tool
extends RefCounted
## Finds plants in the edited scene.


## All plants of [param root] and below, in the order of the scene dock.
static func all(root: Node) -> Array[Plant3D]:
	var plants: Array[Plant3D] = []
	if root is Plant3D:
		plants.append(root)
	if root:
		for node in root.find_children("*", "Plant3D", true, false):
			plants.append(node)
	return plants


## The selected plants, or all plants of the edited scene where no plant is selected.
static func chosen() -> Array[Plant3D]:
	var plants: Array[Plant3D] = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		if node is Plant3D:
			plants.append(node)
	return plants if plants else all(EditorInterface.get_edited_scene_root())


## True if the edited scene [param root] saves what is changed on [param plant].
static func is_saved_with(root: Node, plant: Plant3D) -> bool:
	var owner := plant.owner
	return plant == root or owner == root or (owner and root.is_editable_instance(owner))
