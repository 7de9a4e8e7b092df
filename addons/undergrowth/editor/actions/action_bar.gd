@tool
extends HFlowContainer
## The panel's actions for the chosen species or mix: adds it to the scene, saves or bakes a
## species.

## Emitted when the chosen species was saved to a file and that file is chosen.
signal saved(entry: SpeciesEntry)
## Emitted before [param node], which was just added to the scene, is selected there.
signal added(node: Node)

const EditorState := preload("../editor_state.gd")
const SpeciesEntry := preload("../browser/species_entry.gd")
const Bake := preload("bake.gd")
const BakeDialog := preload("bake_dialog.gd")
const BakeOptions := preload("bake_options.gd")
const FileNames := preload("file_names.gd")
const Inspecting := preload("inspecting.gd")
const NewPlace := preload("new_place.gd")
const NewSpeciesDialog := preload("new_species_dialog.gd")
const ProjectFiles := preload("project_files.gd")
const SceneActions := preload("scene_actions.gd")
const SpeciesTemplate := preload("species_template.gd")
const Surroundings := preload("surroundings.gd")
## Microseconds of a frame after which no new file is started.
const BAKE_USEC_PER_FRAME := 8000
const REPLACE_SIZE := Vector2i(420, 160)
## Maximum number of files that a question lists.
const NAMED_FILES := 6

var _state: EditorState
var _undo: EditorUndoRedoManager
var _dock: Control
var _save_dialog: EditorFileDialog
var _options: BakeOptions

@onready var _add: Button = %Add
@onready var _add_field: Button = %AddField
@onready var _surroundings: CheckBox = %Surroundings
@onready var _assign: Button = %Assign
@onready var _save: Button = %Save
@onready var _bake: Button = %Bake
@onready var _new_dialog: NewSpeciesDialog = %NewSpeciesDialog
@onready var _bake_dialog: BakeDialog = %BakeDialog
@onready var _replace_dialog: ConfirmationDialog = %ReplaceDialog


## Sets the species of [param state] as the target. Dialogs open over [param dock].
func setup(state: EditorState, undo: EditorUndoRedoManager, dock: Control) -> void:
	_state = state
	_undo = undo
	_dock = dock
	_add.pressed.connect(_on_add_pressed)
	_add_field.pressed.connect(_on_add_field_pressed)
	_assign.pressed.connect(_on_assign_pressed)
	_save.pressed.connect(_on_save_pressed)
	_bake.pressed.connect(_on_bake_pressed)
	_new_dialog.accepted.connect(_on_new_accepted)
	_bake_dialog.accepted.connect(_on_bake_accepted)
	_replace_dialog.confirmed.connect(_bake_files)
	_state.function_chosen.connect(_refresh)
	_state.work_changed.connect(_refresh)
	_refresh()
	_apply_theme()


## Opens the dialog for a new species in a script.
func open_new_dialog() -> void:
	_new_dialog.open()


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED and _state:
		_apply_theme()


func _apply_theme() -> void:
	_add.icon = get_theme_icon(&"Add", &"EditorIcons")
	_add_field.icon = get_theme_icon(&"MultiMeshInstance3D", &"EditorIcons")


func _refresh() -> void:
	for button: Button in [_add, _assign, _save]:
		button.disabled = not _state.function
	_add_field.disabled = not _state.function and not _state.mix
	_bake.disabled = not _state.function or _state.work_total > 0


func _on_add_pressed() -> void:
	var root := _find_root()
	if not root or not _can_build():
		return
	var function := _to_scene_function(root)
	var wind := SceneActions.to_scene_wind(_state.own_wind, root)
	var plant := SceneActions.make_plant(function, wind, _state.title)
	_add_to_scene(root, plant, NewPlace.find(EditorInterface.get_editor_viewport_3d(0), root))


func _on_add_field_pressed() -> void:
	add_field(EditorInterface.get_editor_viewport_3d(0))


