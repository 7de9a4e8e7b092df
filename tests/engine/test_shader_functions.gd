## Functions of the add-on's shaders, evaluated on the graphics card.
extends "res://tests/engine/harness.gd"

const COUNT := 64
## Values of a picture are from -RANGE to RANGE, in 16 bits.
const RANGE := 8.0
const NEAR := 2.0 * RANGE / 65535.0
const SHADER := """shader_type canvas_item;
%s
#include "res://addons/undergrowth/shaders/%s.gdshaderinc"
void fragment() {
	float x = floor(UV.x * 64.0) / 63.0;
	float value = %s;
	float part = round((clamp(value / 8.0, -1.0, 1.0) * 0.5 + 0.5) * 65535.0);
	COLOR = vec4(floor(part / 256.0) / 255.0, mod(part, 256.0) / 255.0, 0.0, 1.0);
}
"""
const ORDERS := "#define UNDERGROWTH_PACKED\n#define UNDERGROWTH_ORDERS\n"
const UP := "vec3(0.0, 1.0, 0.0)"

var _stage: SubViewport
var _sheet: ColorRect
var _material: ShaderMaterial


func before_each() -> void:
	_stage = SubViewport.new()
	_stage.size = Vector2i(COUNT, 1)
	_stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_stage)
	_sheet = ColorRect.new()
	_sheet.size = Vector2(COUNT, 1)
	_material = ShaderMaterial.new()
	_sheet.material = _material
	_stage.add_child(_sheet)


func after_each() -> void:
	_stage.free()


func test_the_width_of_a_level_grows_and_ends_within_its_transitions() -> void:
	var uniforms := {undergrowth_level = Vector4(10, 30, 4, 8)}
	var lathe := await _width("undergrowth_width_of_level(40.0 * x)", uniforms)
	_check_at(lathe, 40.0, {5.0: 0.0, 7.0: 0.5, 9.0: 1.0, 22.0: 1.0, 25.0: 1.0, 28.0: 0.5})
	_check_at(lathe, 40.0, {31.0: 0.0, 38.0: 0.0})
	uniforms["undergrowth_has_parts"] = true
	var parts := await _width("undergrowth_width_of_level(40.0 * x)", uniforms)
	_check_at(parts, 40.0, {5.0: 0.0, 7.0: 0.15, 9.0: 0.65, 11.0: 1.0, 28.0: 0.5, 31.0: 0.0})


func test_thinned_plants_cover_as_much_as_all() -> void:
	var ends := {undergrowth_share_ends = Vector3(10, 20, 30)}
	for share: float in [1.0, 0.6, 0.4]:
		ends["undergrowth_shares"] = Vector3.ONE * share
		var widths := await _width("undergrowth_width_of_rank((63.0 * x + 0.5) / 64.0, 5.0)", ends)
		var sum := 0.0
		for width in widths:
			sum += width
		check_near(sum / COUNT, 1.0, 0.05, "covered at a share of %f" % share)
		check(widths[0] > 0.99 / share - 0.3, "the first rank stays at a share of %f" % share)
		check_equal(widths[-1] > NEAR, share == 1.0, "the last rank stays at a share of %f" % share)
	ends["undergrowth_shares"] = Vector3.ONE * 0.1
	var few := await _width("undergrowth_width_of_rank(x, 5.0)", ends)
	check_near(few[0], 3.0, 0.01, "maximum width")


func test_the_density_changes_between_its_distances() -> void:
	var uniforms := {
		undergrowth_share_ends = Vector3(10, 20, 40), undergrowth_shares = Vector3(1.0, 0.5, 0.1)
	}
	var shares := await _width("undergrowth_share_at(50.0 * x)", uniforms)
	_check_at(shares, 50.0, {5.0: 1.0, 10.0: 1.0, 15.0: 0.75, 20.0: 0.5, 30.0: 0.3, 40.0: 0.1})
	_check_at(shares, 50.0, {50.0: 0.1})


