## The shipped ground: the far ground has the colour of far plants, bare ground has not, and every
## material is drawn.
extends "res://tests/engine/picture_harness.gd"

const GROUNDS := "res://addons/undergrowth/grounds/"
const Ground3D := preload("res://addons/undergrowth/grounds/ground_3d.gd")
const DAY := preload("res://addons/undergrowth/environments/day.tscn")
## Of CIE 1976.
const SAME_COLOR := 2.0
const SIZE := Vector2i(320, 180)
## Metres: the field's far end, and the camera's height.
const END := 40.0
const HEIGHT := 4.0
## Of a field that ends near the camera, and of a person. The colours of near plants vary more.
const NEAR_END := 12.0
const NEAR_HEIGHT := 1.7
const NEAR_COLOR := 7.5
## Deviation of the lightness of the ground, as a share of that of the plants.
const MIN_DETAIL := 0.35
## Of the distant field on one side of a border of its planes: deviation of the lightness, as a
## share of that on the other side.
const MIN_EVENNESS := 0.75

var _ground: MeshInstance3D


func after_each() -> void:
	stage.free()


func test_ground_beyond_the_last_plants_continues_their_colour() -> void:
	var grounds: Dictionary[String, String] = {
		"mixes/meadow.tscn": "meadow",
		"species/wheat.tres": "field_soil",
		"mixes/fern_floor.tscn": "forest_floor",
	}
	for file in grounds:
		await _make_stage(file, grounds[file])
		var shown := await picture()
		var plants := _mean(shown, END - 7.0, END - 2.0)
		var beyond := _mean(shown, END + 8.0, END + 20.0)
		var apart := plants.distance_to(beyond)
		check(apart <= SAME_COLOR, "%s: %.1f between %s and %s" % [file, apart, plants, beyond])
		stage.free()
	make_stage()


func test_the_end_of_a_near_field_is_no_line() -> void:
	var grounds: Dictionary[String, String] = {
		"mixes/meadow.tscn": "meadow",
		"mixes/lawn.tscn": "lawn",
		"mixes/fern_floor.tscn": "forest_floor",
		"mixes/wheat_field.tscn": "field_soil"
	}
	for file in grounds:
		await _make_stage(file, grounds[file], NEAR_END, NEAR_HEIGHT)
		var shown := await picture()
		var plants := _mean(shown, NEAR_END - 2.5, NEAR_END - 0.5)
		# Plants hide the ground behind the field's end.
		var beyond := _mean(shown, NEAR_END + 7.0, NEAR_END + 14.0)
		var apart := plants.distance_to(beyond)
		check(apart <= NEAR_COLOR, "%s: %.1f between %s and %s" % [file, apart, plants, beyond])
		var detail := _deviation(shown, NEAR_END + 7.0, NEAR_END + 14.0)
		var own := _deviation(shown, NEAR_END - 2.5, NEAR_END - 0.5)
		check(detail > MIN_DETAIL * own, "%s: detail %.1f beyond %.1f" % [file, detail, own])
		stage.free()
	make_stage()


func test_the_distant_field_has_no_flat_bands() -> void:
	await _show_far_field(2.0)
	var camera := stage.get_camera_3d()
	camera.fov = 15.0
	camera.look_at_from_position(Vector3(0.0, 6.0, 0.0), Vector3(0.0, 0.0, -17.0))
	# From 17.6 m on, twice as far apart planes are drawn.
	var shown := await picture()
	var nearer := _deviation(shown, 15.0, 17.0)
	var farther := _deviation(shown, 18.5, 20.5)
	var evenness := minf(nearer, farther) / maxf(nearer, farther)
	check(evenness > MIN_EVENNESS, "%.2f: %.1f and %.1f" % [evenness, nearer, farther])


