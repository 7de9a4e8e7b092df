@tool
extends PanelContainer
## The chosen species as a plant in the wind of the dock, or a piece of the chosen mix.

const EditorState := preload("../editor_state.gd")
const OrbitCamera := preload("orbit_camera.gd")
const PlantGroup := preload("../widgets/plant_group.gd")
const PreviewOverlay := preload("preview_overlay.gd")
const Traits := preload("species_traits.gd")
const WindClock := preload("../wind_page/wind_clock.gd")
## Gap between the four levels, as a fraction of the plant's height.
const LEVEL_GAP := 0.45
## Number of plants side by side that differ by seed.
const SEEDS := 4
const GROUND_RADIUS := 1.6
const LONGEST_FRAME := 0.1
const LABEL_NAME := "Level"
const LABEL_PIXEL := 0.0022
const LABEL_HEIGHT := 1.08
const BACKDROP_OPACITY := 0.8
## Factor of the editor's font size, so that all counts fit in one line of a narrow dock.
const SMALL_FONT := 0.85
## Start of a plant, as a fraction of the view's width.
const MIDDLE := 0.45
## Minimum height of a view with counts, in pixels at 100 %.
const MIN_HEIGHT_FOR_COUNTS := 120.0
## Margin for swaying, as a fraction of the height.
const SWAY_ROOM := 0.5
## Approximate number of plants in a piece of a mix, and its limits in metres.
const PIECE_PLANTS := 120.0
const MIN_PIECE := 0.4
const MAX_PIECE := 2.5
## As a fraction of the piece's side, seen from a corner and from slightly above.
const PIECE_BREADTH := 1.25
const RING_COLOR := Color(1.0, 1.0, 1.0, 0.55)
const BONE_COLOR := Color(1.0, 0.72, 0.2)

var _state: EditorState
var _plants: Array[Plant3D] = []
var _overlays: Array[MeshInstance3D] = []
# The piece of a mix, or null.
var _piece: PlantField3D
var _refresh_is_queued := false

@onready var _view: SubViewportContainer = %View
@onready var _camera: OrbitCamera = %Camera
@onready var _ground: MeshInstance3D = %Ground
@onready var _plant_root: Node3D = %Plants
@onready var _tools: PanelContainer = %Tools
@onready var _counts_panel: PanelContainer = %CountsPanel
@onready var _counts: Label = %Counts
@onready var _hint_panel: PanelContainer = %HintPanel
@onready var _hint: Label = %Hint
@onready var _play: Button = %Play
@onready var _rings: Button = %Rings
@onready var _bones: Button = %Bones
@onready var _levels: Button = %Levels
@onready var _seeds: Button = %Seeds
@onready var _reset: Button = %Reset


func _ready() -> void:
	set_process(false)


## Shows the species of [param state].
func setup(state: EditorState) -> void:
	_state = state
	_state.function_chosen.connect(_on_function_chosen)
	_state.function_edited.connect(_queue_refresh)
	_state.view_changed.connect(_queue_refresh)
	for toggle: Button in [_rings, _bones]:
		toggle.toggled.connect(func(_on: bool) -> void: _refresh())
	_levels.toggled.connect(_on_row_toggled.bind(_seeds))
	_seeds.toggled.connect(_on_row_toggled.bind(_levels))
	_reset.pressed.connect(_camera.restart)
	_view.gui_input.connect(_on_view_input)
	for part: Control in [_view, _tools, _counts_panel]:
		part.resized.connect(_make_room)
	_apply_theme()
	_on_function_chosen()
	set_process(true)


func _process(delta: float) -> void:
	if not is_visible_in_tree() or not _play.button_pressed:
		return
	if not _state.function and not _piece:
		return
	WindClock.advance(_state.wind, delta)
	for plant in _plants:
		plant._preview(minf(delta, LONGEST_FRAME), _state.wind)
	if _piece:
		_piece._preview(minf(delta, LONGEST_FRAME), _state.wind)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _state:
		_apply_theme()


func _apply_theme() -> void:
	_play.icon = get_theme_icon(&"Play", &"EditorIcons")
	_rings.icon = get_theme_icon(&"Grid", &"EditorIcons")
	_bones.icon = get_theme_icon(&"Bone", &"EditorIcons")
	_levels.icon = get_theme_icon(&"Panels4", &"EditorIcons")
	_seeds.icon = get_theme_icon(&"RandomNumberGenerator", &"EditorIcons")
	_reset.icon = get_theme_icon(&"CenterView", &"EditorIcons")
	var backdrop := StyleBoxFlat.new()
	backdrop.bg_color = Color(get_theme_color(&"base_color", &"Editor"), BACKDROP_OPACITY)
	backdrop.set_corner_radius_all(roundi(4 * EditorInterface.get_editor_scale()))
	backdrop.set_content_margin_all(roundi(4 * EditorInterface.get_editor_scale()))
	_tools.add_theme_stylebox_override(&"panel", backdrop)
	_counts_panel.add_theme_stylebox_override(&"panel", backdrop)
	_hint_panel.add_theme_stylebox_override(&"panel", backdrop)
	var font_size := roundi(get_theme_font_size(&"font_size", &"Label") * SMALL_FONT)
	_counts.add_theme_font_size_override(&"font_size", font_size)


# Levels and seeds are in the same row of plants: one toggle switches the other off.
func _on_row_toggled(is_on: bool, other: Button) -> void:
	if is_on:
		other.set_pressed_no_signal(false)
	_refresh()


# Number of shown plants: one, or one per level or seed.
func _set_plant_count(count: int) -> void:
	while _plants.size() > count:
		_plants.pop_back().queue_free()
	while _plants.size() < count:
		var plant := Plant3D.new()
		plant.simulation_enabled = false
		plant.add_child(_make_label())
		_plant_root.add_child(plant)
		_plants.append(plant)