func test_plants_seen_from_above_are_narrower_in_far_levels() -> void:
	var uniforms := {undergrowth_from_above = Vector2(0.6, 1.2)}
	var code := "undergrowth_width_from(10.0 * x, 10.0)"
	var near := await _width(code, uniforms)
	check_near(near[63], 1.0, NEAR, "the first level")
	uniforms["undergrowth_level"] = Vector4(5, 30, 1, 1)
	var far := await _width(code, uniforms)
	check_near(far[0], 1.0, NEAR, "from the side")
	check_near(far[63], 0.5, 0.001, "from straight above")
	check(far[30] < 1.0 and far[30] > 0.5, "in between: %f" % far[30])
	var below := await _width("undergrowth_width_from(-10.0 * x, 10.0)", uniforms)
	check_near(below[30], far[30], NEAR, "from below")
	uniforms["undergrowth_from_above"] = Vector2(0.1, 1.2)
	far = await _width(code, uniforms)
	check_near(far[63], 0.35, 0.001, "the minimum")


func test_shadows_become_narrower_before_their_end() -> void:
	var code := "undergrowth_width(0.0, vec3(40.0 * x, 0.0, 0.0), vec3(0.0), %s)"
	var uniforms := {undergrowth_shadow_end = 30.0}
	var cast := await _width(code % "true", uniforms)
	_check_at(cast, 40.0, {10.0: 1.0, 24.0: 1.0, 27.0: 0.5, 30.0: 0.0, 39.0: 0.0})
	var seen := await _width(code % "false", uniforms)
	_check_at(seen, 40.0, {10.0: 1.0, 27.0: 1.0, 39.0: 1.0})


func test_a_pixel_is_as_wide_as_its_view() -> void:
	for is_flat: bool in [false, true]:
		var view := Projection.create_perspective(60.0, 2.0, 0.1, 100.0)
		if is_flat:
			view = Projection.create_orthogonal(-4, 4, -2, 2, 0.1, 100.0)
		var code := "100.0 * undergrowth_pixel(10.0 * x, view, vec2(800.0, 400.0), %s)"
		var uniforms := {view = view}
		var widths := await _values(
			"undergrowth_width", code % "false", uniforms, "uniform mat4 view;"
		)
		# A picture of 400 rows.
		var high := 4.0 if is_flat else 2.0 * 5.0 * tan(deg_to_rad(30.0))
		_check_at(widths, 10.0, {5.0: 100.0 * high / 400.0})
		var cast := await _values(
			"undergrowth_width", code % "true", uniforms, "uniform mat4 view;"
		)
		check_near(cast[40], 0.0, NEAR, "in a shadow")


func test_far_plants_have_at_least_a_pixel_and_less_contrast() -> void:
	var code := "widened(vec3(0.1, 0.5, 0.0), %s)"
	var head := """#include "res://addons/undergrowth/shaders/undergrowth_width.gdshaderinc"
float widened(vec3 vertex, float pixel) {
	undergrowth_widen(1.0, vec3(0.0, 0.0, 1.0), pixel, vertex);
	return vertex.x;
}
"""
	var near := await _values("undergrowth_width", code % "0.6 * x", {}, head)
	check_near(near[63], 0.1, NEAR, "the first level keeps its width")
	var uniforms := {undergrowth_level = Vector4(5, 30, 1, 1)}
	var far := await _values("undergrowth_width", code % "0.6 * x", uniforms, head)
	_check_at(far, 0.6, {0.1: 0.1, 0.2: 0.1, 0.4: 0.2, 0.5: 0.25})
	var contrast := "undergrowth_contrast(%s, vec3(0.1, 0.0, 0.0), %s)"
	var thin := await _width(contrast % ["1.0", "0.6 * x"], uniforms)
	_check_at(thin, 0.6, {0.1: 1.0, 0.4: 0.5})
	var wide := await _width(contrast % ["1.0 + 3.0 * x", "0.0"], uniforms)
	check_near(wide[63], 0.5, 0.001, "a plant of four times the width")