func test_the_far_field_starts_on_each_side_of_the_plants() -> void:
	var material := await _show_far_field(1000.0)
	var camera := stage.get_camera_3d()
	camera.fov = 28.0
	camera.look_at_from_position(Vector3(0.0, 6.0, 0.0), Vector3(0.0, 0.0, -20.0))
	material.set_shader_parameter(&"field_bounds", Vector4(-200.0, -200.0, 400.0, 400.0))
	var bare := await picture()
	material.set_shader_parameter(&"field_bounds", Vector4(-200.0, -30.0, 400.0, 10.0))
	var shown := await picture()
	for side: Vector2 in [Vector2(12.0, 17.0), Vector2(34.0, 45.0)]:
		var apart := _mean(shown, side.x, side.y).distance_to(_mean(bare, side.x, side.y))
		check(apart > 5.0, "plants %.0f m away: %.1f" % [side.x, apart])
	var inside := _mean(shown, 23.0, 27.0).distance_to(_mean(bare, 23.0, 27.0))
	check(inside < 1.0, "no far plants between them: %.1f" % inside)


func test_bare_ground_shows_where_the_field_ends() -> void:
	await _make_stage("species/meadow_grass.tres", "field_soil")
	var field: PlantField3D = _ground.get(&"field")
	var shown := await picture()
	var continued := _mean(shown, END + 8.0, END + 20.0)
	var before := _mean(shown, END - 7.0, END - 2.0)
	Ground3D.apply_density(_ground.material_override as ShaderMaterial, field)
	(_ground.material_override as ShaderMaterial).set_shader_parameter(&"field_beyond", 0.0)
	shown = await picture()
	var bare := _mean(shown, END + 8.0, END + 20.0)
	check(continued.distance_to(bare) > 8.0, "the ground has no plants beyond the field")
	var plants := _mean(shown, END - 7.0, END - 2.0)
	check(plants.distance_to(before) <= 2.0 * SAME_COLOR, "the field: %s, %s" % [plants, before])


func test_each_material_is_drawn_and_differs_from_the_others() -> void:
	await _make_stage("")
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(Vector3(0.0, 0.6, 0.0), Vector3(0.0, 0.0, -0.5))
	var means: Dictionary[String, Vector3] = {}
	for file in DirAccess.get_files_at(GROUNDS):
		if file.get_extension() != "tres":
			continue
		_ground.material_override = load(GROUNDS + file)
		var shown := await picture()
		means[file] = _mean_of(shown, 0, SIZE.y)
		check(means[file].x > 8.0 and means[file].x < 75.0, "%s: %s" % [file, means[file]])
		check(_contrast(shown) > 1.5, "%s has details" % file)
	check(means.size() >= 5, "%d materials" % means.size())
	for one in means:
		for other in means:
			if one < other:
				var apart := means[one].distance_to(means[other])
				check(apart > 1.5, "%s and %s are alike: %.1f" % [one, other, apart])


func test_a_layer_lies_over_another_material() -> void:
	await _make_stage("")
	var camera := stage.get_camera_3d()
	camera.look_at_from_position(Vector3(0.0, 0.6, 0.0), Vector3(0.0, 0.0, -0.5))
	var own := StandardMaterial3D.new()
	own.albedo_color = Color(0.1, 0.1, 0.8)
	var layer := (
		(load(GROUNDS + "forest_floor.tres") as ShaderMaterial).duplicate() as ShaderMaterial
	)
	layer.shader = load(GROUNDS + "ground_layer.gdshader")
	layer.set_shader_parameter(&"litter", 0.4)
	own.next_pass = layer
	_ground.material_override = own
	var shown := await picture()
	var blue := 0
	var brown := 0
	for y in range(0, SIZE.y, 2):
		for x in range(0, SIZE.x, 2):
			var color := shown.get_pixel(x, y)
			blue += 1 if color.b > 2.0 * color.r else 0
			brown += 1 if color.r > 1.2 * color.b else 0
	check(blue > 500 and brown > 500, "%d pixels of the material, %d of litter" % [blue, brown])


