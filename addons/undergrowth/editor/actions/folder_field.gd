@tool
extends HBoxContainer
## A field to type or choose a folder of the project.

## Emitted when the folder changed.
signal changed

## The folder, without a trailing slash except for res:// itself.
var folder: String:
	get:
		return _clean(_path.text)
	set(value):
		_path.text = value

var _chooser: EditorFileDialog

@onready var _path: LineEdit = %Path
@onready var _browse: Button = %Browse


func _ready() -> void:
	_path.text_changed.connect(func(_text: String) -> void: changed.emit())
	_browse.pressed.connect(_on_browse_pressed)
	_apply_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()


func _apply_theme() -> void:
	_browse.icon = get_theme_icon(&"Folder", &"EditorIcons")


func _clean(text: String) -> String:
	var path := text.strip_edges().replace("\\", "/")
	return path if path == "res://" else path.rstrip("/")


func _on_browse_pressed() -> void:
	if not _chooser:
		_chooser = EditorFileDialog.new()
		_chooser.file_mode = EditorFileDialog.FILE_MODE_OPEN_DIR
		_chooser.access = EditorFileDialog.ACCESS_RESOURCES
		_chooser.dir_selected.connect(_on_folder_chosen)
		add_child(_chooser)
	_chooser.current_dir = folder
	_chooser.popup_file_dialog()


func _on_folder_chosen(path: String) -> void:
	_path.text = path
	changed.emit()
