@tool
extends EditorPlugin
## Adds the panel "Undergrowth", previews in the inspector, gizmos and thumbnails to the editor, and
## takes everything away again when switched off.

# Loaded when needed: without the library none of these scripts can be compiled.
const DOCK_SCENE := "editor/dock.tscn"
const ICONS := "icons"
## Where the panel is, by the version of the engine.
const EDITOR_DOCK := "editor/place/editor_dock.gd"
const BOTTOM_PANEL := "editor/place/bottom_panel.gd"
const DOCK_ICON := "icons/PlantFunction.svg"
const ICON_SCALE := "editor/icon_scale.gd"
const INSPECTOR := "editor/inspector/undergrowth_inspector.gd"
const REFUSED_VALUES := "editor/inspector/refused_values.gd"
const FIELD_GIZMOS := "editor/gizmo/field_gizmos.gd"
const GIZMOS: Array[String] = ["editor/gizmo/plant_gizmos.gd", FIELD_GIZMOS]
const WIND := "editor/wind/wind_button.gd"
const SWAY := "editor/wind/sway_button.gd"
const BRUSH := "editor/brush/field_brush.gd"
const CLIMBER_PATHS := "editor/climber/climber_path_tool.gd"
const DROP_AREA := "editor/field/drop_area.gd"
const GROUND_WATCH := "editor/field/ground_watch.gd"
const FLAT_FIELDS := "editor/field/flat_fields.gd"
const CREATED_FIELDS := "editor/field/created_fields.gd"
const THUMBNAILS := "editor/thumbnails/plant_thumbnails.gd"
const EXPORT_CHECK := "editor/export/library_check.gd"
const TRANSLATIONS := "editor/translations/translations.gd"
## A class of the library.
const NATIVE_CLASS := &"PlantFunction"
const FIELD_CLASS := &"PlantField3D"
const CLIMBER_CLASS := &"PlantClimber3D"
## Seconds of one step of the simulation; PlantSimulation reads it when the library is loaded.
const STEP_SETTING := "undergrowth/simulation/step_length"
const DEFAULT_STEP := 1.0 / 60.0
## Off: everything runs on the main thread.
const WORKERS_SETTING := "undergrowth/simulation/use_worker_threads"

# The panel: editor/dock.gd, and its place in the editor: one of editor/place.
var _dock: Control
var _place: RefCounted
var _inspector: EditorInspectorPlugin
# Shows errors of refused values in the inspector: editor/inspector/refused_values.gd.
var _refused_values: RefCounted
var _gizmos: Array[EditorNode3DGizmoPlugin] = []
# Where gizmos go whose node is no more.
var _placeholder: Node3D
# The buttons *Sway* and *Wind* in the toolbar of the 3D view.
var _sway: Button
var _wind: Button
# What paints into fields: editor/brush/field_brush.gd.
var _brush: RefCounted
# What draws paths of climbers: editor/climber/climber_path_tool.gd.
var _climber_paths: RefCounted
# Take mixes and species that are dropped on the 3D views: editor/field/drop_area.gd.
var _drop_areas: Array[Control] = []
# Fills fields again whose ground was moved: editor/field/ground_watch.gd.
var _ground_watch: RefCounted
# Warns about fields that are not on the ground: editor/field/flat_fields.gd.
var _flat_fields: RefCounted
# Lays fields of the Create Node dialog on the ground: editor/field/created_fields.gd.
var _created_fields: RefCounted
var _thumbnails: EditorResourcePreviewGenerator
var _export_check: EditorExportPlugin
var _translations: Script


func _enter_tree() -> void:
	_show_settings()
	if not ClassDB.class_exists(NATIVE_CLASS):
		push_error(
			(
				(
					"Undergrowth: its library for this platform is missing in %s. "
					% _folder().path_join("bin")
				)
				+ "Install a release of the add-on, or build it with ./run build."
			)
		)
		return
	_translations = _load(TRANSLATIONS)
	_translations.call(&"add")
	_add_dock()
	_add_helpers()
	_load(ICON_SCALE).call(&"adapt", _folder().path_join(ICONS))


func _exit_tree() -> void:
	if not _dock:
		return
	_refused_values.call(&"close")
	remove_inspector_plugin(_inspector)
	var inspected := EditorInterface.get_inspector().get_edited_object()
	if inspected:
		inspected.notify_property_list_changed()  # Takes the add-on's controls away.
	_remove_gizmos()
	_sway.call(&"close", self)
	_wind.call(&"close")
	for button: Button in [_sway, _wind]:
		remove_control_from_container(CONTAINER_SPATIAL_EDITOR_MENU, button)
		button.queue_free()
	_brush.call(&"close")
	_brush = null
	_climber_paths = null
	for area in _drop_areas:
		area.queue_free()
	_drop_areas.clear()
	_ground_watch.call(&"close")
	_ground_watch = null
	_flat_fields.call(&"close")
	_flat_fields = null
	_created_fields.call(&"close")
	_created_fields = null
	_placeholder.free()  # Only now: they have taken their gizmos from their nodes.
	EditorInterface.get_resource_previewer().remove_preview_generator(_thumbnails)
	remove_export_plugin(_export_check)
	_place.call(&"remove")
	_place = null
	_dock = null
	_translations.call(&"remove")


# Switched on by hand: what is new comes to the front, once.
func _enable_plugin() -> void:
	if _place:
		_place.call(&"show")


