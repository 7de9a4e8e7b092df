@tool
extends RefCounted
## Keeps the icons as large as the editor's own: the editor draws those of an add-on when it imports
## them, and not again when its scale changes.

const SIZE := 16


## Imports the icons of [param folder] anew where the editor's scale is another than it was then, as
## soon as the editor knows its files.
static func adapt(folder: String) -> void:
	# No await: in a project that is opened for the first time the editor reloads scripts, and those
	# that wait are lost.
	var tree := Engine.get_main_loop() as SceneTree
	tree.process_frame.connect(_adapt_known.bind(folder), CONNECT_ONE_SHOT)


static func _adapt_known(folder: String) -> void:
	var files := EditorInterface.get_resource_filesystem()
	if files.is_scanning():
		adapt(folder)
		return
	var wrong: PackedStringArray = []
	for file in ResourceLoader.list_directory(folder):
		var icon := load(folder.path_join(file)) as Texture2D
		if icon and icon.get_height() != roundi(SIZE * EditorInterface.get_editor_scale()):
			wrong.append(folder.path_join(file))
	if wrong:
		files.reimport_files(wrong)
