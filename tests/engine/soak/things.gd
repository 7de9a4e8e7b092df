## Creates and changes the objects of the soak. It finds nodes in the lists of the world.
extends "res://tests/engine/soak/chance.gd"

const FUNCTIONS: Array[StringName] = [
	&"GrassFunction",
	&"ReedFunction",
	&"CattailFunction",
	&"TulipFunction",
	&"BellflowerFunction",
	&"CurvePlantFunction",
]
const SHAPES: Array[StringName] = [
	&"BoxShape3D",
	&"SphereShape3D",
	&"CapsuleShape3D",
	&"CylinderShape3D",
	&"WorldBoundaryShape3D",
	&"ConvexPolygonShape3D",
]
const ScriptSpecies := preload("res://tests/engine/soak/script_species.gd")
const GrowingSpecies := preload("res://tests/engine/soak/growing_species.gd")
const HeightObject := preload("res://tests/engine/soak/height_object.gd")
const Ground3D := preload("res://addons/undergrowth/grounds/ground_3d.gd")
const GROUNDS: Array[Material] = [
	preload("res://addons/undergrowth/grounds/meadow.tres"),
	preload("res://addons/undergrowth/grounds/mud.tres"),
]
const READY_SPECIES := "res://addons/undergrowth/species/"
const MIXES := "res://addons/undergrowth/mixes/"
## Number of ready species in a round. Sanitizers make their builds slow.
const READY_COUNT := 3
const MAX_SAVED_BYTES := 8
const THREAD_TASKS := 4
const MAX_IDS := 60
## Index of the first built-in species after the scripts.
const FIRST_GRASS := 2

var winds: Array[PlantWind] = [PlantWind.new(), PlantWind.new()]
var maps: Array[PlantMap] = [PlantMap.new(), PlantMap.new()]
var habitats: Array[PlantHabitat] = [PlantHabitat.new(), PlantHabitat.new()]

var _fields: Array[PlantField3D]
var _others: Array[Node3D]
var _functions: Array[PlantFunction] = [ScriptSpecies.new(), GrowingSpecies.new()]
## Arrangements of species and their parts.
var _parts: Array[Resource] = []
var _stems: Array[PlantStem] = [PlantStem.new(), PlantStem.new()]
var _entries: Array[PlantFieldSpecies] = []
var _levels: Array[PlantFieldLevel] = []
var _materials: Array[Material] = [StandardMaterial3D.new(), ShaderMaterial.new()]
## Ids of plants that existed at some time.
var _known_ids: PackedInt64Array = []


func _init(seed: int, fields: Array[PlantField3D], others: Array[Node3D]) -> void:
	rng.seed = seed + 1000003
	_fields = fields
	_others = others
	for title in FUNCTIONS:
		_functions.append(ClassDB.instantiate(title))
	_add_ready_species()
	_add_stems()
	winds[1].kind = PlantWind.KIND_AIR
	for function in _functions:
		_entries.append(PlantFieldSpecies.of(function, rng.randf()))
	for i in 4:
		_levels.append(PlantFieldLevel.of(rng.randi_range(1, 8), i * 4.0))
	var shader := Shader.new()
	shader.code = "shader_type spatial; uniform float a = 0.5; void fragment() { ALBEDO = vec3(a); }"
	(_materials[1] as ShaderMaterial).shader = shader


func new_field() -> PlantField3D:
	match rng.randi_range(0, 11):
		0:
			return _new_large_field()
		1:
			return _new_mix()
	var field := (
		PlantField3D.from_species(_some(_functions, 3)) if chance(0.5) else PlantField3D.new()
	)
	field.size = Vector2(4.0 + WIDEST_FIELD * rng.randf(), 6.0)
	field.density = rng.randf_range(1.0, 40.0)
	field.bodies_group = &"walkers"
	field.wind = pick(winds)
	field.prototypes = pick([0, 0, 16])
	field.map = pick(maps) if chance(0.5) else null
	return field


## Returns a field of so many plants that its first build has several parts.
func _new_large_field() -> PlantField3D:
	var field := PlantField3D.from_species([_functions[FIRST_GRASS]])
	field.levels = [PlantFieldLevel.of(2)]
	field.size = Vector2(30.0, 30.0)
	field.density = 28.0
	field.prototypes = 16
	field.tile_size = pick([4.0, 10.0])
	field.view_distance = pick([0.0, 0.0, 12.0])
	field.wind = pick(winds)
	return field


