## The vertices of the meshes that a field passes to the renderer.
extends "res://tests/engine/drawing/drawing_harness.gd"

const MAX_BYTES := 48
const READY := "res://addons/undergrowth/species/%s.tres"


func test_vertices_of_parts_are_small() -> void:
	for species: String in ["meadow_grass", "male_fern", "yarrow"]:
		field = PlantField3D.from_species([load(READY % species)])
		field.size = Vector2(12.0, 12.0)
		field.density = 1.0
		await start()
		var counted := 0
		for instance in drawn_instances():
			var surface := _surface_of(instance)
			var count: int = surface["vertex_count"]
			check(
				_bytes(surface) <= MAX_BYTES * count,
				"%s: %d bytes of %d vertices" % [species, _bytes(surface), count]
			)
			check(
				surface.get("skin_data", PackedByteArray()).is_empty(), "%s has no bones" % species
			)
			counted += count
		check(counted > 0, "%s draws vertices" % species)


func test_vertices_of_lathes_have_no_bones() -> void:
	field = make_field(12.0, 1.0)
	await start()
	for instance in drawn_instances():
		check(_surface_of(instance).get("skin_data", PackedByteArray()).is_empty(), "no bones")


func _surface_of(instance: Dictionary) -> Dictionary:
	return RenderingServer.mesh_get_surface(rid_from_int64(instance["mesh"]), 0)


func _bytes(surface: Dictionary) -> int:
	return surface["vertex_data"].size() + surface["attribute_data"].size()
