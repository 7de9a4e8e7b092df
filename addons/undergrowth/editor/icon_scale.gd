@tool
extends RefCounted
## Matches the size of the add-on's icons to the editor's own. The editor rasterizes them at import
## and not after a change of its scale.

const SIZE := 16


## Imports the icons of [param folder] again if the editor's scale has changed since, after the
## editor's first scan.
static func adapt(folder: String) -> void:
	# No await: the editor reloads scripts in a project that is opened for the first time, which
	# aborts waiting ones.
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
