## Fields of the same species share meshes, and have different seeds of positions.
extends "res://tests/engine/settling_harness.gd"

## Sixteen variants in the first level, eight in the second.
const MESHES := 24
## Tolerance for other objects.
const TOLERANCE := 6

var _fields: Array[PlantField3D] = []


func after_each() -> void:
	for field in _fields:
		field.free()
	_fields.clear()


func test_fields_of_one_species_and_seed_share_their_meshes() -> void:
	var species := TulipFunction.new()
	await _count_added(_make(species))  # Shared shaders and similar objects exist from here on.
	var same := await _count_added(_make(species))
	var other := _make(species)
	other.seed = 5
	var another := await _count_added(other)
	check_near(another - same, MESHES, TOLERANCE, "meshes that a field of another seed adds")


func test_fields_that_begin_in_one_frame_share_their_meshes() -> void:
	var species := TulipFunction.new()
	await _count_added(_make(species))
	var own := await _count_added(_make(species))  # Materials; the meshes exist.
	var three: Array[PlantField3D] = []
	for i in 3:
		three.append(_make(species))
		three.back().seed = 5
	var before := _objects()
	for field in three:
		_add(field)
	await _all_built()
	check_near(_objects() - before, 3 * own + MESHES, 3 * TOLERANCE, "objects of three fields")


func test_a_changed_species_changes_all_of_its_fields_and_frees_the_old_meshes() -> void:
	var species := TulipFunction.new()
	_add(_make(species))
	_add(_make(species))
	await _all_built()
	await frames(20)
	var before := _objects()
	species.shape_deviation = 0.4
	await frames(2)
	await _all_built()
	await frames(60)
	check_equal(_objects(), before, "resources after both have other meshes")


func test_meshes_are_freed_with_the_last_field() -> void:
	var species := TulipFunction.new()
	_add(_make(species))
	await _all_built()
	_drop_all()
	await frames(5)
	var before := _objects()
	for i in 3:
		_add(_make(species))
	await _all_built()
	_drop_all()
	await frames(5)
	check_equal(_objects(), before, "resources without a field")


func test_a_seed_of_the_place_gives_each_place_a_layout_of_its_own() -> void:
	for x: float in [0.0, 20.0, 20.0, 0.0]:
		var field := _make(GrassFunction.new())
		field.seed = -1
		field.position.x = x
		_add(field)
	_fields[3].seed = 0
	await _all_built()
	var layouts: Array[PackedVector3Array] = []
	for field in _fields:
		layouts.append(_roots(field))
	check(layouts[0] != layouts[1], "two places differ")
	check_equal(layouts[1], layouts[2], "one place, one layout")
	check(layouts[0] != layouts[3], "it is not seed 0")


func test_a_moved_field_keeps_its_layout_until_it_is_built_again() -> void:
	var field := _make(GrassFunction.new())
	field.seed = -1
	_add(field)
	await _all_built()
	var before := _roots(field)
	field.position = Vector3(7, 0, 3)
	await frames(20)
	check_equal(_roots(field), before, "the layout after a move")
	field.rebuild()
	await _all_built()
	check(_roots(field) != before, "built again it is that of the new place")
	var moved := _roots(field)
	field.clumping = 0.5
	await _all_built()
	field.clumping = 0.0
	await _all_built()
	check_equal(_roots(field), moved, "the same place, the same layout")


func _make(species: PlantFunction) -> PlantField3D:
	var field := PlantField3D.from_species([species])
	field.species[0].variants = 16
	field.density = 5.0
	field.size = Vector2(5, 5)
	field.levels = [PlantFieldLevel.of(6, 9.0), PlantFieldLevel.of(2)]
	return field


func _add(field: PlantField3D) -> void:
	_fields.append(field)
	root.add_child(field)


func _drop_all() -> void:
	for field in _fields:
		field.free()
	_fields.clear()


## Returns the number of additional objects after the build.
func _count_added(field: PlantField3D) -> int:
	var before := _objects()
	_add(field)
	await _all_built()
	return _objects() - before


func _all_built() -> void:
	await process_frame
	while not _fields.all(is_settled):
		await process_frame
	await frames(10)


func _objects() -> int:
	return int(Performance.get_monitor(Performance.OBJECT_COUNT))


func _roots(field: PlantField3D) -> PackedVector3Array:
	var roots := PackedVector3Array()
	for id in field.get_plant_ids():
		roots.append(field.get_plant_transform(id).origin)
	roots.sort()
	return roots
