@tool
extends "actions_test.gd"
## The first clicks of a new user: from a scene with a terrain to a swaying meadow on it. Each click
## meets a visible control; nothing is scrolled.

const SCENE := "res://first_clicks.tscn"
const MAX_CLICKS := 4
## Of them for the arrows of the tab bar beside the inspector, which can hide the dock's tab.
const MAX_ARROWS := 2
const SWAY_SCRIPT := "res://addons/undergrowth/editor/wind_page/sway_button.gd"

var _clicks := 0
var _arrows := 0


func test_a_meadow_sways_on_a_terrain_after_four_clicks() -> void:
	var root := await _open_terrain()
	await _start_as_a_newcomer()
	_clicks = 0
	await _show_dock_by_clicks()
	check_equal(_state().title, "Meadow", "what is chosen at first")
	await _click_visible(part("Plant/Actions/AddField") as Control)
	print("clicks to a meadow: %d" % _clicks)
	check(_clicks <= MAX_CLICKS, "%d clicks" % _clicks)
	check(_arrows <= MAX_ARROWS, "%d arrows" % _arrows)
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
	check_equal(_state().title, "Meadow", "what is chosen in the dock")
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after one step of undo")
	EditorInterface.save_scene()


func test_the_sway_changes_nothing_in_the_scene() -> void:
	var root := await _open_terrain()
	await open_page("Plant")
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
	await open_page("Plant")
	_clicks = 0
	await _click_item("Lawn")
	await _click_visible(part("Plant/Actions/AddField") as Control)
	check_equal(_clicks, 2, "clicks in the dock")
	check_equal(root.get_child(-1).name, &"Lawn", "the field that was added")
	await undo()


func test_ready_mixes_are_seen_at_once() -> void:
	await _start_as_a_newcomer()
	await open_page("Plant")
	var list := part("Plant/List/MixList") as ItemList
	for i in list.item_count:
		var title := item_title(list, i)
		check(_seen_part().encloses(_rect_of(list, i)), title + " is visible without scrolling")


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


## The state of the editor after its start: the inspector is in front of the dock, and the list is
## at its top.
func _start_as_a_newcomer() -> void:
	_select([])
	part("Plant").call(&"_choose_first")
	(part("Plant/List/Scroll") as ScrollContainer).scroll_vertical = 0
	(part("Plant/Actions/Surroundings") as CheckBox).button_pressed = true
	await open_inspector()
	await frames(5)


## Clicks the dock's tab, after the arrow of the tab bar while the tab is not visible.
func _show_dock_by_clicks() -> void:
	var tab := dock().get_parent() as EditorDock
	var tabs := tab.get_parent() as TabContainer
	var bar := tabs.get_tab_bar()
	var index := tabs.get_tab_idx_from_control(tab)
	_arrows = 0
	while _is_cut(bar, index) and _clicks <= MAX_CLICKS:
		var arrow := bar.get_theme_icon(&"increment").get_width()
		var at := Vector2(bar.size.x - arrow * 0.5, bar.size.y * 0.5)
		await _click_visible(bar, at)
		_arrows += 1
	await _click_visible(bar, bar.get_tab_rect(index).get_center())
	check(dock().is_visible_in_tree(), "the dock is in front")


# A tab that does not fit keeps its old place.
static func _is_cut(bar: TabBar, index: int) -> bool:
	if not bar.get_offset_buttons_visible():
		return false
	var arrows := bar.get_theme_icon(&"increment").get_width() * 2.0
	var tab := bar.get_tab_rect(index)
	var first := bar.get_tab_offset()
	var is_after := index == first or tab.position.x > bar.get_tab_rect(index - 1).position.x
	return index < first or not is_after or tab.end.x > bar.size.x - arrows


func _click_item(title: String) -> void:
	var found := find_item(title)
	var list: ItemList = found[0]
	check(list != null, title + " is listed")
	if not list:
		return
	check(_seen_part().encloses(_rect_of(list, found[1])), title + " is visible")
	await _click_visible(list, list.get_item_rect(found[1]).get_center())


## The visible part of the list.
func _seen_part() -> Rect2:
	return (part("Plant/List/Scroll") as Control).get_global_rect()


func _rect_of(list: ItemList, index: int) -> Rect2:
	var rect := list.get_item_rect(index)
	rect.position += list.global_position
	return rect


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
