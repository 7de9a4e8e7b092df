## Light on leaves: through them, along them, in wind, and equal in all renderers.
extends "res://tests/engine/picture_harness.gd"

const ShownCode := preload("res://tests/engine/shown_code.gd")
const STYLE := preload("res://addons/undergrowth/shaders/plant_parts.gdshader")
const GUIDE := "docs/guide/"
## Pages of the guide with shaders for leaves.
const PAGES: Array[String] = ["materials.md", "leaves.md"]
const STEP := 1.0 / 30.0
## Duration of a wind before its picture, in steps.
const BLOWS := 300
## Pictures for the mean of a gusty wind.
const MOMENTS := 5
## Share by which the mean brightness of a field may differ between winds.
const MAX_CHANGE := 0.1
## Share by which the light on a leaf may differ between renderers.
const MAX_DIFFERENCE := 0.05
## Linear light on a leaf that the sun meets in front, and from behind at 75°, in all renderers.
const IN_FRONT := 0.349
const BEHIND := 0.487
const WINDS := "res://addons/undergrowth/winds/%s.tres"
const MIDDLE := Vector2i(100, 120)


func before_each() -> void:
	make_stage()


func after_each() -> void:
	stage.free()


func test_a_field_has_the_same_brightness_in_all_winds() -> void:
	var species: PlantFunction = load("res://addons/undergrowth/species/meadow_grass.tres")
	var field := PlantField3D.from_species([species.duplicate()])
	field.size = Vector2(5, 5)
	field.density = 40.0
	field.simulation_enabled = false
	field.material_override = ShaderMaterial.new()
	var style: ShaderMaterial = field.material_override
	style.shader = STYLE
	stage.add_child(field)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 2.0, 2.5), Vector3(0, 0.0, -0.5))
	var calm := _mean_of(await _blown(field, "calm"))
	check(calm > 0.02, "the field is lit: %.3f" % calm)
	for name in ["fresh", "storm"]:
		var shown := await _blown(field, name)
		var change := await _mean_over_gusts(field, shown) / calm - 1.0
		check(absf(change) <= MAX_CHANGE, "%s: the mean changes by %.3f" % [name, change])
		style.set_shader_parameter(&"bent_brightness", 0.0)
		await frames(10)  # Fields copy parameters in turns.
		var even := await picture()
		style.set_shader_parameter(&"bent_brightness", null)
		await frames(10)
		var lighter := _count_lighter(shown, even)
		var darker := _count_lighter(even, shown)
		check(lighter > 300, "%s: waves of light in %d pixels" % [name, lighter])
		check(darker > 300, "%s: darker between them in %d pixels" % [name, darker])


func test_light_on_a_leaf_is_the_same_in_all_renderers() -> void:
	_show(_leaf(Color(0.4, 0.6, 0.2), 0.0))
	_light_from(Vector3(0, 0.7, 1.0))
	await _check_light("in front", IN_FRONT)
	_light_from(Vector3(0, 0.27, -1.0))
	await _check_light("from behind", BEHIND)


func test_light_through_a_leaf_depends_on_the_view() -> void:
	_show(_leaf(Color(0.4, 0.6, 0.2), 0.0))
	_light_from(Vector3(0.3, 0, -1.0))
	var against := _light_at(await picture(), MIDDLE)
	_light_from(Vector3(1.0, 0.9, -1.0))
	var aside := _light_at(await picture(), MIDDLE)
	check(against > 1.8 * aside, "against the light %.3f, aside %.3f" % [against, aside])


func test_the_base_of_a_sward_is_darker() -> void:
	var leaf := _show(_leaf(Color(0.4, 0.6, 0.2), 0.0))
	var tip := _light_at(await picture(), MIDDLE)
	leaf.free()
	_show(_leaf(Color(0.4, 0.6, 0.2, 0.05), 0.0), {&"shade_in_light": 0.0})
	var base := _light_at(await picture(), MIDDLE)
	check(base > 0.15 * tip and base < 0.35 * tip, "base %.4f, tip %.4f" % [base, tip])


