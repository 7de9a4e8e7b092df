## Scenes and resources of version 0.2.0 load: old property names set the properties of today, with
## one warning for each file.
extends "res://tests/engine/field_harness.gd"

const SCENE := "user://old_field.tscn"
const MARGIN_SCENE := "user://old_margin.tscn"
const WIND := "user://old_wind.tres"
const OLD_SCENE := """[gd_scene format=3]

[sub_resource type="GrassFunction" id="grass"]

[sub_resource type="PlantFieldSpecies" id="entry"]
species = SubResource("grass")
share = 7.0
detail = 2.0

[sub_resource type="PlantFieldLevel" id="level"]
segments = 5
share = 0.4

[node name="Field" type="PlantField3D"]
species = Array[PlantFieldSpecies]([SubResource("entry")])
levels = Array[PlantFieldLevel]([SubResource("level")])
"""
const OLD_WIND := """[gd_resource type="PlantWind" format=3]

[resource]
kind = 4
stand_height = 0.8
wave_share = 0.6
"""


func test_a_scene_of_0_2_loads_with_one_warning() -> void:
	_write(SCENE, OLD_SCENE)
	var field: PlantField3D = (load(SCENE) as PackedScene).instantiate()
	check_equal(field.species[0].weight, 7.0, "weight")
	check_equal(field.species[0].lod_bias, 2.0, "lod_bias")
	check_equal(field.levels[0].density, 0.4, "density of a level")
	await frames(2)
	check_error("old_field.tscn' uses property names of Undergrowth 0.2")
	field.free()


func test_a_resource_of_0_2_loads_with_one_warning() -> void:
	_write(WIND, OLD_WIND)
	var wind: PlantWind = load(WIND)
	check_equal(wind.canopy_height, 0.8, "canopy_height")
	check_equal(wind.canopy_wave_amount, 0.6, "canopy_wave_amount")
	await frames(2)
	check_error("old_wind.tres' uses property names of Undergrowth 0.2")


func test_saved_edits_of_0_2_are_read() -> void:
	var field := PlantField3D.new()
	field.set(&"kept_changes", PackedByteArray())
	check_equal(field.saved_changes, PackedByteArray(), "saved_changes")
	await frames(2)
	check_error("'kept_changes' is called 'saved_changes'")
	field.free()


func test_unknown_names_are_still_refused() -> void:
	var entry := PlantFieldSpecies.new()
	check(not "shares" in entry, "no such property")
	entry.set(&"shares", 3.0)
	check_equal(entry.weight, 1.0, "weight")


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()


func test_a_transition_in_metres_becomes_a_ratio() -> void:
	var node := '[node name="Field" type="PlantField3D"]\nfade_margin = 1.2\n'
	_write(MARGIN_SCENE, "[gd_scene format=3]\n\n" + node)
	var field: PlantField3D = (load(MARGIN_SCENE) as PackedScene).instantiate()
	check_near(field.fade_ratio, 0.1, 1e-6, "fade_ratio")
	await frames(2)
	check_error("'fade_margin' is called 'fade_ratio'")
	field.free()
