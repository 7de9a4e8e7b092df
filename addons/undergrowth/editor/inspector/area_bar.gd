@tool
extends HBoxContainer
## Buttons at the top of a field's inspector for its area: rectangle, path, or painted.

const AreaModes := preload("../field/area_modes.gd")
const Translations := preload("../translations/translations.gd")
## Icons of the editor, by mode.
const ICONS: Array[StringName] = [&"ReferenceRect", &"Path3D", &"Paint"]

var _field: PlantField3D
var _buttons: Array[Button] = []


## Shows and changes the area of [param field].
func setup(field: PlantField3D) -> void:
	_field = field
	name = "AreaBar"
	set_translation_domain(Translations.DOMAIN)
	add_theme_constant_override(&"separation", 0)
	_add(tr("Rectangle"), tr("Plants grow in a rectangle around the field's origin."))
	_add(tr("Path"), tr("Plants grow inside the outline of a Path3D, or along it with a width."))
	_add(tr("Painted"), tr("Plants grow where the map is painted with the brush."))
	_show()


func _notification(what: int) -> void:
	if what == NOTIFICATION_ENTER_TREE or what == NOTIFICATION_THEME_CHANGED:
		for i in _buttons.size():
			_buttons[i].icon = get_theme_icon(ICONS[i], &"EditorIcons")


# The brush and undo change the area, too.
func _process(_delta: float) -> void:
	if is_instance_valid(_field):
		_show()


func _add(title: String, hint: String) -> void:
	var button := Button.new()
	button.text = title
	button.tooltip_text = hint
	button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	button.toggle_mode = true
	button.size_flags_horizontal = SIZE_EXPAND_FILL
	for state: StringName in [&"icon_pressed_color", &"icon_hover_pressed_color"]:
		button.add_theme_color_override(state, Color.WHITE)  # These icons have colours.
	button.pressed.connect(_on_pressed.bind(_buttons.size()))
	_buttons.append(button)
	add_child(button)


func _on_pressed(mode: AreaModes.Mode) -> void:
	AreaModes.choose(EditorInterface.get_editor_undo_redo(), _field, mode)
	_show()


func _show() -> void:
	var mode := AreaModes.find(_field)
	for i in _buttons.size():
		_buttons[i].set_pressed_no_signal(i == mode)