func test_light_on_a_leaf_comes_from_both_sides() -> void:
	var sun := "vec3(0.0, 2.0 * x - 1.0, sqrt(1.0 - (2.0 * x - 1.0) * (2.0 * x - 1.0)))"
	var code := "undergrowth_leaf_light(%s, %s, vec3(%s), vec3(%s)).g"
	var closed := await _leaf(code % [UP, sun, "1.0, 0.0, 0.0", "0.0"])
	check_near(closed[63], 1.0, 0.001, "light from the front")
	check_near(closed[32], 0.2, 0.02, "light along a leaf")
	check_near(closed[0], 0.0, NEAR, "light from behind a leaf that passes none")
	var open := await _leaf(code % [UP, sun, "1.0, 0.0, 0.0", "0.5"])
	check_near(open[63], 1.0, 0.001, "light from the front of a leaf that passes some")
	check_near(open[0], 0.45, 0.01, "light through a leaf, seen from its edge")
	var against := await _leaf(code % [UP, sun, "0.0, 1.0, 0.0", "0.5"])
	check_near(against[0], 0.9, 0.01, "seen against the light")
	var along := await _leaf(code % [UP, sun, "0.0, -1.0, 0.0", "0.5"])
	check_near(along[0], 0.45, 0.01, "seen with the light")


func test_a_leaf_shines_across_its_fibres() -> void:
	var grain := "vec3(cos(0.5 * PI * x), 0.0, sin(0.5 * PI * x))"
	var code := "undergrowth_sheen(%s, %s, normalize(vec3(1.0, %s, 0.0)), vec3(0.7071, 0.7071, 0.0))"
	var lit := await _leaf(code % [UP, grain, "1.0"])
	check(lit[0] < 0.01, "along the fibres: %f" % lit[0])
	check(lit[63] > 0.07, "across them: %f" % lit[63])
	var behind := await _leaf(code % [UP, grain, "-1.0"])
	check_near(behind[63], 0.0, NEAR, "light from behind")
	# The mean over all directions of fibres.
	var over := "normalize(vec3(0.6, 1.0, 0.0))"
	var turned := "vec3(cos(PI * x), 0.0, sin(PI * x))"
	var each := await _leaf(
		"undergrowth_sheen(%s, %s, %s, %s)" % [UP, turned, over, "normalize(vec3(0.0, 1.0, 0.0))"]
	)
	var mixed := await _leaf(
		"undergrowth_mixed_sheen(%s, %s, %s)" % [UP, over, "normalize(vec3(0.0, 1.0, 0.0))"]
	)
	var mean := 0.0
	for value in each:
		mean += value / COUNT
	check_near(mixed[0], mean, 0.4 * mean, "the mean of all fibres")


func test_colors_keep_their_hue_within_the_gamut() -> void:
	var code := "undergrowth_in_gamut(vec3(4.0 * x, 2.0 * x, 0.0)).%s"
	var red := await _leaf(code % "r")
	var green := await _leaf(code % "g")
	var blue := await _leaf(code % "b")
	for i: int in [5, 30, 63]:
		check(red[i] <= 0.851, "no clipped channel: %f" % red[i])
		check_near(green[i], 0.5 * red[i], 0.002, "hue")
		check_near(blue[i], 0.03 * red[i], 0.002, "no black channel")
	check_near(red[5], 4.0 * 5.0 / 63.0, 0.001, "a dark color stays")


func test_colors_are_converted_to_linear_light_and_back() -> void:
	var linear := await _values("undergrowth_light", "undergrowth_linear(vec3(x)).r")
	var written := await _values("undergrowth_light", "undergrowth_written(vec3(x)).r")
	for i: int in [0, 1, 2, 10, 40, 63]:
		var color := Color(i / 63.0, 0, 0)
		check_near(linear[i], color.srgb_to_linear().r, 0.001, "linear light of %f" % color.r)
		check_near(written[i], color.linear_to_srgb().r, 0.001, "written value of %f" % color.r)


func test_shadow_casters_move_away_from_the_light() -> void:
	var code := "undergrowth_off_light(vec3(0.0, %s, 0.0), place, vec3(1.0, 0.0, 0.0), 0.1).%s"
	var head := "uniform mat4 place;"
	for size: float in [1.0, 2.0]:
		var uniforms := {place = Projection(Transform3D(Basis.from_scale(Vector3.ONE * size)))}
		var high := await _values("undergrowth_light", code % ["2.0", "x"], uniforms, head)
		check_near(high[0], -0.1 / size, 0.001, "a high vertex at a scale of %f" % size)
		var low := await _values("undergrowth_light", code % ["0.0", "x"], uniforms, head)
		check_near(low[0], -0.005 / size, 0.001, "a vertex at the ground")
	var turned := {place = Projection(Transform3D(Basis(Vector3.UP, PI / 2.0)))}
	var aside := await _values("undergrowth_light", code % ["2.0", "z"], turned, head)
	check_near(aside[0], -0.1, 0.001, "of a plant that is turned")


