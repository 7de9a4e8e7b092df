extends SceneTree
# --script vary.gd -- out scene(cam) variantsfile : each variant: name, list of [from,to]
func _initialize() -> void:
	change_scene_to_file("res://field/field.tscn")
	_go.call_deferred(OS.get_cmdline_user_args())
func _go(a: PackedStringArray) -> void:
	await scene_changed
	for l in current_scene.find_children("*", "CanvasLayer", true, false):
		l.hide()
	await RenderingServer.frame_post_draw
	RenderingServer.render_loop_enabled = false
	var fields := current_scene.find_children("*", "PlantField3D", true, false)
	var began := Time.get_ticks_msec()
	for i in 20: await process_frame
	while fields.any(func(f): return f.is_filling()) and Time.get_ticks_msec() - began < 200000: await process_frame
	for i in 40: await process_frame
	RenderingServer.render_loop_enabled = true
	root.size = Vector2i(1280, 720)
	paused = true
	var variants: Array = JSON.parse_string(FileAccess.get_file_as_string(a[1]))
	var scene_cam := root.get_camera_3d()
	var cam := Camera3D.new()
	cam.near = 0.02
	cam.far = 300
	root.add_child(cam)
	cam.make_current()
	var shaders := {}
	for v in variants:
		var own: Camera3D = scene_cam if v.cam == "own" else current_scene.get_node("Views/" + v.cam)
		cam.fov = own.fov
		cam.global_transform = own.global_transform
		for p in shaders: (load(p) as Shader).code = shaders[p]
		for e in v.get("edits", []):
			var path: String = "res://addons/undergrowth/shaders/plant_parts.gdshader"
			var s := load(path) as Shader
			if not path in shaders: shaders[path] = s.code
			var code := s.code
			if not (e[0] in code): print("MISSING ", e[0])
			s.code = code.replace(e[0], e[1])
		for k in v.get("sun", {}): current_scene.get_node("Sun").set(k, v.sun[k])
		for i in 3: await RenderingServer.frame_post_draw
		root.get_texture().get_image().save_png("%s/%s.png" % [a[0], v.name])
		print("%s: %d primitives %d draws" % [v.name, RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME), RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME)])
	var n := 0
	for f in fields: n += f.get_plant_count()
	print("plants ", n)
	quit()