func test_leaves_have_veins_that_fade() -> void:
	var leaves: Array[MeshInstance3D] = []
	for kind in 5:
		leaves.append(_show(_leaf(Color(0.4, 0.6, 0.2), float(kind))))
		leaves[kind].hide()
	var near := await _spread(leaves)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 0, 60.0), Vector3.ZERO)
	var far := await _spread(leaves)
	for kind in range(1, 5):
		var seen := near[kind] - near[0]
		check(seen > 0.03, "veins %d: a spread of %.3f" % [kind, seen])
		if kind < 4:  # A petal is also darker at its base.
			var left := far[kind] - far[0]
			check(left < 0.6 * seen, "veins %d: %.3f far away, %.3f near" % [kind, left, seen])


func test_dead_broad_leaves_are_greener_than_dead_blades() -> void:
	var greens: Array[float] = []
	for kind: float in [1.0, 2.0]:
		var leaf := _show(_leaf(Color(0.4, 0.6, 0.2), kind), {dead_leaves = 1.0})
		var shown := _mean_color(await picture())
		greens.append((shown.g - shown.r) / maxf(shown.g, 1e-4))
		leaf.free()
	check(greens[1] > greens[0] + 0.1, "green of a blade and of a broad leaf: %s" % [greens])


func test_undersides_of_leaves_are_paler_and_bluer() -> void:
	_show(_leaf(Color(0.4, 0.6, 0.2), 2.0))
	var seen: Array[Color] = []
	for side: float in [1.0, -1.0]:
		var place := Vector3(0, 0, 1.5 * side)
		stage.get_camera_3d().look_at_from_position(place, Vector3.ZERO)
		_light_from(place)
		seen.append(_mean_color(await picture()))
	check(seen[1].b > 1.1 * seen[0].b, "blue: %s above, %s below" % seen)
	check(seen[1].b / seen[1].g > 1.03 * seen[0].b / seen[0].g, "hue: %s above, %s below" % seen)


func test_no_channel_of_a_petal_is_clipped() -> void:
	_show(_leaf(Color(1.0, 0.0, 0.0), 4.0))
	var shown := (await picture()).get_pixelv(MIDDLE)
	check(shown.g > 0.02 and shown.b > 0.02 and shown.r < 0.99, "the petal is %s" % shown)


func test_shaders_of_the_guide_draw_leaves() -> void:
	var leaf := _show(_leaf(Color(0.4, 0.6, 0.2), 2.0))
	RenderingServer.global_shader_parameter_add(
		&"season", RenderingServer.GLOBAL_VAR_TYPE_COLOR, Color.WHITE
	)
	var count := 0
	for page in PAGES:
		var path := ShownCode.find_file(GUIDE + page)
		check(path != "", "%s is missing" % page)
		for block in ShownCode.in_markdown(path, page):
			if block.language != "gdshader":
				continue
			count += 1
			leaf.material_override = ShaderMaterial.new()
			leaf.material_override.shader = Shader.new()
			leaf.material_override.shader.code = block.code
			var light := _light_at(await picture(), MIDDLE)
			check(light > 0.05, "%s draws a leaf: %.3f" % [block.place, light])
	leaf.free()
	RenderingServer.global_shader_parameter_remove(&"season")
	check(count >= 2, "%d shaders" % count)


## Returns the mean of `shown` and of later moments. A gust crosses a small field as a whole.
func _mean_over_gusts(field: PlantField3D, shown: Image) -> float:
	var sum := _mean_of(shown)
	for moment in MOMENTS - 1:
		sum += _mean_of(await _blow(field))
	return sum / MOMENTS


func _blown(field: PlantField3D, name: String) -> Image:
	field.wind = load(WINDS % name).duplicate()
	await settled(field)
	return await _blow(field)


func _blow(field: PlantField3D) -> Image:
	_draw_stage(false)
	for i in BLOWS:
		field._preview(STEP, field.wind)
		if i % 10 == 0:
			await process_frame  # The mean follows what is drawn.
	return await picture()


func _show(mesh: Mesh, parameters := {}) -> MeshInstance3D:
	var leaf := MeshInstance3D.new()
	leaf.mesh = mesh
	var style := ShaderMaterial.new()
	style.shader = STYLE
	style.set_shader_parameter(&"patchiness", 0.0)
	style.set_shader_parameter(&"clumpiness", 0.0)
	style.set_shader_parameter(&"dead_leaves", 0.0)
	for name: StringName in parameters:
		style.set_shader_parameter(name, parameters[name])
	leaf.material_override = style
	stage.add_child(leaf)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 0, 1.5), Vector3.ZERO)
	return leaf