func test_snow_lies_on_what_faces_the_sky() -> void:
	var side := "vec3(sqrt(1.0 - x * x), x, 0.0)"
	var code := "undergrowth_snow(%s, %s, %s)"
	var none := await _values("undergrowth_precipitation", code % [side, UP, "1.0"])
	check_near(none[63], 0.0, NEAR, "without snow")
	var uniforms := {undergrowth_precipitation = Vector2(0.0, 0.5)}
	var lies := await _values("undergrowth_precipitation", code % [side, UP, "1.0"], uniforms)
	check_near(lies[0], 0.0, NEAR, "on a vertical surface")
	check_near(lies[63], 0.85, 0.01, "on a level one")
	var low := await _values("undergrowth_precipitation", code % [side, UP, "0.0"], uniforms)
	check(low[63] < 0.5 * lies[63], "below others: %f" % low[63])
	var back := await _values(
		"undergrowth_precipitation", code % ["-" + side, "2.0 * " + UP, "1.0"], uniforms
	)
	check_near(back[63], lies[63], 0.001, "on the back of a leaf")


func test_wet_leaves_are_darker_and_smoother() -> void:
	var wet := {undergrowth_precipitation = Vector2(1.0, 0.0)}
	var color := await _values(
		"undergrowth_precipitation", "undergrowth_weathered(vec3(x), 0.0).g", wet
	)
	check_near(color[63], 0.65, 0.001, "a wet leaf")
	color = await _values("undergrowth_precipitation", "undergrowth_weathered(vec3(x), 1.0).b", wet)
	check_near(color[0], 0.85, 0.001, "under snow")
	var rough := "undergrowth_wet_roughness(x, %s)"
	var smooth_leaf := await _values("undergrowth_precipitation", rough % "0.0", wet)
	_check_at(smooth_leaf, 1.0, {0.2: 0.2, 0.8: 0.3})
	var snow := await _values("undergrowth_precipitation", rough % "1.0", wet)
	check_near(snow[30], 0.9, 0.001, "roughness of snow")


func test_directions_are_unpacked_from_their_octahedron() -> void:
	var code := "undergrowth_direction(uint(%d), 0u).%s"
	for wanted: Vector3 in [
		Vector3.UP,
		Vector3.DOWN,
		Vector3(1, 2, -3).normalized(),
		Vector3(-2, 1, 2).normalized(),
		Vector3(-1, -1, -2).normalized()
	]:
		var word := _pack(wanted)
		for axis in 3:
			var read := await _values("undergrowth_packed", code % [word, "xyz"[axis]])
			check_near(read[0], wanted[axis], 0.006, "%s of %s" % ["xyz"[axis], wanted])
	var across := await _values(
		"undergrowth_packed", "dot(undergrowth_about(%s, 6.28 * x), %s)" % [UP, UP]
	)
	check_near(across[20], 0.0, 0.001, "a tangent is across the normal")
	var first := "undergrowth_about(%s, 0.0)" % UP
	var turn := await _values(
		"undergrowth_packed",
		"dot(cross(%s, undergrowth_about(%s, 1.5707963)), %s)" % [first, UP, UP]
	)
	check_near(turn[0], 1.0, 0.001, "it turns about the normal")


## The steady state of a damped oscillator, as response_to_base() of the core.
func test_a_part_responds_to_its_carrier_as_an_oscillator_on_a_moving_base() -> void:
	for damping: float in [0.25, 0.6]:
		for axis: String in ["x", "y"]:
			var code := "undergrowth_response(3.0 * x, %f).%s" % [damping, axis]
			var values := await _values("undergrowth_swing", code, {}, ORDERS)
			for i in COUNT:
				var ratio := 3.0 * i / (COUNT - 1)
				var pull := Vector2(1.0 - ratio * ratio, 2.0 * damping * ratio)
				var wanted := ratio * ratio * pull / pull.length_squared()
				check_near(values[i], wanted.x if axis == "x" else wanted.y, 2.0 * NEAR, code)


