## Plants of the user's meshes in fields look and bend as a Plant3D with the materials of the file.
extends "res://tests/engine/picture_harness.gd"

const Maker := preload("res://tests/engine/model_maker.gd")
const Files := preload("res://tests/engine/model_files.gd")

## Of the compared plants, about the vertical.
const TURN := 0.7
const STEP := 1.0 / 60.0
## Skinning and the field's shader differ to the first order of the bend, on outlines of leaves.
const MAX_MODEL_PIXELS := 160

var _field: PlantField3D
var _wind: PlantWind


func before_each() -> void:
	make_stage()
	_wind = make_crossing_wind()
	_wind.strength = 6.0
	_field = await make_added_field(_wind)


func after_each() -> void:
	stage.free()


func test_a_flower_of_a_mesh_bends_as_a_single_plant_does() -> void:
	await _compare(_tall(Files.flower(Maker.plain(Color(0.3, 0.7, 0.2))).mesh()), 40)


func test_a_tree_keeps_the_cut_out_of_its_leaves() -> void:
	await _compare(_tall(Files.tree(26).mesh()), 40)


func test_a_normal_map_turns_with_the_plant() -> void:
	var material := Maker.plain(Color(0.5, 0.5, 0.5))
	var bumps := Image.create_empty(8, 8, false, Image.FORMAT_RGB8)
	for y in 8:
		for x in 8:
			bumps.set_pixel(x, y, Color(0.85 if x % 4 < 2 else 0.15, 0.5, 0.85))
	material.normal_enabled = true
	material.normal_texture = ImageTexture.create_from_image(bumps)
	await _compare(_tall(Files.flower(material).mesh()), 40)


func test_a_normal_map_turns_with_a_leaf_along_the_wind() -> void:
	# The bend turns such a leaf about its own normal. In Compatibility, the skinned mesh of the single
	# plant differs from the same mesh without a skeleton at rest already.
	if RenderingServer.get_current_rendering_method() == "gl_compatibility":
		check(true, "no single plant to compare with")
		return
	var material := Maker.plain(Color(0.5, 0.5, 0.5))
	var slope := Image.create_empty(2, 2, false, Image.FORMAT_RGB8)
	slope.fill(Color(0.95, 0.5, 0.7))
	material.normal_enabled = true
	material.normal_texture = ImageTexture.create_from_image(slope)
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	var maker := Maker.new()
	maker.surface(material)
	var along := Vector3(sin(deg_to_rad(60.0)), 0, cos(deg_to_rad(60.0)))
	var spine: PackedVector3Array = []
	var widths: PackedFloat32Array = []
	for row in 9:
		spine.append(Vector3(0, 1.3 * row / 8.0, 0))
		widths.append(0.3)
	maker.sheet(spine, widths, along.rotated(Vector3.UP, -TURN))
	_wind.strength = 20.0
	turn_lights(Vector3(deg_to_rad(-70.0), deg_to_rad(150.0), 0.0))
	await _compare(_tall(maker.mesh()), 60)


func test_a_shader_of_the_file_gets_the_bend() -> void:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = """shader_type spatial;
render_mode cull_disabled, unshaded;
uniform vec4 tint : source_color = vec4(1.0);
varying float high;
void vertex() {
	high = VERTEX.y;
}
void fragment() {
	ALBEDO = tint.rgb;
}
"""
	material.set_shader_parameter("tint", Color(1, 0, 0))
	await _compare(_tall(Files.flower(material).mesh()), 40)


func test_a_change_of_the_files_material_is_seen() -> void:
	var material := Maker.plain(Color.RED)
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	_field.add_plants([Transform3D()], _tall(Files.flower(material).mesh()))
	await frames(4)
	check(_count(await picture(), Color.RED) > MIN_PLANT, "it is red")
	material.albedo_color = Color.BLUE
	await frames(40)
	check(_count(await picture(), Color.BLUE) > MIN_PLANT, "it is blue")


func test_a_material_of_the_species_replaces_those_of_the_file() -> void:
	var species := _tall(Files.tree(26).mesh())
	var blue := Maker.plain(Color.BLUE)
	blue.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	species.material = blue
	_field.add_plants([Transform3D()], species)
	await frames(4)
	var shown := await picture()
	check(_count(shown, Color.BLUE) > MIN_PLANT, "it is blue")
	check_equal(_count(shown, Color.BLUE), count_different(shown, empty_picture()), "blue pixels")


func test_two_fields_of_one_model_are_drawn_alike() -> void:
	var species := _tall(Files.tree(26).mesh())
	_field.add_plants([Transform3D()], species)
	await frames(4)
	var first := await picture()
	_field.hide()
	var other := await make_added_field(_wind)
	other.add_plants([Transform3D()], species)
	await frames(4)
	check(count_different(first, empty_picture()) > MIN_PLANT, "a plant is drawn")
	check(
		count_different(first, await picture()) <= MAX_DIFFERENT, "the second field draws the same"
	)


func _tall(mesh: Mesh) -> MeshPlantFunction:
	var species := MeshPlantFunction.of(mesh)
	species.height = 1.3
	return species


func _compare(species: PlantFunction, steps: int) -> void:
	var place := Transform3D(Basis(Vector3.UP, TURN), Vector3(0.05, 0, 0.1))
	var id := _field.add_plants([place], species)[0]
	await frames(2)
	for i in steps:
		_field._preview(STEP, _wind)
	await frames(2)
	var in_field := await picture()
	_field.hide()
	var at := _field.global_transform * _field.get_plant_transform(id)
	var plant := await make_twin(_field, id, species, at, steps)
	var alone := await picture()
	check(count_different(in_field, empty_picture()) > MIN_PLANT, "a plant is drawn")
	check(plant.get_deflection() > 0.03, "it bends by %.3f" % plant.get_deflection())
	var different := count_different(in_field, alone)
	check(different <= MAX_MODEL_PIXELS, "%d pixels differ" % different)
	plant.simulation_enabled = false
	plant.reset_motion()
	await frames(2)
	var upright := count_different(in_field, await picture())
	check(upright > 2 * different, "%d pixels show the bend, %d differ" % [upright, different])


func _count(shown: Image, color: Color) -> int:
	var count := 0
	for y in shown.get_height():
		for x in shown.get_width():
			var pixel := shown.get_pixel(x, y)
			var apart := Vector3(pixel.r - color.r, pixel.g - color.g, pixel.b - color.b)
			count += 1 if apart.length() < 0.2 else 0
	return count
