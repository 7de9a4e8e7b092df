## Materials of a field: their values are visible, and they may change during a build.
extends "res://tests/engine/picture_harness.gd"

var _field: PlantField3D


func before_each() -> void:
	make_stage()
	_field = PlantField3D.from_species([GrassFunction.new()])
	_field.size = Vector2(3, 3)
	_field.density = 30.0
	_field.simulation_enabled = false
	stage.add_child(_field)
	await _field.build_finished
	await frames(3)


func after_each() -> void:
	stage.free()


func test_a_colour_of_a_plain_material_is_seen() -> void:
	var material := StandardMaterial3D.new()
	material.albedo_color = Color.RED
	_field.species[0].species.material = material
	await _seen_materials()
	var ids := _field.get_plant_ids()
	_check_colour(await picture(), Color.RED, "red")
	material.albedo_color = Color.BLUE
	await _seen_materials()
	_check_colour(await picture(), Color.BLUE, "blue")
	check_equal(_field.get_plant_ids(), ids, "plants")


func test_a_parameter_of_ones_own_shader_is_seen() -> void:
	var material := _own_material()
	_field.species[0].species.material = material
	material.set_shader_parameter("tint", Color.RED)
	await _seen_materials()
	_check_colour(await picture(), Color.RED, "red")
	material.set_shader_parameter("tint", Color.BLUE)
	await _seen_materials()
	_check_colour(await picture(), Color.BLUE, "blue")
	var other := _own_material()
	other.set_shader_parameter("tint", Color.GREEN)
	_field.species[0].species.material = other
	await _seen_materials()
	_check_colour(await picture(), Color.GREEN, "green of another material")


func test_a_material_override_is_applied_and_removed() -> void:
	var before := await picture()
	var material := _own_material()
	material.set_shader_parameter("tint", Color.BLUE)
	_field.material_override = material
	await _seen_materials()
	_check_colour(await picture(), Color.BLUE, "blue")
	_field.material_override = null
	await _seen_materials()
	check_equal(count_different(before, await picture()), 0, "pixels once it is off")


func test_materials_of_skeletons_are_those_of_now() -> void:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = Color.BLUE
	_field.rebuild()
	_field.species[0].species.material = material
	await _field.build_finished
	_field.skeleton_distance = 10.0
	_field.max_skeletons = 1000
	await frames(60)
	check(_field.get_skeletons().size() > 60, "%d skeletons" % _field.get_skeletons().size())
	_check_colour(await picture(), Color.BLUE, "blue")


func test_a_material_set_during_a_rebuild_is_applied_after_it() -> void:
	_field.size = Vector2(40, 40)
	_field.tile_size = 2.0  # So that the preparation takes several frames.
	await _field.build_finished
	for attempt in 2:
		_field.seed += 1
		await frames(1)
		var colour := Color.BLACK
		while _field.is_building():
			colour = Color.RED if colour != Color.RED else Color.BLUE
			var material: Material = _plain(colour)
			if colour == Color.RED:
				material = _own_material()
				(material as ShaderMaterial).set_shader_parameter("tint", colour)
			_field.species[0].species.material = material
			await process_frame
		await _seen_materials()
		_check_colour(await picture(), colour, "the last one")


func test_species_that_change_in_every_frame_of_a_build() -> void:
	_field.size = Vector2(24, 24)
	_field.species.append(PlantFieldSpecies.of(TulipFunction.new()))
	for entry in _field.species:
		entry.species.shape_deviation = 0.5
	_field.rebuild()
	for i in 24:
		for entry in _field.species:
			var function: PlantFunction = entry.species
			function.shading = (
				PlantFunction.SHADING_FLAT if i % 2 == 0 else PlantFunction.SHADING_SMOOTH
			)
			function.material = StandardMaterial3D.new() if i % 3 == 0 else null
			function.shape_deviation = 0.1 + 0.01 * i
		if i % 8 == 0:
			_field.rebuild()
		await process_frame
	await settled(_field)
	check_near(_field.get_plant_count(), 30 * 576, 1000.0, "plants")


## Waits until a field has polled the materials of its species.
func _seen_materials() -> void:
	await frames(20)
	await settled(_field)


func _plain(colour: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = colour
	return material


func _own_material() -> ShaderMaterial:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = """
		shader_type spatial;
		render_mode unshaded;
		#include "res://addons/undergrowth/shaders/undergrowth_bend.gdshaderinc"
		uniform vec4 tint : source_color;

		void vertex() {
			UNDERGROWTH_BEND
		}

		void fragment() {
			UNDERGROWTH_FADE
			ALBEDO = tint.rgb;
		}
	"""
	return material


## Checks that nearly all drawn pixels have more of [param colour] than of the remaining channels.
func _check_colour(shown: Image, colour: Color, what: String) -> void:
	var drawn := 0
	var right := 0
	for y in PICTURE_SIZE.y:
		for x in PICTURE_SIZE.x:
			var pixel := shown.get_pixel(x, y)
			if pixel.r + pixel.g + pixel.b > 0.1:
				drawn += 1
				var own := pixel.r * colour.r + pixel.g * colour.g + pixel.b * colour.b
				right += 1 if own > 0.6 * (pixel.r + pixel.g + pixel.b) else 0
	check(drawn > MIN_PLANT, "%d pixels of plants" % drawn)
	check(right > 0.98 * drawn, "%d of %d pixels are %s" % [right, drawn, what])
