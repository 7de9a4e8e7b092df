extends "sheet.gd"
## What a game does with a field: a body walks through it, it is mown, a rotor blows on it.

const FILES: Dictionary[String, float] = {"meadow_grass": 30.0, "oxeye_daisy": 1.0}
const FROM := Vector3(0.0, 3.4, 4.4)
const WALKERS := &"guide_walkers"

var _mown: PlantField3D


func _fill(row: HBoxContainer) -> void:
	_walk(add_cell(row, "bodies_group", FROM, Vector3.ZERO, 44.0))
	_mown = make_field(FILES, 40.0, Vector2(5.5, 5.5))
	add_cell(row, "remove_along", FROM, Vector3.ZERO, 44.0).add_child(_mown)
	_mown.build_finished.connect(_mow)
	_add_wind(add_cell(row, "PlantWindSource3D", FROM, Vector3.ZERO, 44.0))


func _walk(world: Node3D) -> void:
	var field := make_field(FILES, 40.0, Vector2(5.5, 5.5))
	field.bodies_group = WALKERS
	for place: Vector3 in [Vector3(-1.0, 0.5, 0.3), Vector3(1.1, 0.5, -0.4)]:
		var ball := MeshInstance3D.new()
		ball.mesh = SphereMesh.new()
		var shape := CollisionShape3D.new()
		shape.shape = SphereShape3D.new()
		ball.add_child(shape)
		ball.add_to_group(WALKERS)
		ball.position = place
		world.add_child(ball)
	world.add_child(field)


func _mow() -> void:
	var way: PackedVector3Array = []
	for i in 40:
		way.append(Vector3(0.15 * i - 3.0, 0.0, sin(0.2 * i) * 1.4))
	_mown.remove_along(way, 0.9)


func _add_wind(world: Node3D) -> void:
	var field := make_field(FILES, 40.0, Vector2(5.5, 5.5))
	field.wind = PlantWind.new()
	field.wind.strength = 0.0
	world.add_child(field)
	var rotor := PlantWindSource3D.new()
	rotor.kind = PlantWindSource3D.KIND_FAN
	rotor.radius = 1.0
	rotor.thrust = 15000.0
	rotor.position.y = 2.0
	world.add_child(rotor)
