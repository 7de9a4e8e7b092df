## Draws plants on a device that compiles shaders and draws nothing; prints a JSON list of rows.
##
## tools/gpu starts it and reads its log. First it draws one material at a time, in a multimesh:
## plant_parts.gdshader, plant_cards.gdshader, and a StandardMaterial3D of two sides with vertex
## colours. Then it draws the scene of scene_bench.gd with each number of plants
## after `--`.
## After the last frame of each part the log gets a line: `mark shader NAME` or `mark scene PLANTS`.
## Rows contain the draw calls and primitives of the colour and shadow passes, as in scene_bench.gd.
extends "res://tests/bench/scene_bench.gd"

const SHADERS := {
	"plant_parts": "res://addons/undergrowth/shaders/plant_parts.gdshader",
	"plant_cards": "res://addons/undergrowth/shaders/plant_cards.gdshader",
}
const SPECIES := "res://addons/undergrowth/species/oxeye_daisy.tres"
const SEGMENTS := 12
const INSTANCES := 100
const STEADY_FRAMES := 180  # Idle threads of a loaded machine may start a task late.
const MAX_WAIT := 1800  # Frames.


func _run() -> void:
	if not RenderingServer.get_rendering_device():
		quit(1)
		return
	_add_surroundings()
	_camera.position = Vector3(0.0, EYE_HEIGHT, 10.0)
	var materials := _materials()
	for name in materials:
		await _draw_alone(name, materials[name])
	for count in OS.get_cmdline_user_args():
		await _count_drawn(int(count))
	print(JSON.stringify(_rows))
	quit()


## The materials that are measured alone, by name.
func _materials() -> Dictionary[String, Material]:
	var made: Dictionary[String, Material] = {}
	for name: String in SHADERS:
		var material := ShaderMaterial.new()
		material.shader = Shader.new()
		material.shader.code = _for_single_meshes(load(SHADERS[name]))
		made[name] = material
	made["StandardMaterial3D"] = _plain_material()
	return made


## Returns the code of a shader for the meshes of generate_mesh(), whose vertices are not packed.
func _for_single_meshes(shader: Shader) -> String:
	var folder := shader.resource_path.get_base_dir()
	var code := shader.code.replace("#define UNDERGROWTH_PACKED\n", "")
	return code.replace('#include "', '#include "%s/' % folder)


func _plain_material() -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.vertex_color_use_as_albedo = true
	material.vertex_color_is_srgb = true
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	return material


func _draw_alone(name: String, material: Material) -> void:
	var node := _add_alone(material, INSTANCES)
	await _settle()
	_mark("shader " + name)
	node.free()


## Adds a multimesh with the vertex attributes of a field.
func _add_alone(material: Material, instances: int) -> MultiMeshInstance3D:
	var drawn := MultiMesh.new()
	drawn.transform_format = MultiMesh.TRANSFORM_3D
	drawn.use_custom_data = true
	drawn.mesh = (load(SPECIES) as PlantFunction).generate_mesh(0.0, SEGMENTS)
	drawn.instance_count = instances
	for i in instances:
		drawn.set_instance_transform(i, Transform3D.IDENTITY)
		drawn.set_instance_custom_data(i, Color(0.0, 0.0, 0.0, 1.0))
	var node := MultiMeshInstance3D.new()
	node.multimesh = drawn
	node.material_override = material
	root.add_child(node)
	return node


func _count_drawn(count: int) -> void:
	var field := _add_field(count)
	await _build(field)
	await _settle()
	var row := _counts_of(field)
	row["name"] = "gpu_scene"
	_mark("scene %d" % row["plants"])
	_rows.append(row)
	await _remove(field)


## Waits until the engine compiles no more pipelines. Before that it draws with shaders that are not
## specialised for the scene, and cost more.
func _settle() -> void:
	var steady := 0
	var last := -1
	for frame in MAX_WAIT:
		await process_frame
		OS.delay_usec(FRAME_USEC)
		var compiled := _compiled_pipelines()
		steady = steady + 1 if compiled == last else 0
		last = compiled
		if steady < STEADY_FRAMES:
			continue
		var log := FileAccess.get_file_as_string(_log_path())
		if log.count("\ncompiling ") == log.count("\npipeline "):
			return


func _compiled_pipelines() -> int:
	var sum := 0
	for info: RenderingServer.RenderingInfo in [
		RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_CANVAS,
		RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_MESH,
		RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_SURFACE,
		RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_DRAW,
		RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_SPECIALIZATION,
	]:
		sum += RenderingServer.get_rendering_info(info)
	return sum


func _mark(text: String) -> void:
	var file := FileAccess.open(_log_path(), FileAccess.READ_WRITE)
	file.seek_end()
	file.store_line("mark " + text)


func _log_path() -> String:
	return OS.get_environment("UNDERGROWTH_GPU_LOG")
