@tool
extends RefCounted
## Sets a configuration warning on fields without a ground mode whose plane is not on the ground.
##
## After each step of undo it searches the ground at the centre and at the outline's corners of one
## field per frame.

const Ground := preload("../actions/ground.gd")
const FieldPlacing := preload("field_placing.gd")
const ScenePlants := preload("../wind/scene_plants.gd")
const StepWatch := preload("step_watch.gd")
const Translations := preload("../translations/translations.gd")
## Metres between plane and ground without a warning.
const TOLERANCE := 0.2
## Maximum number of tested corners. Outlines of paths have many.
const MAX_CORNERS := 8
## Frames until new colliders are found by rays.
const PATIENCE := 2

var _steps := StepWatch.new()
# Ids of the fields to check.
var _waiting: Array[int] = []
# Ids of the fields with a warning.
var _advised: Dictionary[int, bool] = {}
var _frames_left := 0


## Checks the fields of the edited scene after each step of undo.
func setup(plugin: EditorPlugin) -> void:
	_steps.setup(plugin, _begin, _check_next)


## Removes all warnings.
func close() -> void:
	_steps.close()
	for id in _advised:
		var field := instance_from_id(id) as PlantField3D
		if field:
			field.call(&"_advise", "")


## Returns the maximum distance in metres between the plane of [param field] and the ground at its
## centre and corners. 0: no ground is there.
static func find_gap(root: Node, field: PlantField3D) -> float:
	if not FieldPlacing.find(root, field):
		return 0.0
	var gap := 0.0
	for point in _find_points(field):
		var met := _find_height(field.get_world_3d(), point)
		if is_finite(met):
			gap = maxf(gap, absf(met - point.y))
	return gap


func _begin() -> void:
	_frames_left = PATIENCE
	_waiting.clear()
	for plant in ScenePlants.all(EditorInterface.get_edited_scene_root()):
		if plant is PlantField3D:
			_waiting.append(plant.get_instance_id())


# Returns true after the last field.
func _check_next() -> bool:
	_frames_left -= 1
	if _frames_left > 0 and _waiting:
		return false
	var field: PlantField3D = null
	while _waiting and not field:
		field = instance_from_id(_waiting.pop_back()) as PlantField3D
	if field and field.is_inside_tree():
		_check(field)
	return _waiting.is_empty()


func _check(field: PlantField3D) -> void:
	var root := EditorInterface.get_edited_scene_root()
	var gap := 0.0
	var is_flat := field.ground_mode == PlantField3D.GROUND_NONE
	if root and is_flat and not FieldPlacing.is_kept_flat(field):
		gap = find_gap(root, field) if ScenePlants.is_saved_with(root, field) else 0.0
	var id := field.get_instance_id()
	if gap > TOLERANCE:
		_advised[id] = true
		var text := (
			Translations
			. text(
				"This flat field is up to %s m off the ground. Press Place on Ground or Keep Flat above."
			)
		)
		field.call(&"_advise", text % String.num(gap, 1))
	elif _advised.erase(id):
		field.call(&"_advise", "")


# World axes.
static func _find_points(field: PlantField3D) -> PackedVector3Array:
	var corners := field.get_outline_points()
	var points := PackedVector3Array([field.global_position])
	var step := maxi(1, ceili(corners.size() / float(MAX_CORNERS)))
	for i in range(0, corners.size(), step):
		points.append(field.to_global(corners[i]))
	return points


# Of the ground below [param point], or above it. INF: none.
static func _find_height(world: World3D, point: Vector3) -> float:
	for start in FieldPlacing.STARTS:
		var hit := Ground.find_hit(world, point + Vector3.UP * start, Vector3.DOWN)
		if not hit.is_empty():
			return hit["position"].y
	return INF
