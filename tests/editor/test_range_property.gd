@tool
extends "editor_test.gd"
## Two numbers of a range in one line of the inspector.

const RangeProperty := preload("res://addons/undergrowth/editor/inspector/range_property.gd")


func test_the_hint_of_a_range_sets_both_sliders() -> void:
	var lengths := RangeProperty.new()
	lengths.setup(false, "0.001,2,0.0005,or_greater,suffix:m", "–")
	for slider: EditorSpinSlider in [lengths.get("_first"), lengths.get("_last")]:
		check_equal([slider.min_value, slider.max_value], [0.001, 2.0], "limits")
		check_equal(slider.step, 0.0005, "step")
		check(slider.allow_greater and not slider.allow_lesser, "beyond the limits")
		check_equal(slider.suffix, "m", "unit")
		check(not slider.rounded, "fractions")
	lengths.free()
	var angles := RangeProperty.new()
	angles.setup(false, "-180,180,0.1,or_less,or_greater,radians_as_degrees", "–")
	var angle: EditorSpinSlider = angles.get("_last")
	check_equal([angle.suffix, angle.step], ["°", 0.1], "unit and step of an angle")
	check(angle.allow_lesser and angle.allow_greater, "angles beyond the limits")
	angles.free()
	var counts := RangeProperty.new()
	counts.setup(true, "0,200,1,or_greater", "–")
	var count: EditorSpinSlider = counts.get("_first")
	check_equal([count.step, count.max_value], [1.0, 200.0], "step and limit of a count")
	check(count.rounded, "whole counts")
	counts.free()
	var free := RangeProperty.new()
	free.setup(false, "", "–")
	var any: EditorSpinSlider = free.get("_first")
	check(any.allow_lesser and any.allow_greater, "any number without a hint")
	free.free()


func test_angles_are_shown_in_degrees_and_set_in_radians() -> void:
	var leaves := PlantArrangement.new()
	leaves.angle = Vector2(deg_to_rad(10.0), deg_to_rad(20.0))
	var angles := RangeProperty.new()
	angles.setup(false, "-180,180,0.1,radians_as_degrees", "–")
	angles.set_object_and_property(leaves, &"angle")
	EditorInterface.get_base_control().add_child(angles)
	angles.update_property()
	var sliders: Array[EditorSpinSlider] = [angles.get("_first"), angles.get("_last")]
	var values := sliders.map(func(slider: EditorSpinSlider) -> int: return roundi(slider.value))
	check_equal(values, [10, 20], "shown")
	var changed: Array[Vector2] = []
	angles.property_changed.connect(
		func(_name: StringName, value: Vector2, _field: StringName, _more: bool) -> void:
			changed.append(value)
	)
	sliders[1].value = 45.0
	check(changed.size() == 1, "%d changes" % changed.size())
	var wanted := Vector2(deg_to_rad(10.0), deg_to_rad(45.0))
	check(changed[0].is_equal_approx(wanted), "set: %s" % changed[0])
	angles.set_read_only(true)
	check(sliders[0].read_only and sliders[1].read_only, "both are read only")
	angles.free()
