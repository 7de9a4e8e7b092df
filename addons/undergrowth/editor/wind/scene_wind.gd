@tool
extends Node
## Moves the plants of the edited scene in the editor's viewport, each in its own wind, while the
## scene sways. The scene does not change: its plants only move, and return to rest at the end.

const EditorState := preload("../editor_state.gd")
const ScenePlants := preload("scene_plants.gd")
const WindClock := preload("wind_clock.gd")

var _state: EditorState
var _root: Node
var _plants: Array[Node3D] = []
# Ids of the plants that a wind moves.
var _moving: Dictionary[int, bool] = {}
var _is_outdated := false


func _ready() -> void:
	set_process(false)


func _exit_tree() -> void:
	_set_running(false)


## Moves the plants while [member EditorState.sways] of [param state] is true.
func setup(state: EditorState) -> void:
	_state = state
	_state.sway_changed.connect(_update)


func _update() -> void:
	_set_running(_state.sways)


func _set_running(on: bool) -> void:
	if on == is_processing():
		return
	set_process(on)
	var tree := get_tree()
	if on:
		tree.node_added.connect(_on_node_changed)
		tree.node_removed.connect(_on_node_changed)
		_collect()
	else:
		tree.node_added.disconnect(_on_node_changed)
		tree.node_removed.disconnect(_on_node_changed)
		_release()


func _process(delta: float) -> void:
	if _is_outdated or EditorInterface.get_edited_scene_root() != _root:
		_collect()
	for plant in _plants:
		var wind: PlantWind = plant.get(&"wind")
		if wind:
			_moving[plant.get_instance_id()] = true
			WindClock.advance(wind, delta)
			plant.call(&"_preview", delta, wind)
		elif _moving.erase(plant.get_instance_id()):
			plant.call(&"reset_motion")


func _collect() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var found := ScenePlants.all(root)
	var stays: Dictionary[Node3D, bool] = {}
	for plant in found:
		stays[plant] = true
	for plant: Variant in _plants:
		if is_instance_valid(plant) and not stays.has(plant):
			(plant as Node3D).call(&"reset_motion")
			_moving.erase((plant as Node3D).get_instance_id())
	_root = root
	_plants = found
	_is_outdated = false


func _release() -> void:
	for plant: Variant in _plants:
		if is_instance_valid(plant):
			(plant as Node3D).call(&"reset_motion")
	_plants.clear()
	_moving.clear()
	_root = null


func _on_node_changed(node: Node) -> void:
	if ScenePlants.is_plant(node):
		_is_outdated = true
