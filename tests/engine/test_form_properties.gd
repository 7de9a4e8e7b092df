## Each property of a part, an arrangement or a species changes the mesh, and is reported once.
extends "res://tests/engine/harness.gd"

const SEGMENTS := 24
## They have no effect on the mesh.
const OF_MOTION: PackedStringArray = ["frequency", "damping_ratio"]
const NEVER: PackedStringArray = ["script", "resource_name", "resource_local_to_scene"]

var _species: PlantFunction
var _part: PlantPart
var _leaves: PlantArrangement
var _carried: PlantArrangement
var _reports := 0


func before_each() -> void:
	_reports = 0


func test_each_property_of_a_blade_changes_the_mesh() -> void:
	_make(PlantBlade.of({length = Vector2(0.2, 0.3), width = 0.05, bend = 0.5, fold = 0.2}))
	_part.set_indexed(^"teeth", 5)
	_part.set_indexed(^"wave", 0.3)
	_check_all(_part, OF_MOTION)


func test_each_property_of_an_axis_changes_the_mesh() -> void:
	var axis := PlantAxis.of({length = Vector2(0.2, 0.3), diameter = Vector2(0.04, 0.01)})
	axis.bend = 0.5
	axis.lobes = 5
	axis.lobe_depth = 0.3
	_make(axis)
	_check_all(_part, OF_MOTION + PackedStringArray(["venation"]))


func test_each_property_of_a_bead_changes_the_mesh() -> void:
	_make(PlantBead.of({length = Vector2(0.02, 0.03), diameter = 0.02}))
	_check_all(_part, OF_MOTION + PackedStringArray(["venation"]))


func test_each_property_of_an_arrangement_changes_the_mesh() -> void:
	var hidden: Dictionary[int, PackedStringArray] = {
		PlantArrangement.LAYOUT_ALONG: ["radius", "dome", "level_tops", "tilt", "swept"],
		PlantArrangement.LAYOUT_WHORL:
		["from", "to", "per_node", "turn", "dome", "level_tops", "tilt", "swept"],
		PlantArrangement.LAYOUT_DISC: ["from", "to", "per_node", "turn", "tilt", "swept"],
		PlantArrangement.LAYOUT_GROUND:
		["from", "to", "per_node", "turn", "dome", "level_tops", "angle", "angle_curve", "flat"],
	}
	for layout in hidden:
		_make(PlantBlade.of({length = Vector2(0.2, 0.3), width = 0.05, bend = 0.5}))
		_leaves.layout = layout as PlantArrangement.ArrangementLayout
		_leaves.radius = 0.02
		_leaves.angle = Vector2(0.7, 0.9)
		_leaves.tilt = Vector2(0.2, 0.9)
		_leaves.scale = Vector2(1.0, 0.5)
		_leaves.dome = 1.0
		_check_all(_leaves, hidden[layout])


func test_each_property_of_what_is_carried_reaches_the_mesh() -> void:
	_make(PlantAxis.of({length = Vector2(0.2, 0.3), diameter = Vector2(0.01, 0.01)}))
	_carried = PlantArrangement.of(
		{part = PlantBlade.of({length = Vector2(0.05, 0.06), width = 0.02}), count = Vector2i(4, 4)}
	)
	_leaves.carries = [_carried]
	_check_change(_carried, &"count", Vector2i(7, 7))
	_check_change(_carried, &"visible", false)
	_check_change(_carried.part, &"width", 0.03)
	_check_change(_carried.part, &"base_color", Color.RED)


func test_each_property_of_the_look_of_a_species_changes_the_mesh() -> void:
	_make(PlantBlade.of({length = Vector2(0.2, 0.3), width = 0.05}))
	_species.has_stem = true
	_check_change(_species, &"has_stem", false)
	_species = TulipFunction.new()
	_species.changed.connect(_count)
	_check_change(_species, &"shading", PlantFunction.SHADING_FLAT)
	_check_change(_species, &"shape_deviation", 0.5)
	_check_change(_species, &"color_deviation", 0.5)


func test_curves_and_gradients_of_a_part_are_followed() -> void:
	_make(PlantBlade.of({length = Vector2(0.2, 0.3), width = 0.05}))
	var curve := _curve()
	var gradient := Gradient.new()
	_part.width_curve = curve
	_part.gradient = gradient
	var before := _bytes()
	_reports = 0
	curve.set_point_value(0, 0.9)
	check(_reports > 0, "a changed curve is reported")
	check(_bytes() != before, "and changes the mesh")
	before = _bytes()
	_reports = 0
	gradient.set_color(0, Color.RED)
	check(_reports > 0, "a changed gradient is reported")
	check(_bytes() != before, "and changes the mesh")
	_part.width_curve = null
	_part.gradient = null
	_reports = 0
	curve.set_point_value(0, 0.3)
	gradient.set_color(0, Color.BLUE)
	check_equal(_reports, 0, "reports of a curve and a gradient that were taken away")


