@tool
extends RefCounted
## Keeps the icons as large as the editor's own: the editor draws those of an add-on when it imports
## them, and not again when its scale changes.

const SIZE := 16


## Imports the icons of [param folder] anew where the editor's scale is another than it was then.
static func adapt(folder: String) -> void:
	var files := EditorInterface.get_resource_filesystem()
	await _wait_for(files)
	var wrong: PackedStringArray = []
	for file in ResourceLoader.list_directory(folder):
		var icon := load(folder.path_join(file)) as Texture2D
		if icon and icon.get_height() != roundi(SIZE * EditorInterface.get_editor_scale()):
			wrong.append(folder.path_join(file))
	if wrong:
		files.reimport_files(wrong)


static func _wait_for(files: EditorFileSystem) -> void:
	var tree := Engine.get_main_loop() as SceneTree
	await tree.process_frame
	while files.is_scanning():
		await tree.process_frame
