@tool
extends RefCounted
## Opens a resource in the editor's inspector and brings the inspector to the front.


static func open(resource: Resource) -> void:
	EditorInterface.edit_resource(resource)
	var above: Node = EditorInterface.get_inspector()
	while above and above is not EditorDock:
		above = above.get_parent()
	if above:
		(above as EditorDock).make_visible()
