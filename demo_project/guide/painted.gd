extends "sheet.gd"
## Where plants grow: a rectangle, an outline with a trail, what is painted.

const FILES: Dictionary[String, float] = {"meadow_grass": 20.0, "poppy": 1.0}
const FROM := Vector3(0.0, 7.0, 9.0)
const EXTENT := Vector2(8.0, 8.0)


func _fill(row: HBoxContainer) -> void:
	_add_world(row, "size").add_child(make_field(FILES, 25.0, EXTENT))
	_fill_outline(_add_world(row, "outline and exclusions"))
	_fill_map(_add_world(row, "map"))


func _add_world(row: HBoxContainer, title: String) -> Node3D:
	return add_cell(row, title, FROM, Vector3(0.0, 0.0, 0.4), 48.0)


func _fill_outline(world: Node3D) -> void:
	var pond: Array[Vector3] = []
	var bed: Array[Vector3] = []
	for i in 24:
		var ray := Vector3.RIGHT.rotated(Vector3.UP, TAU * i / 24.0)
		bed.append(ray * (3.6 + 0.5 * sin(TAU * i / 8.0)))
		pond.append(ray * 1.1 + Vector3(0.8, 0.0, 0.4))
	var field := make_field(FILES, 25.0, EXTENT)
	world.add_child(_make_path("Bed", bed))
	world.add_child(_make_path("Pond", pond))
	field.outline = ^"../Bed"
	field.exclusions = [^"../Pond"] as Array[NodePath]
	world.add_child(field)


func _make_path(title: String, points: Array[Vector3]) -> Path3D:
	var path := Path3D.new()
	path.name = title
	path.curve = Curve3D.new()
	for point in points:
		path.curve.add_point(point)
	return path


func _fill_map(world: Node3D) -> void:
	var field := make_field(FILES, 25.0, EXTENT)
	field.species[1].density_factor = 8.0
	var map := PlantMap.new()
	var grass := field.species[0].get_layer_name()
	var poppies := field.species[1].get_layer_name()
	for i in 12:
		var place := Vector3(0.55 * i - 3.0, 0.0, 2.0 * sin(0.6 * i))
		map.paint(place, 1.2, grass, 0.8)
	map.paint(Vector3(1.6, 0.0, -1.4), 1.6, poppies, 1.0)
	map.paint(Vector3(1.6, 0.0, -1.4), 1.6, grass, 0.5)
	field.map = map
	world.add_child(field)
