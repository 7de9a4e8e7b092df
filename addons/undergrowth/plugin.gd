@tool
extends EditorPlugin
## Adds the dock "Undergrowth" to the editor, and takes everything away again when switched off.

const DOCK_SCENE := "editor/dock.tscn"
const DOCK_ICON := "icons/PlantFunction.svg"
## A class of the library. Without the library no script of the dock can be compiled.
const NATIVE_CLASS := &"PlantFunction"
## Seconds of one step of the simulation; PlantSimulation reads it when the library is loaded.
const STEP_SETTING := "undergrowth/simulation/step_length"
const DEFAULT_STEP := 1.0 / 60.0

var _dock: EditorDock


func _enter_tree() -> void:
	_show_step_setting()
	if not ClassDB.class_exists(NATIVE_CLASS):
		push_error(
			(
				(
					"Undergrowth: its library for this platform is missing in %s. "
					% _folder().path_join("bin")
				)
				+ "Install a release of the add-on, or build it with ./run build."
			)
		)
		return
	_add_dock()


func _exit_tree() -> void:
	if _dock:
		remove_dock(_dock)
		_dock.queue_free()
		_dock = null


func _get_plugin_name() -> String:
	return "Undergrowth"


# The setting stays when the plugin is switched off: the simulation reads it in the game, too.
func _show_step_setting() -> void:
	if not ProjectSettings.has_setting(STEP_SETTING):
		ProjectSettings.set_setting(STEP_SETTING, DEFAULT_STEP)
	ProjectSettings.set_initial_value(STEP_SETTING, DEFAULT_STEP)
	ProjectSettings.set_as_basic(STEP_SETTING, true)
	(
		ProjectSettings
		. add_property_info(
			{
				"name": STEP_SETTING,
				"type": TYPE_FLOAT,
				"hint": PROPERTY_HINT_RANGE,
				"hint_string": "0.001,0.1,0.0001,suffix:s",
			}
		)
	)


func _add_dock() -> void:
	var content: Control = (load(_folder().path_join(DOCK_SCENE)) as PackedScene).instantiate()
	_dock = EditorDock.new()
	_dock.name = "Undergrowth"
	_dock.title = "Undergrowth"
	_dock.layout_key = "Undergrowth"
	_dock.default_slot = EditorDock.DOCK_SLOT_RIGHT_UR
	_dock.available_layouts = EditorDock.DOCK_LAYOUT_ALL
	var icon := _folder().path_join(DOCK_ICON)
	if ResourceLoader.exists(icon):
		_dock.dock_icon = load(icon)
	_dock.add_child(content)
	add_dock(_dock)
	content.call(&"setup", self)


func _folder() -> String:
	return (get_script() as Script).resource_path.get_base_dir()
