## Flutter of leaves in the air around a plant.
extends "res://tests/engine/harness.gd"

const POPPY := "res://addons/undergrowth/species/poppy.tres"
## Degrees.
const VISIBLE := 0.5
const STILL := 0.1

var _wind: PlantWind
var _plant: Plant3D


func before_each() -> void:
	_wind = PlantWind.new()
	_wind.kind = PlantWind.KIND_AIR
	_wind.turbulence = 0.0
	_plant = Plant3D.new()
	_plant.species = load(POPPY)
	_plant.wind = _wind
	root.add_child(_plant)


func after_each() -> void:
	_plant.free()
	_wind = null


func test_leaves_of_a_stiff_stem_flutter_in_a_light_wind() -> void:
	_wind.speed = 3.0
	check(await _flutter_after(300) > VISIBLE, "leaves flutter")


func test_leaves_come_to_rest_after_a_wind() -> void:
	_wind.speed = 9.0
	var blown := await _flutter_after(300)
	_wind.speed = 0.0
	var calm := await _flutter_after(720)
	check(blown > VISIBLE, "in wind by %.2f°" % blown)
	check(calm < STILL, "after it by %.3f°" % calm)


func test_leaves_of_a_plant_that_a_body_holds_in_calm_air_are_still() -> void:
	_wind.speed = 0.0
	var body := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	shape.shape.radius = 0.25
	body.add_child(shape)
	body.add_to_group("pushes")
	_plant.bodies_group = "pushes"
	root.add_child(body)
	body.position = Vector3(-0.1, 0.5 * _plant.get_plant_height(), 0)
	var flutter := await _flutter_after(600)
	var state := _plant.get_motion_state()
	var lean := rad_to_deg(Vector3.UP.angle_to(Vector3(state[0], state[1], state[2])))
	check(lean > 10.0, "the body bends it by %.1f°" % lean)
	check(flutter < STILL, "its leaves move by %.3f°" % flutter)
	body.free()


## Returns the root mean square of the turns of a leaf (degrees), from that frame on.
func _flutter_after(count: int) -> float:
	await frames(count)
	var skeleton := _plant.get_skeleton()
	var leaf := -1
	for bone in skeleton.get_bone_count():
		if leaf < 0 and skeleton.get_bone_name(bone).begins_with("lea"):
			leaf = bone
	check(leaf >= 0, "the plant has a bone for a leaf")
	var turns: Array[Quaternion] = []
	for i in 120:
		await process_frame
		turns.append(skeleton.get_bone_pose_rotation(leaf))
	var mean := turns[0]
	for i in range(1, turns.size()):
		mean = mean.slerp(turns[i], 1.0 / (i + 1))
	var sum := 0.0
	for turn in turns:
		sum += mean.angle_to(turn) ** 2
	return rad_to_deg(sqrt(sum / turns.size()))
