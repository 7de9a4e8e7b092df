@tool
extends RefCounted
## Densities of a field's species: those of the mix, and the maximum of the field. All densities are
## in plants per square metre in the field's own axes.


## Returns the density of the species called [param title] in the mix.
static func of_mix(field: PlantField3D, title: String) -> float:
	var shares := 0.0
	var own := 0.0
	for entry in field.species:
		if entry:
			shares += entry.weight
			if entry.get_layer_name() == title:
				own += entry.weight * entry.density_factor
	return field.density * own / shares if shares > 0.0 else 0.0


## Returns the total density of the species called [param titles].
static func sum_of_mix(field: PlantField3D, titles: PackedStringArray) -> float:
	var sum := 0.0
	for title in titles:
		sum += of_mix(field, title)
	return sum


## Divides [param density] among [param titles] in the proportions of the mix. Divides equally if
## the mix contains none of them.
static func divide(
	field: PlantField3D, titles: PackedStringArray, density: float
) -> PackedFloat64Array:
	var whole := sum_of_mix(field, titles)
	var parts: PackedFloat64Array = []
	for title in titles:
		var part := of_mix(field, title) / whole if whole > 0.0 else 1.0 / titles.size()
		parts.append(density * part)
	return parts


## Returns the density of the species called [param title] at [param point], in the own axes of
## [param field]: that of its map, or without a map that of its area.
static func at(field: PlantField3D, title: String, point: Vector3) -> float:
	if not field.map:
		var corners: PackedVector2Array = []
		for corner in field.get_outline_points():
			corners.append(Vector2(corner.x, corner.z))
		var place := Vector2(point.x, point.z)
		return of_mix(field, title) if Geometry2D.is_point_in_polygon(place, corners) else 0.0
	var share := field.map.get_density(point, title)
	return share * of_mix(field, title) + field.map.get_plant_density(point, title)
