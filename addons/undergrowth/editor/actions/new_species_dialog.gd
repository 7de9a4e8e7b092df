@tool
extends ConfirmationDialog
## The dialog for the name and the folder of a new species.

## Emitted when the user confirms a valid name and folder.
signal accepted(title: String, folder: String)

const SpeciesTemplate := preload("species_template.gd")
const FileNames := preload("file_names.gd")
const FolderField := preload("folder_field.gd")
const Hint := preload("hint.gd")
const SIZE := Vector2i(460, 170)

@onready var _title: LineEdit = %Title
@onready var _folder: FolderField = %Folder
@onready var _hint: Hint = %Hint


func _ready() -> void:
	if is_part_of_edited_scene():
		return
	register_text_enter(_title)
	_title.text_changed.connect(func(_text: String) -> void: _check())
	_folder.changed.connect(_check)
	confirmed.connect(_on_confirmed)


## Opens the dialog with an empty name.
func open() -> void:
	_title.clear()
	_check()
	popup_centered(Vector2i(Vector2(SIZE) * EditorInterface.get_editor_scale()))
	_title.grab_focus()


## Shows [param problem] and stays open.
func refuse(problem: String) -> void:
	_hint.show_problem(problem)


func _check() -> void:
	var problem := SpeciesTemplate.find_problem(_title.text, _folder.folder)
	get_ok_button().disabled = not problem.is_empty()
	if problem.is_empty():
		var path := SpeciesTemplate.path_of(_title.text, _folder.folder)
		_hint.show_text(
			tr("Makes the class %s in %s.") % [FileNames.to_class_title(_title.text), path]
		)
	elif _title.text.is_empty():
		_hint.show_text(tr("Makes a script with the four functions of a plant, ready to change."))
	else:
		_hint.show_problem(problem)


func _on_confirmed() -> void:
	if not get_ok_button().disabled:
		accepted.emit(_title.text, _folder.folder)
