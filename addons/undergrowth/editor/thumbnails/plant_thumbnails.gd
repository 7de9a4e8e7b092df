@tool
extends EditorResourcePreviewGenerator
## Thumbnails of species for the FileSystem dock and resource pickers.
##
## The editor calls this on its own thread with most renderers, and between two frames with
## Compatibility. So pictures are drawn in software, without a viewport. Small lists show the icon
## of the class, which is designed for its size.

const ThumbnailPainter := preload("thumbnail_painter.gd")


func _handles(type: String) -> bool:
	return type == "PlantFunction" or ClassDB.is_parent_class(type, "PlantFunction")


func _generate(resource: Resource, size: Vector2i, _metadata: Dictionary) -> Texture2D:
	var function := resource as PlantFunction
	var image := ThumbnailPainter.paint(function, size) if function else null
	return ImageTexture.create_from_image(image) if image else null
