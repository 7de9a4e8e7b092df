## Base of the engine tests of air: nodes that are freed with their test, and light grass on
## springs.
extends "res://tests/engine/harness.gd"

var _nodes: Array[Node] = []


func after_each() -> void:
	for node in _nodes:
		node.free()
	_nodes.clear()


func _add(node: Node) -> void:
	_nodes.append(node)
	root.add_child(node)


func _species() -> PlantFunction:
	var species := GrassFunction.new()
	species.law = PlantFunction.LAW_SPRING
	species.lean = 0.0
	species.mass = 0.01
	species.wind_weight = 0.02
	species.natural_frequency = 1.5
	species.damping_ratio = 0.4
	return species
