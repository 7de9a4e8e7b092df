## Plants of a field near the camera as skeletons: their selection, their state, and equal pictures.
extends "res://tests/engine/picture_harness.gd"

## Share of the plants' pixels that may differ: Compatibility stores rotations in half floats.
const MAX_DIFFERENT_SHARE := 0.005

var _field: PlantField3D
var _reported: Array[String] = []


func before_each() -> void:
	make_stage()
	_reported = []
	_field = PlantField3D.from_species([TulipFunction.new(), GrassFunction.new()])
	_field.size = Vector2(4, 4)
	_field.density = 12.0
	_field.wind = PlantWind.new()
	_field.wind.kind = PlantWind.KIND_WAVES
	_field.wind.strength = 3.0
	_field.wind.travel_speed = 2.0
	for entry in _field.species:
		entry.lean_deviation = deg_to_rad(20.0)
	_field.max_skeletons = 1000
	stage.add_child(_field)
	await _field.build_finished
	await frames(3)


func after_each() -> void:
	Engine.time_scale = 1.0
	stage.free()


func test_no_plant_is_a_skeleton_by_default() -> void:
	await frames(20)
	check_equal(_field.get_skeletons().size(), 0)
	check(_field.get_skeleton(_field.get_plant_ids()[0]) == null, "no skeleton")


func test_the_nearest_plants_become_skeletons() -> void:
	_field.max_skeletons = 20
	_field.skeleton_distance = 3.0
	await frames(60)
	check_equal(_field.get_skeletons().size(), 20)
	check_equal(_field.get_statistics()["skeletons"], 20)
	var camera_position := stage.get_camera_3d().global_position
	var farthest := 0.0
	for skeleton: Skeleton3D in _field.get_skeletons():
		farthest = maxf(farthest, skeleton.global_position.distance_to(camera_position))
		var id := _field.get_skeleton_plant(skeleton)
		check_equal(_field.get_skeleton(id), skeleton, "skeleton of plant %d" % id)
		check(
			skeleton.transform.is_equal_approx(_field.get_plant_transform(id)),
			"it is where plant %d is" % id
		)
	var nearer := 0
	for transform in _field.get_plant_transforms(_field.get_plant_ids()):
		var away := transform.origin.distance_to(camera_position)
		nearer += 1 if away < farthest / 1.1 else 0
	check(nearer <= 20, "%d plants are nearer than the farthest skeleton" % nearer)


func test_a_skeleton_bends_as_its_plant() -> void:
	_field.skeleton_distance = 7.0
	await frames(60)
	_field.simulation_enabled = false
	await frames(2)
	check(_field.get_skeletons().size() > 100, "there are skeletons")
	for skeleton: Skeleton3D in _field.get_skeletons():
		var id := _field.get_skeleton_plant(skeleton)
		var length := _field.get_plant_height(id) / skeleton.global_basis.y.length()
		var tip := skeleton.transform * (skeleton.get_bone_global_pose(1) * Vector3(0, length, 0))
		# Half a step of a tip at 2 m/s, because pictures are between two steps.
		check_near(tip, _field.get_tip_position(id), 0.02, "tip of plant %d" % id)


func test_skeletons_are_as_transparent_as_their_field() -> void:
	_field.transparency = 0.5
	_field.max_skeletons = 5
	_field.skeleton_distance = 3.0
	await frames(60)
	for wanted: float in [0.5, 0.25]:
		_field.transparency = wanted
		await frames(20)
		check_equal(_field.get_skeletons().size(), 5)
		for skeleton: Skeleton3D in _field.get_skeletons():
			var drawn := skeleton.get_child(0, true) as MeshInstance3D
			check_near(drawn.transparency, wanted, 1e-6, "transparency")


func test_skeletons_appear_and_disappear_unseen() -> void:
	_field.simulation_enabled = false
	await frames(3)
	var before := await picture()
	_field.skeleton_distance = 7.0
	await frames(60)
	var skeletons := _field.get_skeletons().size()
	var during := await picture()
	_field.skeleton_distance = 0.0
	await frames(2)
	var after := await picture()
	check(skeletons > 100, "%d skeletons" % skeletons)
	_check_same(before, during)
	check_equal(count_different(before, after), 0, "pixels that differ after them")


func test_skeletons_of_followers_appear_unseen() -> void:
	var count := _field.get_plant_count()
	_field.prototypes = 4
	await settled(_field)
	check_equal(_field.get_plant_count(), count, "plants stay")
	await frames(20)
	_field.apply_impulse_in_sphere(Vector3.ZERO, 1.0, Vector3(2, 0, 0))
	await frames(12)
	_field.simulation_enabled = false
	await frames(3)
	var before := await picture()
	_field.skeleton_distance = 7.0
	await frames(60)
	check_equal(_field.get_skeletons().size(), _field.get_plant_count(), "skeletons")
	_check_same(before, await picture())


func test_skeletons_are_what_is_drawn() -> void:
	_field.simulation_enabled = false
	_field.skeleton_distance = 7.0
	await frames(60)
	for skeleton: Skeleton3D in _field.get_skeletons():
		skeleton.hide()
	var hidden := await picture()
	_field.hide()
	var nothing := await picture()
	check_equal(
		count_different(hidden, nothing), 0, "pixels of plants that their field still draws"
	)


