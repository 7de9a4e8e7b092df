@tool
extends "editor_test.gd"
## A scene's wind in the settings of the project.

const SHADER := """shader_type spatial;
#include "res://addons/undergrowth/shaders/undergrowth_scene_wind.gdshaderinc"
void vertex() { VERTEX += undergrowth_wind(VERTEX) + undergrowth_wind_over_canopy(VERTEX.xz).xxy; }
"""


func test_a_scene_wind_adds_its_shader_globals_to_the_project() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_AIR
	wind.scene_wind = true
	var file := ConfigFile.new()
	check_equal(file.load("res://project.godot"), OK, "the settings are saved")
	var shader := Shader.new()
	shader.code = SHADER
	var listed := RenderingServer.get_shader_parameter_list(shader.get_rid())
	check_equal(listed.size(), 0, "parameters of a material: %s" % [listed])
	for name in RenderingServer.global_shader_parameter_get_list():
		if name.begins_with("undergrowth_"):
			check(file.has_section_key("shader_globals", name), "saved: %s" % name)
	check(file.has_section_key("shader_globals", "undergrowth_wind_air"), "the wind's speed")
	check(file.has_section_key("shader_globals", "undergrowth_turbulence"), "a texture")
	wind.scene_wind = false
