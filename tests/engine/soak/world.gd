## The objects of a round of the soak: fields and plants, and all nodes that they use. Each action
## changes, queries, moves or frees one object at random.
extends "res://tests/engine/soak/chance.gd"

const Things := preload("res://tests/engine/soak/things.gd")
const MAX_FIELDS := 3
const MAX_PLANTS := 12
const MAX_OTHERS := 24
## Classes with random changes of their own properties.
const SHOWN: Array[StringName] = [&"PlantField3D", &"Plant3D", &"GeometryInstance3D", &"Node3D"]
## Signals of fields with one argument.
const FIELD_SIGNALS_OF_ONE: Array[StringName] = [
	&"build_failed",
	&"body_entered_plants",
	&"body_exited_plants",
	&"skeleton_shown",
	&"skeleton_hidden",
]

var root: Node
var things: Things
var fields: Array[PlantField3D] = []
var plants: Array[Plant3D] = []
## Paths, bodies, meshes, cameras, wind sources and groups that fields use or that are their
## parents.
var others: Array[Node3D] = []

var _actions: Array[Callable] = []
var _second_world: SubViewport


func _init(new_root: Node, seed: int) -> void:
	root = new_root
	rng.seed = seed
	things = Things.new(seed, fields, others)
	_add(Camera3D.new(), others)
	_add_second_world()
	_add_field()
	var often: Array[Callable] = [
		_change_field, _change_field, _query_field, _query_field, _change_resource
	]
	_actions = [_change_plant, _query_plant, _add_field, _add_plant, _add_other, _free_other]
	_actions += [
		_free_field, _free_plant, _move, _move, _reparent, _pause, _change_wind, _edit_path
	]
	_actions += often + often
	_actions += [_change_other, _change_other, _query_other, _save_field, _apply_saved]
	_actions += [things.play_with_map, things.play_with_map, things.work_on_threads]
	_actions += [things.query_function, things.query_simulation, _shade_ground]


func act() -> void:
	_forget_freed()
	var action: Callable = pick(_actions)
	action.call()


## Frees all objects in a random order.
func end() -> void:
	_forget_freed()
	var ids: PackedInt64Array = []
	for node: Node in fields + plants + others:
		ids.append(node.get_instance_id())
	while not ids.is_empty():
		var index := rng.randi_range(0, ids.size() - 1)
		if is_instance_id_valid(ids[index]):
			instance_from_id(ids[index]).free()
		ids.remove_at(index)
	_second_world.free()


func _forget_freed() -> void:
	for list: Array in [fields, plants, others]:
		for i in range(list.size() - 1, -1, -1):
			if not is_instance_valid(list[i]) or list[i].is_queued_for_deletion():
				list.remove_at(i)


func _add(node: Node3D, list: Array) -> void:
	list.append(node)
	var parent: Node = pick(others) if not others.is_empty() and chance(0.2) else root
	if parent != node:
		parent.add_child(node)
	else:
		root.add_child(node)


## Returns a separate world with a camera, as a parent for nodes.
func _add_second_world() -> void:
	_second_world = SubViewport.new()
	_second_world.own_world_3d = true
	_second_world.size = Vector2i(32, 32)
	_second_world.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(_second_world)
	var center := Node3D.new()
	_second_world.add_child(center)
	others.append(center)
	center.add_child(Camera3D.new())


func _add_field() -> void:
	if fields.size() < MAX_FIELDS:
		var field := things.new_field()
		field.build_finished.connect(_on_signal.bind(field))
		for title in FIELD_SIGNALS_OF_ONE:
			field.connect(title, _on_signal.bind(field).unbind(1))
		field.build_progressed.connect(_on_progressed.bind(field))
		_add(field, fields)


func _add_plant() -> void:
	if plants.size() < MAX_PLANTS:
		_add(things.new_plant(), plants)


func _add_other() -> void:
	if others.size() < MAX_OTHERS:
		_add(things.new_other(), others)


func _free_other() -> void:
	if others.size() > 2:
		_free(pick(others), 1.0)


func _free_field() -> void:
	_free(pick(fields), 0.15)


func _free_plant() -> void:
	_free(pick(plants), 0.3)


func _free(node: Node, share: float) -> void:
	if node != null and chance(share):
		if chance(0.5):
			node.free()
		else:
			node.queue_free()


