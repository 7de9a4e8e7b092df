@tool
extends "actions_test.gd"
## Mixes and species that are dropped on the 3D view: from the dock's tiles and from the FileSystem.

const SCENE := "res://drop.tscn"
const MEADOW := "res://addons/undergrowth/mixes/meadow.tscn"
const POPPY := "res://addons/undergrowth/species/poppy.tres"
## Of the view's size: beside its centre.
const PLACE := Vector2(0.35, 0.6)
const AREA_SCRIPT := "res://addons/undergrowth/editor/field/drop_area.gd"


func test_a_mix_is_dropped_on_the_ground_below_the_pointer() -> void:
	var root := await _open_ramp()
	await _drag_tile("Meadow", PLACE)
	var field := root.get_child(-1) as PlantField3D
	check(field != null, "the scene has a field: " + _message())
	if not field:
		return
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	check_equal(field.wind.kind, PlantWind.KIND_AIR, "kind of its wind")
	check_equal(field.name, &"Meadow", "its name")
	check_equal(field.scene_file_path, "", "it is the scene's own")
	check(_place_of(field).distance_to(PLACE) < 0.03, "drawn at %s" % _place_of(field))
	check(absf(field.global_position.y - _ramp_at(field.global_position)) < 0.05, "on the ground")
	check(await until(func() -> bool: return field.get_plant_count() > 100), "plants exist")
	check(_state().sways, "it sways")
	await take_picture("dropped")
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after one step of undo")


func test_a_species_is_dropped() -> void:
	var root := await _open_ramp()
	for title: String in ["Poppy", "Tulip"]:
		await _drag_tile(title, PLACE)
		var field := root.get_child(-1) as PlantField3D
		check(field != null, "the scene has a field: " + _message())
		if not field:
			return
		check_equal(field.species.size(), 1, "species of " + title)
		check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
		check(field.wind != null, "it has a wind")
		await undo()
		check_equal(root.get_child_count(), 1, "nodes after undo")


func test_files_are_dropped_from_the_file_system() -> void:
	var root := await _open_ramp()
	for path: String in [MEADOW, POPPY]:
		await _drag_file(path, PLACE)
		var field := root.get_child(-1) as PlantField3D
		check(field != null, "%s gives a field: %s" % [path, _message()])
		if not field:
			return
		check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
		check_equal(field.wind.kind, PlantWind.KIND_AIR, "kind of its wind")
		await undo()
		check_equal(root.get_child_count(), 1, "nodes after one step of undo")


func test_without_ground_the_field_is_in_view_and_the_message_says_so() -> void:
	var root := await _open_ramp()
	root.get_child(0).free()
	await frames(5)
	await _drag_tile("Lawn", PLACE)
	var field := root.get_child(-1) as PlantField3D
	check_equal(field.ground_mode, PlantField3D.GROUND_NONE, "ground mode")
	check(_place_of(field).distance_to(PLACE) < 0.03, "drawn at %s" % _place_of(field))
	check(_message().contains("no ground is below the pointer"), "the message: " + _message())
	await undo()


func test_other_drags_are_the_editors() -> void:
	await _open_ramp()
	var area := find_by_script(AREA_SCRIPT)
	for data: Variant in [
		{"type": "files", "files": PackedStringArray([SCENE])},
		{"type": "files", "files": PackedStringArray([MEADOW, POPPY])},
		{"type": "nodes", "nodes": []},
		"text",
	]:
		EditorInterface.get_base_control().force_drag(data, null)
		await frames(2)
		check(not area.visible, "not taken: %s" % [data])
		EditorInterface.get_base_control().get_viewport().gui_cancel_drag()
		await frames(2)


func _drag_tile(title: String, share: Vector2) -> void:
	await open_panel()
	_select([])
	var index := find_tile(title)
	await reveal_tile(index)
	await _drag_between(tiles(), tiles().global_position + place_of_tile(index), _in_view(share))


## Drags the file in the tree of the FileSystem.
func _drag_file(path: String, share: Vector2) -> void:
	_select([])
	EditorInterface.select_file(path)
	await frames(10)
	var tree: Tree = null
	var item: TreeItem = null
	for found: Tree in EditorInterface.get_file_system_dock().find_children(
		"*", "Tree", true, false
	):
		var chosen := found.get_selected()
		if chosen and str(chosen.get_metadata(0)) == path:
			tree = found
			item = chosen
	for found: Tree in EditorInterface.get_file_system_dock().find_children(
		"*", "Tree", true, false
	):
		check(item != null, path + " is selected in the FileSystem")
	if not item:
		return
	tree.scroll_to_item(item, true)
	await frames(3)
	var at := Vector2(tree.size.x * 0.5, 0.0)
	while tree.get_item_at_position(at) != item and at.y < tree.size.y:
		at.y += 4.0
	at.y += 6.0  # Within its row.
	await _drag_between(tree, tree.global_position + at, _in_view(share))


# While something is dragged, the engine reads the position of the system's pointer.
func _drag_between(control: Control, from: Vector2, to: Vector2) -> void:
	var before := EditorInterface.get_base_control().get_viewport().get_mouse_position()
	await _point(control, from)
	_press(control, from, MOUSE_BUTTON_LEFT, true)
	await frames(1)
	for i in DRAG_STEPS:
		var now := from.lerp(to, float(i + 1) / DRAG_STEPS)
		Input.warp_mouse(now)
		_move(control, from, now, MOUSE_BUTTON_MASK_LEFT)
		await frames(2)
	var area := find_by_script(AREA_SCRIPT) as Control
	var is_over := func() -> bool:
		_move(control, to, to, MOUSE_BUTTON_MASK_LEFT)
		return control.get_viewport().gui_get_hovered_control() == area
	check(await until(is_over), "the drop area is under the pointer")
	_press(control, to, MOUSE_BUTTON_LEFT, false)
	await frames(5)
	Input.warp_mouse(before)
	await frames(2)


func _in_view(share: Vector2) -> Vector2:
	var view := _view()
	return view.global_position + view.size * share


func _view() -> Control:
	return EditorInterface.get_editor_viewport_3d(0).get_parent() as Control


## Where the field's origin is drawn, as a share of the view's size.
func _place_of(field: PlantField3D) -> Vector2:
	var viewport := EditorInterface.get_editor_viewport_3d(0)
	var pixel := viewport.get_camera_3d().unproject_position(field.global_position)
	return pixel / Vector2(viewport.size)


static func _ramp_at(place: Vector3) -> float:
	return 0.5 - tan(0.1) * place.z


## Opens a scene with a ramp: a box with a collider.
func _open_ramp() -> Node3D:
	var root := Node3D.new()
	root.name = "Slope"
	var ramp := CSGBox3D.new()
	ramp.name = "Ramp"
	ramp.size = Vector3(60.0, 1.0 * cos(0.1), 60.0)
	ramp.rotation.x = 0.1
	ramp.use_collision = true
	root.add_child(ramp)
	ramp.owner = root
	return await _open_alone(SCENE, root)
