## Colours of the ready species without light, over distance and in the gamut.
extends "res://tests/engine/picture_harness.gd"

const FOLDER := "res://addons/undergrowth/species/"
const PLANTS := 6
const SEED := 4
## Height of the view (m) at every distance, as if the camera zoomed.
const VIEW := 1.6
const DISTANCES: PackedFloat32Array = [2.0, 8.0, 25.0]
## Degrees by which the hue of the mean colour may differ from that at the first distance.
const MAX_HUE_CHANGE := 5.0
## The same at the last distance for species whose coarsest form has other shares of its colours.
const MAX_FAR_HUE_CHANGES: Dictionary[String, float] = {
	"buttercup": 10.0,
	"cornflower": 17.0,
	"garden_tulip": 10.0,
	"ivy_carpet": 7.0,
	"lavender": 9.5,
	"lawn_grass": 6.5,
	"oxeye_daisy": 13.5,
	"poppy": 9.0,
	"yarrow": 8.5,
}
## Segments of solid forms, and the ΔE (CIE 1976) by which their mean colour may differ from that of
## the uncut plant.
const UNCUT := 60
const SOLID: PackedInt32Array = [14, 8, 5]
const MAX_TONE_CHANGE := 2.0
## The same of species whose coarse forms are less exact.
const MAX_TONE_CHANGES: Dictionary[String, float] = {
	"bellflower": 3.3,
	"dandelion": 2.3,
	"moss_cushion": 3.7,
	"straw": 4.7,
	"yarrow": 2.4,
}
## Limits of undergrowth_in_gamut(): maximum channel, and minimum channel relative to it, linear.
const MAX_CHANNEL := 0.85
const MIN_SHARE := 0.03
const ROUNDING := 0.01

var field: PlantField3D
# By species, at all distances. Two tests look at them.
var _pictures: Dictionary[String, Array] = {}


func before_each() -> void:
	make_stage()
	stage.debug_draw = Viewport.DEBUG_DRAW_UNSHADED


func after_each() -> void:
	stage.free()


func test_colours_keep_their_hue_over_distance() -> void:
	for file in _species():
		var hues := PackedFloat32Array()
		for shown: Image in await _pictures_of(file):
			hues.append(_mean_of(shown).linear_to_srgb().h * 360.0)
		for i in range(1, hues.size()):
			var change := absf(angle_difference(deg_to_rad(hues[0]), deg_to_rad(hues[i])))
			var is_last := i == hues.size() - 1
			var limit: float = (
				MAX_FAR_HUE_CHANGES.get(file, MAX_HUE_CHANGE) if is_last else MAX_HUE_CHANGE
			)
			check(
				rad_to_deg(change) <= limit,
				"%s at %d m: hue %.1f, %.1f near" % [file, DISTANCES[i], hues[i], hues[0]]
			)


func test_no_channel_of_a_species_is_clipped() -> void:
	for file in _species():
		var shown: Image = (await _pictures_of(file))[0]
		var plants := 0
		var wrong := 0
		var pixels := _bytes_of(shown).to_int32_array()
		for i in pixels.size():
			if pixels[i] & 0xffffff == 0:
				continue
			var color := shown.get_pixel(i % PICTURE_SIZE.x, i / PICTURE_SIZE.x).srgb_to_linear()
			var maximum := maxf(color.r, maxf(color.g, color.b))
			var minimum := minf(color.r, minf(color.g, color.b))
			plants += 1
			var is_clipped := minimum < MIN_SHARE * maximum - ROUNDING
			wrong += 1 if maximum > MAX_CHANNEL + ROUNDING or is_clipped else 0
		check(plants > MIN_PLANT, "%s is seen in %d pixels" % [file, plants])
		check_equal(wrong, 0, "clipped pixels of " + file)


