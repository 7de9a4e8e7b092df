@tool
extends RefCounted
## What kind of plant a species is.


## True where the stem of the four functions grows.
static func has_stem(function: PlantFunction) -> bool:
	return function.has_stem and not function.has_method(&"_grow")


## True where leaves, petals and other parts grow, with or without such a stem.
static func has_parts(function: PlantFunction) -> bool:
	return not function.arrangements.is_empty() or function.has_method(&"_grow")