func _make_label() -> Label3D:
	var label := Label3D.new()
	label.name = LABEL_NAME
	label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	label.fixed_size = true
	label.no_depth_test = true
	label.pixel_size = LABEL_PIXEL
	return label


func _on_function_chosen() -> void:
	_set_plant_count(0)
	if _piece:
		_piece.queue_free()
		_piece = null
	for toggle: Button in [_rings, _bones, _levels, _seeds]:
		toggle.disabled = _state.mix != null
	_queue_refresh()


func _queue_refresh() -> void:
	if not _refresh_is_queued:
		_refresh_is_queued = true
		_refresh.call_deferred()


func _refresh() -> void:
	_refresh_is_queued = false
	if _state.mix:
		_show_piece()
		return
	if not _state.function or not _state.problem.is_empty():
		_show_nothing()
		return
	_hint_panel.visible = false
	var count := EditorState.LEVELS.size() if _levels.button_pressed else 1
	_set_plant_count(SEEDS if _seeds.button_pressed else count)
	for i in _plants.size():
		_show_plant(i)
	_frame()
	_show_counts()
	_show_overlays()


# The last valid plant stays visible while its species has an error.
func _show_nothing() -> void:
	_hint_panel.visible = _plants.is_empty()
	_hint.text = tr("Choose a species above.") if not _state.function else _state.problem
	_counts_panel.visible = false


# Small, with the density of the mix.
func _show_piece() -> void:
	if _piece:
		return
	_hint_panel.visible = false
	_counts_panel.visible = false
	_piece = _state.mix.instantiate()
	var side := clampf(sqrt(PIECE_PLANTS / _piece.density), MIN_PIECE, MAX_PIECE)
	_piece.size = Vector2.ONE * side
	_piece.wind = null
	_piece.build_finished.connect(_show_plant_count)
	_plant_root.add_child(_piece)
	var height := PlantGroup.find_tallest(_piece)
	_ground.scale = Vector3.ONE * side * 0.5 * GROUND_RADIUS
	_camera.frame(Vector3.UP * height * 0.5, Vector2(side * PIECE_BREADTH, height))


func _show_plant_count() -> void:
	var count := _piece.get_plant_count()
	var area := String.num(_piece.size.x * _piece.size.y, 1)
	_counts_panel.visible = true
	_counts.text = tr_n("%d plant on %s m²", "%d plants on %s m²", count) % [count, area]


func _show_plant(index: int) -> void:
	var plant := _plants[index]
	plant.species = _state.function
	plant.height = _state.height
	plant.seed = _state.seed_value + (index if _seeds.button_pressed else 0)
	plant.segments = EditorState.LEVELS[index] if _levels.button_pressed else _state.segments
	plant.rebuild()
	var label: Label3D = plant.get_node(LABEL_NAME)
	label.visible = _plants.size() > 1
	label.text = str(plant.seed if _seeds.button_pressed else plant.segments)
	label.position.y = plant.get_plant_height() * LABEL_HEIGHT


func _frame() -> void:
	var height := _plants[0].get_plant_height()
	var size := _plants[0].get_mesh().get_aabb().size
	var breadth := maxf(size.x, size.z)
	var count := _plants.size()
	var gap := maxf(height * LEVEL_GAP, breadth * 1.2)
	for i in count:
		var place := (i - (count - 1) * 0.5) * gap
		_plants[i].position = OrbitCamera.get_start_side() * place
	var width := (count - 1) * gap + maxf(breadth, height * SWAY_ROOM)
	_ground.scale = Vector3.ONE * maxf(height * 0.5, width * 0.5) * GROUND_RADIUS
	_camera.frame(Vector3.UP * height * 0.5, Vector2(width, height))


func _show_counts() -> void:
	var triangles := 0
	var vertices := 0
	for plant in _plants:
		var mesh := plant.get_mesh()
		triangles += mesh.surface_get_array_index_len(0) / 3
		vertices += mesh.surface_get_array_len(0)
	var height := String.num(_plants[0].get_plant_height(), 2)
	_counts_panel.visible = true
	_counts.text = tr("%s m · %d tris · %d verts") % [height, triangles, vertices]


# The plant is between the tools and the counts. Tools that do not reach the middle are beside it.
func _make_room() -> void:
	var is_over := _tools.position.x + _tools.size.x > _view.size.x * MIDDLE
	var top := _tools.get_rect().end.y if is_over else 0.0
	var is_low := _view.size.y < MIN_HEIGHT_FOR_COUNTS * EditorInterface.get_editor_scale()
	_counts_panel.modulate.a = 0.0 if is_low else 1.0
	var bottom := _counts_panel.size.y if _counts_panel.visible and not is_low else 0.0
	_camera.spare(Vector2(top, bottom))
	_camera.place()


func _show_overlays() -> void:
	for overlay: Variant in _overlays:
		if is_instance_valid(overlay):
			(overlay as Node).queue_free()
	_overlays.clear()
	var is_stem := _state.function != null and _state.function.law == PlantFunction.LAW_STEM
	for plant in _plants:
		var joints := plant.get_joint_count() if is_stem else 0
		if _rings.button_pressed and Traits.has_stem(_state.function):
			var height := plant.get_plant_height()
			var rings := PreviewOverlay.make_rings(_state.function, height, plant.segments, joints)
			_add_overlay(plant, rings, RING_COLOR)
		if _bones.button_pressed:
			var bones := PreviewOverlay.make_bones(plant.get_plant_height(), joints)
			_add_overlay(plant, bones, BONE_COLOR)


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
