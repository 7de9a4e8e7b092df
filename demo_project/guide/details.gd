extends "sheet.gd"
## A poppy with fewer and fewer segments, and what each has of vertices.

const COUNTS: Array[int] = [64, 12, 6, 3, 2]


func _fill(row: HBoxContainer) -> void:
	for segments in COUNTS:
		var plant := Plant3D.new()
		plant.species = load_species("poppy")
		plant.segments = segments
		plant.seed = 2
		var count := plant.get_mesh().surface_get_array_len(0)
		var title := "%d segments\n%d vertices" % [segments, count]
		var from := Vector3(0.0, 0.55, 1.6)
		add_cell(row, title, from, Vector3(0.0, 0.24, 0.0), 28.0).add_child(plant)
