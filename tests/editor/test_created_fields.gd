@tool
extends "actions_test.gd"
## Fields of the Create Node dialog lie on the ground and have the wind of the scene, after one step
## of undo. A field above the ground has a warning with the remedy.

const SCENE := "res://created_fields.tscn"
const BAR_SCRIPT := "res://addons/undergrowth/editor/brush/brush_bar.gd"
## Metres.
const TOLERANCE := 0.05
const PLACE := "Place on Ground"


func test_a_created_field_lies_on_the_collider_below_it() -> void:
	var root := await _open_slope(true)
	var field := await _create(root)
	if not field:
		return
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode")
	await _check_slope(field)
	check(field.wind and field.wind.kind == PlantWind.KIND_AIR, "it has wind")
	check(find_warning(field, PLACE).is_empty(), "no warning: " + find_warning(field, PLACE))
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after one step of undo")
	await redo()
	check_equal(root.get_child_count(), 2, "nodes after redo")
	check_equal(field.ground_mode, PlantField3D.GROUND_COLLIDERS, "ground mode after redo")
	check(absf(field.position.y + 3.0) < TOLERANCE, "its place after redo: %s" % field.position)
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after undo of the redone step")


func test_a_created_field_lies_on_the_mesh_above_it() -> void:
	var root := await _open_slope(false, 3.0)
	var field := await _create(root)
	if not field:
		return
	check_equal(field.ground_mode, PlantField3D.GROUND_MESH, "ground mode")
	await _check_slope(field)
	await undo()


func test_a_created_field_without_ground_stays_in_its_place() -> void:
	var root := await _open_slope(true, 0.0, Vector3(300.0, 0.0, 0.0))
	var field := await _create(root)
	if not field:
		return
	check_equal(field.ground_mode, PlantField3D.GROUND_NONE, "ground mode")
	check_equal(field.position, Vector3.ZERO, "position")
	check(field.wind != null, "it has wind")
	await undo()
	check_equal(root.get_child_count(), 1, "nodes after one step of undo")


func test_a_field_above_the_ground_has_a_warning_until_it_is_placed() -> void:
	var root := await _open_slope(true)
	var field := PlantField3D.new()
	field.size = Vector2(4.0, 4.0)
	field.density = 2.0
	var undo_manager := EditorInterface.get_editor_undo_redo()
	undo_manager.create_action("Paste Node(s)", UndoRedo.MERGE_DISABLE, root)
	undo_manager.add_do_method(root, &"add_child", field, true)
	undo_manager.add_do_property(field, &"owner", root)
	undo_manager.add_do_reference(field)
	undo_manager.add_undo_method(root, &"remove_child", field)
	undo_manager.commit_action()
	var is_warned := func() -> bool: return find_warning(field, PLACE).contains(PLACE)
	check(await until(is_warned), "the scene dock shows the warning")
	_select([field])
	EditorInterface.edit_node(field)
	await frames(5)
	await click(find_by_script(BAR_SCRIPT).get_node(^"%Place") as Control)
	check(await until(func() -> bool: return not is_warned.call()), "the warning is gone")
	await _check_slope(field)
	await undo()
	check(await until(is_warned), "the warning is back after undo")
	await undo()


func test_a_field_on_a_level_plane_has_no_warning() -> void:
	var root := await _open_slope(false, 0.0, Vector3.ZERO, Basis.IDENTITY)
	var field := await _create(root)
	if not field:
		return
	await frames(20)
	check_equal(field.ground_mode, PlantField3D.GROUND_NONE, "ground mode")
	check(find_warning(field, PLACE).is_empty(), "no warning: " + find_warning(field, PLACE))
	await undo()


func test_a_field_that_is_kept_flat_has_no_warning() -> void:
	var root := await _open_slope(true)
	var field := PlantField3D.new()
	field.name = "Lilies"
	root.add_child(field)
	field.owner = root
	_select([field])
	EditorInterface.get_editor_undo_redo().history_changed.emit()
	check(await until(func() -> bool: return find_warning(field, PLACE) != ""), "it has a warning")
	var button := find_by_script(BAR_SCRIPT).get_node("%KeepFlat") as Button
	await click(button)
	check(
		await until(func() -> bool: return find_warning(field, PLACE) == ""), "it has none any more"
	)
	await undo()
	check(
		await until(func() -> bool: return find_warning(field, PLACE) != ""), "undo brings it back"
	)
	check(not button.button_pressed, "the button is up")
	await redo()
	check(
		await until(func() -> bool: return find_warning(field, PLACE) == ""), "redo takes it away"
	)
	check_equal(EditorInterface.save_scene(), OK, "saving")
	var saved := FileAccess.get_file_as_string(SCENE)
	check(saved.contains("_undergrowth_keep_flat"), "the scene keeps it")


## Creates a field below [param root] with the Create Node dialog.
func _create(root: Node) -> PlantField3D:
	_select([root])
	await frames(3)
	await press_key(EditorInterface.get_base_control(), KEY_A, 0, true)
	await frames(5)
	var dialog := _find_create_dialog()
	check(dialog != null, "the dialog opens")
	if not dialog:
		return null
	var line: LineEdit = dialog.find_children("*", "LineEdit", true, false)[0]
	await type(line, "PlantField3D")
	await frames(5)
	await press_key(line, KEY_ENTER)
	await frames(5)
	var field := root.get_child(-1) as PlantField3D
	check(field != null, "the dialog has created a field")
	return field


func _find_create_dialog() -> Window:
	for dialog: Window in EditorInterface.get_base_control().find_children(
		"*", "CreateDialog", true, false
	):
		if dialog.visible:
			return dialog
	return null


## Opens a scene with a slope through [param at], [param height] m above y = -3 (or a plane at 0).
func _open_slope(
	is_solid: bool, height := -3.0, at := Vector3.ZERO, basis := Basis(Vector3.RIGHT, 0.3)
) -> Node3D:
	var root := Node3D.new()
	root.name = "Land"
	var ground: Node3D
	var size := Vector3(40.0, 1.0, 40.0)
	if is_solid:
		ground = StaticBody3D.new()
		var shape := CollisionShape3D.new()
		shape.shape = BoxShape3D.new()
		(shape.shape as BoxShape3D).size = size
		ground.add_child(shape)
	else:
		ground = MeshInstance3D.new()
		(ground as MeshInstance3D).mesh = (
			_make_plane() if basis == Basis.IDENTITY else _make_box(size)
		)
	ground.name = "Slope"
	root.add_child(ground)
	ground.owner = root
	for child in ground.get_children():
		child.owner = root
	# Its upper side goes through the height at the centre.
	var top := 0.0 if basis == Basis.IDENTITY else 0.5 / basis.y.y
	ground.transform = Transform3D(basis, at + Vector3.UP * (height - top))
	return await _open_alone(SCENE, root)


static func _make_plane() -> PlaneMesh:
	var plane := PlaneMesh.new()
	plane.size = Vector2(40.0, 40.0)
	return plane


static func _make_box(size: Vector3) -> BoxMesh:
	var box := BoxMesh.new()
	box.size = size
	return box


## Fails the test unless the plants lie on the slope.
func _check_slope(field: PlantField3D) -> void:
	check(await until(func() -> bool: return field.get_plant_count() > 0), "plants exist")
	var worst := 0.0
	for id in field.get_plant_ids():
		var at := field.get_plant_transform(id).origin
		worst = maxf(worst, absf(at.y + tan(0.3) * at.z))
	check(worst < TOLERANCE, "%f m beside the ground" % worst)
