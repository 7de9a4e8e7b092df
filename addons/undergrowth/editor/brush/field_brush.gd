@tool
extends RefCounted
## The brush in the 3D view: mouse, pen and keys during the editing of a field.

const EditorState := preload("../editor_state.gd")
const BrushBar := preload("brush_bar.gd")
const BrushChoice := preload("brush_choice.gd")
const BrushDensity := preload("brush_density.gd")
const BrushCircle := preload("brush_circle.gd")
const BrushOptions := preload("brush_options.gd")
const BrushReadout := preload("brush_readout.gd")
const BrushSettings := preload("brush_settings.gd")
const BrushStroke := preload("brush_stroke.gd")
const BrushPointer := preload("brush_pointer.gd")
const FieldPlacing := preload("../field/field_placing.gd")
const MapSaving := preload("map_saving.gd")
const PathTool := preload("path_tool.gd")
const PenPressure := preload("pen_pressure.gd")
const TransformGizmo := preload("transform_gizmo.gd")

const BAR_SCENE := "brush_bar.tscn"
const SETTINGS_SCENE := "brush_settings.tscn"

var options := BrushOptions.new()

var _plugin: EditorPlugin
var _bar: BrushBar
var _settings: BrushSettings
var _circle: BrushCircle
var _pointer := BrushPointer.new()
# True if the pointer has moved since the last frame.
var _has_moved := false
# Of the last move with the pen down, until the stroke follows it.
var _pressure := 0.0
# The values of the last update of the circle.
var _drawn_circle: Array = []
var _field: PlantField3D
var _stroke: BrushStroke
var _pen := PenPressure.new()
# True until the stroke has touched the ground.
var _waits_for: Variant
var _choice := BrushChoice.new()
var _path_tool := PathTool.new()
var _map_saving := MapSaving.new()


## Adds the toolbar and the settings to the 3D editor of [param plugin]. It paints the species
## picked in the panel of [param state].
func setup(plugin: EditorPlugin, state: EditorState) -> void:
	_plugin = plugin
	plugin.get_undo_redo().history_changed.connect(_on_history_changed)
	plugin.get_undo_redo().version_changed.connect(_on_history_changed)
	var folder := (get_script() as Script).resource_path.get_base_dir()
	_bar = (load(folder.path_join(BAR_SCENE)) as PackedScene).instantiate()
	plugin.add_control_to_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, _bar)
	_bar.setup(options)
	_bar.fill_wanted.connect(_on_fill_wanted)
	_bar.place_wanted.connect(_on_place_wanted)
	_bar.flat_wanted.connect(_on_flat_wanted)
	_bar.map_wanted.connect(func() -> void: _map_saving.choose_file(_field))
	_map_saving.setup(plugin.get_undo_redo())
	_bar.hide()
	_settings = (load(folder.path_join(SETTINGS_SCENE)) as PackedScene).instantiate()
	plugin.add_control_to_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_BOTTOM, _settings)
	_settings.setup(options)
	_choice.setup(state, options, _settings)
	_path_tool.setup(plugin.get_undo_redo(), options)
	_circle = BrushCircle.new()
	options.changed.connect(_on_options_changed)


## Removes the toolbar and the settings.
func close() -> void:
	edit(null)
	_choice.close()
	_map_saving.close()
	_plugin.get_undo_redo().history_changed.disconnect(_on_history_changed)
	_plugin.get_undo_redo().version_changed.disconnect(_on_history_changed)
	_plugin.remove_control_from_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, _bar)
	_bar.queue_free()
	_plugin.remove_control_from_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_BOTTOM, _settings)
	_settings.queue_free()
	_circle = null
	TransformGizmo.set_visible(true)


## Sets the edited field, or none if [param field] is null.
func edit(field: PlantField3D) -> void:
	if field == _field:
		return
	end_stroke()
	_path_tool.cancel()
	if _field and is_instance_valid(_field):
		_field.tree_exiting.disconnect(_on_field_leaves)
	_field = field
	if field:
		field.tree_exiting.connect(_on_field_leaves)
	else:
		options.tool = BrushOptions.Tool.NONE
	_bar.visible = field != null
	_show_state()
	_choice.edit(field)
	_hide_circle()


