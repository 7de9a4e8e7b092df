@tool
extends Node3D
## A sheep, of spheres: wool, a dark head and four legs that trot as fast as it goes.

const WOOL_BALLS := 46
const STRIDE := 0.55  # m.

@export var wool: Material
@export var skin: Material

var _legs: Array[Node3D] = []
var _before := Vector3.ZERO
var _walked := 0.0


func _ready() -> void:
	var woolly: Array[Transform3D] = [_ball(Vector3(0.0, 0.94, 0.44), Vector3(0.11, 0.08, 0.1))]
	for index in WOOL_BALLS:
		woolly.append(_wool_ball(index))
	var dark: Array[Transform3D] = [_ball(Vector3(0.0, 0.83, 0.53), Vector3(0.1, 0.11, 0.17), 0.5)]
	for side: float in [-1.0, 1.0]:
		var ear := Vector3(0.14 * side, 0.87, 0.44)
		dark.append(_ball(ear, Vector3(0.075, 0.022, 0.035), 0.0, 0.35 * side))
		for end: float in [-1.0, 1.0]:
			_add_leg(Vector3(0.13 * side, 0.42, 0.24 * end))
	_add_balls(wool, woolly)
	_add_balls(skin, dark)
	_before = global_position


func _process(delta: float) -> void:
	var way := (global_position - _before) * Vector3(1.0, 0.0, 1.0)
	_before = global_position
	_walked += way.length()
	var swing := clampf(way.length() / maxf(delta, 1e-4), 0.0, 1.0) * 0.45
	for index in _legs.size():
		var beat := 0.0 if index in [0, 3] else PI
		_legs[index].rotation.x = swing * sin(_walked * TAU / STRIDE + beat)


## Balls of wool, evenly over an ellipsoid: after Vogel, as florets in a head.
func _wool_ball(index: int) -> Transform3D:
	var up := 1.0 - 2.0 * (index + 0.5) / WOOL_BALLS
	var turn := index * 2.39996
	var ring := sqrt(1.0 - up * up)
	var place := Vector3(ring * cos(turn) * 0.21, 0.66 + up * 0.19, ring * sin(turn) * 0.36)
	return _ball(place, Vector3.ONE * (0.115 + 0.02 * sin(index * 7.0)))


func _ball(place: Vector3, radii: Vector3, pitch := 0.0, roll := 0.0) -> Transform3D:
	return Transform3D(Basis.from_euler(Vector3(pitch, 0.0, roll)).scaled_local(radii), place)


func _add_leg(hip: Vector3) -> void:
	var leg := Node3D.new()
	leg.position = hip
	add_child(leg, false, INTERNAL_MODE_BACK)
	_legs.append(leg)
	var shank := CapsuleMesh.new()
	shank.radius = 0.042
	shank.height = 0.46
	shank.radial_segments = 10
	var drawn := MeshInstance3D.new()
	drawn.mesh = shank
	drawn.material_override = skin
	drawn.position.y = -0.2
	leg.add_child(drawn)


## All in one draw.
func _add_balls(material: Material, places: Array[Transform3D]) -> void:
	var ball := SphereMesh.new()
	ball.radius = 1.0
	ball.height = 2.0
	ball.radial_segments = 14
	ball.rings = 8
	var balls := MultiMesh.new()
	balls.transform_format = MultiMesh.TRANSFORM_3D
	balls.mesh = ball
	balls.instance_count = places.size()
	for index in places.size():
		balls.set_instance_transform(index, places[index])
	var drawn := MultiMeshInstance3D.new()
	drawn.multimesh = balls
	drawn.material_override = material
	add_child(drawn, false, INTERNAL_MODE_BACK)
