extends Node3D
## Three fields side by side: every plant moves by itself, each fourth of them does in a frame, or
## 64 of each species do and all other plants follow them. A label in front shows the cost.

const Figures := preload("res://ui/figures.gd")
const PERIOD := 0.25  # s between two looks.
const SMOOTHING := 0.3

## The fields, the one whose cost is 100 % first.
@export var fields: Array[PlantField3D] = []
## What is written in front of each field.
@export var labels: Array[Label3D] = []
## The first line of each label.
@export var titles: PackedStringArray = []

var _costs: PackedFloat32Array = []
var _wait := 0.0  # s.


func _ready() -> void:
	_costs.resize(fields.size())


func _process(delta: float) -> void:
	_wait -= delta
	if _wait > 0.0:
		return
	_wait = PERIOD
	for index in fields.size():
		_show(index, fields[index].get_statistics())


func _show(index: int, figures: Dictionary) -> void:
	var cost: float = figures["step_usec"] + figures["upload_usec"]
	var is_first := _costs[index] == 0.0
	_costs[index] = cost if is_first else lerpf(_costs[index], cost, SMOOTHING)
	var share := 100.0 * _costs[index] / maxf(_costs[0], 0.1)
	labels[index].text = (
		"%s\n%s of %s simulated\n%s a frame, %d %%"
		% [
			titles[index],
			Figures.as_count(figures["simulated"]),
			Figures.as_count(figures["plants"]),
			Figures.as_time(_costs[index]),
			roundi(share),
		]
	)
