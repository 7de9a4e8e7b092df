@tool
extends RefCounted
## Finds the plants in the edited scene that react to a wind: single plants, fields and climbers.
## All have the property wind and the methods _preview and reset_motion.


static func is_plant(node: Node) -> bool:
	return node is Plant3D or node is PlantField3D or node is PlantClimber3D


## Returns all plants from [param root] on, in the order of the scene dock.
static func all(root: Node) -> Array[Node3D]:
	var plants: Array[Node3D] = []
	if root and is_plant(root):
		plants.append(root)
	if root:
		for node in root.find_children("*", "Node3D", true, false):
			if is_plant(node):
				plants.append(node)
	return plants


## Returns the selected plants, or all plants of the edited scene if none is selected.
static func chosen() -> Array[Node3D]:
	var plants: Array[Node3D] = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		if is_plant(node):
			plants.append(node)
	return plants if plants else all(EditorInterface.get_edited_scene_root())


## True if the edited scene [param root] saves changes of [param plant].
static func is_saved_with(root: Node, plant: Node3D) -> bool:
	var owner := plant.owner
	return plant == root or owner == root or (owner and root.is_editable_instance(owner))


## True if changes of [param wind] are saved: with the edited scene [param root], or in a file of
## its own. A wind inside an instanced scene is not.
static func is_wind_saved(root: Node, wind: PlantWind) -> bool:
	if not wind.is_built_in() or wind.resource_path.is_empty():
		return true
	return wind.resource_path.get_slice("::", 0) == root.scene_file_path
