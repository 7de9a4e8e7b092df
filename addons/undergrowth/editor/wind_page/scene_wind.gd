@tool
extends Node
## Applies the dock's wind to all plants of the edited scene in the editor's viewport. The scene
## does not change: its plants only move, and return to rest at the end.

const EditorState := preload("../editor_state.gd")
const ScenePlants := preload("scene_plants.gd")
const WindClock := preload("wind_clock.gd")

## The current wind of the edited scene in place of its plants' own, or null.
static var blowing: PlantWind

var _state: EditorState
var _root: Node
var _plants: Array[Node3D] = []
var _is_outdated := false


func _ready() -> void:
	set_process(false)


func _exit_tree() -> void:
	set_active(false)


func setup(state: EditorState) -> void:
	_state = state


func is_active() -> bool:
	return is_processing()


## Starts or ends it. At the end the plants return to rest.
func set_active(on: bool) -> void:
	if on == is_active():
		return
	set_process(on)
	var tree := get_tree()
	if on:
		tree.node_added.connect(_on_node_changed)
		tree.node_removed.connect(_on_node_changed)
		_collect()
		_report()
	else:
		tree.node_added.disconnect(_on_node_changed)
		tree.node_removed.disconnect(_on_node_changed)
		_release()


func _process(delta: float) -> void:
	if _is_outdated or EditorInterface.get_edited_scene_root() != _root:
		_collect()
	blowing = _state.wind
	if not blowing:
		return
	WindClock.advance(blowing, delta)
	for plant in _plants:
		plant.call(&"_preview", delta, blowing)


func _collect() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var found := ScenePlants.all(root)
	var stays: Dictionary[Node3D, bool] = {}
	for plant in found:
		stays[plant] = true
	for plant: Variant in _plants:
		if is_instance_valid(plant) and not stays.has(plant):
			(plant as Node3D).call(&"reset_motion")
	_root = root
	_plants = found
	_is_outdated = false


func _release() -> void:
	blowing = null
	for plant: Variant in _plants:
		if is_instance_valid(plant):
			(plant as Node3D).call(&"reset_motion")
	_plants.clear()
	_root = null


func _report() -> void:
	if _plants.is_empty():
		_state.report(
			tr("The edited scene has no plants yet. Add one on the Plant page to see it move."),
			EditorState.Severity.WARNING
		)


func _on_node_changed(node: Node) -> void:
	if ScenePlants.is_plant(node):
		_is_outdated = true
