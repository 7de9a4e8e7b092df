@tool
extends "node_gizmos.gd"
## The gizmo of PlantField3D. A click into its area selects it. Its border is always visible. While
## selected, it also shows the box of its plants, its exclusions, roads in their width, and a handle
## on each side of a rectangle, except while a tool of the brush is on. Lines and handles lie on the
## ground of the field.

const BrushOptions := preload("../brush/brush_options.gd")
const DrapedBorder := preload("draped_border.gd")
const GizmoShapes := preload("gizmo_shapes.gd")

const MIN_SIZE := 0.1
## Maximum distance of a handle, in metres.
const FARTHEST := 4096.0
## Steps of the size in metres during a drag, and during a drag with Ctrl.
const STEP := 0.01
const SNAP_STEP := 0.5
## Height of the box in metres for a field without a height of its own.
const MIN_BOX := 0.5
## Clickable margin around the border, as a fraction of its longer side.
const ROOM := 0.02
## Outward direction of each side of the rectangle, by the ids of the handles.
const SIDES: Array[Vector3] = [Vector3.RIGHT, Vector3.LEFT, Vector3.BACK, Vector3.FORWARD]

## Options of the brush.
var brush_options: BrushOptions

# Values before the current drag.
var _size_before := Vector2.ZERO
var _position_before := Vector3.ZERO
# Of the dragged handle above the field's plane, in metres.
var _handle_height := 0.0
var _draped := DrapedBorder.new()


func _init() -> void:
	super()
	add_material("border", _line_material(Color(0.45, 0.85, 0.4, 0.5), false))
	add_material("chosen", _line_material(Color(0.55, 1.0, 0.45, 1.0), true))
	add_material("free", _line_material(Color(0.9, 0.6, 0.3, 0.8), true))
	add_material("box", _line_material(Color(0.6, 0.8, 0.6, 0.2), false))
	create_handle_material("side")


## Releases the editor's objects. Call it before the plugin is removed.
func close() -> void:
	super()
	for id in _made:
		var field := instance_from_id(id) as PlantField3D
		if field and field.build_finished.is_connected(_on_built.bind(id)):
			field.build_finished.disconnect(_on_built.bind(id))


func _get_gizmo_name() -> String:
	return "PlantField3D"


func _has_gizmo(node: Node3D) -> bool:
	return node is PlantField3D


func _redraw(gizmo: EditorNode3DGizmo) -> void:
	gizmo.clear()
	var field := gizmo.get_node_3d() as PlantField3D
	var corners := field.get_outline_points() if field else PackedVector3Array()
	if corners.size() < 3:
		return
	_follow_builds(field)
	var line := _draped.drape_loop(field, corners)
	var border := GizmoShapes.loop(line)
	gizmo.add_collision_segments(border)
	gizmo.add_collision_segments(_room_around(line))
	_add_area(gizmo, line)
	var is_selected := _is_selected(field)
	gizmo.add_lines(border, get_material("chosen" if is_selected else "border", gizmo))
	if is_selected or _is_path_selected(field):
		_add_free_places(gizmo, field)
	if not is_selected:
		return
	gizmo.add_lines(GizmoShapes.box(_box_of(field, corners)), get_material("box", gizmo))
	if _has_handles(field):
		_add_handles(gizmo, field)


