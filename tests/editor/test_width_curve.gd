@tool
extends "actions_test.gd"
## Interrupted drags of width points, which undo restores too.


func test_a_drag_that_another_choice_interrupts_is_undone() -> void:
	var curve := await _begin_drag()
	var dragged := curve.get_point_position(1)
	EditorInterface.edit_resource(TulipFunction.new())
	await frames(2)
	check(curve.get_point_position(1).is_equal_approx(dragged), "the point stays where it was left")
	await _release()
	await undo()
	check(curve.get_point_position(1).is_equal_approx(Vector2(0.45, 1.0)), "undo puts it back")
	await redo()
	check(curve.get_point_position(1).is_equal_approx(dragged), "redo moves it again")
	await undo()
	await _choose("Grass")


func test_a_drag_of_a_curve_that_undo_takes_away_changes_no_other() -> void:
	var curve := await _begin_drag()
	var other := Curve.new()
	other.add_point(Vector2.ZERO)
	other.add_point(Vector2(0.5, 0.5))
	other.add_point(Vector2.ONE)
	var function := _state().function as CurvePlantFunction
	function.width_curve = other
	var points := plot_points() as Control
	var at := _in_window(points, points.size * 0.7)
	_move(points, at, at + Vector2(5, 5), MOUSE_BUTTON_MASK_LEFT)
	await frames(1)
	await _release()
	check_equal(other.get_point_position(1), Vector2(0.5, 0.5), "point of the other curve")
	function.width_curve = curve
	curve.set_point_offset(1, 0.45)
	curve.set_point_value(1, 1.0)


## Returns the curve whose second point follows the pointer.
func _begin_drag() -> Curve:
	await inspect("Own Drawing")
	var curve := (_state().function as CurvePlantFunction).width_curve
	var points := plot_points() as Control
	var grip := _in_window(points, Vector2(points.size.x * curve.get_point_position(1).x, 0.0))
	await _point(points, grip)
	_press(points, grip, MOUSE_BUTTON_LEFT, true)
	_move(points, grip, grip + Vector2(25, 10), MOUSE_BUTTON_MASK_LEFT)
	await frames(2)
	check(curve.get_point_position(1).x > 0.5, "the point follows the pointer")
	return curve


func _release() -> void:
	var points := plot_points() as Control
	_press(points, _in_window(points, Vector2.ONE), MOUSE_BUTTON_LEFT, false)
	await frames(2)
