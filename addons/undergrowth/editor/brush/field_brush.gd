@tool
extends RefCounted
## The brush in the 3D view: what the mouse, the pen and the keys do while a field is edited.

const EditorState := preload("../editor_state.gd")
const BrushBar := preload("brush_bar.gd")
const BrushChoice := preload("brush_choice.gd")
const BrushCircle := preload("brush_circle.gd")
const BrushGround := preload("brush_ground.gd")
const BrushOptions := preload("brush_options.gd")
const BrushSettings := preload("brush_settings.gd")
const BrushStroke := preload("brush_stroke.gd")
const PenPressure := preload("pen_pressure.gd")

const BAR_SCENE := "brush_bar.tscn"
const SETTINGS_SCENE := "brush_settings.tscn"

var options := BrushOptions.new()

var _plugin: EditorPlugin
var _bar: BrushBar
var _settings: BrushSettings
var _circle: BrushCircle
var _field: PlantField3D
var _stroke: BrushStroke
var _pen := PenPressure.new()
# The stroke has not touched the ground yet.
var _waits_for: Variant
var _choice := BrushChoice.new()


## Adds the toolbar and the settings to the 3D editor of [param plugin]. What is picked in the dock
## of [param state] is painted.
func setup(plugin: EditorPlugin, state: EditorState) -> void:
	_plugin = plugin
	plugin.get_undo_redo().history_changed.connect(_on_history_changed)
	plugin.get_undo_redo().version_changed.connect(_on_history_changed)
	var folder := (get_script() as Script).resource_path.get_base_dir()
	_bar = (load(folder.path_join(BAR_SCENE)) as PackedScene).instantiate()
	plugin.add_control_to_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, _bar)
	_bar.setup(options)
	_bar.fill_wanted.connect(_on_fill_wanted)
	_bar.hide()
	_settings = (load(folder.path_join(SETTINGS_SCENE)) as PackedScene).instantiate()
	plugin.add_control_to_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_BOTTOM, _settings)
	_settings.setup(options)
	_choice.setup(state, options, _settings)
	_circle = BrushCircle.new()
	options.changed.connect(_on_options_changed)


## Takes it away again.
func close() -> void:
	_end_stroke()
	_choice.close()
	_plugin.get_undo_redo().history_changed.disconnect(_on_history_changed)
	_plugin.get_undo_redo().version_changed.disconnect(_on_history_changed)
	_plugin.remove_control_from_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_MENU, _bar)
	_bar.queue_free()
	_plugin.remove_control_from_container(EditorPlugin.CONTAINER_SPATIAL_EDITOR_BOTTOM, _settings)
	_settings.queue_free()
	_circle = null


## Works on [param field] from now on; null: on none.
func edit(field: PlantField3D) -> void:
	if field == _field:
		return
	_end_stroke()
	if _field and is_instance_valid(_field):
		_field.tree_exiting.disconnect(_on_field_leaves)
	_field = field
	if field:
		field.tree_exiting.connect(_on_field_leaves)
	else:
		options.tool = BrushOptions.Tool.NONE
	_bar.visible = field != null
	_choice.edit(field)
	_circle.hide()


## What happened over a 3D view. Whether nobody else is to hear of it.
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
	var place: Variant = _find(camera, motion.position)
	_show_circle(place, motion.ctrl_pressed)
	var pressure := _pen.read(motion)
	if not _stroke:
		return false
	if place is Vector3 and pressure > 0.0:
		_touch_first(pressure)
		_stroke.move_to(place, pressure)
	return true


func _handle_key(key: InputEventKey) -> bool:
	if not key.pressed or key.ctrl_pressed or key.alt_pressed:
		return false
	match key.keycode:
		KEY_BRACKETLEFT:
			options.radius /= BrushOptions.RADIUS_FACTOR
		KEY_BRACKETRIGHT:
			options.radius *= BrushOptions.RADIUS_FACTOR
		KEY_ESCAPE:
			options.tool = BrushOptions.Tool.NONE
		_:
			return false
	return true


func _handle_button(camera: Camera3D, button: InputEventMouseButton) -> bool:
	if button.button_index != MOUSE_BUTTON_LEFT or button.alt_pressed:
		return false
	if not button.pressed:
		var had_one := _stroke != null
		_end_stroke()
		return had_one
	var place: Variant = _find(camera, button.position)
	if not place is Vector3:
		return true
	var tool := options.tool_with(button.ctrl_pressed)
	if tool == BrushOptions.Tool.PICK:
		_pick(place)
		return true
	_begin_stroke(place, tool, button.shift_pressed)
	return true


func _begin_stroke(place: Vector3, tool: BrushOptions.Tool, smooths: bool) -> void:
	var paints := tool == BrushOptions.Tool.PAINT and not smooths
	var newcomer := _choice.bring_newcomer() if paints else null
	_stroke = BrushStroke.new(_field, options, tool, smooths, newcomer)
	_waits_for = place
	if not _pen.begin():
		_touch_first(1.0)
	_choice.refresh()


# Where the stroke began, once it is known how strongly.
func _touch_first(pressure: float) -> void:
	if _waits_for is Vector3:
		_stroke.move_to(_waits_for, pressure)
		_waits_for = null


# What grows there is what is painted from now on, as densely and as high.
func _pick(place: Vector3) -> void:
	var map := _field.map
	if not map:
		return
	var point := _field.to_local(place)
	var names: PackedStringArray = []
	for title in map.get_painted_species():
		if map.get_density(point, title) > 0.0:
			names.append(title)
			options.density = map.get_density(point, title)
			options.height = map.get_height_factor(point, title)
	if names:
		options.species = names
	options.tool = BrushOptions.Tool.PAINT


func _end_stroke() -> void:
	if _stroke:
		_touch_first(1.0)
		_stroke.finish(_plugin.get_undo_redo())
		_stroke = null


func _on_fill_wanted() -> void:
	if _field:
		_field.fill()


# Undo takes species away, and the inspector may do so, too.
func _on_history_changed() -> void:
	if _field and not _stroke:
		_choice.refresh()


# On the ground under the pointer; null in the sky.
func _find(camera: Camera3D, point: Vector2) -> Variant:
	var plane := Plane(_field.global_basis.y.normalized(), _field.global_position)
	return BrushGround.find(
		_field, camera.project_ray_origin(point), camera.project_ray_normal(point), plane
	)


func _show_circle(place: Variant, ctrl: bool) -> void:
	if place is Vector3:
		var tool := options.tool_with(ctrl)
		_circle.show_at(_field, place, options.radius, options.falloff, tool)
	else:
		_circle.hide()
	_plugin.update_overlays()


func _on_options_changed() -> void:
	if options.tool == BrushOptions.Tool.NONE and _circle:
		_end_stroke()
		_circle.hide()


func _on_field_leaves() -> void:
	_stroke = null
	_waits_for = null
	edit(null)
