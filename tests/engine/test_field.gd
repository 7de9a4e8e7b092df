## Fields: what they are made of, saved and loaded, and wrong values.
extends "res://tests/engine/harness.gd"

var _field: PlantField3D


func before_each() -> void:
	_field = _make_field()


func after_each() -> void:
	if is_instance_valid(_field):
		_field.free()


func test_the_number_of_plants_is_density_times_area() -> void:
	await _fill()
	check_near(_field.get_plant_count(), 2000, 100.0)


func test_a_field_without_area_or_density_is_empty() -> void:
	_field.density = 0.0
	await _fill()
	check_equal(_field.get_plant_count(), 0)
	await frames(3)


func test_one_plant() -> void:
	_field.species = [] as Array[PlantFunction]
	root.add_child(_field)
	_field.add_plants([Transform3D(Basis.IDENTITY, Vector3(1, 2, 3))], TulipFunction.new())
	check_equal(_field.get_plant_count(), 1)
	await frames(3)
	check_equal(_field.get_plant_transform(0).origin, Vector3(1, 2, 3))
	var height := _field.get_plant_height(0)
	check_near(_field.get_tip_position(0).distance_to(Vector3(1, 2, 3)), height, 1e-4)


func test_a_hundred_thousand_plants() -> void:
	_field.size = Vector2(100, 100)
	_field.density = 10.0
	_field.species = [
		GrassFunction.new(),
		ReedFunction.new(),
		CattailFunction.new(),
		TulipFunction.new(),
		BellflowerFunction.new()
	]
	_field.variants = 8
	await _fill()
	check_near(_field.get_plant_count(), 100000, 1000.0)
	await frames(5)
	var told := _field.get_statistics()
	check_equal(told["simulated"], _field.get_plant_count())
	check(told["bytes_per_plant"] <= 96.0, "at most 96 bytes a plant: %s" % told["bytes_per_plant"])


func test_the_same_seed_gives_the_same_field() -> void:
	await _fill()
	var other := _make_field()
	root.add_child(other)
	await _filled(other)
	check_equal(_described(other), _described(_field), "the other field")
	other.seed = 5
	await _filled(other)
	check(_described(other) != _described(_field), "another seed gives another field")
	other.free()


func test_a_saved_field_is_the_same_when_it_is_loaded() -> void:
	_field.shares = PackedFloat32Array([3, 1])
	_field.seed = 7
	_field.area = _make_curve([Vector3(-5, 0, -5), Vector3(5, 0, -5), Vector3(0, 0, 6)])
	_field.exclusions = [_make_curve([Vector3(-1, 0, -1), Vector3(1, 0, -1), Vector3(0, 0, 1)])]
	_field.wind = PlantWind.new()
	_field.levels = PackedInt32Array([8, 2])
	_field.level_distances = PackedFloat32Array([9.0])
	_field.bodies_group = &"walkers"
	await _fill()
	var scene := PackedScene.new()
	check_equal(scene.pack(_field), OK, "packing")
	var path := "user://field.tscn"
	check_equal(ResourceSaver.save(scene, path), OK, "saving")
	var text := FileAccess.get_file_as_string(path)
	check(text.length() < 4000 and not text.contains("Mesh"), "parameters are saved, no meshes")
	var loaded: PlantField3D = (
		(ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE) as PackedScene)
		. instantiate()
	)
	root.add_child(loaded)
	await _filled(loaded)
	check_equal(_described(loaded), _described(_field), "the loaded field")
	check_equal(loaded.bodies_group, &"walkers")
	check_equal(loaded.levels, PackedInt32Array([8, 2]))
	loaded.free()
	DirAccess.remove_absolute(path)


func test_shares_decide_between_species() -> void:
	_field.shares = PackedFloat32Array([0.0, 1.0])
	await _fill()
	for i: int in range(0, _field.get_plant_count(), 97):
		check_equal(_field.get_plant_function(i), _field.species[1], "species of plant %d" % i)


