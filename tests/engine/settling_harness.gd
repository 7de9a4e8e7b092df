## Base of the engine tests that wait for fields. Scripts without the add-on use the harness alone.
extends "res://tests/engine/harness.gd"


## Waits until [param field] has applied or rejected all changes.
func settled(field: PlantField3D) -> void:
	await frames(2)
	await until(is_settled.bind(field), "the field is seen")
	await frames(2)


## True if no part of the field is being built or prepared for drawing.
func is_settled(field: PlantField3D) -> bool:
	return not field.is_building() and not field.get_statistics()["is_rebuilding_meshes"]
