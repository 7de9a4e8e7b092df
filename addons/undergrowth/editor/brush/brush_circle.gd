@tool
extends RefCounted
## The circle of the brush on the ground. It belongs to no scene.

const BrushGround := preload("brush_ground.gd")

## Points of the outer circle. Each needs one ray.
const POINTS := 24
## Range of the ground search above and below the field's plane, in radii, and its minimum in
## metres.
const REACH := 1.0
const MIN_REACH := 2.0
const LIFT := 0.03
## As a fraction of the radius.
const BREADTH := 0.06
const COLORS: Array[Color] = [
	Color.WHITE,
	Color(0.55, 1.0, 0.4),
	Color(1.0, 0.45, 0.35),
	Color(0.5, 0.75, 1.0),
	Color(0.85, 0.6, 1.0),
	Color.WHITE,
	Color(1.0, 0.85, 0.4),
	Color(1.0, 0.85, 0.4)
]

var _mesh := ImmediateMesh.new()
var _material := StandardMaterial3D.new()
var _instance := RenderingServer.instance_create()


func _init() -> void:
	_material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	_material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	_material.no_depth_test = true
	_material.cull_mode = BaseMaterial3D.CULL_DISABLED
	_material.render_priority = Material.RENDER_PRIORITY_MAX
	_material.disable_fog = true
	RenderingServer.instance_set_base(_instance, _mesh.get_rid())
	RenderingServer.instance_geometry_set_cast_shadows_setting(
		_instance, RenderingServer.SHADOW_CASTING_SETTING_OFF
	)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		RenderingServer.free_rid(_instance)


func hide() -> void:
	RenderingServer.instance_set_visible(_instance, false)


## Draws the circle around [param middle] on the ground of [param field], in the colour of
## [param tool]. The outer circle is the radius, the inner one is the start of the falloff.
func show_at(
	field: PlantField3D, middle: Vector3, radius: float, falloff: float, tool: int
) -> void:
	RenderingServer.instance_set_scenario(_instance, field.get_world_3d().scenario)
	RenderingServer.instance_set_visible(_instance, true)
	_material.albedo_color = COLORS[tool]
	_mesh.clear_surfaces()
	var places := _find_places(field, middle, radius)
	_add_ring(places, middle, 1.0, BREADTH)
	var inner := 1.0 - falloff
	if inner > 0.05 and falloff > 0.02:
		_add_ring(places, middle, inner, 0.5 * BREADTH)


# Points of the outer circle on the ground.
static func _find_places(field: PlantField3D, middle: Vector3, radius: float) -> PackedVector3Array:
	var reach := maxf(radius * REACH, MIN_REACH)
	var tops := PackedVector3Array()
	for i in POINTS:
		var out := Vector3.RIGHT.rotated(Vector3.UP, TAU * i / POINTS) * radius
		tops.append(middle + out + Vector3.UP * reach)
	var places := BrushGround.find_below(field, tops, 2.0 * reach)
	for i in POINTS:
		if not places[i].is_finite() or places[i].y < middle.y - reach:  # Beyond an edge.
			places[i] = Vector3(tops[i].x, middle.y, tops[i].z)
	return places


# Draws a circle at [param part] of the way from the middle to [param places], with that share of
# [param breadth]. Inner circles need no rays.
func _add_ring(places: PackedVector3Array, middle: Vector3, part: float, breadth: float) -> void:
	_mesh.surface_begin(Mesh.PRIMITIVE_TRIANGLE_STRIP, _material)
	for i in POINTS + 1:
		var out := places[i % POINTS] - middle
		var place := middle + out * part + Vector3.UP * LIFT
		out.y = 0.0
		_mesh.surface_add_vertex(place)
		_mesh.surface_add_vertex(place - out * breadth)
	_mesh.surface_end()
