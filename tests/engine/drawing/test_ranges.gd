## The distances at which the renderer draws the instances of a field.
extends "res://tests/engine/drawing/drawing_harness.gd"

const RATIO := 0.2
const ENDS: Array[float] = [12.0, 30.0, 60.0]


func before_each() -> void:
	field = make_field(24.0, 2.0)
	field.levels = [PlantFieldLevel.of(6, ENDS[0]), PlantFieldLevel.of(3, ENDS[1])]
	field.levels.append(PlantFieldLevel.of(2))
	field.visibility_range_end = ENDS[2]
	field.fade_ratio = RATIO
	field.tile_size = 8.0


func test_each_plant_is_drawn_at_all_distances_of_each_level() -> void:
	await start()
	_check_ranges()


func test_ranges_follow_the_scale_of_a_field() -> void:
	field.scale = Vector3.ONE * 0.5
	await start()
	_check_ranges()
	field.scale = Vector3(1.5, 1.0, 2.0)
	await frames(2)
	_check_ranges()


func test_ranges_follow_levels_that_change() -> void:
	await start()
	field.fade_ratio = 2.0 * RATIO
	await rested()
	_check_ranges()


func test_plants_and_their_shadows_go_to_another_world_with_the_field() -> void:
	field.free()
	field = PlantField3D.from_species([load("res://addons/undergrowth/species/meadow_grass.tres")])
	field.size = Vector2(12, 12)
	field.density = 4.0
	await start()
	var viewport := SubViewport.new()
	viewport.own_world_3d = true
	root.add_child(viewport)
	field.reparent(viewport)
	await frames(2)
	var own := viewport.find_world_3d().scenario.get_id()
	var outside := 0
	var instances := DrawingRecord.get_instances()
	for instance: Dictionary in instances:
		outside += 0 if instance["scenario"] == own else 1
	check(instances.size() > 1, "%d instances" % instances.size())
	check_equal(outside, 0, "instances in the world before")
	field.reparent(root)
	viewport.free()


func test_boxes_hold_plants_that_are_bent_to_any_side() -> void:
	await start()
	for instance in drawn_instances():
		var box: AABB = instance["box"]
		for plant in plants_of(instance):
			var id := field.find_nearest_plant(field.to_global(plant.root), 0.01)
			var reach := 0.7 * field.get_plant_height(id)
			for way: Vector3 in [Vector3.UP, Vector3.LEFT, Vector3.RIGHT, Vector3.BACK]:
				check(box.has_point(plant.root + reach * way), "%s in %s" % [plant.root, box])


func test_instances_are_as_high_as_their_plants() -> void:
	await start()
	for instance in drawn_instances():
		var plants := plants_of(instance)
		var first := _mesh_height(plants[0])
		for plant in plants:
			check_near(_mesh_height(plant), first, 1e-3, "height of the mesh")


func _mesh_height(plant: DrawnPlant) -> float:
	var id := field.find_nearest_plant(field.to_global(plant.root), 0.01)
	return field.get_plant_height(id) / (plant.ratio * plant.scale)


## A camera at a distance from a plant can be nearer to the middle of its instance, or farther, by
## the distance between the two.
func _check_ranges() -> void:
	var count := 0
	var drawn: Array[Dictionary] = []
	for level in ENDS.size():
		drawn.append({})
	for instance in drawn_instances():
		var middle: Vector3 = field.to_global(instance["box"].get_center())
		for plant in plants_of(instance):
			var away := field.to_global(plant.root).distance_to(middle) - 1e-3
			for level in ENDS.size():
				var begin := 0.0 if level == 0 else ENDS[level - 1] * (1.0 - field.fade_ratio)
				if (
					instance["begin"] <= maxf(begin - away, 0.0)
					and instance["end"] >= ENDS[level] + away
				):
					drawn[level][plant.root] = true
		check(instance["end"] < ENDS[2] + 60.0, "an instance ends at %f m" % instance["end"])
		count += 1 if instance["begin"] > 0.0 else 0
	check(count > 0, "some instances begin beyond the eye")
	for level in ENDS.size():
		check_equal(drawn[level].size(), field.get_plant_count(), "plants of level %d" % level)
