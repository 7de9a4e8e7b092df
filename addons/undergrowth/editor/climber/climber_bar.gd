@tool
extends HBoxContainer
## Buttons at the top of a climber's inspector: grow again, another seed, and a path on the wall.

const ClimberPathTool := preload("climber_path_tool.gd")
const ClimberSteps := preload("climber_steps.gd")
const Translations := preload("../translations/translations.gd")

var _climber: PlantClimber3D
var _tool: ClimberPathTool
var _draw: Button
var _clear: Button


## Shows and changes [param climber]. [param path_tool] draws its path.
func setup(climber: PlantClimber3D, path_tool: ClimberPathTool) -> void:
	_climber = climber
	_tool = path_tool
	name = "ClimberBar"
	set_translation_domain(Translations.DOMAIN)
	_add(&"Grow", tr("Grow"), tr("Grows the plant again on the present walls."), _grow)
	_add(&"Another", tr("Another"), tr("Grows another plant: a new seed."), _grow_another)
	var hint := tr("Drag over the wall, or click points and press Enter. Escape ends it.")
	_draw = _add(&"DrawPath", tr("Draw Path"), hint, _draw_path)
	_draw.toggle_mode = true
	_clear = _add(&"ClearPath", tr("Clear Path"), tr("The plant grows by itself."), _clear_path)
	_show()


# Undo and the tool change the path, too.
func _process(_delta: float) -> void:
	_show()


func _add(id: StringName, title: String, hint: String, act: Callable) -> Button:
	var button := Button.new()
	button.name = id
	button.text = title
	button.tooltip_text = hint
	button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	button.size_flags_horizontal = SIZE_EXPAND_FILL
	button.clip_text = true
	button.pressed.connect(act)
	add_child(button)
	return button


func _show() -> void:
	if is_instance_valid(_climber) and _draw:
		_draw.set_pressed_no_signal(_tool.is_on and _tool.get_climber() == _climber)
		_clear.disabled = _climber.path.is_empty()


func _grow() -> void:
	_climber.rebuild()


func _grow_another() -> void:
	ClimberSteps.change_seed(EditorInterface.get_editor_undo_redo(), _climber, _climber.seed + 1)


func _draw_path() -> void:
	_tool.edit(_climber)
	_tool.is_on = not _tool.is_on


func _clear_path() -> void:
	ClimberSteps.change_path(EditorInterface.get_editor_undo_redo(), _climber, PackedVector3Array())
