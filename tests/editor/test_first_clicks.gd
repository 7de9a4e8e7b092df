@tool
extends "actions_test.gd"
## The first clicks of a new user: from a scene with a terrain to a swaying meadow on it. Each click
## meets a visible control; nothing is scrolled.

const SCENE := "res://first_clicks.tscn"
const MAX_CLICKS := 4
const SWAY_SCRIPT := "res://addons/undergrowth/editor/wind/sway_button.gd"

var _clicks := 0


func test_a_meadow_sways_on_a_terrain_after_four_clicks() -> void:
	var root := await _open_terrain()
	await _start_as_a_newcomer()
	_clicks = 0
	await _show_panel_by_a_click()
	check_equal(_state().title, "Meadow", "what is chosen at first")
	await _click_visible(part("Browser/Actions/AddField") as Control)
	print("clicks to a meadow: %d" % _clicks)
	check(_clicks <= MAX_CLICKS, "%d clicks" % _clicks)
	var field := _find_field(root)
	check(field != null, "the scene has a field: " + _message())
	if not field:
		return
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	check_equal(field.wind.kind, PlantWind.KIND_AIR, "kind of its wind")
	check(absf(field.wind.speed - 5.0) < 0.1, "a breeze: %f m/s" % field.wind.speed)
	check(await until(func() -> bool: return field.get_plant_count() > 100), "plants exist")
	await _check_on_terrain(field)
	check(await _sways(field), "it sways without another click")
	await take_picture("first_clicks")
	check_equal(_state().title, "Meadow", "what is chosen in the panel")
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after one step of undo")
	EditorInterface.save_scene()


func test_the_sway_changes_nothing_in_the_scene() -> void:
	var root := await _open_terrain()
	await open_panel()
	await _choose("Lawn")
	await _use("AddField")
	var field := _find_field(root)
	check(await until(func() -> bool: return field.get_plant_count() > 100), "plants exist")
	check(await _sways(field), "it sways")
	EditorInterface.save_scene()
	var saved := FileAccess.get_file_as_string(SCENE)
	var version := _history().get_version()
	check(await _sways(field), "it goes on")
	check_equal(_history().get_version(), version, "version of the scene")
	EditorInterface.save_scene()
	check_equal(FileAccess.get_file_as_string(SCENE), saved, "the saved scene")
	var id := field.get_plant_ids()[0]
	await _click_visible(find_by_script(SWAY_SCRIPT))
	await frames(5)
	var rest := field.get_tip_position(id)
	await frames(10)
	check_equal(field.get_tip_position(id), rest, "a tip after the button was switched off")
	check(not field.get_tip_position(id).is_zero_approx(), "it is a tip")
	await _use("AddField")
	check(not _state().sways, "it stays off when another field is added")
	await undo()


func test_another_field_has_the_wind_of_the_scene() -> void:
	var root := await _open_terrain()
	await _choose("Lawn")
	await _use("AddField")
	await _use("AddField")
	var first := root.get_child(1) as PlantField3D
	var second := root.get_child(2) as PlantField3D
	check(first and second, "two fields")
	check(second.wind == first.wind, "both have one wind")
	check_equal(second.species.size(), first.species.size(), "the mix was chosen still")
	await undo()
	await undo()


func test_another_mix_is_chosen_without_scrolling() -> void:
	var root := await _open_terrain()
	await _start_as_a_newcomer()
	await open_panel()
	_clicks = 0
	await _click_tile("Lawn")
	await _click_visible(part("Browser/Actions/AddField") as Control)
	check_equal(_clicks, 2, "clicks in the panel")
	check_equal(root.get_child(-1).name, &"Lawn", "the field that was added")
	await undo()


func test_ready_mixes_are_seen_at_once() -> void:
	await _start_as_a_newcomer()
	await open_panel()
	await click(part("Browser/List/Mixes") as Control)
	for i in tiles().item_count:
		check(_is_seen(i), tile_title(i) + " is visible without scrolling")
	await click(part("Browser/List/All") as Control)
	check(_is_seen(0), "a mix is the first of all tiles")


