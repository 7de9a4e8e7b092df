@tool
extends VBoxContainer
## A swaying plant of a species above its properties in the inspector, at the detail of a near one:
## alone, by levels of detail, or by seeds. Its view stays while the inspector is built again.

const EditorState := preload("../editor_state.gd")
const OrbitCamera := preload("orbit_camera.gd")
const PreviewOverlay := preload("preview_overlay.gd")
const PreviewView := preload("preview_view.gd")
const Traits := preload("species_traits.gd")
const Translations := preload("../translations/translations.gd")
const ViewControls := preload("view_controls.gd")
const WindClock := preload("../wind/wind_clock.gd")
## Of the picture, in pixels at 100 %.
const HEIGHT := 240.0
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
## Factor of the editor's font size, so that all counts fit in one line of a narrow inspector.
const SMALL_FONT := 0.85
## Start of a plant, as a fraction of the view's width.
const MIDDLE := 0.45
## Margin for swaying, as a fraction of the height.
const SWAY_ROOM := 0.5
const RING_COLOR := Color(1.0, 1.0, 1.0, 0.55)
const BONE_COLOR := Color(1.0, 0.72, 0.2)

## The shown species. Set it before the preview enters the tree.
var function: PlantFunction

# A light breeze that belongs to this preview.
var _breeze := PlantWind.new()
var _shown: PreviewView
# The reason that prevents a plant and its solution, or an empty text.
var _problem := ""
var _plants: Array[Plant3D] = []
var _overlays: Array[MeshInstance3D] = []
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
	set_process(function != null)
	if not function:
		return
	set_translation_domain(Translations.DOMAIN)
	_view.custom_minimum_size.y = HEIGHT * EditorInterface.get_editor_scale()
	_breeze.kind = PlantWind.KIND_WAVES
	_breeze.frequency = 0.4
	_breeze.direction = PI / 2.0
	_shown = PreviewView.of(function)
	(%ViewControls as ViewControls).setup(_shown)
	_connect_tools()
	_apply_theme()
	function.changed.connect(_queue_refresh)
	_refresh()


func _connect_tools() -> void:
	_camera.turn_to(_shown.turn, _shown.tilt, _shown.zoom)
	for toggle: Button in [_play, _rings, _bones, _levels, _seeds]:
		toggle.set_pressed_no_signal(_shown.tools.get(toggle.name, toggle.button_pressed))
	for toggle: Button in [_rings, _bones]:
		toggle.toggled.connect(func(_on: bool) -> void: _refresh())
	_levels.toggled.connect(_on_row_toggled.bind(_seeds))
	_seeds.toggled.connect(_on_row_toggled.bind(_levels))
	_reset.pressed.connect(_camera.restart)
	_shown.changed.connect(_queue_refresh)
	_view.gui_input.connect(_on_view_input)
	for part: Control in [_view, _tools, _counts_panel]:
		part.resized.connect(_make_room)


func _exit_tree() -> void:
	if not _shown:
		return
	_shown.turn = _camera.get_turn()
	_shown.tilt = _camera.get_tilt()
	_shown.zoom = _camera.get_zoom()
	for toggle: Button in [_play, _rings, _bones, _levels, _seeds]:
		_shown.tools[toggle.name] = toggle.button_pressed


func _process(delta: float) -> void:
	if not is_visible_in_tree() or not _play.button_pressed:
		return
	WindClock.advance(_breeze, delta)
	for plant in _plants:
		plant._preview(minf(delta, LONGEST_FRAME), _breeze)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _shown:
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


func _queue_refresh() -> void:
	if not _refresh_is_queued:
		_refresh_is_queued = true
		_refresh.call_deferred()


func _refresh() -> void:
	_refresh_is_queued = false
	_problem = function.find_problem(_shown.height, _shown.segments, _shown.first_seed)
	if not _problem.is_empty():
		_show_nothing()
		return
	_hint_panel.visible = false
	_breeze.strength = _breeze_strength()
	var count := EditorState.LEVELS.size() if _levels.button_pressed else 1
	_set_plant_count(SEEDS if _seeds.button_pressed else count)
	for i in _plants.size():
		_show_plant(i)
	_frame()
	_show_counts()
	_show_overlays()


# A force that bends this plant visibly but not flat: a fraction of its weight.
func _breeze_strength() -> float:
	var weight := 1.0 if function.wind_weight < 0.0 else maxf(function.wind_weight, 0.1)
	return clampf(0.1 * function.mass * 9.81 / weight, 0.001, 10.0)


# The last valid plant stays visible while its species has an error.
func _show_nothing() -> void:
	_hint_panel.visible = true
	_hint.text = _problem
	_counts_panel.visible = false


func _show_plant(index: int) -> void:
	var plant := _plants[index]
	plant.species = function
	plant.height = _shown.height
	plant.seed = _shown.first_seed + (index if _seeds.button_pressed else 0)
	plant.segments = EditorState.LEVELS[index] if _levels.button_pressed else _shown.segments
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
	var bottom := _counts_panel.size.y if _counts_panel.visible else 0.0
	_camera.spare(Vector2(top, bottom))
	_camera.place()


func _show_overlays() -> void:
	for overlay: Variant in _overlays:
		if is_instance_valid(overlay):
			(overlay as Node).queue_free()
	_overlays.clear()
	var is_stem := function.law == PlantFunction.LAW_STEM
	for plant in _plants:
		var joints := plant.get_joint_count() if is_stem else 0
		if _rings.button_pressed and Traits.has_stem(function):
			var height := plant.get_plant_height()
			var rings := PreviewOverlay.make_rings(function, height, plant.segments, joints)
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


# Without Ctrl the wheel scrolls the inspector.
func _on_view_input(event: InputEvent) -> void:
	var button := event as InputEventMouseButton
	var is_wheel := (
		button and button.button_index in [MOUSE_BUTTON_WHEEL_UP, MOUSE_BUTTON_WHEEL_DOWN]
	)
	if is_wheel and not button.ctrl_pressed:
		return
	if _camera.handle(event, EditorInterface.get_editor_scale()):
		_view.accept_event()
