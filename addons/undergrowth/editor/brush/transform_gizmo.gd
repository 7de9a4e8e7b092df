@tool
extends RefCounted
## Hides the editor's transform gizmo, which lies below the pointer of the brush.

const VIEWS := 4
## Render layer of the transform gizmo of the first 3D view. That of the next view is one higher.
const FIRST_LAYER := 27


## Shows or hides the transform gizmo in all 3D views.
static func set_visible(is_visible: bool) -> void:
	for i in VIEWS:
		var camera := EditorInterface.get_editor_viewport_3d(i).get_camera_3d()
		if camera:
			var layer := 1 << (FIRST_LAYER + i)
			camera.cull_mask = camera.cull_mask | layer if is_visible else camera.cull_mask & ~layer
