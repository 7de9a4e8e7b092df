extends Node3D
## What the air carries round the camera: pollen always, seeds in a gust, both with the wind.

const REST := Vector3(0.0, -0.12, 0.0)  # m/s², of what floats in calm air.
const CALM := 0.08  # Share of the seeds that fly without a gust.
const PUSH := 0.16  # m/s² for each newton of the wind.
const AIR_PUSH := 0.3  # m/s² for each metre per second of air.
const HEIGHT := 1.5  # m above the ground, where they float.

## The wind that carries them.
@export var wind: PlantWind
@export var pollen: GPUParticles3D
@export var seeds: GPUParticles3D


func _process(_delta: float) -> void:
	var camera := get_viewport().get_camera_3d()
	if camera == null or wind == null:
		return
	var ahead := -camera.global_basis.z * Vector3(1.0, 0.0, 1.0)
	global_position = camera.global_position + ahead.normalized() * 6.0
	var push := _push()
	for floating: GPUParticles3D in [pollen, seeds]:
		(floating.process_material as ParticleProcessMaterial).gravity = REST + push
	seeds.amount_ratio = lerpf(CALM, 1.0, clampf(push.length() / _strong_push(), 0.0, 1.0))


# What the wind does to what floats near the camera (m/s²).
func _push() -> Vector3:
	if wind.kind != PlantWind.KIND_AIR:
		return wind.sample(wind.get_time()) * PUSH
	var place := Vector3(global_position.x, HEIGHT, global_position.z)
	return wind.sample_velocity(wind.get_time(), place) * AIR_PUSH


# What a strong gust of it does.
func _strong_push() -> float:
	if wind.kind != PlantWind.KIND_AIR:
		return maxf(2.5 * wind.strength, 0.1) * PUSH
	return maxf(wind.speed, 0.1) * AIR_PUSH
