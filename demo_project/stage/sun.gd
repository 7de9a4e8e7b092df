extends DirectionalLight3D
## A sun that looks the same in every renderer.
##
## Compatibility adds light with shadows after tone mapping, which makes the same energy brighter.

## Share of the energy that is left in Compatibility.
@export_range(0.1, 1.0, 0.01) var compatibility_share := 0.36


func _ready() -> void:
	if RenderingServer.get_current_rendering_method() == "gl_compatibility":
		light_energy *= compatibility_share
