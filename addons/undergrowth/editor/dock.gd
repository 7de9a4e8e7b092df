@tool
extends VBoxContainer
## The dock's frame: a page for plants, a page for the wind, and a status line below both.

const EditorState := preload("editor_state.gd")
const PlantPage := preload("plant_page/plant_page.gd")
const WindPage := preload("wind_page/wind_page.gd")
const Translations := preload("translations/translations.gd")
const StatusLine := preload("widgets/status_line.gd")

## Minimum width in pixels at 100 %. It leaves enough room on small screens.
const MIN_WIDTH := 300

## State that both pages share.
var state := EditorState.new()

@onready var _pages: TabContainer = %Pages
@onready var _plant_page: PlantPage = %Plant
@onready var _wind_page: WindPage = %Wind
@onready var _status: StatusLine = %Status
@onready var _status_frame: MarginContainer = %StatusFrame


## Activates the dock. A dock that is only opened as a scene stays inactive.
func setup(plugin: EditorPlugin) -> void:
	set_translation_domain(Translations.DOMAIN)
	_pages.set_tab_title(_pages.get_tab_idx_from_control(_plant_page), tr("Plant"))
	_pages.set_tab_title(_pages.get_tab_idx_from_control(_wind_page), tr("Wind"))
	custom_minimum_size.x = MIN_WIDTH * EditorInterface.get_editor_scale()
	_status.setup(state)
	_align_status()
	_plant_page.setup(state, plugin.get_undo_redo(), self)
	_wind_page.setup(state, plugin)


## Returns true if [param data] of a drag is a mix or a species.
func accepts_drag(data: Variant) -> bool:
	return _plant_page.accepts_drag(data)


## Adds a field of the dragged mix or species at [param pixel] of the 3D view [param view].
func drop(data: Variant, view: SubViewport, pixel: Vector2) -> void:
	_plant_page.drop(data, view, pixel)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and state:
		state.close()
	elif what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_align_status()


# Below the pages' content. The theme adds a margin at their edges.
func _align_status() -> void:
	var panel := _pages.get_theme_stylebox(&"panel")
	var left := roundi(panel.get_margin(SIDE_LEFT))
	var right := roundi(panel.get_margin(SIDE_RIGHT))
	_status_frame.add_theme_constant_override(&"margin_left", left)
	_status_frame.add_theme_constant_override(&"margin_right", right)
