@tool
extends "editor_test.gd"
## Base of the tests of the actions: the buttons, their dialogs, and scenes.

const Translations := preload("res://addons/undergrowth/editor/translations/translations.gd")
const EditorState := preload("res://addons/undergrowth/editor/editor_state.gd")
const THEME := "interface/theme/color_preset"
const LIGHT := "Light"


## English for any system language, because the tests compare messages. *Add as Field* adds a field
## only, and no scene sways at first.
func run(test: String) -> void:
	TranslationServer.get_or_add_domain(Translations.DOMAIN).set_locale_override("en")
	_surroundings().button_pressed = false
	_state().choose_sway(true)
	_state().sways = false
	await super(test)
	_surroundings().button_pressed = true
	_state().sways = false


## Saves a picture of the editor's window with a dialog.
func take_dialog_picture(dialog: Window, name: String) -> void:
	await frames(3)
	await drawn()
	if not pictures_folder.is_empty():
		dialog.get_texture().get_image().save_png(pictures_folder.path_join("dialog_%s.png" % name))


## The editor's theme, for [method use_theme].
func used_theme() -> String:
	return EditorInterface.get_editor_settings().get_setting(THEME)


func use_theme(preset: String) -> void:
	EditorInterface.get_editor_settings().set_setting(THEME, preset)
	var root := EditorInterface.get_base_control().get_tree().root
	root.propagate_notification(EditorSettings.NOTIFICATION_EDITOR_SETTINGS_CHANGED)
	await frames(10)


func _state() -> EditorState:
	return dock().get("state")


func _message() -> String:
	return (part("Status/Text") as Label).text


func _hint(dialog: Window) -> String:
	return (dialog.get_node("%Hint") as Label).text


func _use(action: String) -> void:
	await click(part("Browser/Actions/" + action) as Control)
	await frames(3)


func _choose(title: String) -> void:
	await choose_tile(title)
	check_equal(_state().title, title, "chosen species")


## Returns the visible dialog of the action bar of that class.
func _dialog(kind: String) -> Window:
	for child in part("Browser/Actions").get_children(true):
		if child.is_class(kind) and (child as Window).visible:
			return child
	return null


func _type_into(dialog: Window, line: LineEdit, text: String) -> void:
	check(dialog.visible, "the dialog is open")
	await click(line)
	await press_key(line, KEY_A, 0, true)
	await press_key(line, KEY_BACKSPACE)
	await type(line, text)


func _select(nodes: Array) -> void:
	EditorInterface.get_selection().clear()
	for node: Node in nodes:
		EditorInterface.get_selection().add_node(node)


func _open_scene(path: String, root: Node) -> void:
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	await files_are_known()
	check_equal(ResourceSaver.save(scene, path), OK, "saving a scene for the test")
	EditorInterface.get_resource_filesystem().scan()
	await files_are_known()
	EditorInterface.open_scene_from_path(path)
	await frames(5)


## Closes all scenes, opens this one in the 3D view, and returns its root.
func _open_alone(path: String, root: Node) -> Node3D:
	await _close_all_scenes()
	await _open_scene(path, root)
	EditorInterface.set_main_screen_editor("3D")
	await frames(10)
	return EditorInterface.get_edited_scene_root() as Node3D


func _close_all_scenes() -> void:
	for i in 10:
		if not EditorInterface.get_edited_scene_root():
			return
		EditorInterface.close_scene()
		await frames(3)


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)


## Returns the configuration warnings of a field in the tree of the scene dock, in one line, if they
## contain [param what]. Otherwise the text is empty.
func find_warning(field: PlantField3D, what: String) -> String:
	for dock in EditorInterface.get_base_control().find_children("*", "SceneTreeDock", true, false):
		for tree: Tree in dock.find_children("*", "Tree", true, false):
			var item := tree.get_root()
			while item:
				for i in item.get_button_count(0) if item.get_text(0) == field.name else 0:
					var text := " ".join(item.get_button_tooltip_text(0, i).split("\n"))
					if text.contains(what):
						return text
				item = item.get_next_in_tree()
	return ""


# A test may load the plugin again.
func _surroundings() -> CheckBox:
	return part("Browser/Actions/Surroundings") as CheckBox
