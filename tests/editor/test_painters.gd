@tool
extends "editor_test.gd"
## Pictures of species that are drawn in software.

const MeshPainter := preload("res://addons/undergrowth/editor/thumbnails/mesh_painter.gd")
const PlantThumbnails := preload("res://addons/undergrowth/editor/thumbnails/plant_thumbnails.gd")
const ThumbnailPainter := preload("res://addons/undergrowth/editor/thumbnails/thumbnail_painter.gd")
const SIZE := Vector2i(32, 32)


func test_a_mesh_is_upright_with_the_colors_of_its_vertices() -> void:
	var picture := MeshPainter.new().paint(_stack(), SIZE)
	check(_is_red(picture.get_pixel(16, 6)), "the upper half is red: %s" % picture.get_pixel(16, 6))
	check(_is_green(picture.get_pixel(16, 26)), "the lower half is green")
	check_equal(picture.get_pixel(2, 16).a, 0.0, "beside a narrow mesh")
	check_equal(picture.get_used_rect().size.y, 30, "height of the picture without its margin")


func test_a_nearer_triangle_hides_a_farther_one() -> void:
	for is_first: bool in [true, false]:
		var quads: Array[Array] = [[0.0, 2.0, 0.5, Color.RED], [0.0, 2.0, -0.5, Color.GREEN]]
		if not is_first:
			quads.reverse()
		var picture := MeshPainter.new().paint(_mesh(quads), SIZE)
		var front := picture.get_pixel(14, 16)
		check(_is_red(front), "the nearer quad is seen, drawn first: %s" % is_first)


func test_both_sides_of_a_leaf_have_the_same_light() -> void:
	var front := MeshPainter.new().paint(_mesh([[0.0, 2.0, 0.0, Color.WHITE]]), SIZE)
	var back := MeshPainter.new().paint(_mesh([[0.0, 2.0, 0.0, Color.WHITE]], -1.0), SIZE)
	check(front.get_pixel(16, 16).is_equal_approx(back.get_pixel(16, 16)), "light")
	var lit := front.get_pixel(16, 16).r
	check(lit > 0.65 and lit < 1.0, "light of a leaf: %f" % lit)


func test_a_texture_covers_a_mesh_without_its_clear_pixels() -> void:
	var image := Image.create_empty(2, 2, false, Image.FORMAT_RGBA8)
	image.fill(Color.BLUE)
	image.set_pixel(0, 0, Color(0, 0, 1, 0.2))
	image.set_pixel(1, 1, Color.RED)
	var material := StandardMaterial3D.new()
	material.albedo_texture = ImageTexture.create_from_image(image)
	var mesh := _mesh([[0.0, 2.0, 0.0, Color.WHITE]])
	mesh.surface_set_material(0, material)
	var picture := MeshPainter.new().paint(mesh, SIZE)
	check_equal(picture.get_pixel(12, 6).a, 0.0, "the clear corner at the upper left")
	check(picture.get_pixel(20, 6).b > 0.5, "the upper right")
	check(_is_red(picture.get_pixel(20, 26)), "the lower right")
	material.albedo_texture = null
	material.albedo_color = Color.GREEN
	picture = MeshPainter.new().paint(mesh, SIZE)
	check(_is_green(picture.get_pixel(16, 16)), "the color of a material without a texture")


func test_a_stem_is_drawn_from_root_to_tip() -> void:
	var function := CurvePlantFunction.new()
	function.width_curve = Curve.new()
	function.width_curve.add_point(Vector2(0.0, 1.0))
	function.width_curve.add_point(Vector2(1.0, 0.2))
	function.color_gradient = Gradient.new()
	function.color_gradient.set_color(0, Color.RED)
	function.color_gradient.set_color(1, Color.GREEN)
	var picture := ThumbnailPainter.paint(function, SIZE)
	var used := picture.get_used_rect()
	var middle := used.get_center().x
	check(_is_red(picture.get_pixel(middle, used.end.y - 2)), "the root is red")
	check(_breadth(picture, used.end.y - 3) >= _breadth(picture, used.position.y + 3), "and wider")
	var greenest := 0.0
	for x in SIZE.x:
		var color := picture.get_pixel(x, used.position.y + 2)
		greenest = maxf(greenest, (color.g - color.r) * color.a)
	check(greenest > 0.2, "the tip is green: %f" % greenest)


func test_thumbnails_are_for_species_only() -> void:
	var thumbnails := PlantThumbnails.new()
	check(thumbnails._handles("PlantFunction"), "the base class")
	check(thumbnails._handles("TulipFunction"), "a species")
	check(not thumbnails._handles("PlantWind"), "a wind")
	var picture: Texture2D = thumbnails._generate(TulipFunction.new(), SIZE, {})
	check_equal(Vector2i(picture.get_size()), SIZE, "size")
	check_equal(thumbnails._generate(PlantWind.new(), SIZE, {}), null, "picture of a wind")


func _stack() -> ArrayMesh:
	return _mesh([[1.0, 2.0, 0.0, Color.RED], [0.0, 1.0, 0.0, Color.GREEN]])


# Quads that face the painter's camera, each with bottom, top, depth, and color.
func _mesh(quads: Array[Array], side := 1.0) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	var facing := Basis(Vector3.UP, -MeshPainter.TURN)
	for i in quads.size():
		var quad := quads[i]
		for corner: Vector2 in [Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 1)]:
			tool.set_normal(facing * Vector3(0, 0, side))
			tool.set_color(quad[3])
			tool.set_uv(Vector2(corner.x, 1.0 - corner.y))
			var height: float = lerpf(quad[0], quad[1], corner.y)
			var depth: float = quad[2]
			tool.add_vertex(facing * Vector3(corner.x - 0.5, height, depth))
		for index: int in [0, 1, 2, 0, 2, 3]:
			tool.add_index(4 * i + index)
	return tool.commit()


func _breadth(picture: Image, y: int) -> int:
	var count := 0
	for x in picture.get_width():
		count += 1 if picture.get_pixel(x, y).a > 0.5 else 0
	return count


func _is_red(color: Color) -> bool:
	return color.a > 0.5 and color.r > 0.4 and color.g < 0.2


func _is_green(color: Color) -> bool:
	return color.a > 0.5 and color.g > 0.4 and color.r < 0.2