func test_a_shader_of_fields_fits_skeletons_and_single_plants() -> void:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	# As in the class help.
	material.shader.code = """
		shader_type spatial;
		#include "res://addons/undergrowth/shaders/undergrowth_bend.gdshaderinc"

		void vertex() {
			UNDERGROWTH_BEND
			COLOR.rgb *= 0.8 + 0.4 * fract(dot(MODEL_MATRIX[3].xyz, vec3(12.9, 78.2, 37.7)));
		}

		void fragment() {
			UNDERGROWTH_FADE
			ALBEDO = COLOR.rgb;
		}
	"""
	for entry in _field.species:
		entry.species.material = material
	await settled(_field)
	_field.simulation_enabled = false
	await frames(3)
	var before := await picture()
	_field.skeleton_distance = 7.0
	await frames(60)
	check(_field.get_skeletons().size() > 100, "there are skeletons")
	_check_same(before, await picture())


func test_skeletons_are_signalled_and_attached_nodes_move_with_them() -> void:
	_field.skeleton_shown.connect(_report_shown)
	_field.skeleton_hidden.connect(
		func(skeleton: Skeleton3D) -> void:
			_reported.append("hidden %d" % _field.get_skeleton_plant(skeleton))
	)
	_field.max_skeletons = 1
	_field.skeleton_distance = 7.0
	await frames(10)
	check_equal(_reported.size(), 1, "signals")
	var skeleton: Skeleton3D = _field.get_skeletons()[0]
	check_equal(_reported[0], "shown %d" % _field.get_skeleton_plant(skeleton))
	var lamp := skeleton.get_node("Lamp")
	await frames(10)
	_field.simulation_enabled = false
	await frames(2)
	var light := lamp.get_child(0) as Node3D
	var tip := _field.get_tip_position(_field.get_skeleton_plant(skeleton))
	check_near(light.global_position, tip, 0.05, "the light hangs at the plant's tip")
	_field.skeleton_distance = 0.0
	await frames(3)
	check_equal(_reported.size(), 2, "signals")
	check_equal(_reported[1], "hidden -1")
	check(not is_instance_valid(lamp), "the lamp is gone")
	check_equal(_field.get_skeletons().size(), 0)


func test_skeletons_that_scripts_free_come_again() -> void:
	_field.max_skeletons = 12
	_field.skeleton_distance = 7.0
	await frames(30)
	for i in 3:
		(_field.get_skeletons()[0] as Skeleton3D).free()
	(_field.get_skeletons()[0] as Skeleton3D).get_parent().free()
	await frames(30)
	check_equal(_field.get_skeletons().size(), 12)


func test_skeletons_follow_what_happens_to_their_field() -> void:
	_field.skeleton_distance = 7.0
	await frames(60)
	var count := _field.get_skeletons().size()
	var removed := _field.remove_in_sphere(Vector3.ZERO, 1.0)
	check(removed > 10, "plants are removed")
	await frames(2)
	check_equal(_field.get_skeletons().size(), count - removed, "skeletons")
	for skeleton: Skeleton3D in _field.get_skeletons():
		check(skeleton.position.length() > 1.0, "plants at %s are gone" % skeleton.position)
	for i in 12:
		_field.add_plants([Transform3D(Basis(), Vector3(0.1 * i, 0, 0))], _field.species[0].species)
		await frames(3)
	await frames(30)
	check_equal(_field.get_skeletons().size(), _field.get_plant_count(), "skeletons")
	_field.seed = 3
	await _field.build_finished
	await frames(60)
	check_equal(_field.get_skeletons().size(), _field.get_plant_count(), "new skeletons")


func test_skeletons_are_neither_saved_nor_copied() -> void:
	_field.skeleton_distance = 7.0
	await frames(60)
	var scene := PackedScene.new()
	scene.pack(_field)
	check_equal(scene.get_state().get_node_count(), 1, "saved nodes")
	var copy: PlantField3D = _field.duplicate()
	copy.skeleton_distance = 0.0
	stage.add_child(copy)
	await frames(2)
	check_equal(copy.get_child_count(true), 0, "children of a copy")
	check_equal(_field.get_child_count(), 0, "children that others see")
	copy.free()


func _check_same(before: Image, during: Image) -> void:
	var drawn := count_different(before, empty_picture())
	check(drawn > 20 * MIN_PLANT, "plants are drawn")
	var different := count_different(before, during)
	check(
		different <= MAX_DIFFERENT_SHARE * drawn,
		"%d of %d pixels differ with skeletons" % [different, drawn]
	)


func _report_shown(skeleton: Skeleton3D) -> void:
	_reported.append("shown %d" % _field.get_skeleton_plant(skeleton))
	var lamp := BoneAttachment3D.new()
	lamp.name = "Lamp"
	lamp.bone_name = "tip"
	skeleton.add_child(lamp)
	var light := Node3D.new()
	var height := _field.get_plant_height(_field.get_skeleton_plant(skeleton))
	light.position.y = height / skeleton.global_basis.y.length()
	lamp.add_child(light)
