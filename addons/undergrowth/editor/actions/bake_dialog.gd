@tool
extends ConfirmationDialog
## The dialog for the options of a bake.

## Emitted when the user confirms complete options.
signal accepted(options: BakeOptions)

const BakeOptions := preload("bake_options.gd")
const FolderField := preload("folder_field.gd")
const Hint := preload("hint.gd")
const SIZE := Vector2i(480, 410)

@onready var _title: LineEdit = %Title
@onready var _folder: FolderField = %Folder
@onready var _height: EditorSpinSlider = %Height
@onready var _variants: EditorSpinSlider = %Variants
@onready var _seed: EditorSpinSlider = %Seed
@onready var _levels: LineEdit = %Levels
@onready var _meshes: CheckBox = %Meshes
@onready var _scene: CheckBox = %Scene
@onready var _model: CheckBox = %Model
@onready var _hint: Hint = %Hint


func _ready() -> void:
	if is_part_of_edited_scene():
		return
	for line: LineEdit in [_title, _levels]:
		register_text_enter(line)
		line.text_changed.connect(func(_text: String) -> void: _check())
	for box: Range in [_height, _variants, _seed]:
		box.value_changed.connect(func(_value: float) -> void: _check())
	for choice: CheckBox in [_meshes, _scene, _model]:
		choice.toggled.connect(func(_on: bool) -> void: _check())
	_folder.changed.connect(_check)
	confirmed.connect(_on_confirmed)


## Opens the dialog for a plant called [param title]. The other options stay as last chosen.
func open(title: String) -> void:
	_title.text = title
	_check()
	popup_centered(Vector2i(Vector2(SIZE) * EditorInterface.get_editor_scale()))
	_title.grab_focus()
	_title.select_all()


## Returns the chosen options.
func get_options() -> BakeOptions:
	var options := BakeOptions.new()
	options.title = _title.text
	options.folder = _folder.folder
	options.height = _height.value
	options.variants = roundi(_variants.value)
	options.first_seed = roundi(_seed.value)
	options.read_levels(_levels.text)
	options.with_meshes = _meshes.button_pressed
	options.with_scene = _scene.button_pressed
	options.with_model = _model.button_pressed
	return options


func _check() -> void:
	var options := get_options()
	var problem := options.find_problem()
	get_ok_button().disabled = not problem.is_empty()
	if not problem.is_empty():
		_hint.show_problem(problem)
		return
	var count := options.count_files()
	var ends := options.get_ends()
	var names := ends[0].get_file()
	if count > 1:
		names = tr("%s to %s") % [names, ends[1].get_file()]
	_hint.show_text(tr_n("%d file: %s", "%d files: %s", count) % [count, names])


func _on_confirmed() -> void:
	if not get_ok_button().disabled:
		accepted.emit(get_options())
