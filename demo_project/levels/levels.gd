extends Node3D
## Two species in several levels of detail, a row of each.

const ROW_DEPTH := 2.6

## The species, one for each row.
@export var species: Array[PlantFunction] = []
## What each row is called.
@export var row_names: PackedStringArray = []
## The levels of detail, from left to right.
@export var levels: PackedInt32Array = [4, 8, 16, 32]
## Metres between two plants of a row.
@export_range(0.2, 5.0, 0.05, "suffix:m") var gap := 1.5
## Height that every plant is scaled to.
@export_range(0.1, 5.0, 0.05, "suffix:m") var height := 1.7
## The wind that moves them.
@export var wind: PlantWind


func _ready() -> void:
	for row in species.size():
		for column in levels.size():
			var x := (column - (levels.size() - 1) / 2.0 + row * 0.5) * gap
			_add_plant(row, levels[column], Vector3(x, 0.0, -row * ROW_DEPTH))
		_write(
			row_names[row],
			Vector3((row - levels.size()) * 0.5 * gap, 0.5 * height, -row * ROW_DEPTH)
		)


func _add_plant(row: int, segments: int, place: Vector3) -> void:
	var plant := Plant3D.new()
	plant.species = species[row]
	plant.wind = wind
	plant.segments = segments
	plant.position = place
	add_child(plant)
	plant.scale = Vector3.ONE * height / plant.get_plant_height()
	var triangles := _count_triangles(plant.get_mesh())
	var text := "%d segments\n%d triangles" % [segments, triangles]
	# The front row is named at its feet and the back row over its heads: no text hides a plant.
	var beside := Vector3(0.0, 0.2, 0.55) if row == 0 else Vector3(0.0, height + 0.25, 0.0)
	_write(text, place + beside)


func _count_triangles(mesh: ArrayMesh) -> int:
	return mesh.surface_get_array_index_len(0) / 3


func _write(text: String, place: Vector3) -> void:
	var label := Label3D.new()
	label.text = text
	label.position = place
	label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
	label.pixel_size = 0.0032
	label.font_size = 40
	label.outline_size = 10
	label.modulate = Color(0.96, 0.97, 0.93)
	label.outline_modulate = Color(0.1, 0.12, 0.1, 0.85)
	add_child(label)
