## Several worlds in one game: wind sources and bodies of one world have no effect in another.
extends "res://tests/engine/air_harness.gd"

const SOON := 180  # Frames in which a rotor bends plants in its range.


func test_a_rotor_bends_plants_of_its_own_world_only() -> void:
	var other := _add_world()
	var outside := _add_both(root)
	var inside := _add_both(other)
	await frames(5)
	var rotor := PlantWindSource3D.new()
	rotor.kind = PlantWindSource3D.KIND_FAN
	rotor.thrust = 3000.0
	rotor.position = Vector3(5, 5, 0)
	other.add_child(rotor)
	await frames(SOON)
	check(_bends(outside).length() < 1e-4, "bends outside: %s" % _bends(outside))
	check(_bends(inside).x > 0.02, "the plant inside bends: %s" % _bends(inside))
	check(_bends(inside).y > 0.02, "the field inside bends: %s" % _bends(inside))
	rotor.reparent(root)
	_nodes.append(rotor)
	await frames(900)
	check(_bends(outside).x > 0.02, "the plant bends where the rotor is: %s" % _bends(outside))
	check(_bends(outside).y > 0.02, "the field bends where the rotor is: %s" % _bends(outside))
	check(_bends(inside).length() < 0.005, "bends where it was: %s" % _bends(inside))


func test_a_body_pushes_plants_of_its_own_world_only() -> void:
	var other := _add_world()
	var outside := _add_both(root, &"walkers")
	var inside := _add_both(other, &"walkers")
	await frames(5)
	var body := StaticBody3D.new()
	var ball := SphereShape3D.new()
	ball.radius = 0.4
	add_shape(body, ball)
	body.position = Vector3(-0.2, 0.5, 0)
	body.add_to_group(&"walkers")
	other.add_child(body)
	await frames(20)
	check_equal(_bends(outside), Vector2.ZERO, "bends outside")
	check(_bends(inside).x > 0.05, "the plant inside is pushed: %s" % _bends(inside))
	check(_bends(inside).y > 0.05, "the field inside is pushed: %s" % _bends(inside))
	body.reparent(root)
	_nodes.append(body)
	await frames(20)
	check(_bends(outside).x > 0.05, "the plant is pushed where the body is: %s" % _bends(outside))
	check(_bends(outside).y > 0.05, "the field is pushed where the body is: %s" % _bends(outside))


func _add_world() -> SubViewport:
	var viewport := SubViewport.new()
	viewport.own_world_3d = true
	_add(viewport)
	return viewport


## Returns a plant and a field of one plant, at the same position: [plant, field, id].
func _add_both(to: Node, group := &"") -> Array:
	var plant := Plant3D.new()
	plant.species = _species()
	plant.height = 0.8
	plant.bodies_group = group
	var field := PlantField3D.new()
	field.density = 0.0
	field.bodies_group = group
	for node: Node in [field, plant]:
		if to == root:
			_add(node)
		else:
			to.add_child(node)
	var id := field.add_plants([Transform3D.IDENTITY], _species())[0]
	return [plant, field, id]


## Returns the distance of the tips from upright (m): of the plant (x) and of the field's (y).
func _bends(both: Array) -> Vector2:
	var tip := (both[0] as Plant3D).get_tip_position()
	var other := (both[1] as PlantField3D).get_tip_position(both[2])
	return Vector2(Vector2(tip.x, tip.z).length(), Vector2(other.x, other.z).length())