func _new_mix() -> PlantField3D:
	var files := ResourceLoader.list_directory(MIXES)
	var mix: PackedScene = load(MIXES + files[rng.randi_range(0, files.size() - 1)])
	var field: PlantField3D = mix.instantiate()
	field.size = Vector2(3.0, 2.0)
	return field


func new_plant() -> Plant3D:
	var plant := Plant3D.new()
	plant.species = pick(_functions)
	plant.wind = pick(winds)
	plant.position = place()
	return plant


## Returns a path, a body, a mesh or an object for the ground, a camera, or a parent node.
func new_other() -> Node3D:
	match rng.randi_range(0, 10):
		0:
			var path := Path3D.new()
			edit_path(path)
			return path
		1:
			var ground := MeshInstance3D.new()
			ground.mesh = PlaneMesh.new() if chance(0.5) else BoxMesh.new()
			ground.scale = Vector3(8.0, 1.0, 8.0)
			return ground
		2:
			var camera := Camera3D.new()
			camera.current = chance(0.5)
			camera.position = place()
			return camera
		3:
			return Node3D.new()
		4, 5:
			return _new_wind_source()
		6:
			return HeightObject.new()
		7:
			return _new_shaded_ground()
	return _new_body()


func edit_path(path: Path3D) -> void:
	if path == null:
		return
	path.curve = null if chance(0.1) else Curve3D.new()
	for i in rng.randi_range(0, 8) if path.curve != null else 0:
		path.curve.add_point(place(), place() * 0.1, place() * 0.1)


func _new_shaded_ground() -> Node3D:
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	(ground.mesh as PlaneMesh).material = pick(GROUNDS)
	ground.set_script(Ground3D)
	ground.set(&"field", pick(_fields.filter(is_instance_valid)))
	ground.set(&"shows_density", chance(0.5))
	return ground


## Measures the plants of [param field] for the material of a ground.
func shade_ground(field: PlantField3D) -> void:
	var material: ShaderMaterial = pick(GROUNDS).duplicate()
	Ground3D.apply_density(material, field)
	if chance(0.2):
		Ground3D.apply_color(material, field)


func any_resource() -> Resource:
	return pick(
		pick(
			[_functions, _functions, _entries, _levels, _materials, _stems, _parts, maps, habitats]
		)
	)


## Calls a method of a map, or stores its bytes for later maps.
func play_with_map() -> void:
	var map: PlantMap = pick(maps)
	if chance(0.2):
		keep_bytes(map.data)
	elif map.data.is_empty() and chance(0.3):
		maps[maps.find(map)] = PlantMap.new()  # The bytes may have been invalid.
	elif chance(0.1):
		maps[rng.randi_range(0, maps.size() - 1)] = map.snapshot()
	elif chance(0.05):
		map.data = value({"name": "data", "type": TYPE_PACKED_BYTE_ARRAY})
	else:
		var methods := ClassDB.class_get_method_list(&"PlantMap", true)
		query(map, pick(methods.filter(_is_no_setter)))


## Calls a method of a species.
func query_function() -> void:
	var methods := ClassDB.class_get_method_list(&"PlantFunction", true)
	query(pick(_functions), pick(methods.filter(_is_no_setter)))


## Calls a method of the simulation, or changes its step.
func query_simulation() -> void:
	var simulation: Object = Engine.get_singleton(&"PlantSimulation")
	if chance(0.1):
		simulation.set(&"step_length", pick([0.001, 0.1, 1.0 / 60.0, NAN]))
	else:
		var methods := ClassDB.class_get_method_list(&"PlantSimulation", true)
		query(simulation, pick(methods.filter(_is_no_setter)))


## Stores saved [param bytes], which are damaged and loaded later.
func keep_bytes(bytes: PackedByteArray) -> void:
	saved_bytes.append(bytes)
	if saved_bytes.size() > MAX_SAVED_BYTES:
		saved_bytes.remove_at(0)


## Generates meshes and plants, and samples winds, on threads. The main thread waits for them,
## because the headless renderer supports one thread at a time.
func work_on_threads() -> void:
	var chosen: Array = []
	for i in 1 if DisplayServer.get_name() == "headless" else THREAD_TASKS:
		chosen.append([pick(_functions), pick(winds), rng.randi_range(0, 12), rng.randi()])
	var group := WorkerThreadPool.add_group_task(
		func(index: int) -> void:
			_work(chosen[index][0], chosen[index][1], chosen[index][2], index),
		chosen.size()
	)
	WorkerThreadPool.wait_for_group_task_completion(group)


