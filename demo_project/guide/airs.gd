extends "sheet.gd"
## What air of several speeds does to grass, wheat and poppies, without its gusts.

const WINDS: Array[String] = ["calm", "breeze", "fresh", "gale", "storm"]


func _fill(row: HBoxContainer) -> void:
	for file in WINDS:
		var wind := (load("res://addons/undergrowth/winds/%s.tres" % file) as PlantWind).duplicate()
		wind.direction = PI / 2.0
		wind.turbulence = 0.0  # Else a storm may be in a lull just now.
		var title := "%s, %s m/s" % [file.capitalize(), String.num(wind.speed, 1)]
		var world := add_cell(row, title, Vector3(0.0, 1.0, 2.8), Vector3(0.0, 0.42, 0.0), 36.0)
		var files: Dictionary[String, float] = {"meadow_grass": 8.0, "wheat": 2.0, "poppy": 1.0}
		var field := make_field(files, 45.0, Vector2(3.2, 2.6))
		field.wind = wind
		world.add_child(field)