# A field of a species or mix [param file] in front of the camera, on ground to the horizon.
func _make_stage(
	file: String, ground: String = "meadow", end: float = END, height: float = HEIGHT
) -> void:
	stage = SubViewport.new()
	stage.size = SIZE
	stage.own_world_3d = true
	stage.render_target_update_mode = SubViewport.UPDATE_DISABLED
	root.add_child(stage)
	var day := DAY.instantiate()
	var environment: WorldEnvironment = day.get_node(^"Environment")
	environment.environment = environment.environment.duplicate()
	environment.environment.fog_enabled = false
	stage.add_child(day)
	var camera := Camera3D.new()
	camera.fov = 12.0 if end == END else 30.0
	stage.add_child(camera)
	camera.look_at_from_position(Vector3(0, height, 0), Vector3(0, 0, -end))
	_ground = MeshInstance3D.new()
	_ground.set_script(Ground3D)
	var plane := PlaneMesh.new()
	plane.size = Vector2(400, 400)
	plane.material = load(GROUNDS + ground + ".tres")
	_ground.mesh = plane
	if file:
		var resource := load("res://addons/undergrowth/" + file)
		var field: PlantField3D
		if resource is PackedScene:
			field = (resource as PackedScene).instantiate()
		else:
			field = PlantField3D.from_species([resource as PlantFunction])
			field.density = 30.0
		field.size = Vector2(12, minf(26.0, end - 2.0))
		field.simulation_enabled = false
		field.position.z = -end + 0.5 * field.size.y
		stage.add_child(field)
		_ground.set(&"field", field)
	stage.add_child(_ground)
	for i in 2:
		await process_frame  # Draws nothing.


# Makes a stage with ground only, where plants of 0.8 m start at a distance. Returns its material.
func _show_far_field(distance: float) -> ShaderMaterial:
	await _make_stage("")
	var material := (load(GROUNDS + "field_soil.tres") as ShaderMaterial).duplicate()
	material.set_shader_parameter(&"field_height", 0.8)
	material.set_shader_parameter(&"field_distance", distance)
	_ground.material_override = material
	return material


# The mean colour (L*a*b*) of the ground between two distances.
func _mean(shown: Image, from: float, to: float) -> Vector3:
	var camera := stage.get_camera_3d()
	var near := camera.unproject_position(Vector3(0, 0, -from)).y
	var far := camera.unproject_position(Vector3(0, 0, -to)).y
	return _mean_of(shown, int(far), int(near))


# The standard deviation of the lightness between two distances.
func _deviation(shown: Image, from: float, to: float) -> float:
	var camera := stage.get_camera_3d()
	var near := int(camera.unproject_position(Vector3(0, 0, -from)).y)
	var far := int(camera.unproject_position(Vector3(0, 0, -to)).y)
	var sum := 0.0
	var squares := 0.0
	var count := 0
	for y in range(far, near):
		for x in range(SIZE.x / 6, SIZE.x * 5 / 6):
			var color := shown.get_pixel(x, y).srgb_to_linear()
			var lightness := _to_lab(Vector3(color.r, color.g, color.b)).x
			sum += lightness
			squares += lightness * lightness
			count += 1
	var mean := sum / maxi(count, 1)
	return sqrt(maxf(squares / maxi(count, 1) - mean * mean, 0.0))


func _mean_of(shown: Image, top: int, bottom: int) -> Vector3:
	var sum := Vector3.ZERO
	var count := 0
	for y in range(top, bottom):
		for x in range(SIZE.x / 6, SIZE.x * 5 / 6):
			var color := shown.get_pixel(x, y).srgb_to_linear()
			sum += Vector3(color.r, color.g, color.b)
			count += 1
	return _to_lab(sum / maxi(count, 1))


func _contrast(shown: Image) -> float:
	var sum := 0.0
	for y in range(0, SIZE.y, 3):
		for x in range(1, SIZE.x, 3):
			sum += absf(
				shown.get_pixel(x, y).get_luminance() - shown.get_pixel(x - 1, y).get_luminance()
			)
	return 255.0 * sum * 9.0 / (SIZE.x * SIZE.y)


func _to_lab(linear: Vector3) -> Vector3:
	var x := (0.4124 * linear.x + 0.3576 * linear.y + 0.1805 * linear.z) / 0.9505
	var y := 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z
	var z := (0.0193 * linear.x + 0.1192 * linear.y + 0.9505 * linear.z) / 1.089
	return Vector3(
		116.0 * _root_of(y) - 16.0,
		500.0 * (_root_of(x) - _root_of(y)),
		200.0 * (_root_of(y) - _root_of(z))
	)


func _root_of(value: float) -> float:
	return pow(value, 1.0 / 3.0) if value > 0.008856 else 7.787 * value + 16.0 / 116.0