## Handles an event of a 3D view. Returns true if it consumed the event.
func handle(camera: Camera3D, event: InputEvent) -> bool:
	if not _field or options.tool == BrushOptions.Tool.NONE:
		return false
	if event is InputEventKey:
		return _handle_key(event as InputEventKey)
	var button := event as InputEventMouseButton
	if button:
		return _handle_button(camera, button)
	var motion := event as InputEventMouseMotion
	if not motion:
		return false
	_pointer.move_to(camera, motion)
	var pressure := _pen.read(motion)
	if _stroke and pressure > 0.0:
		_pressure = pressure
	_follow_pointer_soon()
	if options.draws_path():
		return motion.button_mask & MOUSE_BUTTON_MASK_LEFT != 0
	return _stroke != null


func _handle_key(key: InputEventKey) -> bool:
	if not key.pressed or key.ctrl_pressed or key.alt_pressed:
		return false
	if _path_tool.handle_key(key.keycode):
		_plugin.update_overlays()
		return true
	match key.keycode:
		KEY_BRACKETLEFT:
			_scale_radius(1.0 / BrushOptions.RADIUS_FACTOR)
		KEY_BRACKETRIGHT:
			_scale_radius(BrushOptions.RADIUS_FACTOR)
		KEY_ESCAPE:
			options.tool = BrushOptions.Tool.NONE
		_:
			return false
	return true


# Ctrl and the wheel change the radius.
func _handle_wheel(button: InputEventMouseButton) -> bool:
	var is_up := button.button_index == MOUSE_BUTTON_WHEEL_UP
	if not button.ctrl_pressed or not (is_up or button.button_index == MOUSE_BUTTON_WHEEL_DOWN):
		return false
	if button.pressed:
		_scale_radius(BrushOptions.RADIUS_FACTOR if is_up else 1.0 / BrushOptions.RADIUS_FACTOR)
	return true


func _scale_radius(factor: float) -> void:
	if options.draws_path():
		options.width *= factor
	else:
		options.radius *= factor
	_follow_pointer_soon()


func _handle_button(camera: Camera3D, button: InputEventMouseButton) -> bool:
	if _handle_wheel(button):
		return true
	if button.button_index != MOUSE_BUTTON_LEFT or button.alt_pressed:
		return false
	if options.draws_path():
		return _handle_path(camera, button)
	if not button.pressed:
		var had_one := _stroke != null
		end_stroke()
		return had_one
	_pointer.move_to(camera, button)
	var place: Variant = _pointer.find_place(_field)
	if not place is Vector3:
		return true
	var tool := options.tool_with(button.ctrl_pressed)
	if tool == BrushOptions.Tool.PICK:
		_pick(place)
		return true
	var erases_all := (
		tool == BrushOptions.Tool.ERASE and button.ctrl_pressed and button.shift_pressed
	)
	_begin_stroke(place, tool, button.shift_pressed and not erases_all, erases_all)
	return true


func _handle_path(camera: Camera3D, button: InputEventMouseButton) -> bool:
	_pointer.move_to(camera, button)
	var place: Variant = _pointer.find_place(_field)
	if not button.pressed:
		_path_tool.release()
	elif place is Vector3:
		_path_tool.press(_field, place, button.double_click)
	_plugin.update_overlays()
	return true


func _begin_stroke(
	place: Vector3, tool: BrushOptions.Tool, smooths: bool, erases_all: bool
) -> void:
	var paints := tool == BrushOptions.Tool.PAINT and not smooths
	var added: Array[PlantFieldSpecies] = []
	if paints:
		added = _choice.take_new_entries()
	_settings.show_message("")
	var species := PackedStringArray() if erases_all else options.species
	_stroke = BrushStroke.new(_field, options, tool, smooths, species, added)
	_pressure = 0.0
	_waits_for = place
	if not _pen.begin():
		_touch_first(1.0)
	_choice.refresh()


# Touches the start of the stroke when the pressure is available.
func _touch_first(pressure: float) -> void:
	if _waits_for is Vector3:
		_stroke.move_to(_waits_for, pressure)
		_waits_for = null


# Picks the species and all painted values at the pointer for the next strokes.
func _pick(place: Vector3) -> void:
	var map := _field.map
	if not map:
		return
	var point := _field.to_local(place)
	var names: PackedStringArray = []
	var density := 0.0
	var is_as_mixed := true
	for title in map.get_painted_species():
		var share := map.get_density(point, title)
		var plants := map.get_plant_density(point, title)
		if share > 0.0 or plants > 0.0:
			names.append(title)
			density += BrushDensity.at(_field, title, point)
			is_as_mixed = is_as_mixed and share == 1.0 and plants == 0.0
			options.height = map.get_height_factor(point, title)
			options.scale_jitter = map.get_scale_jitter(point, title)
			options.color_jitter = map.get_color_jitter(point, title)
	if names:
		options.species = names
		options.density = density
		options.is_as_mixed = is_as_mixed
	options.tool = BrushOptions.Tool.PAINT


