extends "res://tests/engine/harness.gd"

func test_cost() -> void:
	var wind := PlantWind.new()
	wind.kind = PlantWind.KIND_WAVES
	wind.strength = 10.0
	var list: Array[PlantFunction] = [TulipFunction.new(), load("res://addons/undergrowth/species/garden_tulip.tres"), load("res://addons/undergrowth/species/meadow_grass.tres")]
	for k in 3:
		for moving in [true, false]:
			var holder := Node3D.new()
			root.add_child(holder)
			var plants := []
			for i in 300:
				var plant := Plant3D.new()
				plant.species = list[k]
				plant.segments = 2
				plant.wind = wind if moving else null
				holder.add_child(plant)
				plant.position.x = 0.1 * i
				plants.append(plant)
			await frames(20)
			var times: Array[float] = []
			for i in 60:
				await process_frame
				times.append(PlantSimulation.get_pose_time_usec())
			times.sort()
			print("COST %s moving %s min %.3f median %.3f us a plant" % [["lathe", "tulip", "grass"][k], moving, times[0] / 300, times[30] / 300])
			holder.free()
	check(true, "")
