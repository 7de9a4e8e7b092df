@tool
extends RefCounted
## Possible ground of fields in a scene: the shapes of its bodies, and the solids of its CSG nodes.

## Practically infinite, in metres.
const ENDLESS := 1.0e6


## One of them, at the time of the collection.
class Shape:
	extends RefCounted
	## Position and parameters. A different state means a different ground.
	var state: Array = []
	## In world axes.
	var box: AABB
	## The body or the CSG node.
	var node_id := 0


# Box of each shape in its own axes, by its id. Valid until the shape reports a change.
var _boxes: Dictionary[int, AABB] = {}
# Number of reported changes of each shape.
var _changes: Dictionary[int, int] = {}


## Returns all solids below [param root] on one of the physics layers of [param mask], by the ids of
## their nodes.
func survey(root: Node, mask: int) -> Dictionary[int, Shape]:
	var found: Dictionary[int, Shape] = {}
	for node: CollisionShape3D in root.find_children("*", "CollisionShape3D", true, false):
		var body := node.get_parent() as PhysicsBody3D
		if body and body.collision_layer & mask and node.shape and not node.disabled:
			found[node.get_instance_id()] = _of_shape(node, body)
	for node: CSGShape3D in root.find_children("*", "CSGShape3D", true, false):
		var what := [node.operation, node.use_collision, node.collision_layer]
		found[node.get_instance_id()] = _make(node, node, node.get_aabb(), what)
	return found


## Releases the shapes.
func close() -> void:
	for id in _changes:
		var shape := instance_from_id(id) as Shape3D
		if shape:
			shape.changed.disconnect(_on_shape_changed)
	_changes.clear()
	_boxes.clear()


func _of_shape(node: CollisionShape3D, body: PhysicsBody3D) -> Shape:
	var id := node.shape.get_instance_id()
	if not _changes.has(id):
		_changes[id] = 0
		node.shape.changed.connect(_on_shape_changed.bind(id))
	if not _boxes.has(id):
		_boxes[id] = _find_box(node.shape)
	return _make(node, body, _boxes[id], [id, _changes[id], body.collision_layer])


func _find_box(shape: Shape3D) -> AABB:
	if shape is WorldBoundaryShape3D:
		return AABB(Vector3.ONE * -ENDLESS, Vector3.ONE * 2.0 * ENDLESS)
	return shape.get_debug_mesh().get_aabb()


func _make(node: Node3D, body: Node3D, box: AABB, what: Array) -> Shape:
	var place := node.global_transform
	var shape := Shape.new()
	shape.box = place * box
	shape.state = [place, box, what]
	shape.node_id = body.get_instance_id()
	return shape


func _on_shape_changed(id: int) -> void:
	_changes[id] += 1
	_boxes.erase(id)
