@tool
extends "editor_test.gd"
## The plant page: the list, the preview, the properties.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const MANY := 20
const MANY_FILES := "res://dock_many_%d.tres"
const SPECIES_FILE := "res://dock_species.tres"


func test_dock_shows_a_plant() -> void:
	check(dock() != null, "the dock exists")
	await open_page("Plant")
	check(dock().is_visible_in_tree(), "the dock is visible")
	var found := find_item("Poppy")
	await click_item(found[0], found[1])
	check(_state().function != null, "a species is chosen")
	check_equal(_state().problem, "", "problem")
	var counts := part("Plant/Preview/Counts") as Label
	check(counts.text.contains("tris"), "triangles are counted: " + counts.text)


func test_click_chooses_each_species_that_ships() -> void:
	await open_page("Plant")
	var simple := part("Plant/List/SimpleList") as ItemList
	check(simple.item_count >= 6, "the five species of the thesis and the one of curves are listed")
	for list: ItemList in [part("Plant/List/ReadyList"), simple]:
		for i in list.item_count:
			await click_item(list, i)
			check_equal(_state().title, item_title(list, i), "chosen species")
			check_equal(_state().problem, "", "problem of " + _state().title)
			check(_state().function != null and not _state().mix, "it is a species")


func test_thumbnails_arrive() -> void:
	var seen: Dictionary[int, bool] = {}
	var count := 0
	for name: String in LISTS.slice(0, 3):
		var list := part("Plant/List/" + name) as ItemList
		check(await until(_have_arrived.bind(list)), "every item has a thumbnail: " + name)
		count += list.item_count
		for i in list.item_count:
			var picture := list.get_item_icon(i).get_image()
			seen[hash(picture.get_data())] = true
			var used := picture.get_used_rect().size
			check(
				maxi(used.x, used.y) > picture.get_height() * 0.8,
				"%s fills its picture: %s" % [list.get_item_text(i), used]
			)
	check_equal(seen.size(), count, "different thumbnails")


func _have_arrived(list: ItemList) -> bool:
	var waiting := list.get_theme_icon(&"FileThumbnail", &"EditorIcons")
	for i in list.item_count:
		if list.get_item_icon(i) == waiting:
			return false
	return true


func test_filter_leaves_what_matches() -> void:
	await open_page("Plant")
	var filter := part("Plant/List/Filter") as LineEdit
	var list := part("Plant/List/SimpleList") as ItemList
	await click(filter)
	await type(filter, "tul")
	check_equal(list.item_count, 1, "species with tul")
	check(not (part("Plant/List/Mixes") as Control).visible, "a group without any is hidden")
	await type(filter, "x")
	check((part("Plant/List/NoMatch") as Label).visible, "the list says that nothing matches")
	for i in 4:
		await press_key(filter, KEY_BACKSPACE)
	check(list.item_count >= 6, "all species are back")


func test_preview_turns_and_zooms() -> void:
	await open_page("Plant")
	var view := part("Plant/Preview/View") as Control
	var camera := part("Plant/Preview/Camera") as Camera3D
	var before := camera.position
	await drag(view, view.size * 0.5, view.size * 0.5 + Vector2(60, 0))
	check(not camera.position.is_equal_approx(before), "a drag turns the camera")
	var distance := camera.position.length()
	await wheel(view, 3)
	check(camera.position.length() < distance, "the wheel brings the camera nearer")
	await click(part("Plant/Preview/Reset") as Control)
	check(camera.position.is_equal_approx(before), "the button puts it back")


func test_preview_sways() -> void:
	await open_page("Plant")
	var plant := part("Plant/Preview/Plants").get_child(0) as Plant3D
	var maximum := 0.0
	for i in 60:
		await frames(1)
		maximum = maxf(maximum, plant.get_deflection())
	check(maximum > 0.005, "the plant moves in the wind, by %f rad" % maximum)
	var play := part("Plant/Preview/Play") as Button
	await click(play)
	var held := plant.get_tip_position()
	await frames(10)
	check_equal(plant.get_tip_position(), held, "tip of the paused plant")
	await click(play)


func test_overlays_and_levels() -> void:
	await open_page("Plant")
	var plants := part("Plant/Preview/Plants")
	for name: String in ["Rings", "Bones", "Levels"]:
		await click(part("Plant/Preview/" + name) as Control)
	await frames(2)
	check_equal(plants.get_child_count(), 4, "levels side by side")
	var segments := plants.get_children().map(func(node: Plant3D) -> int: return node.segments)
	check_equal(segments, Array(EditorState.LEVELS), "their segments")
	await take_picture("levels")
	for name: String in ["Rings", "Bones", "Levels"]:
		await click(part("Plant/Preview/" + name) as Control)
	await frames(2)
	check_equal(plants.get_child_count(), 1, "plants after switching back")


func test_next_plant_of_the_species() -> void:
	await open_page("Plant")
	var before := _state().seed_value
	await click(part("Plant/ViewControls/Dice") as Control)
	check_equal(_state().seed_value, before + 1, "seed")


func test_project_species_come_and_go() -> void:
	await open_page("Plant")
	var list := part("Plant/List/ProjectList") as ItemList
	var tulip := TulipFunction.new()
	check_equal(ResourceSaver.save(tulip, SPECIES_FILE), OK, "saving")
	EditorInterface.get_resource_filesystem().scan()
	var listed := func() -> bool: return _index_of(list, SPECIES_FILE) >= 0
	check(await until(listed), "a new file appears in the list")
	await click_item(list, _index_of(list, SPECIES_FILE))
	check_equal(_state().path, SPECIES_FILE, "path of the chosen species")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(SPECIES_FILE))
	EditorInterface.get_resource_filesystem().scan()
	var gone := func() -> bool: return _index_of(list, SPECIES_FILE) < 0
	check(await until(gone), "a deleted file leaves the list")
	check(_state().function is TulipFunction, "its plant stays")
	var text := (part("Status/Text") as Label).text
	check(text.contains(SPECIES_FILE), "the status line: " + text)