func _handles(object: Object) -> bool:
	var is_ours := object.is_class(FIELD_CLASS) or object.is_class(CLIMBER_CLASS)
	return _brush != null and object is Node3D and is_ours


func _edit(object: Object) -> void:
	if _brush:
		_brush.call(&"edit", object if object and object.is_class(FIELD_CLASS) else null)
		_climber_paths.call(&"edit", object)


func _make_visible(is_shown: bool) -> void:
	if _brush and not is_shown:
		_edit(null)


func _forward_3d_gui_input(camera: Camera3D, event: InputEvent) -> int:
	var is_ours: bool = _brush and _brush.call(&"handle", camera, event)
	is_ours = is_ours or (_climber_paths and _climber_paths.call(&"handle", camera, event))
	return AFTER_GUI_INPUT_STOP if is_ours else AFTER_GUI_INPUT_PASS


func _forward_3d_draw_over_viewport(overlay: Control) -> void:
	if _brush:
		_brush.call(&"draw_over", overlay)
		_climber_paths.call(&"draw_over", overlay)


# The editor calls this before it shows another scene, and before it saves.
func _get_state() -> Dictionary:
	if _brush:
		_brush.call(&"end_stroke")
	return {}


func _get_plugin_name() -> String:
	return "Undergrowth"


# The settings stay when the plugin is switched off: the library reads them in the game, too.
func _show_settings() -> void:
	_show_setting(STEP_SETTING, DEFAULT_STEP, PROPERTY_HINT_RANGE, "0.001,0.1,0.0001,suffix:s")
	_show_setting(WORKERS_SETTING, true)


func _show_setting(
	setting: String, value: Variant, hint := PROPERTY_HINT_NONE, hint_string := ""
) -> void:
	if not ProjectSettings.has_setting(setting):
		ProjectSettings.set_setting(setting, value)
	ProjectSettings.set_initial_value(setting, value)
	ProjectSettings.set_as_basic(setting, true)
	ProjectSettings.set_restart_if_changed(setting, true)
	ProjectSettings.add_property_info(
		{"name": setting, "type": typeof(value), "hint": hint, "hint_string": hint_string}
	)


func _add_dock() -> void:
	_dock = (_load(DOCK_SCENE) as PackedScene).instantiate()
	var place := EDITOR_DOCK if ClassDB.class_exists(&"EditorDock") else BOTTOM_PANEL
	_place = (_load(place) as GDScript).new()
	var icon := _folder().path_join(DOCK_ICON)
	var texture: Texture2D = load(icon) if ResourceLoader.exists(icon) else null
	_place.call(&"add", self, _dock, _translations.get(&"DOMAIN"), texture)
	_dock.call(&"setup", self)


func _add_helpers() -> void:
	_climber_paths = (_load(CLIMBER_PATHS) as GDScript).new()
	_climber_paths.call(&"setup", self)
	_inspector = (_load(INSPECTOR) as GDScript).new()
	_inspector.set(&"climber_paths", _climber_paths)
	add_inspector_plugin(_inspector)
	_refused_values = (_load(REFUSED_VALUES) as GDScript).new()
	_refused_values.call(&"setup")
	_add_gizmos()
	_add_wind()
	_brush = (_load(BRUSH) as GDScript).new()
	_brush.call(&"setup", self, _dock_state())
	_gizmos[GIZMOS.find(FIELD_GIZMOS)].set(&"brush_options", _brush.get(&"options"))
	var accepts := Callable(_dock, &"accepts_drag")
	_drop_areas = _load(DROP_AREA).call(&"add_to_views", accepts, Callable(_dock, &"drop"))
	_ground_watch = (_load(GROUND_WATCH) as GDScript).new()
	_ground_watch.call(&"setup", self)
	_flat_fields = (_load(FLAT_FIELDS) as GDScript).new()
	_flat_fields.call(&"setup", self)
	_created_fields = (_load(CREATED_FIELDS) as GDScript).new()
	_created_fields.call(&"setup", _dock_state())
	_thumbnails = (_load(THUMBNAILS) as GDScript).new()
	EditorInterface.get_resource_previewer().add_preview_generator(_thumbnails)
	_export_check = (_load(EXPORT_CHECK) as GDScript).new()
	_export_check.call(&"setup", _folder())
	add_export_plugin(_export_check)


func _add_wind() -> void:
	_sway = (_load(SWAY) as GDScript).new()
	_wind = (_load(WIND) as GDScript).new()
	_sway.set(&"wind_button", _wind)
	for button: Button in [_sway, _wind]:
		add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, button)
		button.call(&"setup", self, _dock_state())


# State that all parts share: editor/editor_state.gd.
func _dock_state() -> RefCounted:
	return _dock.get(&"state")


func _add_gizmos() -> void:
	_placeholder = Node3D.new()
	for file in GIZMOS:
		var plugin: EditorNode3DGizmoPlugin = (_load(file) as GDScript).new()
		add_node_3d_gizmo_plugin(plugin)
		plugin.call(&"setup", get_undo_redo(), _placeholder)
		_gizmos.append(plugin)


func _remove_gizmos() -> void:
	for plugin in _gizmos:
		plugin.call(&"close")
		remove_node_3d_gizmo_plugin(plugin)
	_gizmos.clear()


func _load(file: String) -> Resource:
	return load(_folder().path_join(file))


func _folder() -> String:
	return (get_script() as Script).resource_path.get_base_dir()
