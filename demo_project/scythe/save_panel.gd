extends PanelContainer
## Saves what was mown of a field, and brings it back: by its buttons, or the keys F5 and F9.
##
## C cuts the plants around the mower at the root; they do not grow back.

const FILE := "user://field.save"
const SWING := 2.5  # m.

## The field that is saved.
@export var field: PlantField3D
## The mower.
@export var mower: Node3D

@onready var _message: Label = %Message
@onready var _load: Button = %Load


func _ready() -> void:
	(%Save as Button).pressed.connect(_save)
	(%Cut as Button).pressed.connect(_cut)
	_load.pressed.connect(_bring_back)
	_load.disabled = not FileAccess.file_exists(FILE)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"save_field"):
		_save()
	elif event.is_action_pressed(&"load_field") and not _load.disabled:
		_bring_back()
	elif event.is_action_pressed(&"cut_plants"):
		_cut()


func _save() -> void:
	var bytes := field.get_changes()
	var file := FileAccess.open(FILE, FileAccess.WRITE)
	if file == null or not file.store_buffer(bytes):
		_message.text = "could not be written"
		return
	_load.disabled = false
	_message.text = "saved in %.1f KiB" % (bytes.size() / 1024.0)


func _bring_back() -> void:
	var is_sound := field.apply_changes(FileAccess.get_file_as_bytes(FILE))
	_message.text = "as it was saved" if is_sound else "the file is damaged"


func _cut() -> void:
	var ahead := mower.global_position - mower.global_basis.z * SWING
	_message.text = "%d plants cut" % field.remove_in_sphere(ahead, SWING)
