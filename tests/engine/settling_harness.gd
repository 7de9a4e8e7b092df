## Base of the engine tests that wait for fields. Scripts without the add-on have the harness alone.
extends "res://tests/engine/harness.gd"


## Waits until all that was told to [param field] just now is seen, or refused.
func settled(field: PlantField3D) -> void:
	await frames(2)
	await until(is_settled.bind(field), "the field is seen")
	await frames(2)


## Whether nothing of the field is being filled or made ready to be drawn.
func is_settled(field: PlantField3D) -> bool:
	return not field.is_building() and not field.get_statistics()["is_rebuilding_meshes"]
