@tool
extends PanelContainer
## The chosen species as a plant that stands in the wind of the dock.

const EditorState := preload("../editor_state.gd")
const OrbitCamera := preload("orbit_camera.gd")
const PreviewOverlay := preload("preview_overlay.gd")
## Gap between the four levels, in shares of the plant's height.
const LEVEL_GAP := 0.45
const GROUND_RADIUS := 1.6
const LONGEST_FRAME := 0.1
const RING_COLOR := Color(1.0, 1.0, 1.0, 0.55)
const BONE_COLOR := Color(1.0, 0.72, 0.2)

var _state: EditorState
var _plants: Array[Plant3D] = []
var _overlays: Array[MeshInstance3D] = []
var _refresh_is_queued := false

@onready var _view: SubViewportContainer = %View
@onready var _camera: OrbitCamera = %Camera
@onready var _ground: MeshInstance3D = %Ground
@onready var _plant_root: Node3D = %Plants
@onready var _counts: Label = %Counts
@onready var _hint: Label = %Hint
@onready var _level_labels: Control = %LevelLabels
@onready var _play: Button = %Play
@onready var _rings: Button = %Rings
@onready var _bones: Button = %Bones
@onready var _levels: Button = %Levels
@onready var _reset: Button = %Reset


func _ready() -> void:
	set_process(false)


## Shows the species of [param state].
func setup(state: EditorState) -> void:
	_state = state
	for i in EditorState.LEVELS.size():
		_add_plant()
	_state.function_chosen.connect(_on_function_chosen)
	_state.function_edited.connect(_queue_refresh)
	_state.view_changed.connect(_queue_refresh)
	_state.wind_changed.connect(_take_wind)
	for toggle: Button in [_rings, _bones, _levels]:
		toggle.toggled.connect(func(_on: bool) -> void: _refresh())
	_reset.pressed.connect(_camera.restart)
	_view.gui_input.connect(_on_view_input)
	_view.resized.connect(_queue_refresh)
	_dress()
	_take_wind()
	_on_function_chosen()
	set_process(true)


func _process(delta: float) -> void:
	if not is_visible_in_tree() or not _play.button_pressed or not _shows_plant():
		return
	for plant in _plants:
		plant.step(minf(delta, LONGEST_FRAME))


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_dress()


func _dress() -> void:
	_play.icon = get_theme_icon(&"Play", &"EditorIcons")
	_rings.icon = get_theme_icon(&"CylinderMesh", &"EditorIcons")
	_bones.icon = get_theme_icon(&"Bone", &"EditorIcons")
	_levels.icon = get_theme_icon(&"FileThumbnail", &"EditorIcons")
	_reset.icon = get_theme_icon(&"CenterView", &"EditorIcons")


func _add_plant() -> void:
	var plant := Plant3D.new()
	plant.simulating = false
	plant.visible = _plants.is_empty()
	_plant_root.add_child(plant)
	_plants.append(plant)


func _shows_plant() -> bool:
	return _state.function != null and _plants[0].get_mesh() != null


func _take_wind() -> void:
	for plant in _plants:
		plant.wind = _state.wind


func _on_function_chosen() -> void:
	for plant in _plants:
		plant.function = _state.function if _state.problem.is_empty() else null
	_queue_refresh()


func _queue_refresh() -> void:
	if not _refresh_is_queued:
		_refresh_is_queued = true
		_refresh.call_deferred()


func _refresh() -> void:
	_refresh_is_queued = false
	if not _state.function or not _state.problem.is_empty():
		_show_nothing()
		return
	_hint.visible = false
	for i in _plants.size():
		_show_plant(i)
	_frame()
	_show_counts()
	_show_overlays()


func _show_nothing() -> void:
	var plant_stands := _state.function and _plants[0].function == _state.function
	_plant_root.visible = plant_stands and _plants[0].get_mesh() != null
	_hint.visible = not _plant_root.visible
	_hint.text = tr("Choose a species above.") if not _state.function else _state.problem
	_counts.text = ""


func _show_plant(index: int) -> void:
	var plant := _plants[index]
	var all := _levels.button_pressed
	_plant_root.visible = true
	plant.visible = all or index == 0
	plant.function = _state.function
	plant.height = _state.height
	plant.seed = _state.seed_value
	plant.lod = EditorState.LEVELS[index] if all else _state.lod
	plant.rebuild()


func _frame() -> void:
	var height := _plants[0].get_plant_height()
	var breadth := _plants[0].get_mesh().get_aabb().size.x
	var count := _plants.size() if _levels.button_pressed else 1
	var gap := maxf(height * LEVEL_GAP, breadth * 1.2)
	for i in _plants.size():
		_plants[i].position.x = (i - (count - 1) * 0.5) * gap if count > 1 else 0.0
	var width := (count - 1) * gap + maxf(breadth, height * 0.3)
	_ground.scale = Vector3.ONE * maxf(height * 0.5, width * 0.5) * GROUND_RADIUS
	_camera.frame(Vector3.UP * height * 0.5, Vector2(width, height))


func _show_counts() -> void:
	var triangles := 0
	var vertices := 0
	for plant in _plants:
		if plant.visible:
			var mesh := plant.get_mesh()
			triangles += mesh.surface_get_array_index_len(0) / 3
			vertices += mesh.surface_get_array_len(0)
	_counts.text = (
		tr("%s m · %d triangles · %d vertices")
		% [String.num(_plants[0].get_plant_height(), 2), triangles, vertices]
	)


func _show_overlays() -> void:
	for overlay in _overlays:
		overlay.queue_free()
	_overlays.clear()
	for plant in _plants:
		if plant.visible and _rings.button_pressed:
			var height := plant.get_plant_height()
			var rings := PreviewOverlay.make_rings(_state.function, height, plant.lod)
			_add_overlay(plant, rings, RING_COLOR)
		if plant.visible and _bones.button_pressed:
			_add_overlay(plant, PreviewOverlay.make_bone(plant.get_plant_height()), BONE_COLOR)


func _add_overlay(plant: Plant3D, lines: ArrayMesh, color: Color) -> void:
	var overlay := MeshInstance3D.new()
	overlay.mesh = lines
	overlay.material_override = PreviewOverlay.make_material(color)
	overlay.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	overlay.custom_aabb = plant.get_reach()
	var skeleton := plant.get_skeleton()
	var drawn := skeleton.get_child(0, true) as MeshInstance3D
	overlay.skin = drawn.skin
	skeleton.add_child(overlay)
	overlay.skeleton = overlay.get_path_to(skeleton)
	_overlays.append(overlay)


func _on_view_input(event: InputEvent) -> void:
	if _camera.handle(event, EditorInterface.get_editor_scale()):
		_view.accept_event()
