@tool
extends RefCounted
## Ground, sun and sky of the add-on for a scene that has none of them.

const Ground := preload("ground.gd")
const Ground3D := preload("../../grounds/ground_3d.gd")
const DAY := preload("../../environments/day.tscn")
const GROUNDS := "res://addons/undergrowth/grounds/"
const DEFAULT_GROUND := "meadow"
## The material by the file of a mix or a species. All others use the default.
const GROUND_OF: Dictionary[String, String] = {
	"barley": "field_soil",
	"cattail": "mud",
	"common_reed": "mud",
	"dead_leaves": "forest_floor",
	"fern_floor": "forest_floor",
	"field_horsetail": "forest_floor",
	"ivy_carpet": "forest_floor",
	"lawn": "lawn",
	"lawn_grass": "lawn",
	"male_fern": "forest_floor",
	"moss_cushion": "forest_floor",
	"reed_bed": "mud",
	"twigs": "forest_floor",
	"wheat": "field_soil",
	"wheat_field": "field_soil",
}
## Metres: it ends in the haze.
const SIDE := 2000.0
## Metres above and below the field in which a ground is searched.
const REACH := 1.0


## Returns new nodes for what the scene of [param root] lacks, for [param field] at [param point] of
## the world. [param file] is the file of its mix or species.
static func make(root: Node3D, field: PlantField3D, point: Vector3, file: String) -> Array[Node]:
	var made: Array[Node] = []
	if not has_ground(root.get_world_3d(), point):
		made.append(_make_ground(root, field, point, file))
	var day := DAY.instantiate()
	for node: Node in day.get_children():
		if not _has(root, node.get_class()):
			node.owner = null
			day.remove_child(node)
			made.append(node)
	day.free()
	return made


## Returns true if a mesh or a collider is at [param point].
static func has_ground(world: World3D, point: Vector3) -> bool:
	var hit := Ground.find_seen(world, point + Vector3.UP * REACH, Vector3.DOWN, Plane())
	return hit is Vector3 and (hit as Vector3).y > point.y - REACH


## Returns true if [param node] is a ground of [method make].
static func is_ground(node: Node) -> bool:
	return node.get_script() == Ground3D


static func _make_ground(
	root: Node3D, field: PlantField3D, point: Vector3, file: String
) -> MeshInstance3D:
	var plane := PlaneMesh.new()
	plane.size = Vector2(SIDE, SIDE)
	var ready := load(GROUNDS + _ground_of(file) + ".tres") as ShaderMaterial
	var material := ready.duplicate() as ShaderMaterial
	Ground3D.apply_color(material, field)
	plane.material = material
	var ground := MeshInstance3D.new()
	ground.name = "Ground"
	ground.mesh = plane
	ground.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	ground.set_script(Ground3D)
	ground.set(&"field", field)
	ground.position = root.to_local(point)
	return ground


static func _ground_of(file: String) -> String:
	return GROUND_OF.get(file.get_file().get_basename(), DEFAULT_GROUND)


static func _has(root: Node, kind: String) -> bool:
	return root.is_class(kind) or not root.find_children("*", kind, true, false).is_empty()
