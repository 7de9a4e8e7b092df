@tool
extends SubViewportContainer
## A rotating and swaying plant of a species at the detail of a near one, above the species'
## properties. A button shows several plants side by side.

const EditorState := preload("../editor_state.gd")
const Translations := preload("../translations/translations.gd")
const WindClock := preload("../wind_page/wind_clock.gd")

const SEGMENTS := EditorState.NEAR_SEGMENTS
## Seeds of the plants, from left to right.
const SEEDS: Array[int] = [1, 2, 3, 4]
## In pixels at 100 %.
const HEIGHT := 200.0
## Radians per second.
const TURN_RATE := 0.5
## Empty margin around the plant, as a fraction of the picture.
const MARGIN := 1.1
## Minimum breadth of a plant, as a fraction of its height.
const MIN_REACH := 0.3
## Distance of plants in a row, as a factor of their breadth to one side.
const ROW_GAP := 1.4
const LONGEST_FRAME := 0.1

## The shown species. Set it before the view enters the tree.
var function: PlantFunction

# A light breeze that belongs to this view.
var _breeze := PlantWind.new()
var _plants: Array[Plant3D] = []

@onready var _turntable: Node3D = %Turntable
@onready var _camera: Camera3D = %Camera
@onready var _problem: Label = %Problem
@onready var _seeds: Button = %Seeds


func _ready() -> void:
	set_translation_domain(Translations.DOMAIN)
	custom_minimum_size.y = HEIGHT * EditorInterface.get_editor_scale()
	_breeze.kind = PlantWind.KIND_WAVES
	_breeze.frequency = 0.4
	_breeze.direction = PI / 2.0
	_plants = [%Plant]
	_seeds.icon = get_theme_icon(&"RandomNumberGenerator", &"EditorIcons")
	resized.connect(_frame_plants)
	_seeds.toggled.connect(func(_on: bool) -> void: _on_function_changed())
	if function:
		function.changed.connect(_on_function_changed)
		_on_function_changed()


func _process(delta: float) -> void:
	if not _turntable.visible or not is_visible_in_tree():
		return
	var frame := minf(delta, LONGEST_FRAME)
	WindClock.advance(_breeze, frame)
	for plant in _plants:
		plant.rotate_y(TURN_RATE * frame)
		plant._preview(frame, _breeze)


func _on_function_changed() -> void:
	var found := function.find_problem(0.0, SEGMENTS, SEEDS[0])
	_problem.text = found
	_problem.visible = not found.is_empty()
	_turntable.visible = found.is_empty()
	if not found.is_empty():
		return
	_breeze.strength = _breeze_strength()
	_set_plant_count(SEEDS.size() if _seeds.button_pressed else 1)
	for i in _plants.size():
		_plants[i].segments = SEGMENTS
		_plants[i].seed = SEEDS[i]
		_plants[i].species = function
	_frame_plants()


func _set_plant_count(count: int) -> void:
	while _plants.size() > count:
		_plants.pop_back().queue_free()
	while _plants.size() < count:
		var plant := Plant3D.new()
		plant.simulation_enabled = false
		_turntable.add_child(plant)
		_plants.append(plant)


# A force that bends this plant visibly but not flat: a fraction of its weight.
func _breeze_strength() -> float:
	var weight := 1.0 if function.wind_weight < 0.0 else maxf(function.wind_weight, 0.1)
	return clampf(0.1 * function.mass * 9.81 / weight, 0.001, 10.0)


# In a row, with room to turn.
func _frame_plants() -> void:
	if not _plants[0].species:
		return
	var height := 0.0
	var reach := 0.0
	for plant in _plants:
		var box := plant.get_mesh().get_aabb()
		height = maxf(height, box.end.y)
		reach = maxf(
			reach, maxf(maxf(-box.position.x, box.end.x), maxf(-box.position.z, box.end.z))
		)
	reach = maxf(reach, height * MIN_REACH)
	for i in _plants.size():
		_plants[i].position.x = (i - (_plants.size() - 1) * 0.5) * reach * ROW_GAP
	var half_width := reach * (1.0 + (_plants.size() - 1) * 0.5 * ROW_GAP)
	var aspect := size.x / size.y if size.x > 0.0 and size.y > 0.0 else 1.0
	var half := maxf(height * 0.5, half_width / aspect) * MARGIN
	_camera.size = half * 2.0
	_camera.near = 0.01
	_camera.far = maxf(half, half_width) * 20.0
	var at := Vector3(0.0, height * 0.5, 0.0)
	var away := Vector3(0.0, 0.15, 1.0).normalized() * maxf(half, half_width) * 8.0
	_camera.look_at_from_position(at + away, at)