func test_plants_stand_inside_the_area_and_outside_exclusions() -> void:
	_field.area = _make_curve(
		[Vector3(0, 0, 0), Vector3(10, 0, 0), Vector3(10, 0, 10), Vector3(0, 0, 10)]
	)
	_field.exclusions = [
		_make_curve([Vector3(4, 0, 4), Vector3(6, 0, 4), Vector3(6, 0, 6), Vector3(4, 0, 6)])
	]
	var path := _make_field()
	path.size = Vector2(2, 2)
	path.position = Vector3(1, 0, 1)
	root.add_child(path)
	path.name = "Path"
	root.add_child(_field)
	_field.excluded_fields = [NodePath("../Path")]
	await _filled(_field)
	check_near(_field.get_plant_count(), 5 * (100 - 4 - 4), 40.0)
	for i in _field.get_plant_count():
		var place := _field.get_plant_transform(i).origin
		var at := Vector2(place.x, place.z)
		check(Rect2(0, 0, 10, 10).has_point(at), "%s is inside the area" % at)
		check(not Rect2(4, 4, 2, 2).has_point(at), "%s is outside the exclusion" % at)
		check(not Rect2(0, 0, 2, 2).has_point(at), "%s is outside the other field" % at)
	path.free()


func test_a_new_field_without_species_is_no_error() -> void:
	_field.species = [] as Array[PlantFunction]
	root.add_child(_field)
	await frames(3)
	check_equal(_field.get_plant_count(), 0)


func test_an_empty_species_is_one_error_and_the_field_stays() -> void:
	await _fill()
	var before := _described(_field)
	_field.species = [GrassFunction.new(), null]
	await frames(3)
	check_error("species[1] is empty")
	check_equal(_described(_field), before, "the field")
	_field.species = [] as Array[PlantFunction]
	await frames(3)
	check_error("has no species")
	check_equal(_described(_field), before, "the field")


func test_shares_of_0_are_one_error() -> void:
	await _fill()
	_field.shares = PackedFloat32Array([0, 0])
	await frames(3)
	check_error("share")
	check(_field.get_plant_count() > 0, "the field stays")


func test_an_area_of_nothing_is_one_error() -> void:
	await _fill()
	_field.area = _make_curve([Vector3.ZERO, Vector3.RIGHT])
	await frames(3)
	check_error("PlantField3D")
	check(_field.get_plant_count() > 0, "the field stays")
	_field.area = null
	_field.size = Vector2.ZERO
	await frames(3)
	check_error("PlantField3D")


func test_absurd_densities_are_refused() -> void:
	await _fill()
	_field.density = NAN
	check_error("density")
	_field.density = -1.0
	check_error("density")
	_field.density = 1e9
	check_error("density")
	check_equal(_field.density, 5.0)
	_field.size = Vector2(1000, 1000)
	await frames(3)
	check_error("plants")
	check_near(_field.get_plant_count(), 2000, 100.0, "plants that stay")


func test_wrong_numbers_keep_the_old_value() -> void:
	var wrong := {
		"variants": 0,
		"update_interval": 0,
		"prototypes": 65,
		"threads": -1,
		"chunk_size": 0.0,
		"clumping": 1.5,
		"height_deviation": NAN,
		"wind_speed": -1.0,
		"scale_range": Vector2(2, 1),
		"levels": PackedInt32Array([0]),
		"level_distances": PackedFloat32Array([5, 5]),
		"fade_margin": INF,
		"ground": 9,
	}
	for property: String in wrong:
		var before: Variant = _field.get(property)
		_field.set(property, wrong[property])
		check_error(property)
		check_equal(_field.get(property), before, property)


func test_ground_is_what_a_mesh_says() -> void:
	var hill := MeshInstance3D.new()
	var plane := PlaneMesh.new()
	plane.size = Vector2(10, 10)
	hill.mesh = plane
	hill.rotation.z = 0.3
	hill.position.y = 2.0
	hill.name = "Hill"
	root.add_child(hill)
	root.add_child(_field)
	_field.ground = PlantField3D.GROUND_MESH
	_field.ground_mesh = NodePath("../Hill")
	await _filled(_field)
	check_near(_field.get_plant_count(), 5 * 10 * 10 * cos(0.3), 40.0)
	for i in _field.get_plant_count():
		var place := _field.get_plant_transform(i).origin
		check_near(place.y, 2.0 + place.x * tan(0.3), 1e-3, "height at %s" % place)
	_field.slope_limits_degrees = Vector2(0, 10)
	await _filled(_field)
	check_equal(_field.get_plant_count(), 0, "plants on too steep a slope")
	hill.free()