func test_green_leaves_die_and_petals_do_not() -> void:
	var green := await _values("undergrowth_patches", "undergrowth_greenness(vec3(0.2, x, 0.1))")
	check_near(green[63], 1.0, 0.001, "a leaf")
	check_near(green[0], 0.0, 0.001, "a red petal")
	var pale := await _values("undergrowth_patches", "undergrowth_greenness(vec3(0.6, x, 0.55))")
	check_near(pale[63], 0.0, 0.001, "a pale petal")
	var code := "undergrowth_with_dead_leaves(vec3(%s), x).%s"
	var leaf := "0.2, 0.5, 0.1"
	var red := await _values("undergrowth_patches", code % [leaf, "r"])
	var grass := await _values("undergrowth_patches", code % [leaf, "g"])
	check_near(red[0], 0.2, 0.001, "a fresh leaf")
	check(red[63] > grass[63], "a dead leaf is brown: %f, %f" % [red[63], grass[63]])
	var petal := await _values("undergrowth_patches", code % ["0.6, 0.1, 0.2", "r"])
	check_near(petal[63], 0.6, 0.001, "a petal")


func test_grain_of_ground_fades_where_a_pixel_covers_it() -> void:
	var file := "../grounds/undergrowth_ground"
	var head := ""
	for include: String in ["leaf", "light", "patches", "precipitation", "wind"]:
		head += '#include "res://addons/undergrowth/shaders/undergrowth_%s.gdshaderinc"\n' % include
	var code := "undergrowth_grain(vec2(10.0 * x, 3.0), %s)"
	var far := await _values(file, code % "0.1, 0.2", {}, head)
	for i: int in [3, 20, 50]:
		check_near(far[i], 0.5, 0.001, "a pixel of two cells")
	var near := Array(await _values(file, code % "2.0, 0.1", {}, head))
	check(near.max() - near.min() > 0.2, "cells of many pixels: %f" % (near.max() - near.min()))


func _pack(direction: Vector3) -> int:
	var sum := absf(direction.x) + absf(direction.y) + absf(direction.z)
	var at := Vector2(direction.x, direction.y) / sum
	if direction.z < 0.0:
		at = Vector2(
			(1.0 - absf(at.y)) * (1.0 if at.x >= 0.0 else -1.0),
			(1.0 - absf(at.x)) * (1.0 if at.y >= 0.0 else -1.0)
		)
	var whole := ((at + Vector2.ONE) * 511.0).round()
	return int(whole.x) | int(whole.y) << 10


# Checks values at points from 0 to [param span], between the samples around each.
func _check_at(values: PackedFloat64Array, span: float, wanted: Dictionary) -> void:
	for at: float in wanted:
		var place := at / span * (COUNT - 1)
		var low := mini(int(place), COUNT - 2)
		var value := lerpf(values[low], values[low + 1], place - low)
		check_near(value, wanted[at], 0.04, "value at %f" % at)


func _width(code: String, uniforms := {}) -> PackedFloat64Array:
	return await _values("undergrowth_width", code, uniforms)


func _leaf(code: String) -> PackedFloat64Array:
	return await _values("undergrowth_leaf", code)


# Returns the value of an expression for x from 0 to 1.
func _values(file: String, code: String, uniforms := {}, head := "") -> PackedFloat64Array:
	var shader := Shader.new()
	shader.code = SHADER % [head, file, code]
	_material.shader = shader
	for title: StringName in uniforms:
		_material.set_shader_parameter(title, uniforms[title])
	await frames(1)
	await RenderingServer.frame_post_draw
	var picture := _stage.get_texture().get_image()
	var values := PackedFloat64Array()
	for x in COUNT:
		var color := picture.get_pixel(x, 0)
		var part := roundf(color.r * 255.0) * 256.0 + roundf(color.g * 255.0)
		values.append((part / 65535.0 * 2.0 - 1.0) * RANGE)
	return values
