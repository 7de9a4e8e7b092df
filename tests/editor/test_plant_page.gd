@tool
extends "editor_test.gd"
## The panel's tiles, and a species in the inspector: its preview and its properties.

const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const MANY := 20
const MANY_FILES := "res://dock_many_%d.tres"
const SPECIES_FILE := "res://dock_species.tres"
const GRASS := "Grass"


func test_a_double_click_opens_a_species_in_the_inspector() -> void:
	check(dock() != null, "the panel exists")
	await inspect("Poppy")
	check(dock().is_visible_in_tree(), "the panel is visible")
	check(_state().function != null, "a species is chosen")
	check_equal(_state().problem, "", "problem")
	check(EditorInterface.get_inspector().get_edited_object() == _state().function, "inspected")
	var counts := preview_part("Counts") as Label
	check(counts.text.contains("tris"), "triangles are counted: " + counts.text)
	var view := preview_part("View") as Control
	check(view.size.y >= 200.0 * EditorInterface.get_editor_scale(), "height: %f" % view.size.y)


func test_a_double_click_on_a_mix_opens_nothing() -> void:
	await inspect("Poppy")
	var before := EditorInterface.get_inspector().get_edited_object()
	await inspect("Meadow")
	check(EditorInterface.get_inspector().get_edited_object() == before, "what is inspected")
	var text := (part("Status/Text") as Label).text
	check(text.contains("several species"), "the status line: " + text)


func test_click_chooses_each_species_that_ships() -> void:
	await open_panel()
	for category: String in ["Ready", "Simple"]:
		await click(part("Browser/List/" + category) as Control)
		check(tiles().item_count >= 6, category)
		for i in tiles().item_count:
			await click_tile(i)
			check_equal(_state().title, tile_title(i), "chosen species")
			check_equal(_state().problem, "", "problem of " + _state().title)
			check(_state().function != null and not _state().mix, "it is a species")


func test_thumbnails_arrive() -> void:
	await open_panel()
	check(await until(_have_arrived), "every tile has a thumbnail")
	var seen: Dictionary[int, bool] = {}
	var count := 0
	for i in tiles().item_count:
		if tile_key(i).begins_with("res://") and not tile_key(i).begins_with("res://addons/"):
			continue
		var picture := tiles().get_item_icon(i).get_image()
		seen[hash(picture.get_data())] = true
		count += 1
		var used := picture.get_used_rect().size
		var is_filled := maxi(used.x, used.y) > picture.get_height() * 0.8
		check(is_filled, "%s fills its picture: %s" % [tile_title(i), used])
	check_equal(seen.size(), count, "different thumbnails")


func _have_arrived() -> bool:
	var waiting := tiles().get_theme_icon(&"FileThumbnail", &"EditorIcons")
	for i in tiles().item_count:
		if tiles().get_item_icon(i) == waiting:
			return false
	return true


func test_filter_leaves_what_matches() -> void:
	await open_panel()
	var filter := part("Browser/List/Filter") as LineEdit
	var count := tiles().item_count
	await click(filter)
	await type(filter, "tul")
	check_equal(tiles().item_count, 2, "species with tul")
	await type(filter, "x")
	check((part("Browser/List/NoMatch") as Label).visible, "the list says that nothing matches")
	for i in 4:
		await press_key(filter, KEY_BACKSPACE)
	check_equal(tiles().item_count, count, "all are back")


func test_preview_turns_and_zooms() -> void:
	await inspect("Poppy")
	var view := preview_part("View") as Control
	var camera := preview_part("Camera") as Camera3D
	var before := camera.position
	await drag(view, view.size * 0.5, view.size * 0.5 + Vector2(60, 0))
	check(not camera.position.is_equal_approx(before), "a drag turns the camera")
	var distance := camera.position.length()
	await wheel(view, 3)
	check_equal(camera.position.length(), distance, "distance: the wheel scrolls the inspector")
	holds_ctrl = true
	await wheel(view, 3)
	holds_ctrl = false
	check(camera.position.length() < distance, "with Ctrl it brings the camera nearer")
	var near := camera.position
	_state().function.notify_property_list_changed()
	await frames(5)
	camera = preview_part("Camera") as Camera3D
	check(camera.position.is_equal_approx(near), "it stays when the inspector is built again")
	await click(preview_part("Reset") as Control)
	check(camera.position.is_equal_approx(before), "the button puts it back")


func test_preview_shows_the_plant_between_covered_parts() -> void:
	await inspect("Poppy")
	var camera := preview_part("Camera") as Camera3D
	var height: float = camera.get_viewport().get_visible_rect().size.y
	var usual: Vector2 = camera.get("_covered")
	for covered: Vector2 in [Vector2(0.3, 0.0), Vector2(0.0, 0.3)]:
		camera.call(&"spare", covered * height)
		var middle := camera.unproject_position(camera.get("_center")).y / height
		var free := 0.5 * (covered.x + 1.0 - covered.y)
		check(absf(middle - free) < 0.03, "the plant is at %.2f, not %.2f" % [middle, free])
	camera.call(&"spare", usual)


func test_preview_sways() -> void:
	await inspect("Poppy")
	var plant := preview_part("Plants").get_child(0) as Plant3D
	var maximum := 0.0
	for i in 60:
		await frames(1)
		maximum = maxf(maximum, plant.get_deflection())
	check(maximum > 0.005, "the plant moves in the wind, by %f rad" % maximum)
	var play := preview_part("Play") as Button
	await click(play)
	var held := plant.get_tip_position()
	await frames(10)
	check_equal(plant.get_tip_position(), held, "tip of the paused plant")
	await click(play)