func test_plants_lean_with_the_ground() -> void:
	var hill := MeshInstance3D.new()
	hill.mesh = PlaneMesh.new()
	(hill.mesh as PlaneMesh).size = Vector2(10, 10)
	hill.rotation.z = 0.4
	hill.name = "Hill"
	root.add_child(hill)
	_field.ground_mesh = NodePath("../Hill")
	_field.ground = PlantField3D.GROUND_MESH
	_field.lean_deviation_degrees = 0.0
	_field.simulating = false
	for function: PlantFunction in _field.species:
		function.law = PlantFunction.LAW_SPRING
		function.lean_degrees = 0.0
	await _fill()
	check_near(_field_axis(5), Vector3.UP, 1e-3, "a plant without alignment")
	_field.slope_alignment = 1.0
	await _filled(_field)
	for i: int in range(0, _field.get_plant_count(), 17):
		check_near(_field_axis(i), hill.basis.y, 2e-3, "axis of plant %d" % i)
	_field.slope_alignment = 0.5
	await _filled(_field)
	check_near(_field_axis(5), Vector3.UP.rotated(Vector3.BACK, 0.2), 5e-3, "half an alignment")
	hill.free()


func test_added_plants_keep_their_turn_and_their_tilt() -> void:
	_field.species = [] as Array[PlantFunction]
	_field.simulating = false
	root.add_child(_field)
	var function := TulipFunction.new()
	function.law = PlantFunction.LAW_SPRING
	function.lean_degrees = 0.0
	var tilt := Basis(Vector3(1, 0, 2).normalized(), 0.6)
	_field.add_plants([Transform3D(tilt * Basis(Vector3.UP, 1.3), Vector3(1, 2, 3))], function)
	await frames(2)
	check_near(_field_axis(0), tilt.y, 1e-3, "axis")
	check_near(_field.get_plant_transform(0).basis.z, Basis(Vector3.UP, 1.3).z, 1e-3, "front")


func test_ground_is_what_rays_hit() -> void:
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	var box := BoxShape3D.new()
	box.size = Vector3(8, 2, 8)
	shape.shape = box
	body.add_child(shape)
	body.position.y = 0.5
	root.add_child(body)
	await physics_frames(2)
	root.add_child(_field)
	_field.ground = PlantField3D.GROUND_COLLIDERS
	await _filled(_field)
	check_near(_field.get_plant_count(), 5 * 8 * 8, 30.0)
	for i in _field.get_plant_count():
		check_near(_field.get_plant_transform(i).origin.y, 1.5, 1e-3, "height")
	_field.height_limits = Vector2(2, 5)
	await _filled(_field)
	check_equal(_field.get_plant_count(), 0, "plants below the limit")
	body.free()


func test_filling_tells_how_far_it_is() -> void:
	var told: Array[float] = []
	_field.filling_progressed.connect(func(share: float) -> void: told.append(share))
	_field.size = Vector2(60, 60)
	await _fill()
	check(not told.is_empty() and told[-1] == 1.0, "it ends with 1: %s" % [told])
	var sorted := told.duplicate()
	sorted.sort()
	check_equal(told, sorted, "progress")


func test_the_old_field_stays_until_the_new_one_stands() -> void:
	await _fill()
	var count := _field.get_plant_count()
	_field.density = 1.0
	check_equal(_field.get_plant_count(), count, "plants at once")
	check(_field.is_filling(), "it fills")
	await _filled(_field)
	check_near(_field.get_plant_count(), 400, 50.0, "plants then")


func _fill() -> void:
	root.add_child(_field)
	await _filled(_field)


## A signal's sender must not be freed while it sends.
func _filled(field: PlantField3D) -> void:
	await field.filled
	await process_frame


## The direction from a plant's root to its tip.
func _field_axis(index: int) -> Vector3:
	var at := _field.get_plant_transform(index).origin
	return (_field.get_tip_position(index) - at).normalized()


func _make_field() -> PlantField3D:
	var field := PlantField3D.new()
	field.species = [GrassFunction.new(), TulipFunction.new()]
	field.density = 5.0
	return field


func _make_curve(points: Array[Vector3]) -> Curve3D:
	var curve := Curve3D.new()
	for point in points:
		curve.add_point(point)
	return curve


func _described(field: PlantField3D) -> Array:
	var told := [field.get_plant_count()]
	for i: int in range(0, field.get_plant_count(), 13):
		told.append_array(
			[field.get_plant_transform(i), field.get_plant_height(i), field.get_plant_seed(i)]
		)
	return told
