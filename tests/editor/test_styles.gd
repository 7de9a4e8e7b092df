@tool
extends "style_checks.gd"
## Shows all controls of the add-on in the editor. None is truncated on the screens of this run.
## Each step saves a picture (look_*.png) for review.

const SCENE := "res://looks.tscn"
const BAR_SCRIPT := "res://addons/undergrowth/editor/brush/brush_bar.gd"
const SETTINGS_SCRIPT := "res://addons/undergrowth/editor/brush/brush_settings.gd"
## Side of the 3D view's axes in its corner, in pixels at 100 %.
const AXES := 110.0
const LONG := "res://foxtail.gd: its base shape runs clockwise as seen from above. Reverse it."


func test_the_tiles_and_the_inspector_of_species() -> void:
	await _open_garden()
	_select([])
	await open_panel()
	check(await until(_has_pictures), "each species has its picture")
	for shown: Array in [["Wheat", "species"], ["Meadow", "mix"], ["Own Drawing", "curves"]]:
		await _choose(shown[0])
		await inspect(shown[0])
		await frames(10)
		check_nothing_is_cut(find_by_script(PREVIEW_SCRIPT), shown[1])
		check_nothing_is_cut(dock(), shown[1])
		await take_style(shown[1])


func _speak(locale: String) -> void:
	TranslationServer.get_or_add_domain(Translations.DOMAIN).set_locale_override(locale)
	find_by_script(SETTINGS_SCRIPT).propagate_notification(Node.NOTIFICATION_TRANSLATION_CHANGED)


func test_levels_rings_and_bones() -> void:
	await inspect("Poppy")
	for tool: String in ["Levels", "Rings", "Bones"]:
		var button := preview_part(tool) as Button
		await click(button)
		await frames(10)
		check_nothing_is_cut(find_by_script(PREVIEW_SCRIPT), tool)
		await take_style(tool.to_lower())
		await click(button)


func test_the_panel_by_itself() -> void:
	await _choose("Poppy")
	tiles().get_v_scroll_bar().value = tiles().get_v_scroll_bar().max_value
	_state().report(LONG, EditorState.Severity.ERROR)
	await frames(5)
	check_nothing_is_cut(dock(), "an error")
	await take_style("error")
	_state().report("Nothing is selected.", EditorState.Severity.WARNING)
	_state().begin_work("Baking Poppy…", 10)
	_state().advance_work()
	await frames(5)
	check_nothing_is_cut(dock(), "work")
	await take_style("work")
	_state().end_work()
	_state().report("")


func test_the_popup_for_wind() -> void:
	await open_wind()
	for kind: Array in [[PlantWind.KIND_WAVES, "waves"], [PlantWind.KIND_AIR, "air"]]:
		_state().wind.kind = kind[0]
		_state().wind.speed = 6.0
		await frames(60)
		check_nothing_is_cut(wind_panel(), kind[1])
		var view := EditorInterface.get_editor_viewport_3d(0).get_parent() as Control
		var frame := (wind_panel().get_parent() as Control).get_global_rect()
		check(view.get_global_rect().encloses(frame), "within the view: %s" % frame)
		var side := Vector2.ONE * AXES * EditorInterface.get_editor_scale()
		var end := view.get_global_rect().end
		var axes := Rect2(end.x - side.x, view.global_position.y, side.x, side.y)
		check(not axes.intersects(frame), "beside the axes: %s" % frame)
		await take_style(kind[1])
	await close_wind()
	_state().wind.kind = PlantWind.KIND_WAVES


func test_the_brush() -> void:
	var root := EditorInterface.get_edited_scene_root()
	for name: String in ["Field", "Full"]:
		_select([root.get_node(name)])
		await frames(20)
		for tool: String in ["Paint", "Height"]:
			await click(_bar().get_node("%" + tool) as Control)
			await frames(10)
			check_nothing_is_cut(_bar(), tool)
			check_nothing_is_cut(find_by_script(SETTINGS_SCRIPT), tool)
			await take_style("brush_%s_%s" % [name, tool])
			_speak("hr")
			await frames(4)
			check_nothing_is_cut(find_by_script(SETTINGS_SCRIPT), tool + " in Croatian")
			await take_style("brush_%s_%s_hr" % [name, tool])
			_speak("en")
		await click(_bar().get_node("%Height") as Control)


