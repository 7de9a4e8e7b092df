extends MeshInstance3D
## A butterfly that flits over the flowers round its place: up and down, now here, now there.

## How far from its place it goes.
@export_range(0.5, 20.0, 0.1, "suffix:m") var range_radius := 3.0
## Between the ground and it, on the mean.
@export_range(0.1, 3.0, 0.05, "suffix:m") var flight_height := 0.9
## How fast it flits.
@export_range(0.1, 3.0, 0.05) var haste := 0.5
## What it flies over: a node with a `height_at(x, z)` method.
@export var ground: Node3D

var _noise := FastNoiseLite.new()
var _time := 0.0

@onready var _home := global_position


func _ready() -> void:
	_noise.seed = hash(name)
	_noise.frequency = 0.25
	_time = _noise.seed % 100
	_fly(0.0)


func _process(delta: float) -> void:
	_fly(delta)


func _fly(delta: float) -> void:
	_time += delta * haste
	var before := global_position
	var x := _home.x + _noise.get_noise_2d(_time, 0.0) * 2.0 * range_radius
	var z := _home.z + _noise.get_noise_2d(0.0, _time) * 2.0 * range_radius
	var low := float(ground.call(&"height_at", x, z)) if ground else 0.0
	var bob := 0.12 * sin(_time * 9.0) + 0.5 * _noise.get_noise_2d(_time * 2.0, 50.0)
	global_position = Vector3(x, low + maxf(0.2, flight_height + bob), z)
	var way := (global_position - before) * Vector3(1.0, 0.0, 1.0)
	if way.length_squared() > 1e-8:
		global_basis = Basis.looking_at(way.normalized(), Vector3.UP)
