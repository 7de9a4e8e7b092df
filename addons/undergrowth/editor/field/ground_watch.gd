@tool
extends RefCounted
## Rebuilds fields on colliders when a step of the edited scene moved or removed their ground. A
## drag has an effect at its end only.
##
## The engine has no signal for moved colliders. After each step of undo this class compares the
## shapes of a scene with such a field.

const GroundShapes := preload("ground_shapes.gd")
const StepWatch := preload("step_watch.gd")

var _steps := StepWatch.new()
var _shapes := GroundShapes.new()
# Solids of the last comparison, and the id of its scene. 0: no scene.
var _seen: Dictionary[int, GroundShapes.Shape] = {}
var _scene_id := 0


## Compares the edited scene after each step of undo.
func setup(plugin: EditorPlugin) -> void:
	_steps.setup(plugin, func() -> void: pass, _check_once)


func close() -> void:
	_steps.close()
	_shapes.close()
	_forget()


func _check_once() -> bool:
	_check()
	return true


func _check() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var fields := _find_fields(root)
	if fields.is_empty():
		_forget()
		return
	var mask := 0
	for field in fields:
		mask |= field.ground_collision_mask
	var now := _shapes.survey(root, mask)
	var before := _seen if _scene_id == root.get_instance_id() else now
	var moved := _compare(before, now)
	_seen = now
	_scene_id = root.get_instance_id()
	for field in fields:
		if moved.any(_is_under.bind(field)):
			field.rebuild()


func _forget() -> void:
	_seen = {}
	_scene_id = 0


func _find_fields(root: Node) -> Array[PlantField3D]:
	var found: Array[PlantField3D] = []
	if not root:
		return found
	for node: Node in [root] + root.find_children("*", "PlantField3D", true, false):
		var field := node as PlantField3D
		if field and field.ground_mode == PlantField3D.GROUND_COLLIDERS:
			found.append(field)
	return found


# Returns the old and the new areas of changed solids.
func _compare(
	before: Dictionary[int, GroundShapes.Shape], now: Dictionary[int, GroundShapes.Shape]
) -> Array[GroundShapes.Shape]:
	var differing: Array[GroundShapes.Shape] = []
	for id in before:
		if not now.has(id) or now[id].state != before[id].state:
			differing.append(before[id])
	for id in now:
		if not before.has(id) or now[id].state != before[id].state:
			differing.append(now[id])
	return differing


# Seen from above, at any height.
func _is_under(shape: GroundShapes.Shape, field: PlantField3D) -> bool:
	var node := instance_from_id(shape.node_id) as Node
	if node and _pushes(node, field.bodies_group):
		return false
	var box := field.global_transform.affine_inverse() * shape.box
	var area := AABB()
	for point in field.get_outline_points():
		area = area.expand(point) if area else AABB(point, Vector3.ZERO)
	return _flat(area).intersects(_flat(box), true)


func _flat(box: AABB) -> Rect2:
	return Rect2(box.position.x, box.position.z, box.size.x, box.size.z)


# Bodies that push plants are not their ground.
func _pushes(node: Node, group: StringName) -> bool:
	var above := node
	while above and not group.is_empty():
		if above.is_in_group(group):
			return true
		above = above.get_parent()
	return false