func test_list_is_refreshed_while_pictures_wait() -> void:
	await open_page("Plant")
	var list := part("Plant/List/ProjectList") as ItemList
	for i in MANY:
		var path := MANY_FILES % i
		check_equal(ResourceSaver.save(ReedFunction.new(), path), OK, "saving " + path)
		if i < MANY - 2:
			continue
		EditorInterface.get_resource_filesystem().scan()
		check(await until(func() -> bool: return _index_of(list, path) >= 0), path + " is listed")
	await frames(MANY)
	for i in MANY:
		DirAccess.remove_absolute(ProjectSettings.globalize_path(MANY_FILES % i))
	EditorInterface.get_resource_filesystem().scan()
	var gone := func() -> bool: return _index_of(list, MANY_FILES % (MANY - 1)) < 0
	check(await until(gone), "deleted files leave the list")


func test_picture_of_the_plant_page() -> void:
	await open_page("Plant")
	var list := part("Plant/List/SimpleList") as ItemList
	await click_item(list, 3)
	await frames(30)
	await take_picture("plant")


func _state() -> EditorState:
	return dock().get("state")


func _index_of(list: ItemList, key: String) -> int:
	for i in list.item_count:
		if list.get_item_tooltip(i) == key:
			return i
	return -1


func test_property_changes_are_undone() -> void:
	await open_page("Plant")
	var list := part("Plant/List/SimpleList") as ItemList
	await click_item(list, 0)
	var grass := _state().function as GrassFunction
	var before := grass.blade_width
	var slider := _find_slider("blade_width")
	check(slider != null, "the inspector shows the width of a blade")
	await _bring_into_sight(slider)
	await click(slider, Vector2(slider.size.x * 0.3, slider.size.y * 0.4))
	await frames(3)
	await press_key(slider, KEY_A, 0, true)
	await type(slider, "0.05")
	await press_key(slider, KEY_ENTER)
	await frames(2)
	check_equal(grass.blade_width, 0.05, "width as typed")
	var after := grass.blade_width
	await undo()
	check_equal(grass.blade_width, before, "width after undo")
	await redo()
	check_equal(grass.blade_width, after, "width after redo")
	await undo()


func test_a_stem_has_its_properties_and_bones() -> void:
	await open_page("Plant")
	await click_item(part("Plant/List/SimpleList") as ItemList, 0)
	var grass := _state().function
	check(not _shows("stem"), "a plant of one joint has no stem")
	grass.law = PlantFunction.LAW_STEM
	await frames(5)
	check(_shows("stem") and _shows("natural_frequency"), "the stem is shown")
	check(not _shows("mass"), "its mass is not shown")
	grass.stem = PlantStem.new()
	grass.stem.joints = 3
	for name: String in ["Rings", "Bones"]:
		await click(part("Plant/Preview/" + name) as Control)
	await frames(5)
	var plant := part("Plant/Preview/Plants").get_child(0) as Plant3D
	check_equal(plant.get_joint_count(), 3, "joints")
	for overlay: Node in plant.get_skeleton().get_children():
		var lines := (overlay as MeshInstance3D).mesh
		var bones: PackedInt32Array = lines.surface_get_arrays(0)[Mesh.ARRAY_BONES]
		check_equal(Array(bones).max(), 4, "the last link's bone")
	await take_picture("stem")
	for name: String in ["Rings", "Bones"]:
		await click(part("Plant/Preview/" + name) as Control)
	grass.stem = null
	grass.law = PlantFunction.LAW_SPRING


func _shows(property: String) -> bool:
	for editor: EditorProperty in dock().find_children("*", "EditorProperty", true, false):
		if editor.get_edited_property() == property:
			return true
	return false


func _bring_into_sight(control: Control) -> void:
	var above := control.get_parent()
	while above is not EditorInspector:
		above = above.get_parent()
	(above as EditorInspector).ensure_control_visible(control)
	await frames(2)


func _find_slider(property: String) -> EditorSpinSlider:
	for editor: EditorProperty in dock().find_children("*", "EditorProperty", true, false):
		if editor.get_edited_property() == property:
			return editor.find_children("*", "EditorSpinSlider", true, false)[0]
	return null


func test_width_curve_is_dragged() -> void:
	await open_page("Plant")
	var list := part("Plant/List/SimpleList") as ItemList
	await click_item(list, list.item_count - 1)
	var curve := (_state().function as CurvePlantFunction).width_curve
	var points := part("Plant/Points") as Control
	await frames(2)
	var grip := Vector2(points.size.x * curve.get_point_position(1).x, 0.0)
	await drag(points, grip, grip + Vector2(30.0, 12.0))
	var moved := curve.get_point_position(1)
	check(moved.x > 0.5 and moved.y < 0.8, "the point went along: %s" % moved)
	await undo()
	check(curve.get_point_position(1).is_equal_approx(Vector2(0.45, 1.0)), "undo puts it back")
	await redo()
	check(curve.get_point_position(1).is_equal_approx(moved), "redo moves it again")
	await take_picture("curves")
	await double_click(points, Vector2(points.size.x * 0.2, points.size.y * 0.4))
	check_equal(curve.point_count, 4, "points after a double-click")
	await undo()
	check_equal(curve.point_count, 3, "points after undo")
	var place := Vector2(moved.x, 0.5 - 0.5 * moved.y) * points.size
	await click(points, place, MOUSE_BUTTON_RIGHT)
	check_equal(curve.point_count, 2, "points after a right click")
	await undo()
	await undo()
