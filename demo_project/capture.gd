extends SceneTree
## Takes pictures of a scene of the demo, with a display or under Xvfb:
##
## godot --path demo_project --rendering-method forward_plus --fixed-fps 15 --audio-driver Dummy
##     --script res://capture.gd -- --out=DIR [--scene=res://field/field.tscn] [--name=demo]
##     [--frames=60] [--every=1] [--size=1280x720] [--frame_size=640x360] [--views=yes]
##     [--fine=no]
##
## Writes DIR/demo.png (of that size, with the panel), DIR/views/NAME.png for each camera under the
## scene's node "Views" (without panels), and DIR/frames/000.png … (of frame_size without it, one
## per frame of --fixed-fps, or per --every frames, with a gust); no frames with --frames=0. With
## --fine=no plants are as coarse as without a graphics card. Ends with status 1 where it could not.
## Forward+ in software (lavapipe) is faster than Compatibility (llvmpipe) and looks better.

const WARM_UP_FRAMES := 100
const GUST_FRAME := 8

var _options := {
	"out": "",
	"scene": "res://field/field.tscn",
	"name": "demo",
	"frames": "60",
	"size": "1280x720",
	"frame_size": "640x360",
	"views": "",
	"every": "1",
	"fine": "yes",
}


func _initialize() -> void:
	for argument in OS.get_cmdline_user_args():
		var words := argument.trim_prefix("--").split("=", true, 1)
		if words.size() != 2 or not words[0] in _options:
			_fail("capture.gd does not know %s" % argument)
			return
		_options[words[0]] = words[1]
	if not _options["out"] or change_scene_to_file(_options["scene"]) != OK:
		_fail("capture.gd needs --out=DIR and a scene that can be loaded.")
		return
	_take_pictures.call_deferred()


func _take_pictures() -> void:
	var folder: String = _options["out"]
	var frames := int(_options["frames"])
	DirAccess.make_dir_recursive_absolute(folder.path_join("frames"))
	await _sway()
	await _draw_at(_size("size"))
	if not _save(folder.path_join("%s.png" % _options["name"])):
		return
	if _options["views"] and not await _take_views(folder.path_join("views")):
		return
	root.msaa_3d = Viewport.MSAA_2X  # In software a frame takes a third of the time.
	_hide_panels()
	await _draw_at(_size("frame_size"))
	var every := int(_options["every"])
	for index in frames:
		if index * every == GUST_FRAME:
			_trigger_gust()
		await _pass(every - 1)
		await RenderingServer.frame_post_draw
		if not _save(folder.path_join("frames/%03d.png" % index)):
			return
	quit()


## The scene from each of its cameras.
func _take_views(folder: String) -> bool:
	DirAccess.make_dir_recursive_absolute(folder)
	_hide_panels()
	var usual := root.get_camera_3d()
	for view: Camera3D in current_scene.get_node(^"Views").get_children():
		view.make_current()
		await _draw_at(root.size)
		if not _save(folder.path_join("%s.png" % view.name.to_snake_case())):
			return false
	usual.make_current()
	return true


## Lets the plants grow, and swing for some seconds, without drawing them.
func _sway() -> void:
	await scene_changed
	for panel in current_scene.find_children("WindPanel", "PanelContainer", true, false):
		panel.set(&"shows_frame_rate", false)
	await RenderingServer.frame_post_draw
	_draw(false)
	var fields := current_scene.find_children("*", "PlantField3D", true, false)
	if _options["fine"] == "yes":
		for panel in current_scene.find_children("PicturePanel", "PanelContainer", true, false):
			panel.call(&"draw_fine_plants")  # As a graphics card would show them.
	while fields.any(func(field: PlantField3D) -> bool: return field.is_building()):
		await process_frame
	await _pass(WARM_UP_FRAMES)


## Lets [param count] frames pass without drawing them.
func _pass(count: int) -> void:
	_draw(false)
	for _frame in count:
		await process_frame
	_draw(true)


## Without a render loop, Forward+ still draws each frame in which buffers change, so the 3D view is
## disabled, too.
func _draw(is_drawn: bool) -> void:
	RenderingServer.render_loop_enabled = is_drawn
	root.disable_3d = not is_drawn


## So small, panels hide the plants and can't be read.
func _hide_panels() -> void:
	for layer: CanvasLayer in current_scene.find_children("*", "CanvasLayer", true, false):
		layer.hide()


## Everything has that size from the second frame on.
func _draw_at(size: Vector2i) -> void:
	root.size = size
	await _pass(1)
	await RenderingServer.frame_post_draw


func _size(option: String) -> Vector2i:
	var size: PackedStringArray = _options[option].split("x")
	return Vector2i(int(size[0]), int(size[-1]))


func _trigger_gust() -> void:
	for panel in current_scene.find_children("WindPanel", "PanelContainer", true, false):
		(panel.get(&"wind") as PlantWind).trigger_gust()


func _save(path: String) -> bool:
	var image := root.get_texture().get_image()
	if image == null or image.save_png(path) != OK:
		_fail("capture.gd could not write %s" % path)
		return false
	return true


func _fail(message: String) -> void:
	printerr(message)
	quit(1)
