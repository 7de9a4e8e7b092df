## Each property that places plants has an effect, which ends with it, and is built once.
extends "res://tests/engine/field_harness.gd"

const CORNERS: Array[Vector3] = [Vector3(-2, 0, -2), Vector3(2, 0, -2), Vector3(0, 0, 2)]

var _builds := 0


func before_each() -> void:
	field = PlantField3D.from_species([GrassFunction.new(), ReedFunction.new()])
	field.size = Vector2(6, 5)
	field.density = 6.0
	field.clumping = 0.5
	field.simulation_enabled = false
	for entry in field.species:
		entry.lean_deviation = 0.2


func test_each_property_of_the_area_places_plants() -> void:
	var area := add_path("Area", CORNERS)
	var hole := add_path("Hole", CORNERS)
	await _begin()
	_check_value(&"size", Vector2(5, 6))
	_check_value(&"density", 7.0)
	_check_value(&"seed", 9)
	_check_value(&"clumping", 0.9)
	_check_value(&"clump_size", 1.5)
	_check_value(&"edge_falloff", 1.0)
	_check_value(&"exclusions", [hole])
	_check_value(&"outline", area)
	field.outline = area
	_check_value(&"outline_width", 0.5)
	field.exclusions = [hole]
	_check_value(&"exclusion_widths", PackedFloat32Array([0.5]))
	field.outline = NodePath()
	var map := PlantMap.new()
	map.paint(Vector3.ZERO, 1.5, "Grass", 1.0)
	_check_value(&"map", map)


func test_each_property_of_the_ground_places_plants() -> void:
	var slope := MeshInstance3D.new()
	slope.name = "Slope"
	slope.mesh = _make_slope(0.5)
	field.add_child(slope)
	var other := MeshInstance3D.new()
	other.name = "Other"
	other.mesh = _make_slope(-0.2)
	field.add_child(other)
	await _begin()
	field.ground_mesh = ^"Slope"
	_check_value(&"ground_mode", PlantField3D.GROUND_MESH)
	field.ground_mode = PlantField3D.GROUND_MESH
	_check_value(&"ground_mesh", ^"Other")
	_check_value(&"slope_alignment", 0.5)
	_check_value(&"height_limits", Vector2(-0.5, 0.5))
	_check_value(&"slope_limits", Vector2(0.0, 0.1))


func test_each_property_of_colliders_places_plants() -> void:
	var low := add_plate(20.0, 0.5)
	var high := add_plate(20.0, 2.0)
	high.collision_layer = 2
	field.ground_mode = PlantField3D.GROUND_COLLIDERS
	await physics_frames(2)
	await _begin()
	_check_value(&"ground_collision_mask", 2)
	field.ground_collision_mask = 3
	_check_value(&"ground_choice", PlantField3D.GROUND_LOWEST)
	field.build_now()
	for id in field.get_plant_ids():
		check_near(field.get_plant_transform(id).origin.y, 2.0, 1e-3, "the highest ground")
	low.free()
	high.free()


func test_each_property_of_an_entry_places_plants() -> void:
	await _begin()
	var entry := field.species[0]
	_check_value(&"weight", 3.0, entry)
	_check_value(&"density_factor", 0.5, entry)
	_check_value(&"scale_range", Vector2(0.5, 0.6), entry)
	_check_value(&"height_deviation", 0.4, entry)
	_check_value(&"lean_deviation", 0.5, entry)
	_check_value(&"species", TulipFunction.new(), entry)
	var map := PlantMap.new()
	map.paint(Vector3.ZERO, 1.0, "Reed", 1.0)
	field.map = map
	_check_value(&"layer", "Reed", entry)


func test_each_change_of_placement_is_built_once() -> void:
	await _begin()
	for values: Dictionary in [{density = 7.0}, {seed = 3}, {size = Vector2(4, 4), density = 5.0}]:
		_builds = 0
		for title: StringName in values:
			field.set(title, values[title])
		await rested()
		await frames(3)
		check_equal(_builds, 1, "signals after %s" % values)


func test_combed_plants_lean_the_same_way() -> void:
	for entry in field.species:
		entry.lean_deviation = 0.3
	field.combed = 0.0
	await _begin()
	var apart := _mean_lean().length()
	field.combed = 1.0
	field.build_now()
	var together := _mean_lean().length()
	check(together > 3.0 * apart, "mean lean of combed plants: %f, before %f" % [together, apart])


func _begin() -> void:
	await start()
	_builds = 0
	field.build_finished.connect(func() -> void: _builds += 1)


func _check_value(title: StringName, value: Variant, object: Object = field) -> void:
	check(field.build_now(), "%s: it can be built" % title)
	var before: Variant = object.get(title)
	var placed := _places()
	object.set(title, value)
	check(field.is_building(), "%s: a build is due" % title)
	check(field.build_now(), "%s: it is built" % title)
	check(_places() != placed, "%s places plants" % title)
	check(not field.is_building(), "%s: no build is due then" % title)
	object.set(title, before)
	check(field.build_now(), "%s: it is built again" % title)
	var back := _places()
	check(back[0] == placed[0] and back[1] == placed[1], "%s: the plants are back" % title)
	check(_distance(back[2], placed[2]) < 0.01, "%s: their tips are back" % title)


func _places() -> Array:
	var ids := sorted_ids()
	var species := Array(ids).map(field.get_plant_species)
	return [field.get_plant_transforms(ids), species, field.get_tip_positions(ids)]


func _distance(tips: PackedVector3Array, others: PackedVector3Array) -> float:
	var distance := 0.0
	for i in mini(tips.size(), others.size()):
		distance = maxf(distance, tips[i].distance_to(others[i]))
	return distance


func _mean_lean() -> Vector3:
	var sum := Vector3.ZERO
	for id in field.get_plant_ids():
		var up := relative_tip(id).normalized()
		sum += Vector3(up.x, 0.0, up.z)
	return sum / field.get_plant_count()


# A plane of 20 m that rises by this many metres per metre along x.
func _make_slope(rise: float) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for corner: Vector2 in [
		Vector2(-10, -10),
		Vector2(10, -10),
		Vector2(10, 10),
		Vector2(-10, -10),
		Vector2(10, 10),
		Vector2(-10, 10)
	]:
		tool.set_normal(Vector3(-rise, 1.0, 0.0).normalized())
		tool.add_vertex(Vector3(corner.x, rise * corner.x, corner.y))
	return tool.commit()
