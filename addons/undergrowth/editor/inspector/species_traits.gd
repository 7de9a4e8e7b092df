@tool
extends RefCounted
## Tests for the kind of a species.


## True if the species has the stem of the four functions.
static func has_stem(function: PlantFunction) -> bool:
	return function.has_stem and not has_models(function) and not function.has_method(&"_grow")


## True if the species has leaves, petals or other parts, with or without such a stem.
static func has_parts(function: PlantFunction) -> bool:
	return not function.arrangements.is_empty() or function.has_method(&"_grow")


## True if the plants are meshes of the user.
static func has_models(function: PlantFunction) -> bool:
	return function is MeshPlantFunction