func test_overlays_and_levels() -> void:
	await inspect("Poppy")
	var plants := preview_part("Plants")
	for name: String in ["Rings", "Bones", "Levels"]:
		await click(preview_part(name) as Control)
	await frames(2)
	check_equal(plants.get_child_count(), 4, "levels side by side")
	var segments := plants.get_children().map(func(node: Plant3D) -> int: return node.segments)
	check_equal(segments, Array(EditorState.LEVELS), "their segments")
	await take_picture("levels")
	for name: String in ["Rings", "Bones", "Levels"]:
		await click(preview_part(name) as Control)
	await frames(2)
	check_equal(plants.get_child_count(), 1, "plants after switching back")


func test_next_plant_of_the_species() -> void:
	await inspect("Poppy")
	var before := (preview_part("Plants").get_child(0) as Plant3D).seed
	await click(preview_part("ViewControls").get_node("%Dice") as Control)
	await frames(3)
	check_equal((preview_part("Plants").get_child(0) as Plant3D).seed, before + 1, "seed")


func test_project_species_come_and_go() -> void:
	await open_panel()
	var tulip := TulipFunction.new()
	check_equal(ResourceSaver.save(tulip, SPECIES_FILE), OK, "saving")
	EditorInterface.get_resource_filesystem().scan()
	var listed := func() -> bool: return find_key(SPECIES_FILE) >= 0
	check(await until(listed), "a new file appears in the list")
	await click_tile(find_key(SPECIES_FILE))
	check_equal(_state().path, SPECIES_FILE, "path of the chosen species")
	DirAccess.remove_absolute(ProjectSettings.globalize_path(SPECIES_FILE))
	EditorInterface.get_resource_filesystem().scan()
	var gone := func() -> bool: return find_key(SPECIES_FILE) < 0
	check(await until(gone), "a deleted file leaves the list")
	check(_state().function is TulipFunction, "its plant stays")
	var text := (part("Status/Text") as Label).text
	check(text.contains(SPECIES_FILE), "the status line: " + text)


func test_list_is_refreshed_while_pictures_wait() -> void:
	await open_panel()
	for i in MANY:
		var path := MANY_FILES % i
		check_equal(ResourceSaver.save(ReedFunction.new(), path), OK, "saving " + path)
		if i < MANY - 2:
			continue
		EditorInterface.get_resource_filesystem().scan()
		check(await until(func() -> bool: return find_key(path) >= 0), path + " is listed")
	await frames(MANY)
	for i in MANY:
		DirAccess.remove_absolute(ProjectSettings.globalize_path(MANY_FILES % i))
	EditorInterface.get_resource_filesystem().scan()
	var gone := func() -> bool: return find_key(MANY_FILES % (MANY - 1)) < 0
	check(await until(gone), "deleted files leave the list")


func test_picture_of_the_plant_page() -> void:
	await open_panel()
	await inspect("Tulip")
	await frames(30)
	await take_picture("plant")


func _state() -> EditorState:
	return dock().get("state")


func test_property_changes_are_undone() -> void:
	await inspect(GRASS)
	var grass := _state().function as GrassFunction
	var before := grass.blade_width
	var slider := _find_slider("blade_width")
	check(slider != null, "the inspector shows the width of a blade")
	slider.value = 0.05
	await frames(2)
	check_equal(grass.blade_width, 0.05, "width as typed")
	var after := grass.blade_width
	await undo()
	check_equal(grass.blade_width, before, "width after undo")
	await redo()
	check_equal(grass.blade_width, after, "width after redo")
	await undo()


func test_a_stem_has_its_properties_and_bones() -> void:
	await inspect(GRASS)
	var grass := _state().function
	check(not _shows("stem"), "a plant of one joint has no stem")
	grass.law = PlantFunction.LAW_STEM
	await frames(5)
	check(_shows("stem") and _shows("natural_frequency"), "the stem is shown")
	check(not _shows("mass"), "its mass is not shown")
	grass.stem = PlantStem.new()
	grass.stem.joints = 3
	for name: String in ["Rings", "Bones"]:
		await click(preview_part(name) as Control)
	await frames(5)
	var plant := preview_part("Plants").get_child(0) as Plant3D
	check_equal(plant.get_joint_count(), 3, "joints")
	for overlay: Node in plant.get_skeleton().get_children():
		var lines := (overlay as MeshInstance3D).mesh
		var bones: PackedInt32Array = lines.surface_get_arrays(0)[Mesh.ARRAY_BONES]
		check_equal(Array(bones).max(), 4, "the last link's bone")
	await take_picture("stem")
	for name: String in ["Rings", "Bones"]:
		await click(preview_part(name) as Control)
	grass.stem = null
	grass.law = PlantFunction.LAW_SPRING


func _shows(property: String) -> bool:
	var inspector := EditorInterface.get_inspector()
	for editor: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if editor.get_edited_property() == property:
			return true
	return false


func _find_slider(property: String) -> EditorSpinSlider:
	var inspector := EditorInterface.get_inspector()
	for editor: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if editor.get_edited_property() == property:
			return editor.find_children("*", "EditorSpinSlider", true, false)[0]
	return null


func test_width_curve_is_dragged() -> void:
	await inspect("Own Drawing")
	var curve := (_state().function as CurvePlantFunction).width_curve
	var points := plot_points() as Control
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
