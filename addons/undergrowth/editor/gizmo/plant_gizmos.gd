@tool
extends "node_gizmos.gd"
## The gizmo of Plant3D. A click on the plant's mesh selects it. A selected plant shows a handle for
## its height, its tip and bend, the joints of a stem with several, the direction of its wind, and
## the box that contains it in every bend.

const GizmoShapes := preload("gizmo_shapes.gd")

const HEIGHT_HANDLE := 0
const MIN_HEIGHT := 0.01
const MAX_HEIGHT := 1000.0
## Steps of the height in metres during a drag, and during a drag with Ctrl.
const STEP := 0.001
const SNAP_STEP := 0.1
## Minimum deflection, in radians, of a visible bend.
const MIN_BEND := 0.005


func _init() -> void:
	super()
	add_material("box", _line_material(Color(0.6, 0.8, 0.6, 0.2), false))
	add_material("bend", _line_material(Color(1.0, 0.8, 0.25, 0.9), true))
	add_material("wind", _line_material(Color(0.45, 0.75, 1.0, 0.9), true))
	create_handle_material("height")


func _get_gizmo_name() -> String:
	return "Plant3D"


func _has_gizmo(node: Node3D) -> bool:
	return node is Plant3D


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var plant := gizmo.get_node_3d() as Plant3D
	var mesh := plant.get_mesh() if plant and plant.species else null
	if not mesh:
		return
	gizmo.add_collision_triangles(mesh.generate_triangle_mesh())
	if not _is_selected(plant):
		return
	gizmo.add_lines(GizmoShapes.box(plant.get_reach()), get_material("box", gizmo))
	_draw_bend(gizmo, plant)
	_draw_joints(gizmo, plant)
	_draw_wind(gizmo, plant)
	var top := Vector3(0.0, plant.get_plant_height(), 0.0)
	var ids := PackedInt32Array([HEIGHT_HANDLE])
	gizmo.add_handles(PackedVector3Array([top]), get_material("height", gizmo), ids)


func _get_handle_name(_gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> String:
	return tr("Height")


func _get_handle_value(gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> Variant:
	var plant := gizmo.get_node_3d() as Plant3D
	return plant.height if plant else 0.0


func _set_handle(
	gizmo: EditorNode3DGizmo, _id: int, _secondary: bool, camera: Camera3D, point: Vector2
) -> void:
	var plant := gizmo.get_node_3d() as Plant3D
	if not plant:
		return
	var height := GizmoShapes.reach_along(plant, Vector3.UP, MAX_HEIGHT, camera, point)
	var step := SNAP_STEP if Input.is_key_pressed(KEY_CTRL) else STEP
	plant.height = clampf(snappedf(height, step), MIN_HEIGHT, MAX_HEIGHT)


func _commit_handle(
	gizmo: EditorNode3DGizmo, _id: int, _secondary: bool, restore: Variant, cancel: bool
) -> void:
	var plant := gizmo.get_node_3d() as Plant3D
	if not plant:
		return
	var height := plant.height
	plant.height = restore
	if cancel or is_equal_approx(height, restore):
		return
	_undo.create_action(tr("Change Plant Height"), UndoRedo.MERGE_DISABLE, plant)
	for other in _plants_to_change(plant):
		_undo.add_do_property(other, &"height", height)
		_undo.add_undo_property(other, &"height", other.height)
	_undo.commit_action()


# All selected plants if the dragged one is among them.
func _plants_to_change(dragged: Plant3D) -> Array[Plant3D]:
	var plants: Array[Plant3D] = []
	for node in EditorInterface.get_selection().get_selected_nodes():
		if node is Plant3D:
			plants.append(node)
	if not plants.has(dragged):
		plants.assign([dragged])
	return plants


func _draw_bend(gizmo: EditorNode3DGizmo, plant: Plant3D) -> void:
	if plant.get_deflection() < MIN_BEND:
		return
	var tip := plant.get_tip_position()
	var height := plant.get_plant_height()
	var lines := GizmoShapes.arc(Vector3.UP, tip.normalized(), height * 0.5)
	lines.append_array(GizmoShapes.cross(tip, height * 0.04))
	if plant.get_joint_count() == 1:
		lines.append_array(PackedVector3Array([Vector3.ZERO, tip]))
	gizmo.add_lines(lines, get_material("bend", gizmo))


# Also for a straight stem: the gizmo shows the positions of its bones.
func _draw_joints(gizmo: EditorNode3DGizmo, plant: Plant3D) -> void:
	if plant.get_joint_count() > 1:
		gizmo.add_lines(GizmoShapes.chain(joints_of(plant)), get_material("bend", gizmo))


func _draw_wind(gizmo: EditorNode3DGizmo, plant: Plant3D) -> void:
	var wind := _wind_on(plant)
	if not wind:
		return
	var axes := plant.global_basis.orthonormalized().transposed()
	var blowing := axes * _wind_direction(wind)
	var from := Vector3.UP * plant.get_plant_height() * 0.5
	var arrow := GizmoShapes.arrow(
		from, from + blowing * plant.get_plant_height() * 0.4, axes * Vector3.UP
	)
	gizmo.add_lines(arrow, get_material("wind", gizmo))


## Returns the vector from the root to the tip, in the plant's own axes.
static func joints_of(plant: Plant3D) -> PackedVector3Array:
	var joints := PackedVector3Array()
	for joint in plant.get_joint_count() + 1:
		joints.append(plant.get_joint_position(joint))
	return joints


# Returns the current wind of the plant, or null in still air.
static func _wind_on(plant: Plant3D) -> PlantWind:
	var wind := plant.wind
	return wind if wind and wind.strength > 0.0 else null


static func _wind_direction(wind: PlantWind) -> Vector3:
	return Vector3.BACK.rotated(Vector3.UP, wind.direction)


func _get_shown_values(node: Node3D) -> Array:
	var plant := node as Plant3D
	var wind := _wind_on(plant)
	return [plant.get_tip_position(), wind.direction if wind else INF, plant.global_basis]