func _work(function: PlantFunction, wind: PlantWind, segments: int, seed: int) -> void:
	function.generate_mesh(0.0, segments, seed)
	function.find_problem(1.0, segments, seed)
	wind.sample_velocity(seed, Vector3.UP)
	var plant := Plant3D.new()
	plant.species = function
	plant.get_mesh()
	plant.free()


func _is_no_setter(method: Dictionary) -> bool:
	var title: String = method["name"]
	return (
		not title.begins_with("_") and (not title.begins_with("set_") or title.ends_with("image"))
	)


func _add_ready_species() -> void:
	var files := ResourceLoader.list_directory(READY_SPECIES)
	for i in READY_COUNT:
		var ready: PlantFunction = load(READY_SPECIES + files[rng.randi_range(0, files.size() - 1)])
		var own: PlantFunction = ready.duplicate_deep(Resource.DEEP_DUPLICATE_INTERNAL)
		_functions.append(own)
		_add_parts(own.arrangements)
		if own.stem != null:
			_stems.append(own.stem)


func _add_parts(arrangements: Array) -> void:
	for arrangement: PlantArrangement in arrangements:
		if arrangement != null and not _parts.has(arrangement):
			_parts.append(arrangement)
			if arrangement.part != null:
				_parts.append(arrangement.part)
			_add_parts(arrangement.carries)


## Sets stems of all kinds of stiffness, and species that bend by them.
func _add_stems() -> void:
	_stems[1].modes = 2
	for stem in _stems.slice(0, 2):
		var reed := CurvePlantFunction.new()
		reed.law = PlantFunction.LAW_STEM
		reed.stem = stem
		_functions.append(reed)


func _new_wind_source() -> Node3D:
	var source := PlantWindSource3D.new()
	source.kind = rng.randi_range(0, 2) as PlantWindSource3D.Kind
	source.position = place()
	return source


func _new_curve() -> Curve:
	var low := rng.randf_range(-10.0, 10.0)
	var high := low + rng.randf_range(0.1, 50.0)
	return PlantHabitat.make_curve([Vector2(low, rng.randf()), Vector2(high, rng.randf())])


## Sets one property of [param object], described by [param info], to a random value.
func change(object: Object, info: Dictionary) -> void:
	if info == null or info["usage"] & PROPERTY_USAGE_READ_ONLY:
		return
	var title: String = info["name"]
	match title:
		"species":
			object.set(title, pick(_functions) if not object is PlantField3D else _entry_list())
		"levels":
			object.set(title, _level_list())
		"wind":
			object.set(title, null if chance(0.1) else pick(winds))
		"stem":
			object.set(title, null if chance(0.2) else pick(_stems))
		"habitat":
			object.set(title, null if chance(0.3) else pick(habitats))
		"map":
			object.set(title, null if chance(0.3) else pick(maps))
		"part":
			object.set(
				title, pick(_parts.filter(func(one: Resource) -> bool: return one is PlantPart))
			)
		"material", "material_override", "material_overlay":
			object.set(title, null if chance(0.4) else pick(_materials))
		"ground_object":
			_choose_ground_object(object as PlantField3D)
		"outline", "ground_mesh":
			object.set(title, NodePath() if chance(0.3) else _path_from(object as Node))
		"exclusions", "streaming_targets":
			object.set(title, _path_list(object as Node))
		_ when object is PlantHabitat and title.ends_with("_curve"):
			object.set(title, null if chance(0.3) else _new_curve())
		_:
			# The engine itself does not accept positions that are not finite.
			var chosen: Variant = place() if info["type"] == TYPE_VECTOR3 else value(info)
			if chosen != null:
				object.set(title, chosen)


## Calls a method of [param object], described by [param info], with random arguments.
func query(object: Object, info: Dictionary) -> void:
	var arguments: Array = []
	for argument: Dictionary in info["args"]:
		arguments.append(_argument(object, argument))
	var answer: Variant = object.callv(info["name"], arguments)
	if answer is PackedByteArray:
		keep_bytes(answer)
	if answer is PackedInt64Array and not answer.is_empty():
		_known_ids = answer.slice(0, MAX_IDS)
	if answer is Node and not answer.is_inside_tree() and answer != object:
		answer.free()