func test_the_inspector() -> void:
	var root := EditorInterface.get_edited_scene_root()
	var field := root.get_node("Field") as PlantField3D
	for name: String in ["Field", "Poppy", "Source"]:
		_select([root.get_node(name)])
		await open_inspector()
		await frames(20)
		await take_style("inspector_" + name)
	var resources: Dictionary[String, Resource] = {
		"wind": field.wind,
		"map": field.map,
		"species": field.species[0].species,
		"entry": field.species[0],
		"curves": CurvePlantFunction.new()
	}
	for name in resources:
		EditorInterface.edit_resource(resources[name])
		await open_inspector()
		await frames(20)
		check_nothing_is_cut(EditorInterface.get_inspector(), name)
		await take_style("inspector_" + name)
	EditorInterface.edit_node(null)


func test_the_dialogs_for_species() -> void:
	await _choose("Poppy")
	await click(part("Browser/List/New") as Control)
	await _check_dialog("ConfirmationDialog", "new_empty")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	for typed: Array in [["Marsh Sedge", "new"], ["9 lives", "new_refused"]]:
		await _type_into(dialog, dialog.get_node("%Title") as LineEdit, typed[0])
		await _check_dialog("ConfirmationDialog", typed[1])
	var browse := dialog.get_node("%Folder").get_node("%Browse") as Button
	await click(browse)
	for child in dialog.get_node("%Folder").get_children(true):
		if child is EditorFileDialog:
			await take_dialog_style(child as Window, "folder")
			(child as Window).hide()
	await frames(3)
	dialog.hide()
	await frames(3)
	await _use("Save")
	await _check_dialog("EditorFileDialog", "save")
	_dialog("EditorFileDialog").hide()
	await frames(3)


func test_the_dialogs_for_baking() -> void:
	for level in 4:  # Of a run on another screen.
		DirAccess.remove_absolute("res://poppy_lod%d.res" % level)
	await _choose("Poppy")
	await _use("Bake")
	await _check_dialog("ConfirmationDialog", "bake")
	var dialog := _dialog("ConfirmationDialog") as ConfirmationDialog
	await _type_into(dialog, dialog.get_node("%Levels") as LineEdit, "many")
	await _check_dialog("ConfirmationDialog", "bake_refused")
	await _type_into(dialog, dialog.get_node("%Levels") as LineEdit, "6, 3, 2, 1")
	await click(dialog.get_ok_button())
	check(await until(func() -> bool: return _message().begins_with("Baked")), _message())
	await _use("Bake")
	await click(_dialog("ConfirmationDialog").call(&"get_ok_button") as Control)
	await frames(3)
	await _check_dialog("ConfirmationDialog", "replace")
	_dialog("ConfirmationDialog").hide()


func test_the_dialog_for_a_wind() -> void:
	await open_wind()
	await click(wind_part("Save") as Control)
	await frames(5)
	for child: Node in wind_part("WindActions").get_children(true):
		if child is EditorFileDialog:
			await take_dialog_style(child as Window, "wind")
			(child as Window).hide()
	check(true, "seen")


func _has_pictures() -> bool:
	var missing := dock().get_theme_icon(&"FileThumbnail", &"EditorIcons")
	for i in tiles().item_count:
		if tiles().get_item_icon(i) == missing:
			return false
	return true


func _check_dialog(kind: String, name: String) -> void:
	var dialog := _dialog(kind)
	check(dialog != null, "the dialog %s is open" % name)
	if dialog:
		await take_dialog_style(dialog, name)


func _bar() -> Control:
	return find_by_script(BAR_SCRIPT)


func _open_garden() -> void:
	var root := Node3D.new()
	root.name = "Garden"
	var poppy := Plant3D.new()
	poppy.species = load("res://addons/undergrowth/species/poppy.tres")
	var few := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	few.map = PlantMap.new()
	var many := PlantField3D.from_species(
		[GrassFunction.new(), TulipFunction.new(), ReedFunction.new(), BellflowerFunction.new()]
	)
	var nodes: Dictionary[String, Node3D] = {
		"Poppy": poppy, "Field": few, "Full": many, "Source": PlantWindSource3D.new()
	}
	for name in nodes:
		nodes[name].name = name
		root.add_child(nodes[name])
		nodes[name].owner = root
	for field: PlantField3D in [few, many]:
		field.size = Vector2(3, 3)
		field.density = 4.0
		field.wind = PlantWind.new()
	await _open_scene(SCENE, root)
	EditorInterface.set_main_screen_editor("3D")
