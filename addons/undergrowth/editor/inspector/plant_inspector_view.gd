@tool
extends SubViewportContainer
## A rotating and swaying plant of a species, above the species' properties.

const Translations := preload("../translations/translations.gd")
const WindClock := preload("../wind_page/wind_clock.gd")

const SEGMENTS := 16
const PLANT_SEED := 1
## Radians per second.
const TURN_RATE := 0.5
## Empty margin around the plant, as a fraction of the picture.
const MARGIN := 1.25
const LONGEST_FRAME := 0.1

## The shown species. Set it before the view enters the tree.
var function: PlantFunction

# A light breeze that belongs to this view.
var _breeze := PlantWind.new()

@onready var _turntable: Node3D = %Turntable
@onready var _camera: Camera3D = %Camera
@onready var _plant: Plant3D = %Plant
@onready var _problem: Label = %Problem


func _ready() -> void:
	set_translation_domain(Translations.DOMAIN)
	custom_minimum_size.y = 150.0 * EditorInterface.get_editor_scale()
	_breeze.kind = PlantWind.KIND_WAVES
	_breeze.frequency = 0.4
	_breeze.direction = PI / 2.0
	if function:
		function.changed.connect(_on_function_changed)
		_on_function_changed()


func _process(delta: float) -> void:
	if not _plant.visible or not is_visible_in_tree():
		return
	var frame := minf(delta, LONGEST_FRAME)
	_turntable.rotate_y(TURN_RATE * frame)
	WindClock.advance(_breeze, frame)
	_plant._preview(frame, _breeze)


func _on_function_changed() -> void:
	var found := function.find_problem(0.0, SEGMENTS, PLANT_SEED)
	_problem.text = found
	_problem.visible = not found.is_empty()
	_plant.visible = found.is_empty()
	if not found.is_empty():
		return
	_breeze.strength = _breeze_strength()
	_plant.segments = SEGMENTS
	_plant.seed = PLANT_SEED
	_plant.species = function
	_frame_plant()


# A force that bends this plant visibly but not flat: a fraction of its weight.
func _breeze_strength() -> float:
	var weight := 1.0 if function.wind_weight < 0.0 else maxf(function.wind_weight, 0.1)
	return clampf(0.1 * function.mass * 9.81 / weight, 0.001, 10.0)


func _frame_plant() -> void:
	var box := _plant.get_mesh().get_aabb()
	var half_height := box.size.y / 2.0
	var half_width := maxf(maxf(absf(box.position.x), absf(box.end.x)), box.size.y * 0.3)
	var reach := maxf(half_height, half_width) * MARGIN
	_camera.size = reach * 2.0
	_camera.near = 0.01
	_camera.far = reach * 20.0
	var at := Vector3(0.0, box.get_center().y, 0.0)
	_camera.position = at + Vector3(0.0, 0.15, 1.0).normalized() * reach * 8.0
	_camera.look_at_from_position(_camera.position, at)
