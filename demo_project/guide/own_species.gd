extends "sheet.gd"
## Species of one's own: parts step by step, a script of four functions, curves.

const Tuft := preload("tuft.gd")
const Foxtail := preload("res://script_species/foxtail.gd")
const TITLES: Array[String] = ["blades", "and culms", "and spikelets"]


func _fill(row: HBoxContainer) -> void:
	for i in TITLES.size():
		var tuft := Tuft.new()
		tuft.steps = i + 1
		_add_plant(row, TITLES[i], tuft)
	_add_plant(row, "four functions", Foxtail.new())
	_add_plant(row, "curves", _make_thistle())


func _add_plant(row: HBoxContainer, title: String, species: PlantFunction) -> void:
	var from := Vector3(0.0, 0.75, 2.0)
	var world := add_cell(row, title, from, Vector3(0.0, 0.32, 0.0), 30.0)
	var plant := Plant3D.new()
	plant.species = species
	plant.segments = 40
	plant.seed = 3
	world.add_child(plant)


func _make_thistle() -> CurvePlantFunction:
	var thistle := CurvePlantFunction.new()
	thistle.radius = 0.04
	thistle.width_curve = Curve.new()
	for point: Vector2 in [Vector2(0.0, 0.2), Vector2(0.8, 0.15), Vector2(0.9, 1.0), Vector2(1, 0)]:
		thistle.width_curve.add_point(point)
	thistle.color_gradient = Gradient.new()
	thistle.color_gradient.set_color(0, Color.DARK_OLIVE_GREEN)
	thistle.color_gradient.set_color(1, Color.MEDIUM_ORCHID)
	return thistle
