## ground_3d.gd: the colour and the density of a field for the material of a ground.
extends "res://tests/engine/field_harness.gd"

const Ground3D := preload("res://addons/undergrowth/grounds/ground_3d.gd")
const GROUNDS := "res://addons/undergrowth/grounds/"
const SPECIES := "res://addons/undergrowth/species/"
const MASK := 128


func test_colour_of_a_field_is_that_of_its_plants() -> void:
	var grass := _color_of({"meadow_grass": 1.0})
	var wheat := _color_of({"wheat": 1.0})
	check(grass.g > grass.r and grass.g > grass.b, "grass is green: %s" % grass)
	check(wheat.r > wheat.g and wheat.g > wheat.b, "wheat is yellow: %s" % wheat)
	var both := _color_of({"meadow_grass": 1.0, "wheat": 1.0})
	check(both.r > grass.r and both.r < wheat.r, "a mix is between them: %s" % both)
	var litter := _color_of({"meadow_grass": 1.0, "dead_leaves": 1.0})
	var brown := _color_of({"dead_leaves": 1.0})
	check(brown.r > brown.g, "dead leaves are brown: %s" % brown)
	var red := litter.r / litter.g - grass.r / grass.g
	check(red < 0.3 * (brown.r / brown.g - grass.r / grass.g), "grass hides dead leaves")


func test_translucency_is_that_of_the_parts() -> void:
	var material := ShaderMaterial.new()
	Ground3D.apply_color(material, _make_field({"meadow_grass": 1.0}))
	var leaves: float = material.get_shader_parameter(&"field_translucency")
	check(leaves > 0.5 and leaves <= 0.85, "leaves of grass: %f" % leaves)
	Ground3D.apply_color(material, _make_field({"twigs": 1.0}))
	var wood: float = material.get_shader_parameter(&"field_translucency")
	check(wood < 0.1, "twigs: %f" % wood)


func test_colour_of_plants_without_parts() -> void:
	var material := ShaderMaterial.new()
	field = PlantField3D.from_species([GrassFunction.new()])
	Ground3D.apply_color(material, field)
	var grass: Color = material.get_shader_parameter(&"field_color")
	check(grass.g > grass.r and grass.g > grass.b, "grass is green: %s" % grass)
	check_equal(material.get_shader_parameter(&"field_translucency"), 0.0, "light through a stem")


func test_density_is_a_picture_of_the_plants() -> void:
	field = _make_field({"meadow_grass": 1.0})
	field.size = Vector2(16, 8)
	field.density = 30.0
	field.position = Vector3(5, 0, -3)
	var levels: Array[PlantFieldLevel] = [PlantFieldLevel.of(1)]
	field.levels = levels
	await start()
	field.remove_in_sphere(Vector3(9, 0, -3), 2.5)
	await frames(2)
	var material := ShaderMaterial.new()
	Ground3D.apply_density(material, field)
	var area: Vector4 = material.get_shader_parameter(&"field_area")
	check_near(area.x + 0.5 * area.z, 5.0, 0.2, "middle of the area along x")
	check_near(area.y + 0.5 * area.w, -3.0, 0.2, "middle of the area along z")
	check(area.z > 15.5 and area.z < 17.5, "size of the area: %s" % area)
	var mask := (material.get_shader_parameter(&"field_mask") as ImageTexture).get_image()
	check_equal(mask.get_width(), MASK, "pixels")
	var grown := _at(mask, area, Vector2(1, -3))
	var bare := _at(mask, area, Vector2(9, -3))
	check(grown > 0.8, "among plants: %f" % grown)
	check(bare < 0.1, "where they were removed: %f" % bare)


func test_bounds_are_the_rectangle_of_the_field_and_follow_its_builds() -> void:
	field = _make_field({"meadow_grass": 1.0})
	field.size = Vector2(8, 4)
	field.density = 2.0
	field.position = Vector3(5, 0, -3)
	var ground := MeshInstance3D.new()
	ground.set_script(Ground3D)
	ground.mesh = PlaneMesh.new()
	ground.mesh.material = load(GROUNDS + "meadow.tres")
	ground.set(&"field", field)
	root.add_child(field)
	root.add_child(ground)
	var material := ground.material_override as ShaderMaterial
	check_equal(material.get_shader_parameter(&"field_bounds"), Vector4(1, -5, 8, 4), "bounds")
	field.size = Vector2(10, 4)
	field.build_finished.emit()
	check_equal(material.get_shader_parameter(&"field_bounds"), Vector4(0, -5, 10, 4), "wider")
	ground.free()


func test_density_of_a_field_outside_the_tree_is_one_error() -> void:
	field = _make_field({"wheat": 1.0})
	var material := ShaderMaterial.new()
	Ground3D.apply_density(material, field)
	check_error("needs the field in the tree")
	check_equal(material.get_shader_parameter(&"field_mask"), null, "density")


func test_density_of_plants_at_absurd_distances() -> void:
	field = PlantField3D.new()
	root.add_child(field)
	await frames(2)
	var far := Transform3D(Basis.IDENTITY, Vector3(1e30, 0.0, 0.0))
	field.add_plants([Transform3D.IDENTITY, far], GrassFunction.new())
	var material := ShaderMaterial.new()
	Ground3D.apply_density(material, field)
	check(material.get_shader_parameter(&"field_mask") is ImageTexture, "there is a picture")


func test_a_ground_changes_a_copy_of_its_material() -> void:
	field = _make_field({"wheat": 1.0})
	root.add_child(field)
	var ready := load(GROUNDS + "field_soil.tres") as ShaderMaterial
	var before: Color = ready.get_shader_parameter(&"field_color")
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	(ground.mesh as PlaneMesh).material = ready
	ground.set_script(Ground3D)
	ground.set(&"field", field)
	root.add_child(ground)
	await frames(2)
	var own := ground.material_override as ShaderMaterial
	check(own != null and own != ready, "it has its own material")
	check(own.get_shader_parameter(&"field_color") != before, "with the colour of the field")
	check_equal(ready.get_shader_parameter(&"field_color"), before, "the file's colour")
	ground.free()


func _color_of(weights: Dictionary[String, float]) -> Color:
	var material := ShaderMaterial.new()
	Ground3D.apply_color(material, _make_field(weights))
	return material.get_shader_parameter(&"field_color")


func _make_field(weights: Dictionary[String, float]) -> PlantField3D:
	if is_instance_valid(field):
		field.free()
	field = PlantField3D.new()
	var entries: Array[PlantFieldSpecies] = []
	for file in weights:
		entries.append(PlantFieldSpecies.of(load(SPECIES + file + ".tres"), weights[file]))
	field.species = entries
	return field


func _at(mask: Image, area: Vector4, place: Vector2) -> float:
	var at := (place - Vector2(area.x, area.y)) / Vector2(area.z, area.w) * MASK
	return mask.get_pixelv(Vector2i(at)).r