func _argument(object: Object, info: Dictionary) -> Variant:
	var made: Variant = null
	match info["name"]:
		"id":
			made = pick(_ids(object)) if chance(0.95) else rng.randi()
		"ids":
			made = _ids(object)
		"state":
			made = _state()
		"transforms":
			made = _transforms()
		"functions":
			made = _some(_functions, 4)
		"shares":
			made = PackedFloat32Array([rng.randf(), -rng.randf(), NAN])
		"species":
			made = null if chance(0.05) else pick(_functions)
			if int(info["type"]) == TYPE_STRING:
				made = pick(_entries).get_layer_name() if chance(0.7) else value(info)
		"wind":
			made = pick(winds)
		"from":
			made = pick(maps)
		"image":
			made = Image.create_empty(rng.randi_range(1, 9), 5, false, Image.FORMAT_RGBA8)
		"rng":
			made = RandomNumberGenerator.new()
		"material":
			made = null if chance(0.1) else pick(_materials)
		"skeleton":
			var field := object as PlantField3D
			made = pick(field.get_skeletons()) if field != null and chance(0.8) else null
		_:
			made = value(info)
	return made


## Returns ids of existing plants, some of removed ones, and some twice.
func _ids(object: Object) -> PackedInt64Array:
	var ids := PackedInt64Array()
	var field := object as PlantField3D
	if field != null and chance(0.9):
		var all := field.get_plant_ids()
		for i in rng.randi_range(1, MAX_IDS) if not all.is_empty() else 0:
			ids.append(all[rng.randi_range(0, all.size() - 1)])
	if ids.is_empty() or chance(0.15):
		ids.append_array(_known_ids)
	if ids.is_empty():
		ids.append(rng.randi())
	return ids


func _state() -> PackedFloat32Array:
	var state := PackedFloat32Array()
	state.resize(6 * rng.randi_range(0, MAX_IDS))
	for i in state.size():
		state[i] = rng.randfn() if chance(0.99) else pick(ODD_NUMBERS)
	return state


func _transforms() -> Variant:
	if chance(0.05):
		return "nonsense"
	var transforms: Array[Transform3D] = []
	for i in rng.randi_range(0, MAX_IDS):
		transforms.append(odd_transform())
	return transforms


func _some(from: Array, maximum: int) -> Array:
	var some: Array = []
	for i in rng.randi_range(0, maximum):
		some.append(pick(from))
	return some


func _entry_list() -> Array[PlantFieldSpecies]:
	var list: Array[PlantFieldSpecies] = []
	list.assign(_some(_entries, 4))
	if chance(0.05):
		list.append(null)
	return list


func _level_list() -> Array[PlantFieldLevel]:
	var list: Array[PlantFieldLevel] = []
	list.assign(_some(_levels, 4))
	if chance(0.05):
		list.append(null)
	return list


func _path_from(node: Node) -> NodePath:
	var target: Node = pick(_others + _fields)
	if target == null or node == null or not node.is_inside_tree() or not target.is_inside_tree():
		return ^"../nowhere"
	return node.get_path_to(target)


func _choose_ground_object(field: PlantField3D) -> void:
	var ground: Node = pick(_others.filter(func(node: Node3D) -> bool: return node is HeightObject))
	var has_path := ground != null and ground.is_inside_tree() and field.is_inside_tree()
	field.ground_object = field.get_path_to(ground) if has_path else NodePath()
	if chance(0.7):
		field.ground_mode = PlantField3D.GROUND_OBJECT


func _path_list(node: Node) -> Array[NodePath]:
	var list: Array[NodePath] = []
	for i in rng.randi_range(0, 3):
		list.append(_path_from(node))
	return list


func _new_body() -> Node3D:
	var body: CollisionObject3D = (
		pick([StaticBody3D.new, AnimatableBody3D.new, CharacterBody3D.new, Area3D.new]).call()
	)
	body.position = place()
	for i in rng.randi_range(0, 2):
		var shape := CollisionShape3D.new()
		shape.shape = null if chance(0.1) else ClassDB.instantiate(pick(SHAPES))
		if shape.shape is ConvexPolygonShape3D:
			shape.shape.points = PackedVector3Array([place(), place(), place(), place(), place()])
		shape.position = place() * 0.1
		body.add_child(shape)
	if chance(0.8):
		body.add_to_group(&"walkers")
	return body
