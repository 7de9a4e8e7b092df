@tool
extends HFlowContainer
## Controls for height, seed and level of detail of the shown plant.

const PreviewView := preload("preview_view.gd")

var _view: PreviewView

@onready var _height: EditorSpinSlider = %Height
@onready var _seed: EditorSpinSlider = %Seed
@onready var _segments: EditorSpinSlider = %Segments
@onready var _dice: Button = %Dice


## Shows and changes [param view].
func setup(view: PreviewView) -> void:
	_view = view
	_segments.value = view.segments
	_seed.value = view.first_seed
	_height.value = view.height
	_height.value_changed.connect(func(metres: float) -> void: _view.height = metres)
	_seed.value_changed.connect(func(number: float) -> void: _view.first_seed = int(number))
	_segments.value_changed.connect(func(number: float) -> void: _view.segments = int(number))
	_dice.pressed.connect(func() -> void: _seed.value += 1)
	for slider: Control in [_height, _seed, _segments]:
		slider.custom_minimum_size.x *= EditorInterface.get_editor_scale()
	_translate()
	_apply_theme()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and is_node_ready():
		_apply_theme()
	elif what == NOTIFICATION_TRANSLATION_CHANGED and is_node_ready():
		_translate()


# These sliders do not translate their labels themselves.
func _translate() -> void:
	_height.label = tr("Height")
	_seed.label = tr("Seed")
	_segments.label = tr("Segments")


func _apply_theme() -> void:
	_dice.icon = get_theme_icon(&"RandomNumberGenerator", &"EditorIcons")