## Adds a field of the chosen species or mix to the edited scene, at [param pixel] of [param view]
## or at its centre.
func add_field(view: Viewport, pixel := Vector2.INF) -> void:
	var root := _find_root()
	if not root or not _can_build():
		return
	var place: NewPlace = NewPlace.find(view, root, pixel)
	var no_ground := (
		tr("It is flat: no ground is below the pointer.")
		if pixel.is_finite()
		else tr("It is flat: the centre of the 3D view shows no ground.")
	)
	var wind := SceneActions.to_scene_wind(_state.own_wind, root)
	if _state.mix:
		var mixed := SceneActions.make_mix(_state.mix, wind)
		_add_to_scene(root, mixed, place, no_ground, _state.mix.resource_path)
	else:
		var field := SceneActions.make_field(_to_scene_function(root), wind, _state.title)
		var file := _state.origin.resource_path if _state.origin else ""
		_add_to_scene(root, field, place, no_ground, file)


func _to_scene_function(root: Node) -> PlantFunction:
	return SceneActions.to_scene_function(_state.function, root, _state.origin)


## A field of [param file] gets the surroundings that the scene lacks, or the warning
## [param no_ground].
func _add_to_scene(root: Node, plant: Node3D, place: NewPlace, no_ground := "", file := "") -> void:
	var parent := SceneActions.get_parent_for_new(root)
	var field := plant as PlantField3D
	var others: Array[Node] = []
	if field and root is Node3D and _surroundings.button_pressed:
		others = Surroundings.make(root as Node3D, field, place.point, file)
	if field:
		place.lay(field, parent)
	SceneActions.add(_undo, root, parent, plant, place.point, others)
	added.emit(plant)
	_select(plant)
	_state.show_new_plants_move()
	var names := PackedStringArray([plant.name])
	for other in others:
		names.append(other.name)
	var message := tr("Added %s to the scene.") % ", ".join(names)
	if field and not place.has_ground and not others.any(Surroundings.is_ground):
		_warn(message + " " + no_ground)
	else:
		_state.report(message)


func _on_assign_pressed() -> void:
	var root := _find_root()
	if not root or not _can_build():
		return
	var plants := SceneActions.get_selected_plants(root)
	if plants.is_empty():
		_warn(tr("Nothing is selected. Select Plant3D or PlantField3D nodes in the scene."))
		return
	var function := _to_scene_function(root)
	var wind := SceneActions.to_scene_wind(_state.own_wind, root)
	SceneActions.assign(_undo, root, plants, function, wind)
	_state.report(_describe_assigned(plants))


func _describe_assigned(plants: Array[Node3D]) -> String:
	var is_field := func(plant: Node3D) -> bool: return plant is PlantField3D
	if plants.any(is_field):
		return tr("%s grows in what is selected now.") % tr(_state.title)
	var message := tr_n("%d plant is %s now.", "%d plants are %s now.", plants.size())
	return message % [plants.size(), tr(_state.title)]


func _on_save_pressed() -> void:
	if not _save_dialog:
		_save_dialog = EditorFileDialog.new()
		_save_dialog.file_mode = EditorFileDialog.FILE_MODE_SAVE_FILE
		_save_dialog.access = EditorFileDialog.ACCESS_RESOURCES
		_save_dialog.add_filter("*.tres", tr("Plant Function"))
		_save_dialog.file_selected.connect(save_as)
		add_child(_save_dialog)
	_save_dialog.title = tr("Save Species As")
	var own := _state.function.resource_path
	if own.get_extension() == "tres" and not _state.function.is_built_in():
		_save_dialog.current_path = own
	else:
		_save_dialog.current_file = FileNames.to_stem(_state.title) + ".tres"
	_save_dialog.popup_file_dialog()


## Saves the chosen species to [param path], chooses the file's content and opens it in the
## inspector.
func save_as(path: String) -> void:
	var problem := ProjectFiles.find_problem(path)
	if not problem.is_empty():
		_fail(problem)
		return
	var saved := ProjectFiles.save_function(_state.function, path)
	if not saved:
		_fail(tr("Cannot write %s. Choose another folder, or make this one writable.") % path)
		return
	ProjectFiles.announce(path)
	_choose(saved, path, false)
	Inspecting.open(saved)
	_state.report_file(tr("Saved %s.") % path, path)