func test_solid_forms_have_the_mean_colour_of_the_plant() -> void:
	var shown := MeshInstance3D.new()
	var look := StandardMaterial3D.new()
	look.vertex_color_use_as_albedo = true
	look.vertex_color_is_srgb = true
	look.cull_mode = BaseMaterial3D.CULL_DISABLED
	shown.material_override = look
	stage.add_child(shown)
	stage.get_camera_3d().projection = Camera3D.PROJECTION_ORTHOGONAL
	for file in _species():
		var species: PlantFunction = load(FOLDER + file + ".tres")
		shown.mesh = species.generate_mesh(0.0, UNCUT, SEED)
		var size := shown.mesh.get_aabb().size
		var uncut := await _tone_of(size)
		for segments in SOLID:
			shown.mesh = species.generate_mesh(0.0, segments, SEED)
			var change := (await _tone_of(size)).distance_to(uncut)
			var limit: float = MAX_TONE_CHANGES.get(file, MAX_TONE_CHANGE)
			check(change <= limit, "%s of %d segments: ΔE %.2f" % [file, segments, change])


func _species() -> PackedStringArray:
	var files := PackedStringArray()
	for file in ResourceLoader.list_directory(FOLDER):
		if file.ends_with(".tres"):
			files.append(file.get_basename())
	check(files.size() >= 27, "%d species" % files.size())
	return files


## Returns the pictures of some plants from DISTANCES.
func _pictures_of(file: String) -> Array:
	if not _pictures.has(file):
		await _plant(file)
		var shown: Array[Image] = []
		for away in DISTANCES:
			shown.append(await _seen_from(away))
		_pictures[file] = shown
		field.free()
	return _pictures[file]


## Makes a field of some plants of a species, without differences between clumps and plants.
func _plant(file: String) -> void:
	field = await make_added_field(null)
	var species: PlantFunction = load(FOLDER + file + ".tres").duplicate()
	var look := ShaderMaterial.new()
	look.shader = load("res://addons/undergrowth/shaders/plant_parts.gdshader")
	for name in ["patchiness", "clumpiness"]:
		look.set_shader_parameter(name, 0.0)
	species.material = look
	var places: Array[Transform3D] = []
	for i in PLANTS:
		var at := Vector3(0.2 * (i - 0.5 * PLANTS), 0, 0)
		places.append(Transform3D(Basis(Vector3.UP, 2.4 * i), at))
	field.add_plants(places, species)


## Returns the picture from this distance (m). Plants have the same size on it.
func _seen_from(away: float) -> Image:
	var camera := stage.get_camera_3d()
	camera.fov = rad_to_deg(2.0 * atan(0.5 * VIEW / away))
	camera.look_at_from_position(Vector3(0, 0.5 + 0.3 * away, away), Vector3(0, 0.5, 0))
	return await picture()


## Returns the mean colour of a mesh of this size from two sides, in L*a*b*.
func _tone_of(size: Vector3) -> Vector3:
	var camera := stage.get_camera_3d()
	camera.size = 1.1 * maxf(size.y, maxf(size.x, size.z))
	var middle := Vector3(0, 0.5 * size.y, 0)
	var sum := Vector4.ZERO
	for turn: float in [0.3, 1.9]:
		var way := Vector3(5.0 * sin(turn), 1.5, 5.0 * cos(turn))
		camera.look_at_from_position(middle + way, middle)
		sum += sum_of_light(await picture())
	sum /= maxf(sum.w, 1.0)
	return _lab_of(Vector3(sum.x, sum.y, sum.z))


## CIE 1976 L*a*b* under D65.
func _lab_of(light: Vector3) -> Vector3:
	var x := light.dot(Vector3(0.4124, 0.3576, 0.1805)) / 0.9505
	var y := light.dot(Vector3(0.2126, 0.7152, 0.0722))
	var z := light.dot(Vector3(0.0193, 0.1192, 0.9505)) / 1.089
	var roots := Vector3(pow(x, 1.0 / 3.0), pow(y, 1.0 / 3.0), pow(z, 1.0 / 3.0))
	return Vector3(116.0 * roots.y - 16.0, 500.0 * (roots.x - roots.y), 200.0 * (roots.y - roots.z))


## Returns the mean linear colour of the plants.
func _mean_of(shown: Image) -> Color:
	var sum := sum_of_light(shown)
	var largest := maxf(sum.x, maxf(sum.y, sum.z))
	return Color(sum.x / largest, sum.y / largest, sum.z / largest)
