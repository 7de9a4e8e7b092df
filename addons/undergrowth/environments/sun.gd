extends DirectionalLight3D
## A sun of equal brightness in all renderers. Compatibility adds light with shadows after tone
## mapping, which makes the same energy brighter.

## Factor of the energy in Compatibility.
@export_range(0.1, 1.0, 0.01) var compatibility_share := 0.36


func _ready() -> void:
	if RenderingServer.get_current_rendering_method() == "gl_compatibility":
		light_energy *= compatibility_share
