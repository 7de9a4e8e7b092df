@tool
extends VBoxContainer
## The panel "Undergrowth" below the 3D view: tiles of mixes and species with their actions, and a
## status line.

const Browser := preload("browser/browser.gd")
const EditorState := preload("editor_state.gd")
const Translations := preload("translations/translations.gd")
const StatusLine := preload("widgets/status_line.gd")
const TOASTS: Dictionary[int, EditorToaster.Severity] = {
	EditorState.Severity.WARNING: EditorToaster.SEVERITY_WARNING,
	EditorState.Severity.ERROR: EditorToaster.SEVERITY_ERROR,
}

## Minimum height in pixels at 100 %: two rows of tiles, or one in a low window.
const MIN_HEIGHT := 296
const MIN_HEIGHT_IF_LOW := 196
## Of the window's height.
const MAX_SHARE := 0.33

## State that all parts of the add-on's editor share.
var state := EditorState.new()

@onready var _browser: Browser = %Browser
@onready var _status: StatusLine = %Status


## Activates the panel. A panel that is only opened as a scene stays inactive.
func setup(plugin: EditorPlugin) -> void:
	set_translation_domain(Translations.DOMAIN)
	EditorInterface.get_base_control().resized.connect(_fit_height)
	_fit_height()
	_status.setup(state)
	_browser.setup(state, plugin.get_undo_redo(), self)
	state.reported.connect(_on_reported)


## The minimum height in a window of [param window] pixels at [param scale].
static func height_in(window: float, scale: float) -> float:
	return clampf(MAX_SHARE * window, MIN_HEIGHT_IF_LOW * scale, MIN_HEIGHT * scale)


## Returns true if [param data] of a drag is a mix or a species.
func accepts_drag(data: Variant) -> bool:
	return _browser.accepts_drag(data)


## Adds a field of the dragged mix or species at [param pixel] of the 3D view [param view].
func drop(data: Variant, view: SubViewport, pixel: Vector2) -> void:
	_browser.drop(data, view, pixel)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and state:
		state.close()


func _fit_height() -> void:
	var window := EditorInterface.get_base_control().size.y
	custom_minimum_size.y = height_in(window, EditorInterface.get_editor_scale())


# While the panel is hidden, warnings appear where the editor's own do.
func _on_reported(text: String, severity: EditorState.Severity) -> void:
	if text and TOASTS.has(severity) and not is_visible_in_tree():
		EditorInterface.get_editor_toaster().push_toast(text, TOASTS[severity])