func _sways(field: PlantField3D) -> bool:
	var id := field.get_plant_ids()[0]
	var before := field.get_tip_position(id)
	var moves := func() -> bool: return field.get_tip_position(id).distance_to(before) > 1e-4
	return await until(moves)


## Fails the test unless the plants are at the height of the terrain.
func _check_on_terrain(field: PlantField3D) -> void:
	var worst := 0.0
	for id in field.get_plant_ids():
		var at := field.to_global(field.get_plant_transform(id).origin)
		worst = maxf(worst, absf(at.y - _height_at(at.x, at.z)))
	check(worst < 0.05, "%f m beside the terrain" % worst)


## The state of the editor after its start: the output log is in front of the panel, and the tiles
## are at their top.
func _start_as_a_newcomer() -> void:
	_select([])
	part("Browser").call(&"_choose_first")
	tiles().get_v_scroll_bar().value = 0.0
	(part("Browser/Actions/Surroundings") as CheckBox).button_pressed = true
	var tab := dock().get_parent() as EditorDock
	(tab.get_parent() as TabContainer).current_tab = -1
	await frames(5)
	check(not dock().is_visible_in_tree(), "the panel is closed")


func _show_panel_by_a_click() -> void:
	var tab := dock().get_parent() as EditorDock
	var tabs := tab.get_parent() as TabContainer
	var bar := tabs.get_tab_bar()
	await _click_visible(bar, bar.get_tab_rect(tabs.get_tab_idx_from_control(tab)).get_center())
	check(dock().is_visible_in_tree(), "the panel is in front")


func _click_tile(title: String) -> void:
	var index := find_tile(title)
	check(_is_seen(index), title + " is visible")
	await _click_visible(tiles(), place_of_tile(index))


func _is_seen(index: int) -> bool:
	var rect := tiles().get_item_rect(index)
	rect.position.y -= tiles().get_v_scroll_bar().value
	return Rect2(Vector2.ZERO, tiles().size).encloses(rect)


## Clicks [param control] and counts the click. Fails the test unless it is visible and receives it.
func _click_visible(control: Control, at := Vector2.INF) -> void:
	var place := control.get_global_transform() * (control.size * 0.5 if at == Vector2.INF else at)
	var window := EditorInterface.get_base_control().get_global_rect()
	check(control.is_visible_in_tree(), "%s is visible" % control.name)
	check(window.has_point(place), "%s is in the window" % control.name)
	_clicks += 1
	await click(control, at)
	var met := control.get_viewport().gui_get_hovered_control()
	check(
		met == control,
		"%s is below the pointer, not %s" % [control.name, met.name if met else &"any"]
	)


func _find_field(root: Node) -> PlantField3D:
	for child in root.get_children():
		if child is PlantField3D:
			return child
	return null


func _history() -> UndoRedo:
	var manager := EditorInterface.get_editor_undo_redo()
	var id := manager.get_object_history_id(EditorInterface.get_edited_scene_root())
	return manager.get_history_undo_redo(id)


static func _height_at(x: float, z: float) -> float:
	return 0.15 * x - 0.1 * z + 0.2


## Opens a scene with only a terrain: a sloping mesh and its collider.
func _open_terrain() -> Node3D:
	var mesh := _make_terrain()
	var root := Node3D.new()
	root.name = "Land"
	var body := StaticBody3D.new()
	body.name = "Terrain"
	root.add_child(body)
	body.owner = root
	var seen := MeshInstance3D.new()
	seen.name = "Mesh"
	seen.mesh = mesh
	var shape := CollisionShape3D.new()
	shape.name = "Shape"
	shape.shape = mesh.create_trimesh_shape()
	for child: Node in [seen, shape]:
		body.add_child(child)
		child.owner = root
	return await _open_alone(SCENE, root)


static func _make_terrain() -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for corner: Vector2 in [
		Vector2(-1, -1),
		Vector2(1, -1),
		Vector2(1, 1),
		Vector2(-1, -1),
		Vector2(1, 1),
		Vector2(-1, 1)
	]:
		var at := corner * 40.0
		tool.add_vertex(Vector3(at.x, _height_at(at.x, at.y), at.y))
	tool.generate_normals()
	return tool.commit()
