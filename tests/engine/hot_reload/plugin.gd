## Runs in the editor, because the engine reloads libraries only there: see test_hot_reload.gd.
##
## Prints `result NAME` or `result NAME: why` for each check after each reload.
@tool
extends EditorPlugin

const EXTENSION := "res://undergrowth.gdextension"
const PATIENCE := 60.0
const STEP := 1.0 / 60.0

# Untyped: after a reload, the types in a compiled script are those of the old library.
var _tulip: Node3D
var _curve: Node3D
var _field: Node3D
var _shared: Resource
var _last_strength := 2.5


func _enter_tree() -> void:
	get_tree().create_timer(PATIENCE).timeout.connect(func() -> void: get_tree().quit(1))
	_run.call_deferred()


func _run() -> void:
	_shared = _make("PlantWind", {"kind": 1, "strength": _last_strength, "direction": PI / 2.0})
	var tulip := _make("TulipFunction", {"mass": 0.75, "shape_deviation": 0.25})
	_tulip = _plant({"species": tulip, "height": 1.25, "segments": 7, "seed": 5})
	var curve := _make("CurvePlantFunction", {"width_curve": _make_width(), "radius": 0.25})
	_curve = _plant({"species": curve, "height": 2.0})
	_field = _make_field(tulip)
	await _frames(3)
	await _until_filled()
	_drive(_tulip)
	for round_number in 3:
		var status: int = GDExtensionManager.reload_extension(EXTENSION)
		_report("reload %d" % round_number, status == GDExtensionManager.LOAD_STATUS_OK)
		await _frames(3)
		await _check_all(round_number)
	for plant in [_tulip, _curve, _field]:
		plant.free()
	_tulip = null
	_curve = null
	_field = null
	_shared = null
	print("result end")
	get_tree().quit()


func _check_all(round_number: int) -> void:
	var prefix := "after reload %d: " % round_number
	_report(prefix + "settings of the plant", _tulip.height == 1.25 and _tulip.segments == 7)
	_report(prefix + "seed of the plant", _tulip.seed == 5 and not _tulip.simulation_enabled)
	var species: Resource = _tulip.species
	_report(prefix + "species", species.get_class() == "TulipFunction" and species.mass == 0.75)
	_report(prefix + "wind", _tulip.wind == _shared and _shared.strength == _last_strength)
	_report(prefix + "curve", _curve.species.width_curve.point_count == 2)
	for plant: Node3D in [_tulip, _curve]:
		_report(
			prefix + "one skeleton", plant.find_children("*", "Skeleton3D", true, false).size() == 1
		)
		_report(
			prefix + "one mesh", plant.find_children("*", "MeshInstance3D", true, false).size() == 1
		)
		var skeleton: Skeleton3D = plant.call("get_skeleton")
		_report(prefix + "its own skeleton", skeleton == plant.get_child(0, true))
		var mesh: ArrayMesh = plant.call("get_mesh")
		_report(prefix + "mesh", absf(mesh.get_aabb().size.y - plant.height) < 1e-5)
		_report(prefix + "mesh shown", skeleton.get_child(0, true).mesh == mesh)
	_check_motion(prefix)
	await _check_signals(prefix)
	await _check_field(prefix)


func _check_motion(prefix: String) -> void:
	_tulip.call("reset_motion")
	_drive(_tulip)
	var tip: Vector3 = _tulip.call("get_tip_position")
	_report(prefix + "the wind moves it", tip.x > 0.01 and absf(tip.length() - 1.25) < 1e-4)
	var turned: Quaternion = _tulip.call("get_skeleton").get_bone_pose_rotation(1)
	_report(prefix + "its bone turns", (turned * Vector3.UP).angle_to(tip) < 0.15)


func _check_signals(prefix: String) -> void:
	for shading: int in [1, 0]:
		_tulip.species.shading = shading
		await _frames(2)
		var count: int = _tulip.call("get_mesh").surface_get_array_len(0)
		var expected: ArrayMesh = _tulip.species.call("generate_mesh", 1.25, 7)
		_report(prefix + "it follows its species", count == expected.surface_get_array_len(0))
	var before: float = _curve.call("get_mesh").get_aabb().size.x
	var width: Curve = _curve.species.width_curve
	width.set_point_value(0, width.get_point_position(0).y * 0.5)
	await _frames(2)
	var after: float = _curve.call("get_mesh").get_aabb().size.x
	_report(prefix + "it follows its curve", absf(after - 0.5 * before) < 1e-3 * before)


func _check_field(prefix: String) -> void:
	_report(prefix + "settings of the field", _field.density == 6.0 and _field.species.size() == 1)
	var entry: Resource = _field.species[0]
	_report(prefix + "its entry", entry.weight == 0.5 and entry.species == _tulip.species)
	await _until_filled()
	_report(prefix + "the field is filled", _field.call("get_plant_count") > 10)
	var id: int = _field.call("get_plant_ids")[0]
	var before: Vector3 = _field.call("get_tip_position", id)
	for i in 20:
		_shared.call("advance", STEP)
		_field.call("_preview", STEP, _shared)
	var after: Vector3 = _field.call("get_tip_position", id)
	_report(prefix + "the field moves", after.distance_to(before) > 1e-3)


func _until_filled() -> void:
	await _frames(2)
	while _field.call("is_building"):
		await _frames(1)


func _drive(plant: Node3D) -> void:
	for i in 20:
		plant.call("advance", STEP)


func _make(type: String, properties: Dictionary) -> Resource:
	var resource: Resource = ClassDB.instantiate(type)
	for property: String in properties:
		resource.set(property, properties[property])
	return resource


func _make_width() -> Curve:
	var curve := Curve.new()
	curve.add_point(Vector2(0.0, 1.0))
	curve.add_point(Vector2(1.0, 0.0))
	return curve


func _plant(properties: Dictionary) -> Node3D:
	var plant: Node3D = ClassDB.instantiate("Plant3D")
	for property: String in properties:
		plant.set(property, properties[property])
	plant.set("simulation_enabled", false)
	plant.set("wind", _shared)
	add_child(plant)
	return plant


func _make_field(species: Resource) -> Node3D:
	var field: Node3D = ClassDB.instantiate("PlantField3D")
	field.species = [_make("PlantFieldSpecies", {"species": species, "weight": 0.5})]
	field.size = Vector2(4.0, 4.0)
	field.density = 6.0
	add_child(field)
	return field


func _frames(count: int) -> void:
	for i in count:
		await get_tree().process_frame


func _report(what: String, holds: bool) -> void:
	print("result " + what + ("" if holds else ": does not hold"))
