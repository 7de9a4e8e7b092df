extends Plant3D
## A stem on whose tip alone a load presses that grows and goes again, so slowly that the stem
## always rests. It bends as the elastica does; the load is given in units of its stiffness.

const PERIOD := 30.0  # s.
const HEAVIEST := 6.0
## Newtons that bend so little that the tip's slope is in proportion to them.
const LIGHT := 1e-3
const SETTLING := 600  # Steps.

## Load times length squared over stiffness, α of the elastica.
var load_now := 0.0

var _newtons := 0.0  # Of α = 1.
var _time := 0.0  # s.


func _ready() -> void:
	wind = PlantWind.new()
	wind.kind = PlantWind.KIND_CONSTANT
	wind.direction = PI / 2.0
	_weigh()


func _process(delta: float) -> void:
	_time += delta
	load_now = HEAVIEST * 0.5 * (1.0 - cos(TAU * _time / PERIOD))
	wind.strength = load_now * _newtons


## Radians between the stem's end and upright.
func get_tip_angle() -> float:
	return get_deflection()


## The tip beside and above the root, in lengths of the stem.
func get_tip_place() -> Vector2:
	var tip := get_tip_position() / get_plant_height()
	return Vector2(tip.x, tip.y)


## Finds out how stiff the stem is: the slope of the tip under a light load is half of α.
func _weigh() -> void:
	wind.strength = LIGHT
	simulation_enabled = false
	for step in SETTLING:
		advance(1.0 / 60.0)
	_newtons = LIGHT * 0.5 / tan(get_deflection())
	simulation_enabled = true
	reset_motion()
