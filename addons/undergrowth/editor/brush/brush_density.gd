@tool
extends RefCounted
## How densely a field grows its species: what the mix gives each of them, and what the field has
## room for. All densities are in plants per square metre of the field's own axes.


## The density that the mix gives the species called [param title].
static func of_mix(field: PlantField3D, title: String) -> float:
	var shares := 0.0
	var own := 0.0
	for entry in field.species:
		if entry:
			shares += entry.weight
			if entry.get_layer_name() == title:
				own += entry.weight * entry.density_factor
	return field.density * own / shares if shares > 0.0 else 0.0


## The density of all species called [param titles] together.
static func sum_of_mix(field: PlantField3D, titles: PackedStringArray) -> float:
	var sum := 0.0
	for title in titles:
		sum += of_mix(field, title)
	return sum


## Divides [param density] among [param titles] as the mix does: a density for each. Where the mix
## has none of them, all get the same.
static func divide(
	field: PlantField3D, titles: PackedStringArray, density: float
) -> PackedFloat64Array:
	var whole := sum_of_mix(field, titles)
	var parts: PackedFloat64Array = []
	for title in titles:
		var part := of_mix(field, title) / whole if whole > 0.0 else 1.0 / titles.size()
		parts.append(density * part)
	return parts


## The density that the map of [param field] wants of the species called [param title] at
## [param point], in the field's own axes.
static func at(field: PlantField3D, title: String, point: Vector3) -> float:
	var share := field.map.get_density(point, title)
	return share * of_mix(field, title) + field.map.get_plant_density(point, title)
