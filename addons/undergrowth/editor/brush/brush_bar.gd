@tool
extends HBoxContainer
## The field's tools in the toolbar of the 3D view: the tools of the brush, and buttons to place the
## field on the ground, to save its map in tiles and to rebuild it.

## Emitted when the user requests a rebuild of the field.
signal fill_wanted
## Emitted when the user wants the field on the ground.
signal place_wanted
## Emitted when the user wants the field off the ground, or not any more.
signal flat_wanted(on: bool)
## Emitted when the user wants the field's map in files.
signal map_wanted

const BrushOptions := preload("brush_options.gd")
const Translations := preload("../translations/translations.gd")

## Icons of the editor, by tool.
const ICONS: Array[StringName] = [
	&"",
	&"Paint",
	&"Eraser",
	&"ExpandTree",
	&"RandomNumberGenerator",
	&"ColorPick",
	&"CurveInOut",
	&"CurveClose"
]
const FILL_ICON := &"Reload"
const PLACE_ICON := &"Snap"
const KEEP_ICON := &"Pin"
const MAP_ICON := &"Save"

var _options: BrushOptions

@onready var _tools: Array[Button] = [null, %Paint, %Erase, %Height, %Jitter, %Pick, %Trail, %Path]
@onready var _fill: Button = %Fill
@onready var _place: Button = %Place
@onready var _keep_flat: Button = %KeepFlat
@onready var _save_map: Button = %SaveMap


## Shows and changes [param options].
func setup(options: BrushOptions) -> void:
	_options = options
	set_translation_domain(Translations.DOMAIN)
	for tool in range(1, _tools.size()):
		_tools[tool].pressed.connect(_on_tool_pressed.bind(tool))
	_fill.pressed.connect(fill_wanted.emit)
	_place.pressed.connect(place_wanted.emit)
	_keep_flat.toggled.connect(flat_wanted.emit)
	_save_map.pressed.connect(map_wanted.emit)
	options.changed.connect(_show)
	_apply_theme()
	_show()


## Shows the field's ground: [param is_flat] without a ground mode, [param is_kept] so by the user.
func show_ground(is_flat: bool, is_kept: bool) -> void:
	_keep_flat.visible = is_flat
	_keep_flat.set_pressed_no_signal(is_kept)


## Shows the button to save the field's map in tiles if [param is_possible].
func offer_map(is_possible: bool) -> void:
	_save_map.visible = is_possible


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _options:
		_apply_theme()


func _on_tool_pressed(tool: int) -> void:
	var is_off := _options.tool == tool
	_options.tool = BrushOptions.Tool.NONE if is_off else tool as BrushOptions.Tool


func _show() -> void:
	for tool in range(1, _tools.size()):
		_tools[tool].set_pressed_no_signal(_options.tool == tool)


func _apply_theme() -> void:
	for tool in range(1, _tools.size()):
		_tools[tool].icon = get_theme_icon(ICONS[tool], &"EditorIcons")
	_fill.icon = get_theme_icon(FILL_ICON, &"EditorIcons")
	_place.icon = get_theme_icon(PLACE_ICON, &"EditorIcons")
	_save_map.icon = get_theme_icon(MAP_ICON, &"EditorIcons")
	_keep_flat.icon = get_theme_icon(KEEP_ICON, &"EditorIcons")
