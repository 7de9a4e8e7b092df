@tool
extends RefCounted
## Opens a resource in the editor's inspector and brings the inspector to the front.

const Front := preload("../place/front.gd")


static func open(resource: Resource) -> void:
	EditorInterface.edit_resource(resource)
	Front.bring(EditorInterface.get_inspector())
