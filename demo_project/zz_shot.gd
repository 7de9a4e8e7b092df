extends SceneTree
# --script shot.gd -- scene out name:x,y,z:tx,ty,tz:fov ...
func _initialize() -> void:
	var a := OS.get_cmdline_user_args()
	change_scene_to_file(a[0])
	_go.call_deferred(a)
func v(t: String) -> Vector3:
	var p := t.split_floats(",")
	return Vector3(p[0], p[1], p[2])
func _go(a: PackedStringArray) -> void:
	await scene_changed
	for l in current_scene.find_children("*", "CanvasLayer", true, false):
		l.hide()
	await RenderingServer.frame_post_draw
	RenderingServer.render_loop_enabled = false
	var fields := current_scene.find_children("*", "PlantField3D", true, false)
	for i in 400:
		await process_frame
		if i > 60 and fields.all(func(f): return not f.is_filling()): break
	for i in 40: await process_frame
	RenderingServer.render_loop_enabled = true
	root.size = Vector2i(800, 450)
	root.msaa_3d = Viewport.MSAA_2X
	var cam := Camera3D.new()
	cam.near = 0.05
	cam.far = 300
	root.add_child(cam)
	cam.make_current()
	for s in a.slice(2):
		var p := s.split(":")
		if p.size() == 1:
			var own: Camera3D = current_scene.get_node("Views/" + p[0])
			cam.fov = own.fov
			cam.global_transform = own.global_transform
			for i in 2: await RenderingServer.frame_post_draw
			root.get_texture().get_image().save_png("%s/%s.png" % [a[1], p[0]])
			print("%s: %d primitives %d draws" % [p[0], RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME), RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME)])
			continue
		cam.fov = float(p[3]) if p.size() > 3 else 50.0
		cam.global_position = v(p[1])
		cam.look_at(v(p[2]))
		for i in 1: await RenderingServer.frame_post_draw
		var t := Time.get_ticks_usec()
		await RenderingServer.frame_post_draw
		root.get_texture().get_image().save_png("%s/%s.png" % [a[1], p[0]])
		print("%s: %d primitives %d draws %.0f ms" % [p[0], RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME), RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME), (Time.get_ticks_usec() - t) / 1000.0])
	var n := 0
	for f in fields: n += f.get_plant_count()
	print("plants ", n)
	quit()
