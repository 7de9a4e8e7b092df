@tool
extends RefCounted
## The circle of the brush on the ground. It belongs to no scene.

const BrushGround := preload("brush_ground.gd")

const POINTS := 40
## Over and under the field's plane ground is looked for, in radii and at least in metres.
const REACH := 1.0
const LEAST_REACH := 2.0
const LIFT := 0.03
## As a part of the radius.
const BREADTH := 0.06
const COLORS: Array[Color] = [
	Color.WHITE, Color(0.55, 1.0, 0.4), Color(1.0, 0.45, 0.35), Color(0.5, 0.75, 1.0), Color.WHITE
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


## Lies around [param middle] on the ground of [param field], in the colour of [param tool]: the
## outer circle is the radius, the inner one where the falloff begins.
func show_at(
	field: PlantField3D, middle: Vector3, radius: float, falloff: float, tool: int
) -> void:
	RenderingServer.instance_set_scenario(_instance, field.get_world_3d().scenario)
	RenderingServer.instance_set_visible(_instance, true)
	_material.albedo_color = COLORS[tool]
	_mesh.clear_surfaces()
	_add_ring(field, middle, radius, BREADTH * radius)
	var inner := radius * (1.0 - falloff)
	if inner > 0.05 * radius and falloff > 0.02:
		_add_ring(field, middle, inner, 0.5 * BREADTH * radius)


func _add_ring(field: PlantField3D, middle: Vector3, radius: float, breadth: float) -> void:
	var reach := maxf(radius * REACH, LEAST_REACH)
	var plane := Plane(Vector3.UP, middle.y)
	_mesh.surface_begin(Mesh.PRIMITIVE_TRIANGLE_STRIP, _material)
	for i in POINTS + 1:
		var out := Vector3.RIGHT.rotated(Vector3.UP, TAU * i / POINTS) * radius
		var above := middle + out + Vector3.UP * reach
		var met: Variant = BrushGround.find(field, above, Vector3.DOWN, plane)
		var place: Vector3 = met if met is Vector3 else middle + out
		if place.y < middle.y - reach:
			place.y = middle.y  # Over an edge.
		_mesh.surface_add_vertex(place + Vector3.UP * LIFT)
		_mesh.surface_add_vertex(place + Vector3.UP * LIFT - out * (breadth / radius))
	_mesh.surface_end()