func _change_field() -> void:
	_change(pick(fields))


func _change_plant() -> void:
	_change(pick(plants))


## Sometimes sets several at once, as when settings are loaded.
func _change(node: Node3D) -> void:
	for i in rng.randi_range(1, 3) if node != null else 0:
		var shown := SHOWN.filter(node.is_class)
		var properties := ClassDB.class_get_property_list(
			shown[0] if chance(0.8) else pick(shown), true
		)
		things.change(node, pick(properties))


func _change_other() -> void:
	var sources := others.filter(func(node: Node3D) -> bool: return node is PlantWindSource3D)
	var source: Node3D = pick(sources if chance(0.8) else others)
	if source is PlantWindSource3D:
		things.change(source, pick(ClassDB.class_get_property_list(&"PlantWindSource3D", true)))
	elif source is Camera3D and chance(0.1):
		source.position = point()


func _query_other() -> void:
	var source: Node3D = pick(others)
	if source is PlantWindSource3D:
		source.explode()


func _save_field() -> void:
	var field: PlantField3D = pick(fields)
	if field != null:
		things.keep_bytes(field.get_changes())


func _apply_saved() -> void:
	var field: PlantField3D = pick(fields)
	if field == null:
		return
	var bytes: PackedByteArray = things.damaged_save(FIELD_LETTERS)
	if chance(0.5):
		field.apply_changes(bytes)
	else:
		field.saved_changes = bytes


func _query_field() -> void:
	_query(pick(fields))


func _shade_ground() -> void:
	var field: PlantField3D = pick(fields)
	if field != null:
		things.shade_ground(field)


func _query_plant() -> void:
	_query(pick(plants))


func _query(node: Node3D) -> void:
	if node == null:
		return
	var methods := ClassDB.class_get_method_list(node.get_class(), true).filter(_is_query)
	things.query(node, pick(methods))


func _is_query(method: Dictionary) -> bool:
	var title: String = method["name"]
	var is_setter := title.begins_with("set_") and title != "set_motion_state"
	return not is_setter and (not title.begins_with("_") or title == "_preview")


func _change_resource() -> void:
	var resource := things.any_resource()
	if resource != null:
		things.change(resource, pick(resource.get_property_list().filter(_is_stored)))


func _is_stored(property: Dictionary) -> bool:
	return (
		property["usage"] & PROPERTY_USAGE_STORAGE
		and not property["name"] in ["resource_path", "script"]
	)


func _change_wind() -> void:
	var wind: PlantWind = pick(things.winds)
	if chance(0.5):
		things.query(
			wind, pick(ClassDB.class_get_method_list(&"PlantWind", true).filter(_is_query))
		)
	else:
		things.change(wind, pick(ClassDB.class_get_property_list(&"PlantWind", true)))


func _move() -> void:
	var node: Node3D = pick(others + fields + plants if chance(0.3) else others)
	if node != null:
		node.transform = transform() if chance(0.3) else Transform3D(Basis.IDENTITY, place())
		node.visible = chance(0.9)


func _reparent() -> void:
	var node: Node3D = pick(fields + plants + others)
	var parent: Node = pick(others) if chance(0.5) else root
	if node == null or parent == null or parent == node or node.is_ancestor_of(parent):
		return
	if chance(0.5) and node.is_inside_tree():
		node.reparent(parent, chance(0.5))
		return
	if node.get_parent() != null:
		node.get_parent().remove_child(node)
	if chance(0.7):
		parent.add_child(node)


func _pause() -> void:
	var tree := Engine.get_main_loop() as SceneTree
	tree.paused = chance(0.2)
	Engine.time_scale = pick([1.0, 1.0, 1.0, 0.0, 0.1, 20.0])


func _edit_path() -> void:
	things.edit_path(pick(others.filter(func(node: Node3D) -> bool: return node is Path3D)))


## A build emits it in most of its frames.
func _on_progressed(_ratio: float, field: PlantField3D) -> void:
	if chance(0.05):
		_on_signal(field)


## Runs actions in signal handlers, as scripts do.
func _on_signal(field: PlantField3D) -> void:
	if chance(0.2):
		_query(field)
	elif chance(0.1):
		_change(field)
	elif chance(0.05):
		field.queue_free()