## Returns a square leaf of 1 m with this code of its venation. Its base is below.
func _leaf(color: Color, veins: float) -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	var corners := PackedVector3Array()
	var uvs := PackedVector2Array()
	var custom := PackedFloat32Array()
	for corner: Vector2 in [Vector2(0, 0), Vector2(0, 1), Vector2(1, 1), Vector2(1, 0)]:
		corners.append(Vector3(corner.x - 0.5, corner.y - 0.5, 0))
		uvs.append(Vector2(corner.x, 1.0 - corner.y))
		custom.append_array(PackedFloat32Array([0.0, 0.0, veins + 0.5, 1.0]))
	arrays[Mesh.ARRAY_VERTEX] = corners
	arrays[Mesh.ARRAY_TEX_UV] = uvs
	arrays[Mesh.ARRAY_CUSTOM0] = custom
	var normals := PackedVector3Array()
	normals.resize(4)
	normals.fill(Vector3.BACK)
	arrays[Mesh.ARRAY_NORMAL] = normals
	var colors := PackedColorArray()
	colors.resize(4)
	colors.fill(color)
	arrays[Mesh.ARRAY_COLOR] = colors
	var tangents := PackedFloat32Array()
	for i in 4:
		tangents.append_array(PackedFloat32Array([0.0, 1.0, 0.0, 1.0]))
	arrays[Mesh.ARRAY_TANGENT] = tangents
	arrays[Mesh.ARRAY_INDEX] = PackedInt32Array([0, 1, 2, 0, 2, 3])
	var mesh := ArrayMesh.new()
	var format := Mesh.ARRAY_CUSTOM_RGBA_FLOAT << Mesh.ARRAY_FORMAT_CUSTOM0_SHIFT
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], {}, format)
	return mesh


## Directs the sun's light from [param place] to the origin.
func _light_from(place: Vector3) -> void:
	var suns := stage.find_children("*", "DirectionalLight3D", true, false)
	(suns[0] as DirectionalLight3D).look_at_from_position(place, Vector3.ZERO)


func _check_light(what: String, expected: float) -> void:
	var light := _light_at(await picture(), MIDDLE)
	check(
		absf(light / expected - 1.0) <= MAX_DIFFERENCE,
		"%s: %.4f, not %.4f" % [what, light, expected]
	)


func _light_at(shown: Image, place: Vector2i) -> float:
	return shown.get_pixelv(place).srgb_to_linear().get_luminance()


## Returns the mean linear light of the pixels that are not background.
func _mean_of(shown: Image) -> float:
	var sum := 0.0
	var count := 0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			var light := _light_at(shown, Vector2i(x, y))
			sum += light
			count += 1 if light > 0.0 else 0
	return sum / maxi(count, 1)


## Returns the mean linear colour of the whole picture.
func _mean_color(shown: Image) -> Color:
	var sum := Color.BLACK
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			sum += shown.get_pixel(x, y).srgb_to_linear()
	return sum / (PICTURE_SIZE.x * PICTURE_SIZE.y)


func _count_lighter(one: Image, other: Image) -> int:
	var count := 0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			var place := Vector2i(x, y)
			count += 1 if _light_at(one, place) > 1.05 * _light_at(other, place) else 0
	return count


## Returns for each leaf the standard deviation of its light, as a share of the mean.
func _spread(leaves: Array[MeshInstance3D]) -> PackedFloat32Array:
	var spreads := PackedFloat32Array()
	for leaf in leaves:
		leaf.show()
		var shown := await picture()
		leaf.hide()
		var lights := PackedFloat32Array()
		for y in PICTURE_SIZE.y:
			for x in PICTURE_SIZE.x:
				var light := _light_at(shown, Vector2i(x, y))
				if light > 0.001:
					lights.append(light)
		var mean := 0.0
		for light in lights:
			mean += light / lights.size()
		var square := 0.0
		for light in lights:
			square += (light - mean) * (light - mean) / lights.size()
		spreads.append(sqrt(square) / mean if mean > 0.0 else -1.0)
	return spreads
