@tool
extends EditorPlugin
## Adds the dock "Undergrowth" to the editor, and takes everything away again when switched off.

const DOCK_SCENE := "editor/dock.tscn"
const DOCK_ICON := "icons/PlantFunction.svg"
## A class of the library. Without the library no script of the dock can be compiled.
const NATIVE_CLASS := &"PlantFunction"

var _dock: EditorDock


func _enter_tree() -> void:
	if not ClassDB.class_exists(NATIVE_CLASS):
		push_error(
			(
				"Undergrowth: its library for this platform is missing in %s. "
				% _folder().path_join("bin")
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


func _add_dock() -> void:
	var content: Control = (load(_folder().path_join(DOCK_SCENE)) as PackedScene).instantiate()
	_dock = EditorDock.new()
	_dock.name = "Undergrowth"
	_dock.title = "Undergrowth"
	_dock.layout_key = "Undergrowth"
	_dock.default_slot = EditorDock.DOCK_SLOT_RIGHT_UL
	_dock.available_layouts = EditorDock.DOCK_LAYOUT_ALL
	var icon := _folder().path_join(DOCK_ICON)
	if ResourceLoader.exists(icon):
		_dock.dock_icon = load(icon)
	_dock.add_child(content)
	add_dock(_dock)
	content.call(&"setup", self)


func _folder() -> String:
	return (get_script() as Script).resource_path.get_base_dir()