## Draws the numbers of the brush beside the pointer if it is over [param overlay].
func draw_over(overlay: Control) -> void:
	if not _field or not _drawn_circle or not _pointer.is_over(overlay):
		return
	var place: Variant = _pointer.find_place(_field)
	if not place is Vector3:
		return
	if options.draws_path():
		_path_tool.draw_over(overlay, _pointer.get_camera(), _pointer.get_point())
		return
	var tool := options.tool_with(_pointer.is_ctrl_pressed)
	var names := _settings.get_painted_names()
	var text := BrushReadout.describe(_field, options, tool, names, _field.to_local(place))
	BrushReadout.draw(overlay, _pointer.get_point(), text)


## Ends a stroke in progress while its scene is still the edited one. The step of undo belongs to
## that scene.
func end_stroke() -> void:
	if not _stroke:
		return
	_move_stroke()
	var stroke := _stroke
	_touch_first(1.0)
	_stroke = null
	var message := stroke.explain()
	stroke.finish(_plugin.get_undo_redo())
	_choice.refresh()
	_settings.show_message(message)


func _on_place_wanted() -> void:
	var root := EditorInterface.get_edited_scene_root()
	if not _field or FieldPlacing.place(_plugin.get_undo_redo(), root, _field):
		return
	EditorInterface.get_editor_toaster().push_toast(
		_bar.tr("No collider, mesh or terrain is below or above the centre of the field."),
		EditorToaster.SEVERITY_WARNING
	)


func _on_flat_wanted(on: bool) -> void:
	if _field:
		FieldPlacing.keep_flat(_plugin.get_undo_redo(), _field, on)


func _show_state() -> void:
	if _field:
		_bar.offer_map(MapSaving.is_possible(_field))
		var is_flat := _field.ground_mode == PlantField3D.GROUND_NONE
		_bar.show_ground(is_flat, FieldPlacing.is_kept_flat(_field))


func _on_fill_wanted() -> void:
	if _field:
		_field.rebuild()


# Undo and the inspector can remove species too.
func _on_history_changed() -> void:
	if _field and not _stroke:
		_choice.refresh()
		_show_state()


# Once per frame, for any number of pointer events.
func _follow_pointer_soon() -> void:
	if not _has_moved:
		_has_moved = true
		_plugin.get_tree().process_frame.connect(_follow_pointer, CONNECT_ONE_SHOT)


func _follow_pointer() -> void:
	_has_moved = false
	_move_stroke()
	_move_path()
	_show_circle()


func _move_path() -> void:
	var place: Variant = _pointer.find_place(_field) if _field and options.draws_path() else null
	if place is Vector3:
		_path_tool.move_to(_field, place, _pointer.is_pressed)


# Moves the stroke to the pointer if the pointer has moved with the pen down.
func _move_stroke() -> void:
	if not _stroke or _pressure <= 0.0 or not _field.is_inside_tree():
		return
	var pressure := _pressure
	_pressure = 0.0
	var place: Variant = _pointer.find_place(_field)
	if place is Vector3:
		_touch_first(pressure)
		_stroke.move_to(place, pressure)


func _show_circle() -> void:
	if not _circle or not _field or options.tool == BrushOptions.Tool.NONE:
		return
	var tool := options.tool_with(_pointer.is_ctrl_pressed)
	var state := [_pointer.get_sight(), _field.global_transform]
	state.append_array([options.get_circle(), tool])
	if state == _drawn_circle:
		return
	_drawn_circle = state
	var place: Variant = _pointer.find_place(_field)
	if place is Vector3:
		var circle := options.get_circle()
		_circle.show_at(_field, place, circle.x, circle.y, tool)
	else:
		_circle.hide()
	_plugin.update_overlays()


func _hide_circle() -> void:
	_drawn_circle = []
	_circle.hide()
	_plugin.update_overlays()


func _on_options_changed() -> void:
	TransformGizmo.set_visible(options.tool == BrushOptions.Tool.NONE)
	if not options.draws_path():
		_path_tool.cancel()
	if options.tool == BrushOptions.Tool.NONE and _circle:
		end_stroke()
		_hide_circle()


func _on_field_leaves() -> void:
	edit(null)
