## The shaders that the guide shows add no wrong pixels with antialiasing and glow.
extends "res://tests/engine/picture_harness.gd"

const ShownCode := preload("res://tests/engine/shown_code.gd")
const PAGES: PackedStringArray = [
	"docs/guide/materials.md",
	"docs/guide/leaves.md",
	"docs/guide/baking.md",
	"docs/guide/grounds.md"
]
const SIZE := Vector2i(320, 180)
## Factor by which channels may be brighter, because antialiasing samples other points of a plant.
## The plain picture misses small highlights. Extrapolated values have no bound.
const TOLERANCE_OF_LIGHT := 1.8


func before_each() -> void:
	make_stage()
	stage.size = SIZE
	stage.use_hdr_2d = true
	var found := stage.find_children("*", "WorldEnvironment", true, false)
	var environment := (found[0] as WorldEnvironment).environment
	environment.glow_enabled = true
	environment.glow_hdr_threshold = 1.0


func after_each() -> void:
	stage.free()


func test_shaders_of_the_guide_have_no_wrong_pixels_with_msaa() -> void:
	RenderingServer.global_shader_parameter_add(
		&"season", RenderingServer.GLOBAL_VAR_TYPE_COLOR, Color.WHITE
	)
	var field := PlantField3D.from_species(
		[load("res://addons/undergrowth/species/lawn_grass.tres")]
	)
	field.size = Vector2(8, 8)
	field.density = 120.0
	field.simulation_enabled = false
	field.material_override = ShaderMaterial.new()
	stage.add_child(field)
	stage.get_camera_3d().look_at_from_position(Vector3(0, 1.2, 7.0), Vector3.ZERO)
	var count := 0
	for block in _shaders():
		var shader := Shader.new()
		shader.code = block.code
		field.material_override = ShaderMaterial.new()
		(field.material_override as ShaderMaterial).shader = shader
		count += 1
		await _check_antialiased(block.place)
	field.free()
	RenderingServer.global_shader_parameter_remove(&"season")
	check(count >= 2, "%d shaders of plants" % count)


func _check_antialiased(place: String) -> void:
	stage.msaa_3d = Viewport.MSAA_DISABLED
	var brightest := brightest_of(await picture())
	check(brightest > 0.05 and brightest < 4.0, "%s is lit, by at most %.2f" % [place, brightest])
	stage.msaa_3d = Viewport.MSAA_4X
	var shown := await picture()
	var wrong := count_wrong(shown, TOLERANCE_OF_LIGHT * brightest)
	check_equal(
		wrong, 0, "wrong pixels of %s, of %.2f and %.2f" % [place, brightest_of(shown), brightest]
	)


## Returns the shaders of plants that the guide shows.
func _shaders() -> Array:
	var blocks := []
	for page in PAGES:
		for block in ShownCode.in_markdown(ShownCode.find_file(page), page):
			if block.language == "gdshader" and "UNDERGROWTH_BEND" in block.code:
				blocks.append(block)
	return blocks
