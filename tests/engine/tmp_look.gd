extends "res://tests/engine/harness.gd"

const SIZE := Vector2i(520, 520)
var stage: SubViewport

func test_look() -> void:
	stage = SubViewport.new()
	stage.size = SIZE
	stage.own_world_3d = true
	stage.msaa_3d = Viewport.MSAA_4X
	stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(stage)
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-50, 30, 0)
	stage.add_child(sun)
	var env := WorldEnvironment.new()
	env.environment = Environment.new()
	env.environment.background_mode = Environment.BG_COLOR
	env.environment.background_color = Color(0.75, 0.8, 0.85)
	env.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	env.environment.ambient_light_color = Color(0.6, 0.6, 0.6)
	stage.add_child(env)
	var camera := Camera3D.new()
	camera.fov = 40
	stage.add_child(camera)
	for species: String in ["oxeye_daisy", "meadow_grass"]:
		var plant := Plant3D.new()
		plant.species = load("res://addons/undergrowth/species/%s.tres" % species)
		plant.simulation_enabled = false
		plant.seed = 5
		var wind := PlantWind.new()
		wind.kind = PlantWind.KIND_CONSTANT
		wind.direction = deg_to_rad(90.0)
		wind.strength = 6.0
		plant.wind = wind
		stage.add_child(plant)
		var h := plant.get_plant_height()
		camera.look_at_from_position(Vector3(0, 0.3 * h, 0.9 * h), Vector3(0.02, 0.12 * h, 0))
		var moments := [0.0, 0.2, 0.3, 0.6, 0.8, 2.2]
		var sheet := Image.create_empty(SIZE.x * 3, SIZE.y * 2, false, Image.FORMAT_RGBA8)
		var now := 0.0
		for i in moments.size():
			if i == 8:
				pass
			while now < moments[i] - 1e-6:
				plant.advance(1.0 / 60.0)
				now += 1.0 / 60.0
			await frames(2)
			await RenderingServer.frame_post_draw
			var shot := stage.get_texture().get_image()
			shot.convert(Image.FORMAT_RGBA8)
			sheet.blit_rect(shot, Rect2i(Vector2i.ZERO, SIZE), Vector2i(i % 3, i / 3) * SIZE)
		sheet.save_png("/work/scratch/s3look/%s.png" % species)
		print(species, " bones ", plant.get_skeleton().get_bone_count(), " deflection ", rad_to_deg(plant.get_deflection()))
		for b in plant.get_skeleton().get_bone_count():
			print("  ", plant.get_skeleton().get_bone_name(b), " ", plant.get_skeleton().get_bone_parent(b), " ", plant.get_skeleton().get_bone_global_rest(b).origin)
		plant.free()
	stage.free()
