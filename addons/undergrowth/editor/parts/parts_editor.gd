@tool
extends VBoxContainer
## The parts of a species in the inspector: their tree, buttons to add, duplicate and remove them,
## and the properties of the selected ones.

const PartSteps := preload("part_steps.gd")
const PartsTree := preload("parts_tree.gd")
const Translations := preload("../translations/translations.gd")
const SECTION_CLASS := "EditorInspectorSection"
const CATEGORY_CLASS := "EditorInspectorCategory"
## Properties that the tree shows, and those of every resource.
const HIDDEN: Array[StringName] = [&"carries", &"visible", &"script"]
## Share of the names in a line's width.
const NAME_SHARE := 0.56

# Id of the selected arrangement by the id of its species. The inspector makes new controls at every
# change of the list of properties.
static var _selected: Dictionary[int, int] = {}

var _function: PlantFunction
var _steps: PartSteps
var _tree := PartsTree.new()
var _add := Button.new()
var _duplicate := Button.new()
var _remove := Button.new()
# Inspectors of the selected part, and of its arrangement, and their titles.
var _details: Array[EditorInspector] = []
var _titles: Array[Label] = []


## Shows the parts of [param function].
func setup(function: PlantFunction) -> void:
	_function = function
	_steps = PartSteps.new(EditorInterface.get_editor_undo_redo(), function)
	_add_buttons()
	_tree.name = "Tree"
	_tree.chosen.connect(_on_chosen)
	add_child(_tree)
	for i in 2:
		_add_details()
	_tree.setup(function, _steps)
	var known := instance_from_id(_selected.get(function.get_instance_id(), 0)) as PlantArrangement
	if known and _tree.find_carrier(known):
		_tree.choose(known)
	else:
		_on_chosen(null)


func _notification(what: int) -> void:
	if what == NOTIFICATION_THEME_CHANGED or what == NOTIFICATION_ENTER_TREE:
		_add.icon = get_theme_icon(&"Add", &"EditorIcons")
		_duplicate.icon = get_theme_icon(&"Duplicate", &"EditorIcons")
		_remove.icon = get_theme_icon(&"Remove", &"EditorIcons")


func _add_buttons() -> void:
	var bar := HBoxContainer.new()
	var title := Label.new()
	title.text = Translations.text("Parts")
	title.size_flags_horizontal = SIZE_EXPAND_FILL
	title.theme_type_variation = &"HeaderSmall"
	bar.add_child(title)
	_add.name = "Add"
	_add.tooltip_text = Translations.text("Adds leaves on the selected part.")
	_add.pressed.connect(_on_add_pressed)
	_duplicate.name = "Duplicate"
	_duplicate.tooltip_text = Translations.text("Duplicates the selected part.")
	_duplicate.pressed.connect(_on_duplicate_pressed)
	_remove.name = "Remove"
	_remove.tooltip_text = Translations.text("Removes the selected part.")
	_remove.pressed.connect(_on_remove_pressed)
	for button in [_add, _duplicate, _remove]:
		(button as Button).theme_type_variation = &"FlatButton"
		bar.add_child(button)
	add_child(bar)


# As high as its properties: the inspector around it scrolls.
func _add_details() -> void:
	var title := Label.new()
	title.theme_type_variation = &"HeaderSmall"
	add_child(title)
	_titles.append(title)
	var inspector := EditorInspector.new()
	inspector.vertical_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	inspector.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	inspector.resource_selected.connect(
		func(resource: Resource, _path: String) -> void: EditorInterface.edit_resource(resource)
	)
	add_child(inspector)
	_details.append(inspector)
	var content := inspector.get_child(0) as Control
	content.minimum_size_changed.connect(_trim.bind(inspector))


# What is in the tree, and what all resources have, stays out.
func _trim(inspector: EditorInspector) -> void:
	for section: Control in inspector.find_children("*", SECTION_CLASS, true, false):
		if section.tooltip_text == "Resource":
			section.hide()
	for category: Control in inspector.find_children("*", CATEGORY_CLASS, true, false):
		category.hide()
	for property: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		property.name_split_ratio = NAME_SHARE
		if property.get_edited_property() in HIDDEN:
			property.hide()
	for button: Button in inspector.get_child(0).find_children("*", "Button", false, false):
		button.hide()  # Add Metadata.


func _on_chosen(arrangement: PlantArrangement) -> void:
	_selected[_function.get_instance_id()] = arrangement.get_instance_id() if arrangement else 0
	_duplicate.disabled = not arrangement
	_remove.disabled = not arrangement
	var shown: Array[Resource] = [arrangement.part if arrangement else null, arrangement]
	var titles := ["", ""]
	if arrangement and arrangement.part:
		var kind := arrangement.part.get_class().trim_prefix("Plant")
		titles[0] = "%s (%s)" % [arrangement.part.resource_name, Translations.text(kind)]
	if arrangement:
		titles[1] = Translations.text("Arrangement of %s") % PartSteps.title_of(arrangement)
	for i in _details.size():
		_titles[i].text = titles[i]
		_titles[i].visible = shown[i] != null
		_details[i].visible = shown[i] != null
		_details[i].edit(shown[i])


func _on_add_pressed() -> void:
	var chosen := _tree.get_chosen()
	_tree.choose(_steps.add_leaf(chosen if chosen else _function))


func _on_duplicate_pressed() -> void:
	var chosen := _tree.get_chosen()
	_tree.choose(_steps.duplicate(_tree.find_carrier(chosen), chosen))


func _on_remove_pressed() -> void:
	var chosen := _tree.get_chosen()
	_steps.remove(_tree.find_carrier(chosen), chosen)
	_tree.choose(null)