func _on_new_accepted(title: String, folder: String) -> void:
	var problem := SpeciesTemplate.write(title, folder)
	if not problem.is_empty():
		_new_dialog.refuse(problem)
		_fail(problem)
		return
	_new_dialog.hide()
	var path := SpeciesTemplate.path_of(title, folder)
	ProjectFiles.announce(path)
	var script := load(path) as Script
	EditorInterface.edit_script(script)
	EditorInterface.set_main_screen_editor("Script")
	if script.can_instantiate():
		_choose(script.call(&"new") as PlantFunction, path, true)
	_state.report(tr("Made %s. Change its four functions and save it.") % path)


func _on_bake_pressed() -> void:
	if _can_build():
		_bake_dialog.open(_state.title)


func _on_bake_accepted(options: BakeOptions) -> void:
	_options = options
	var existing := options.get_existing_files()
	if existing.is_empty():
		_bake_files()
		return
	_replace_dialog.dialog_text = _describe_replaced(existing)
	_replace_dialog.popup_centered(
		Vector2i(Vector2(REPLACE_SIZE) * EditorInterface.get_editor_scale())
	)


func _describe_replaced(files: PackedStringArray) -> String:
	var names := "\n".join(files.slice(0, NAMED_FILES))
	if files.size() > NAMED_FILES:
		names += "\n…"
	return (
		(
			tr_n(
				"%d file exists already. Replace it?",
				"%d files exist already. Replace them?",
				files.size()
			)
			% files.size()
		)
		+ "\n\n"
		+ names
	)


## Bakes a few files per frame until all exist, one fails or the user cancels.
func _bake_files() -> void:
	if _state.work_total > 0:
		_warn(tr("Other work is going on. Wait for its end, or cancel it."))
		return
	var work := Bake.new(_state.function, _options)
	var total := work.get_pieces_left()
	var problem := ""
	_state.begin_work(tr("Baking %s…") % _options.title, total)
	while not work.is_done() and problem.is_empty() and not _state.work_cancelled:
		await get_tree().process_frame
		if not is_inside_tree():
			return
		problem = _bake_for_a_frame(work)
	_state.end_work()
	_report_end(work, total, problem)
	ProjectFiles.announce_all()


func _bake_for_a_frame(work: Bake) -> String:
	var end := Time.get_ticks_usec() + BAKE_USEC_PER_FRAME
	var problem := ""
	while not work.is_done() and problem.is_empty() and Time.get_ticks_usec() < end:
		problem = work.bake_next()
		_state.advance_work()
	return problem


func _report_end(work: Bake, total: int, problem: String) -> void:
	var count := work.written.size()
	if not problem.is_empty():
		_fail(problem)
	elif count < total:
		_warn(tr("Cancelled. %d of %d files were written.") % [count, total])
	else:
		var message := tr_n("Baked %d file to %s.", "Baked %d files to %s.", count)
		_state.report_file(message % [count, _options.folder], work.written[0])


func _find_root() -> Node:
	var root := EditorInterface.get_edited_scene_root()
	if not root:
		_fail(tr("There is no scene. Create or open one, then add plants to it."))
	return root


func _can_build() -> bool:
	if _state.problem.is_empty():
		return true
	_fail("%s: %s" % [tr(_state.title), _state.problem])
	return false


func _select(node: Node) -> void:
	var selection := EditorInterface.get_selection()
	selection.clear()
	selection.add_node(node)
	EditorInterface.set_main_screen_editor("3D")


func _choose(function: PlantFunction, path: String, is_script: bool) -> void:
	var entry: SpeciesEntry = SpeciesEntry.from_file(path, is_script, "")
	_state.choose(function, path, entry.title)
	saved.emit(entry)


func _warn(text: String) -> void:
	_state.report(text, EditorState.Severity.WARNING)


func _fail(text: String) -> void:
	_state.report(text, EditorState.Severity.ERROR)
