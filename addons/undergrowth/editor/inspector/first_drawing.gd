@tool
extends RefCounted
## The initial curve of a species of curves without one: a leaf.


## True if the species has no curve.
static func is_missing(curves: CurvePlantFunction) -> bool:
	return not curves.width_curve and not curves.color_gradient


static func make_curve() -> Curve:
	var curve := Curve.new()
	curve.add_point(Vector2(0.0, 0.35), 0.0, 1.0)
	curve.add_point(Vector2(0.45, 1.0))
	curve.add_point(Vector2(1.0, 0.0), -2.5, 0.0)
	return curve


static func make_gradient() -> Gradient:
	var gradient := Gradient.new()
	gradient.colors = PackedColorArray([Color("3b6e22"), Color("a9c95b")])
	return gradient
