extends Node3D
## What the air carries round the camera: pollen always, seeds in a gust, both with the wind.

const CALM := 0.08  # Share of the seeds that fly without a gust.
const SPEED_OF_NEWTONS := 0.6  # m/s for each newton of a wind that is a force.
const STRONG := 0.8  # Of the wind's speed at 10 m: a gust, so low above the ground.

## The wind that carries them.
@export var wind: PlantWind
@export var pollen: GPUParticles3D
@export var seeds: GPUParticles3D
## What lies under them: a node with a `height_at(x, z)` method.
@export var ground: Node3D


func _process(_delta: float) -> void:
	var camera := get_viewport().get_camera_3d()
	if camera == null or wind == null:
		return
	var ahead := -camera.global_basis.z * Vector3(1.0, 0.0, 1.0)
	global_position = camera.global_position + ahead.normalized() * 6.0
	var low := float(ground.call(&"height_at", global_position.x, global_position.z))
	for floating: GPUParticles3D in [pollen, seeds]:
		_carry(floating.process_material as ShaderMaterial, low)
	seeds.amount_ratio = lerpf(CALM, 1.0, clampf(_gust(low), 0.0, 1.0))


# Sends the air to the particles' shader, which uses the same air as the plants.
func _carry(motion: ShaderMaterial, low: float) -> void:
	var is_air := wind.kind == PlantWind.KIND_AIR
	var even := Vector3.ZERO if is_air else wind.sample(wind.get_time()) * SPEED_OF_NEWTONS
	motion.set_shader_parameter(&"even_wind", even)
	motion.set_shader_parameter(&"ground", low)
	if is_air:
		wind.apply_to_material(motion)
	else:
		motion.set_shader_parameter(&"undergrowth_wind_air", Vector4.ZERO)


# 1 in a strong gust of this wind, 0 in a lull.
func _gust(low: float) -> float:
	if wind.kind != PlantWind.KIND_AIR:
		return wind.sample(wind.get_time()).length() / maxf(2.5 * wind.strength, 0.1)
	var place := global_position - Vector3(0.0, low, 0.0)
	var share := wind.sample_velocity(wind.get_time(), place).length() / maxf(wind.speed, 1.0)
	return inverse_lerp(0.5 * STRONG, STRONG, share)
