extends Node3D
## What the air carries round the camera: pollen always, seeds in a gust, both with the wind.

const REST := Vector3(0.0, -0.12, 0.0)  # m/s², of what floats in calm air.
const CALM := 0.08  # Share of the seeds that fly without a gust.
const PUSH := 0.16  # m/s² for each newton of the wind.

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
	var force := wind.sample(wind.get_time())
	for floating: GPUParticles3D in [pollen, seeds]:
		(floating.process_material as ParticleProcessMaterial).gravity = REST + force * PUSH
	var gust := clampf(force.length() / maxf(2.5 * wind.strength, 0.1), 0.0, 1.0)
	seeds.amount_ratio = lerpf(CALM, 1.0, gust)