func _get_handle_name(_gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> String:
	return tr("Size")


## Returns the text that the 3D view shows during a drag.
func _get_handle_value(gizmo: EditorNode3DGizmo, _id: int, _secondary: bool) -> Variant:
	var field := gizmo.get_node_3d() as PlantField3D
	if not field:
		return ""
	return "%s × %s m" % [String.num(field.size.x, 2), String.num(field.size.y, 2)]


func _begin_handle_action(gizmo: EditorNode3DGizmo, id: int, _secondary: bool) -> void:
	var field := gizmo.get_node_3d() as PlantField3D
	if field:
		_handle_height = _find_handles(field)[id].y
		_size_before = field.size
		_position_before = field.position


## Sets the size and the position of the field. The opposite side stays in place.
func _set_handle(
	gizmo: EditorNode3DGizmo, id: int, _secondary: bool, camera: Camera3D, point: Vector2
) -> void:
	var field := gizmo.get_node_3d() as PlantField3D
	if not field:
		return
	var side := SIDES[id]
	var axis := 0 if side.x else 1
	var half := field.size[axis] * 0.5
	var from := Vector3.UP * _handle_height
	var reach := GizmoShapes.reach_along(field, side, FARTHEST, camera, point, from)
	var step := SNAP_STEP if Input.is_key_pressed(KEY_CTRL) else STEP
	var is_both := Input.is_key_pressed(KEY_ALT)
	var length := snappedf(reach * 2.0 if is_both else reach + half, step)
	var size := field.size
	size[axis] = maxf(length, MIN_SIZE)
	if not is_both:
		field.translate_object_local(side * (size[axis] * 0.5 - half))
	field.size = size


func _commit_handle(
	gizmo: EditorNode3DGizmo, _id: int, _secondary: bool, _restore: Variant, cancel: bool
) -> void:
	var field := gizmo.get_node_3d() as PlantField3D
	if not field or (field.size == _size_before and field.position == _position_before):
		return
	var size := field.size
	var position := field.position
	field.size = _size_before
	field.position = _position_before
	if cancel:
		return
	_undo.create_action(tr("Change Field Size"), UndoRedo.MERGE_DISABLE, field)
	_undo.add_do_property(field, &"size", size)
	_undo.add_do_property(field, &"position", position)
	_undo.add_undo_property(field, &"size", _size_before)
	_undo.add_undo_property(field, &"position", _position_before)
	_undo.commit_action()


# The editor tests a gizmo only if the ray hits the box of its clickable shapes. Without a margin,
# half of the clicks on the border would miss.
static func _room_around(corners: PackedVector3Array) -> PackedVector3Array:
	var box := AABB(corners[0], Vector3.ZERO)
	for corner in corners:
		box = box.expand(corner)
	box = box.grow(box.get_longest_axis_size() * ROOM)
	return [box.position, box.position, box.end, box.end]


func _add_area(gizmo: EditorNode3DGizmo, corners: PackedVector3Array) -> void:
	var flat := PackedVector2Array()
	for corner in corners:
		flat.append(Vector2(corner.x, corner.z))
	var faces := PackedVector3Array()
	for i in Geometry2D.triangulate_polygon(flat):
		faces.append(corners[i])
	var triangles := TriangleMesh.new()
	if faces and triangles.create_from_faces(faces):
		gizmo.add_collision_triangles(triangles)


func _add_free_places(gizmo: EditorNode3DGizmo, field: PlantField3D) -> void:
	for i in field.exclusions.size():
		var free := field.get_exclusion_points(i)
		if free.size() > 2:
			var line := _draped.drape_loop(field, free)
			gizmo.add_lines(GizmoShapes.loop(line), get_material("free", gizmo))


# Handles would move the plants of a painted field, and lie below the pointer of the brush.
func _has_handles(field: PlantField3D) -> bool:
	var is_brush_on := brush_options and brush_options.tool != BrushOptions.Tool.NONE
	return field.outline.is_empty() and not field.map and not is_brush_on


func _add_handles(gizmo: EditorNode3DGizmo, field: PlantField3D) -> void:
	var ids := PackedInt32Array(range(SIDES.size()))
	gizmo.add_handles(_find_handles(field), get_material("side", gizmo), ids)


func _find_handles(field: PlantField3D) -> PackedVector3Array:
	var places := PackedVector3Array()
	for side in SIDES:
		places.append(side * Vector3(field.size.x, 0.0, field.size.y) * 0.5)
	return _draped.drape(field, places)


# New plants can be on changed ground.
func _follow_builds(field: PlantField3D) -> void:
	var listener := _on_built.bind(field.get_instance_id())
	if not field.build_finished.is_connected(listener):
		field.build_finished.connect(listener)


func _on_built(id: int) -> void:
	_draped.forget(id)
	var field := instance_from_id(id) as PlantField3D
	if field:
		field.update_gizmos()


# At the height of the plants above the border, if the field has one.
static func _box_of(field: PlantField3D, corners: PackedVector3Array) -> AABB:
	var box := AABB(corners[0], Vector3.ZERO)
	for corner in corners:
		box = box.expand(corner)
	var seen := field.get_aabb()
	if seen.has_surface():
		return box.merge(seen)
	return box.expand(box.position + Vector3.UP * MIN_BOX)


# True if its outline or one of its exclusions is selected.
func _is_path_selected(field: PlantField3D) -> bool:
	var paths: Array[NodePath] = field.exclusions.duplicate()
	paths.append(field.outline)
	for path in paths:
		var node := field.get_node_or_null(path) as Node3D if path else null
		if node and _is_selected(node):
			return true
	return false


# Also fields whose paths are selected.
func _worked_on() -> Array[Node3D]:
	var fields: Array[Node3D] = []
	for id in _made:
		var field := instance_from_id(id) as PlantField3D
		if _is_selected(field) or _is_path_selected(field):
			fields.append(field)
	return fields


# A field updates its gizmo after a change of its own size. These values change without an update:
# the position of its outline, and the box of its plants.
func _get_shown_values(node: Node3D) -> Array:
	var field := node as PlantField3D
	var values := [field.get_outline_points(), field.get_aabb(), _has_handles(field)]
	if DrapedBorder.is_needed(field):
		values.append(field.global_transform)
	for i in field.exclusions.size():
		values.append(field.get_exclusion_points(i))
	return values