func test_colors_of_a_part_go_from_base_to_tip() -> void:
	_make(PlantBlade.of({length = Vector2(0.3, 0.3), width = 0.02}))
	_leaves.count = Vector2i(1, 1)
	_leaves.layout = PlantArrangement.LAYOUT_GROUND
	_leaves.tilt = Vector2.ZERO
	_species.has_stem = false
	_part.base_color = Color.RED
	_part.tip_color = Color.GREEN
	_check_red_to_green("two colors")
	_part.gradient = Gradient.new()
	_part.gradient.set_color(0, Color.RED)
	_part.gradient.set_color(1, Color.GREEN)
	_part.base_color = Color.BLUE
	_part.tip_color = Color.BLUE
	_check_red_to_green("a gradient instead of them")


func _check_red_to_green(title: String) -> void:
	var arrays := _species.generate_mesh(0.0, SEGMENTS, 1).surface_get_arrays(0)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var colors: PackedColorArray = arrays[Mesh.ARRAY_COLOR]
	var low := 0
	var high := 0
	for i in points.size():
		low = i if points[i].y < points[low].y else low
		high = i if points[i].y > points[high].y else high
	check(colors[low].r > 0.7 and colors[low].g < 0.3, "%s: %s at the base" % [title, colors[low]])
	check(
		colors[high].g > 0.7 and colors[high].r < 0.3, "%s: %s at the tip" % [title, colors[high]]
	)


func _make(part: PlantPart) -> void:
	_part = part
	_leaves = PlantArrangement.of({part = part, count = Vector2i(4, 7)})
	_species = PlantFunction.new()
	_species.arrangements = [_leaves]
	_species.changed.connect(_count)


func _count() -> void:
	_reports += 1


func _check_all(object: Resource, without_effect: PackedStringArray) -> void:
	var tried := 0
	for property in object.get_property_list():
		var title: StringName = property["name"]
		var is_stored: bool = property["usage"] & PROPERTY_USAGE_STORAGE != 0
		if not is_stored or title in NEVER or title in without_effect or title == &"carries":
			continue
		_check_change(object, title, _other(object.get(title), property))
		tried += 1
	check(tried >= 5, "%d properties of %s" % [tried, object.get_class()])


func _check_change(object: Resource, title: StringName, value: Variant) -> void:
	var what := "%s.%s" % [object.get_class(), title]
	var before: Variant = object.get(title)
	object.set(title, before)  # An angle then is one that degrees can write.
	var bytes := _bytes()
	_reports = 0
	object.set(title, value)
	check_equal(_reports, 1, "reports of " + what)
	check(_bytes() != bytes, what + " changes the mesh")
	object.set(title, value)
	check_equal(_reports, 1, "reports of the same value of " + what)
	object.set(title, before)
	check(_bytes() == bytes, what + " restores the mesh")


func _bytes() -> PackedByteArray:
	var mesh := _species.generate_mesh(0.0, SEGMENTS, 1)
	return var_to_bytes(mesh.surface_get_arrays(0)) if mesh else PackedByteArray()


func _other(value: Variant, property: Dictionary) -> Variant:
	if property["type"] == TYPE_OBJECT:
		return _resource(property["hint_string"])
	var other: Variant = not value
	match property["type"]:
		TYPE_INT:
			other = (int(value) + 1) % (4 if property["hint"] == PROPERTY_HINT_ENUM else 100)
		TYPE_FLOAT:
			other = float(value) + 0.05 if float(value) < 0.3 else 0.5 * float(value) + 0.1
		TYPE_VECTOR2:
			other = (value as Vector2) * 0.8 + Vector2(0.01, 0.02)
		TYPE_VECTOR2I:
			other = (value as Vector2i) + Vector2i(3, 3)
		TYPE_COLOR:
			other = Color.MAGENTA
	return other


func _resource(kind: String) -> Resource:
	match kind:
		"Curve":
			return _curve()
		"Gradient":
			var gradient := Gradient.new()
			gradient.set_color(0, Color.YELLOW)
			return gradient
	return PlantAxis.of({length = Vector2(0.1, 0.1), diameter = Vector2(0.02, 0.01)})


func _curve() -> Curve:
	var curve := Curve.new()
	curve.add_point(Vector2(0.0, 0.4))
	curve.add_point(Vector2(1.0, 0.7))
	return curve
