@tool
extends Button
## The button *Sway* in the toolbar of the 3D view: moves the plants of the edited scene, each in
## its own wind. Visible while the scene has plants.

const EditorState := preload("../editor_state.gd")
const SceneWind := preload("scene_wind.gd")
const ScenePlants := preload("scene_plants.gd")
const Translations := preload("../translations/translations.gd")
const ICON := preload("../../icons/PlantWind.svg")

## Visible like this one.
var wind_button: Button

var _state: EditorState
var _is_pending := false


## Shows and changes [member EditorState.sways] of [param state].
func setup(plugin: EditorPlugin, state: EditorState) -> void:
	_state = state
	name = "Sway"
	set_translation_domain(Translations.DOMAIN)
	text = "Sway"
	tooltip_text = tr("Moves the plants of this scene in their wind, in the editor only.")
	icon = ICON
	toggle_mode = true
	theme_type_variation = &"FlatButton"
	toggled.connect(_state.choose_sway)
	_state.sway_changed.connect(_show)
	plugin.scene_changed.connect(_on_scene_changed)
	var tree := plugin.get_tree()
	tree.node_added.connect(_on_node_changed)
	tree.node_removed.connect(_on_node_changed)
	var scene_wind := SceneWind.new()
	add_child(scene_wind)
	scene_wind.setup(state)
	_show()
	_show_if_needed()


## Disconnects it from the editor. Call it before the plugin is removed.
func close(plugin: EditorPlugin) -> void:
	plugin.scene_changed.disconnect(_on_scene_changed)
	plugin.get_tree().node_added.disconnect(_on_node_changed)
	plugin.get_tree().node_removed.disconnect(_on_node_changed)


func _show() -> void:
	set_pressed_no_signal(_state.sways)


func _on_scene_changed(_root: Node) -> void:
	_show_soon()


func _on_node_changed(node: Node) -> void:
	if ScenePlants.is_plant(node):
		_show_soon()


# Once for any number of nodes.
func _show_soon() -> void:
	if not _is_pending:
		_is_pending = true
		_show_if_needed.call_deferred()


func _show_if_needed() -> void:
	_is_pending = false
	visible = not ScenePlants.all(EditorInterface.get_edited_scene_root()).is_empty()
	wind_button.visible = visible
