## Looks at an exported game from within: its field fills, sways, is cut and saved. Prints `ok` and
## `not ok` as the engine tests do. After `--` one may say `--picture=PATH`.
extends Node

const SAVED := "user://field.tscn"
const STATE := "user://motion.dat"
const MINUTE := 60000
const TESTS := 4

var _field: PlantField3D
var _count := 0


func _ready() -> void:
	print("start")
	# In software a picture takes long, and one is enough.
	RenderingServer.render_loop_enabled = false
	_run.call_deferred()


func _run() -> void:
	await get_tree().process_frame
	_field = get_tree().current_scene.find_children("*", "PlantField3D", true, false)[0]
	_report("the field fills", await _fills())
	_report("its plants sway", await _sways())
	await _draw()
	_report("it is cut", _is_cut())
	_report("it is saved and loaded", await _is_saved())
	print("done %d" % TESTS)
	await _wait(10)
	OS.delay_msec(50)
	get_tree().quit()


func _report(test: String, fault: String) -> void:
	print("ok " + test if fault.is_empty() else "not ok %s: %s" % [test, fault])


func _wait(frames: int) -> void:
	for _frame in frames:
		await get_tree().process_frame


func _fills() -> String:
	var deadline := Time.get_ticks_msec() + 5 * MINUTE
	while _field.is_building() and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame
	_count = _field.get_plant_count()
	return "" if _count > 10000 and not _field.is_building() else "%d plants exist" % _count


func _sways() -> String:
	var ids := _field.get_plant_ids()
	var before := _field.get_tip_positions(ids)
	var deadline := Time.get_ticks_msec() + 2 * MINUTE
	var moved := 0
	while moved < ids.size() / 10.0 and Time.get_ticks_msec() < deadline:
		await get_tree().process_frame
		moved = 0
		var now := _field.get_tip_positions(ids)
		for i in ids.size():
			moved += 1 if now[i].distance_to(before[i]) > 0.01 else 0
	return "" if moved >= ids.size() / 10.0 else "%d of %d moved" % [moved, ids.size()]


## A picture of what sways, where one was asked for.
func _draw() -> void:
	for word in OS.get_cmdline_user_args():
		if word.begins_with("--picture="):
			RenderingServer.render_loop_enabled = true
			for _frame in 2:
				await RenderingServer.frame_post_draw
			RenderingServer.render_loop_enabled = false
			get_viewport().get_texture().get_image().save_png(word.trim_prefix("--picture="))


func _is_cut() -> String:
	var ids := _field.get_plant_ids()
	var place := _field.global_transform * _field.get_plant_transform(ids[0]).origin
	var gone := _field.find_plants_in_sphere(place, 1.0)
	_field.remove_in_sphere(place, 1.0)
	var are_gone := Array(gone).all(func(id: int) -> bool: return not _field.has_plant(id))
	var count := _field.get_plant_count()
	if ids[0] in gone and are_gone and count == ids.size() - gone.size():
		return ""
	return "%d of %d exist, %d should be gone" % [count, ids.size(), gone.size()]


## Its motion comes back from a file, and the field from a scene that was saved.
func _is_saved() -> String:
	var ids := _field.get_plant_ids().slice(0, 100)
	var state := _field.get_motion_state(ids)
	var file := FileAccess.open(STATE, FileAccess.WRITE)
	file.store_var(state)
	file.close()
	_field.reset_motion()
	_field.set_motion_state(ids, FileAccess.open(STATE, FileAccess.READ).get_var())
	var back := _field.get_motion_state(ids)
	for i in state.size():
		if absf(back[i] - state[i]) > 1e-3:
			return "number %d of the motion is %f, not %f" % [i, back[i], state[i]]
	for part in _field.find_children("*", "", true, false):
		part.owner = _field
	var scene := PackedScene.new()
	if scene.pack(_field) != OK or ResourceSaver.save(scene, SAVED) != OK:
		return "the field is not saved"
	var again: PlantField3D = (load(SAVED) as PackedScene).instantiate()
	_field.get_parent().add_child(again)
	await again.build_finished
	var count := again.get_plant_count()
	again.queue_free()
	return "" if count == _count else "%d plants came back, not %d" % [count, _count]
