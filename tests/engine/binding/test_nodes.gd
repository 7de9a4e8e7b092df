## Nodes of C++ classes: notifications, engine virtuals, signals, dynamic properties, scenes.
extends "res://tests/engine/harness.gd"

const SCENE := "user://probe_scene.tscn"

var _node: ProbeNode


class Own:
	extends ProbeDerived
	var was_ready := false

	func _ready() -> void:
		was_ready = true


func before_each() -> void:
	_node = ProbeNode.new()


func after_each() -> void:
	_node.free()


func test_a_new_object_is_notified_once_that_it_is_complete() -> void:
	check_equal(_node.get_log(), PackedStringArray(["postinitialize"]))
	check(_node.get_inner_child().get_parent() == _node, "a child made in the constructor")


func test_notifications_and_engine_virtuals_arrive_in_order() -> void:
	_node.clear_log()
	root.add_child(_node)
	root.remove_child(_node)
	check_equal(_node.get_log(), PackedStringArray(["enter", "ready", "exit"]))


func test_base_classes_get_notifications_first_and_predelete_last() -> void:
	var derived := ProbeDerived.new()
	derived.clear_log()
	root.add_child(derived)
	root.remove_child(derived)
	var expected := ["enter", "ready", "derived ready", "derived exit", "exit"]
	check_equal(derived.get_log(), PackedStringArray(expected))
	derived.free()


func test_a_script_adds_to_native_notifications() -> void:
	var own := Own.new()
	own.clear_log()
	root.add_child(own)
	check(own.was_ready, "the script's _ready")
	check_equal(own.get_log(), PackedStringArray(["enter", "ready", "derived ready"]))
	own.free()


func test_process_is_called_when_overridden() -> void:
	root.add_child(_node)
	check(_node.is_processing(), "switched on by the override")
	await frames(2)
	check(_node.get_processed() > 0.0, "time was counted")


func test_signals_bring_their_arguments() -> void:
	var signals: Array = []
	_node.measured.connect(func(value: float, at: Vector3) -> void: signals.append([value, at]))
	_node.position.y = 2.0
	_node.measure(1.5)
	check_equal(signals, [[1.5, Vector3(0, 2, 0)]])
	for entry in ClassDB.class_get_signal_list("ProbeNode", true):
		check_equal(entry["args"][1]["name"], "at")


func test_a_bound_method_is_connected_and_disconnected() -> void:
	_node.clear_log()
	_node.listen(true)
	_node.measure(1.5)
	check_equal(_node.get_signal_connection_list("measured").size(), 1)
	_node.listen(false)
	_node.measure(2.5)
	check_equal(_node.get_signal_connection_list("measured").size(), 0)
	check_equal(_node.get_log(), PackedStringArray(["measured 1.5 at 0.0"]))


func test_a_native_callable_is_connected_and_disconnected() -> void:
	_node.clear_log()
	_node.listen_native(true)
	_node.listen_native(true)
	check_error("already connected")
	_node.measure(1.5)
	check_equal(_node.get_signal_connection_list("measured").size(), 1)
	_node.listen_native(false)
	_node.measure(2.5)
	check_equal(_node.get_signal_connection_list("measured").size(), 0)
	check_equal(_node.get_log(), PackedStringArray(["measured 1.5 at 0.0"]))


func test_callables_of_one_method_are_equal() -> void:
	var one := Callable(_node, "add")
	check(one == Callable(_node, "add"), "equal")
	check(one != Callable(_node, "turn"), "different")


func test_indexed_and_dynamic_properties_are_set_and_listed() -> void:
	_node.axis_y = 3.0
	check_equal(_node.position, Vector3(0, 3, 0))
	_node.set("extra/first", 4)
	check_equal(_node.get("extra/first"), 4)
	check_equal(_node.get("extra/none"), 0)
	check_equal(_node.get("no_such_property"), null)
	var names := _node.get_property_list().map(func(p: Dictionary) -> String: return p["name"])
	check("extra/first" in names and "extra/second" in names and "axis_y" in names, "listed")


func test_an_object_writes_itself_as_text() -> void:
	_node.speed = 2.0
	check_equal(str(_node), "<probe at 2.0>")


func test_constants_are_bound() -> void:
	check(ClassDB.class_has_integer_constant("ProbeNode", "NOTIFICATION_READY"), "bound")
	check_equal(ClassDB.class_get_integer_constant("ProbeNode", "NOTIFICATION_READY"), 13)


func test_a_scene_is_saved_and_loaded() -> void:
	var resource := ProbeResource.new()
	resource.count = 8
	_node.speed = 4.0
	_node.resource = resource
	_node.set("extra/second", "text")
	var child := ProbeDerived.new()
	child.name = "Child"
	_node.add_child(child)
	child.owner = _node
	var scene := PackedScene.new()
	check_equal(scene.pack(_node), OK)
	check_equal(ResourceSaver.save(scene, SCENE), OK)
	var loaded: PackedScene = ResourceLoader.load(SCENE, "", ResourceLoader.CACHE_MODE_IGNORE)
	var copy: ProbeNode = loaded.instantiate()
	check_equal(copy.speed, 4.0)
	check_equal(copy.get("extra/second"), "text")
	check_equal(copy.resource.count, 8)
	check(copy.get_node("Child") is ProbeDerived, "the child's class")
	check_equal(copy.get_child_count(true), 2, "one child of the scene, one internal")
	copy.free()
	DirAccess.remove_absolute(SCENE)


func test_a_copy_has_the_same_properties() -> void:
	_node.speed = 6.0
	var copy: ProbeNode = _node.duplicate()
	check_equal(copy.speed, 6.0)
	copy.free()
