extends "sheet.gd"
## Ivy on a wall: by itself, along a drawn path, and its leaves from near.

const WALL := Vector3(6.0, 2.6, 0.3)
const BRICKS := preload("res://stage/brick_wall.gdshader")
## Degrees: from the upper left.
const SUN := Vector3(-42.0, -38.0, 0.0)


func _fill(row: HBoxContainer) -> void:
	_add_wall(row, "by itself", Vector3(1.0, 1.6, 4.4), Vector3(0.0, 1.25, 0.0), 40.0, [])
	var path := PackedVector3Array(
		[Vector3(0.2, 1.2, 0.0), Vector3(1.2, 1.75, 0.0), Vector3(2.6, 1.7, 0.0)]
	)
	_add_wall(row, "along a path", Vector3(0.6, 1.7, 4.4), Vector3(0.1, 1.3, 0.0), 40.0, path)
	_add_wall(row, "leaves", Vector3(0.15, 0.98, 0.6), Vector3(0.02, 1.0, 0.0), 40.0, [])


func _add_wall(
	row: HBoxContainer,
	title: String,
	from: Vector3,
	at: Vector3,
	degrees: float,
	path: PackedVector3Array
) -> void:
	var world := add_cell(row, title, from, at, degrees)
	(world.get_node("Sun") as Node3D).rotation_degrees = SUN
	var wall := MeshInstance3D.new()
	wall.mesh = BoxMesh.new()
	(wall.mesh as BoxMesh).size = WALL
	var bricks := ShaderMaterial.new()
	bricks.shader = BRICKS
	wall.material_override = bricks
	wall.position = Vector3(0.0, 0.5 * WALL.y, -0.5 * WALL.z)
	world.add_child(wall)
	var ivy := PlantClimber3D.new()
	ivy.position = Vector3(0.0 if path.is_empty() else -1.4, -0.5 * WALL.y, 0.5 * WALL.z)
	ivy.seed = 3
	ivy.path = path
	ivy.shoots = 5 if path.is_empty() else 2
	ivy.length = 2.8 if path.is_empty() else 5.0
	ivy.branching = 6.0
	wall.add_child(ivy)
