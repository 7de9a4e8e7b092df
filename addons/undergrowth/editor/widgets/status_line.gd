@tool
extends HBoxContainer
## Small lines for messages, a button that shows the file of a message, and the progress of long
## work with a cancel button.

const EditorState := preload("../editor_state.gd")
const Front := preload("../place/front.gd")
const ICONS: Dictionary[int, StringName] = {
	EditorState.Severity.INFO: &"NodeInfo",
	EditorState.Severity.WARNING: &"StatusWarning",
	EditorState.Severity.ERROR: &"StatusError",
}
const COLORS: Dictionary[int, StringName] = {
	EditorState.Severity.INFO: &"font_color",
	EditorState.Severity.WARNING: &"warning_color",
	EditorState.Severity.ERROR: &"error_color",
}

## As a factor of the editor's font size.
const SMALL_FONT := 0.85

## Number of lines. A longer message is in the tooltip.
@export var lines := 1

var _state: EditorState
var _severity := EditorState.Severity.INFO
# The file of the message, or an empty text.
var _file := ""

@onready var _icon: TextureRect = %Icon
@onready var _text: Label = %Text
@onready var _show_file: LinkButton = %ShowFile
@onready var _work: HBoxContainer = %Work
@onready var _progress: ProgressBar = %Progress
@onready var _cancel: Button = %Cancel


## Shows the messages and the progress of [param state], or only what is about the wind.
func setup(state: EditorState, is_for_wind := false) -> void:
	_state = state
	_text.max_lines_visible = lines
	if is_for_wind:
		_state.wind_reported.connect(show_message)
	else:
		_state.reported.connect(show_message)
		_state.file_reported.connect(_offer_file)
		_state.work_changed.connect(_on_work_changed)
	_show_file.pressed.connect(_on_show_file_pressed)
	_cancel.pressed.connect(_on_cancel_pressed)
	_on_work_changed()
	show_message("", EditorState.Severity.INFO)
	_progress.custom_minimum_size.x *= EditorInterface.get_editor_scale()
	_keep_room()


## Shows [param text]. An empty text clears the line.
func show_message(text: String, severity: EditorState.Severity) -> void:
	_severity = severity
	_text.text = text
	_text.tooltip_text = text
	_icon.visible = not text.is_empty()
	_show_file.hide()
	_apply_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()


func _apply_theme() -> void:
	_icon.texture = get_theme_icon(ICONS[_severity], &"EditorIcons")
	var source := &"Label" if _severity == EditorState.Severity.INFO else &"Editor"
	var font_size := roundi(get_theme_font_size(&"font_size", &"Label") * SMALL_FONT)
	for control: Control in [_text, _show_file]:
		control.add_theme_font_size_override(&"font_size", font_size)
	_text.add_theme_color_override(&"font_color", get_theme_color(COLORS[_severity], source))
	_keep_room()


# The same height for every message, so that the controls above do not move.
func _keep_room() -> void:
	var font_size := _text.get_theme_font_size(&"font_size")
	var line := _text.get_theme_font(&"font").get_height(font_size)
	line += _text.get_theme_constant(&"line_spacing")
	var margins := _text.get_theme_stylebox(&"normal").get_minimum_size().y
	_text.custom_minimum_size.y = ceilf(line * _text.max_lines_visible + margins)


func _offer_file(path: String) -> void:
	_file = path
	_show_file.show()


func _on_show_file_pressed() -> void:
	var files := EditorInterface.get_file_system_dock()
	Front.bring(files)
	files.navigate_to_path(_file)


func _on_work_changed() -> void:
	_work.visible = _state.work_total > 0
	_progress.max_value = maxi(1, _state.work_total)
	_progress.value = _state.work_done
	_cancel.disabled = _state.work_cancelled
	if _work.visible and _text.text != _state.work_title:
		show_message(_state.work_title, EditorState.Severity.INFO)
	elif not _work.visible and _text.text == _state.work_title:
		show_message("", EditorState.Severity.INFO)


func _on_cancel_pressed() -> void:
	_state.cancel_work()
