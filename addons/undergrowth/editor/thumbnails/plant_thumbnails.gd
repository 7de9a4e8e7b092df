@tool
extends EditorResourcePreviewGenerator
## Thumbnails of species for the FileSystem dock and resource pickers.
##
## The editor asks on a thread of its own with most renderers, and between two frames with
## Compatibility: pictures are painted in software, without a viewport and without waiting for one.
## Small lists keep the icon of the class, which is drawn for its size.

const ThumbnailPainter := preload("thumbnail_painter.gd")


func _handles(type: String) -> bool:
	return type == "PlantFunction" or ClassDB.is_parent_class(type, "PlantFunction")


func _generate(resource: Resource, size: Vector2i, _metadata: Dictionary) -> Texture2D:
	var function := resource as PlantFunction
	var image := ThumbnailPainter.paint(function, size) if function else null
	return ImageTexture.create_from_image(image) if image else null
