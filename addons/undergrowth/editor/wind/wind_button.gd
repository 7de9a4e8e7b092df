@tool
extends Button
## The button *Wind* in the toolbar of the 3D view: shows a panel with the wind of the edited scene
## over the view, which stays while the user works. Visible while the scene has plants.

const EditorState := preload("../editor_state.gd")
const Translations := preload("../translations/translations.gd")
const WindPanel := preload("wind_panel.gd")
const PANEL := preload("wind_panel.tscn")
const ICON := preload("../../icons/PlantWind.svg")
## Distance from the borders of the view, in pixels at 100 %.
const GAP := 10.0
## Width and height of the view's axes in its corner, in pixels at 100 %.
const AXES := 120.0

var _frame := PanelContainer.new()
var _panel: WindPanel


## Shows and changes the wind of [param state].
func setup(plugin: EditorPlugin, state: EditorState) -> void:
	name = "Wind"
	set_translation_domain(Translations.DOMAIN)
	text = "Wind"
	tooltip_text = tr("Wind of this scene: speed, direction and presets.")
	icon = ICON
	toggle_mode = true
	theme_type_variation = &"FlatButton"
	_panel = PANEL.instantiate()
	_frame.set_translation_domain(Translations.DOMAIN)
	_frame.hide()
	_frame.add_child(_panel)
	EditorInterface.get_editor_viewport_3d(0).get_parent().get_parent().add_child(_frame)
	_panel.setup(state, plugin)
	_frame.get_parent_control().resized.connect(_place)
	_frame.resized.connect(_place)
	toggled.connect(func(_on: bool) -> void: _show())
	visibility_changed.connect(_show)
	_apply_theme()


## Removes the panel. Call it before the plugin is removed.
func close() -> void:
	_frame.queue_free()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _panel:
		_apply_theme()


func _apply_theme() -> void:
	_frame.add_theme_stylebox_override(&"panel", get_theme_stylebox(&"panel", &"PopupPanel"))


func _show() -> void:
	_frame.visible = button_pressed and is_visible_in_tree()
	_place()


# Below the axes of the view, or to their left in a low view.
func _place() -> void:
	var view := _frame.get_parent_control().size
	var gap := GAP * EditorInterface.get_editor_scale()
	var axes := AXES * EditorInterface.get_editor_scale()
	var lowest := view.y - _frame.size.y - gap
	var is_below := lowest >= axes
	var right := view.x - _frame.size.x - (gap if is_below else axes)
	_frame.position = Vector2(
		maxf(right, 0.0), axes if is_below else clampf(gap, 0.0, maxf(lowest, 0.0))
	)
