## Reloads the probe library while objects of its classes exist. test_library.gd runs it in an
## editor.
extends SceneTree

const LIBRARY := "res://probe.gdextension"

var _problems := 0


func _initialize() -> void:
	var resource: Resource = ClassDB.instantiate("ProbeResource")
	resource.set("count", 9)
	resource.set("points", PackedVector3Array([Vector3.UP]))
	var node: Node = ClassDB.instantiate("ProbeDerived")
	node.set("speed", 3.0)
	node.set("resource", resource)
	node.set("extra/first", 2)
	root.add_child(node)
	var placeholder: Node = ClassDB.instantiate("ProbeRuntime")
	for i in 3:
		_check(GDExtensionManager.reload_extension(LIBRARY) == 0, "the library is loaded again")
		_check(node.get("speed") == 3.0, "a number")
		_check(node.get("resource") == resource, "a reference")
		_check(node.get("extra/first") == 2, "a dynamic property")
		_check(node.call("add", 1) == 111, "a call")
		_check(resource.get("count") == 9, "a property of a resource")
		_check(resource.get("points") == PackedVector3Array([Vector3.UP]), "a packed array")
		_check(resource.call("ask_count", 5) == 5, "a call that scripts may override")
		_check(ClassDB.instantiate("ProbeChecks") != null, "a new object")
		_check(Engine.get_singleton("ProbeServer").call("answer") == 42, "the singleton")
	node.free()
	placeholder.free()
	resource = null
	if _problems == 0:
		print("3 reloads passed")
	quit(1 if _problems > 0 else 0)


func _check(condition: bool, what: String) -> void:
	if not condition:
		_problems += 1
		print("lost by the reload: " + what)
