extends PanelContainer
## Sets how long trodden plants take to rise, and lets walkers come and go.

const GROUP := &"path_walkers"

## The fields that are trodden.
@export var fields: Array[PlantField3D] = []
## The bodies that tread them.
@export var walkers: Array[Node3D] = []

@onready var _recovery: Slider = %Recovery
@onready var _value: Label = %Value
@onready var _walk: Button = %Walk


func _ready() -> void:
	for field in fields:
		for entry in field.species:
			entry.species = entry.species.duplicate() as PlantFunction
	_recovery.value_changed.connect(_set_recovery)
	_walk.toggled.connect(_let_walk)
	(%Camp as Button).pressed.connect(_make_camp)
	(%Rise as Button).pressed.connect(_raise)
	_set_recovery(_recovery.value)
	_let_walk(true)


func _set_recovery(seconds: float) -> void:
	_value.text = "%d s" % roundi(seconds)
	for field in fields:
		for entry in field.species:
			entry.species.recovery_time = seconds


func _let_walk(on: bool) -> void:
	for field in fields:
		field.bodies_group = GROUP if on else &""
	for walker in walkers:
		walker.visible = on
		walker.process_mode = Node.PROCESS_MODE_INHERIT if on else Node.PROCESS_MODE_DISABLED


func _make_camp() -> void:
	for field in fields:
		field.trample_in_sphere(Vector3(0.0, 0.0, 2.5), 1.2)


func _raise() -> void:
	for field in fields:
		field.trample_in_sphere(Vector3.ZERO, 50.0, 0.0)
