@tool
extends "editor_test.gd"
## Errors of refused values at their controls in the inspector.


func test_the_cause_is_below_the_control_until_the_next_edit() -> void:
	var grass := GrassFunction.new()
	grass.mass = 0.05
	EditorInterface.edit_resource(grass)
	await frames(4)
	var control := _control_of(&"mass")
	check(control != null, "the inspector shows the mass")
	if control == null:
		return
	control.emit_changed(&"mass", -5.0)
	await frames(3)
	check_error("mass cannot be -5")
	var shown := _shown_below(control)
	check(shown.begins_with("Mass cannot be -5"), "shown: %s" % shown)
	check_equal(grass.mass, 0.05, "the old value stays")
	control.emit_changed(&"mass", 0.07)
	await frames(3)
	check_equal(_shown_below(control), "", "shown after a good value")
	check_equal(grass.mass, 0.07, "mass")
	EditorInterface.edit_resource(null)


func _control_of(property: StringName) -> EditorProperty:
	var inspector := EditorInterface.get_inspector()
	for control: EditorProperty in inspector.find_children("*", "EditorProperty", true, false):
		if control.get_edited_property() == property:
			return control
	return null


func _shown_below(control: EditorProperty) -> String:
	for label: Label in control.get_parent().find_children("RefusedValue*", "Label", false, false):
		if label.get_index() == control.get_index() + 1:
			return label.text
	return ""
