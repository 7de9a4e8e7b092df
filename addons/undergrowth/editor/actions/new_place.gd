@tool
extends RefCounted
## The place for a new plant or field in a 3D viewport, and the ground there. A field
## is laid on that ground.

const BrushGround := preload("../brush/brush_ground.gd")
const Ground := preload("ground.gd")

## World axes.
var point := Vector3.ZERO
## False if nothing was hit.
var has_ground := false

var _mesh: MeshInstance3D
var _collider: Object
var _terrain: Node
## Path below [member _terrain] of the object with the heights.
var _terrain_property := NodePath()


## Returns the place in the scene of [param root] at [param pixel], or at the centre of the view.
static func find(viewport: Viewport, root: Node, pixel := Vector2.INF) -> RefCounted:
	var camera := viewport.get_camera_3d()
	if not camera:
		return new()
	var at := pixel if pixel.is_finite() else viewport.get_visible_rect().size * 0.5
	var from := camera.project_ray_origin(at)
	return find_along(viewport.find_world_3d(), root, from, camera.project_ray_normal(at))


## Returns the same for a ray of [param world]. A terrain without colliders in the editor is ground
## if it has heights.
static func find_along(world: World3D, root: Node, from: Vector3, direction: Vector3) -> RefCounted:
	var found := new()
	var hit := Ground.find_hit(world, from, direction)
	found._take(hit)
	if not found._terrain and found._find_terrain(root):
		var met: Variant = BrushGround.find_on(found._terrain_object(), from, direction)
		if (
			met is Vector3
			and (hit.is_empty() or from.distance_to(met) < from.distance_to(hit.position))
		):
			found.point = met
			found.has_ground = true
			return found
		found._terrain = null
	found.point = hit.position if found.has_ground else Ground.on_plane(from, direction)
	return found


## Sets the ground mode of [param field], which is about to be added below [param parent]. A level
## plane needs none.
func lay(field: PlantField3D, parent: Node) -> void:
	if _terrain:
		field.ground_mode = PlantField3D.GROUND_OBJECT
		field.ground_object = NodePath(
			String(_path_from_child(parent, _terrain)) + String(_terrain_property)
		)
	elif _collider:
		field.ground_mode = PlantField3D.GROUND_COLLIDERS
		var layers: Variant = _collider.get(&"collision_layer")
		if layers is int and not layers & field.ground_collision_mask:
			field.ground_collision_mask = layers
	elif _mesh and not _is_level_plane():
		field.ground_mode = PlantField3D.GROUND_MESH
		field.ground_mesh = _path_from_child(parent, _mesh)


func _take(hit: Dictionary) -> void:
	has_ground = not hit.is_empty()
	_mesh = hit.get("node") as MeshInstance3D
	_collider = hit.get("collider")
	var node := (_collider if _collider else hit.get("node")) as Node
	while node and not _terrain:
		_take_terrain(node)
		node = node.get_parent()


## Returns true if the scene has a terrain.
func _find_terrain(root: Node) -> bool:
	for node in root.find_children("*", "Node3D", true, false):
		if _take_terrain(node):
			return true
	return false


## Returns true if [param node], or its property [code]data[/code], has heights.
func _take_terrain(node: Node) -> bool:
	for property: String in ["", ":data"]:
		var object: Object = node if property.is_empty() else node.get(&"data") as Object
		if _has_heights(object):
			_terrain = node
			_terrain_property = NodePath(property)
			return true
	return false


## Other methods of that name, such as that of a Plant3D, take no position.
static func _has_heights(object: Object) -> bool:
	return (
		object != null
		and object.has_method(&"get_height")
		and object.get_method_argument_count(&"get_height") == 1
	)


func _terrain_object() -> Object:
	return _terrain if _terrain_property.is_empty() else _terrain.get(&"data")


func _is_level_plane() -> bool:
	var plane := _mesh.mesh as PlaneMesh
	return (
		plane != null
		and plane.orientation == PlaneMesh.FACE_Y
		and _mesh.global_basis.y.normalized().is_equal_approx(Vector3.UP)
	)


static func _path_from_child(parent: Node, to: Node) -> NodePath:
	return ^".." if to == parent else NodePath("../" + String(parent.get_path_to(to)))
