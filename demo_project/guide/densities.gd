extends "sheet.gd"
## How many tufts of meadow grass on a square metre look like what.

const DENSITIES: Array[float] = [4.0, 15.0, 40.0, 100.0]


func _fill(row: HBoxContainer) -> void:
	for density in DENSITIES:
		var from := Vector3(0.0, 1.6, 5.0)
		var world := add_cell(row, "%d / m²" % density, from, Vector3(0.0, 0.0, 0.5), 36.0)
		world.add_child(make_field({"meadow_grass": 1.0}, density, Vector2(9.0, 9.0)))
