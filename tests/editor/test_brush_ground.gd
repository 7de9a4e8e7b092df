@tool
extends "brush_test.gd"
## The brush on ground without ray hits: an object's, such as a terrain of another add-on.


class Terrain:
	extends Node3D
	var data: Object


class Plateau:
	extends RefCounted
	const HEIGHT := 1.0
	const HALF_WIDTH := 1.0

	func get_height(place: Vector3) -> float:
		return HEIGHT if absf(place.x) < HALF_WIDTH else NAN


func test_it_paints_where_the_terrain_is_seen() -> void:
	var field := await _field_on_a_terrain()
	await _choose_tool("Erase")
	await click(_view(), _place_of(field, Vector3(0, Plateau.HEIGHT, 0)))
	await _rested(field)
	check(field.map != null, "something is erased")
	if field.map:
		check(field.map.get_density(Vector3.ZERO, GRASS) == 0.0, "under the pointer")


func test_it_falls_to_the_plane_beyond_the_terrain() -> void:
	var field := await _field_on_a_terrain()
	field.map = PlantMap.new()
	field.map.paint(Vector3.ZERO, 0.5, GRASS, 1.0, 0.0)  # Plants exist for any query.
	var camera := EditorInterface.get_editor_viewport_3d(0).get_camera_3d()
	var beyond := Vector3(signf(camera.global_position.x) * 2.2, 0, 0)
	await _choose_tool("Paint")
	await click(_view(), _place_of(field, beyond))
	check(field.map.get_density(beyond, GRASS) == 1.0, "painted there")
	await _rested(field)


func _field_on_a_terrain() -> PlantField3D:
	var field := await _edited_field()
	var terrain := Terrain.new()
	terrain.name = "Terrain"
	terrain.data = Plateau.new()
	field.get_parent().add_child(terrain)
	field.ground_mode = PlantField3D.GROUND_OBJECT
	field.ground_object = NodePath("../Terrain:data")
	await _rested(field)
	_sharpen(0.5)
	return field
