extends Node3D
## Lets drops and flakes fall as much as a wind has rain and snow, and as its air drives them.

const HEAVY := 20.0  # mm/h, of all drops.
const DROP_SPEED := 7.0  # m/s.
const FLAKE_SPEED := 1.2  # m/s.
const AIR_AT_DROPS := 0.6  # Of the wind's speed at 10 m.

## The wind whose rain and snow fall.
@export var wind: PlantWind

@onready var _drops: GPUParticles3D = $Drops
@onready var _flakes: GPUParticles3D = $Flakes


func _ready() -> void:
	wind.changed.connect(_follow)
	_follow()


func _follow() -> void:
	var along := Vector3(sin(wind.direction), 0.0, cos(wind.direction))
	var air := AIR_AT_DROPS * (wind.speed if wind.kind == PlantWind.KIND_AIR else 0.0) * along
	_let_fall(_drops, wind.rain / HEAVY, air + DROP_SPEED * Vector3.DOWN)
	_let_fall(_flakes, wind.snow, air + FLAKE_SPEED * Vector3.DOWN)


func _let_fall(particles: GPUParticles3D, share: float, velocity: Vector3) -> void:
	particles.emitting = share > 0.0
	particles.amount_ratio = clampf(share, 0.05, 1.0)
	var process := particles.process_material as ParticleProcessMaterial
	process.direction = velocity.normalized()
	process.initial_velocity_min = velocity.length()
	process.initial_velocity_max = 1.15 * velocity.length()
	# The box is as far upwind as its particles drift.
	particles.lifetime = particles.position.y / -velocity.y
	particles.position.x = -0.5 * velocity.x * particles.lifetime
	particles.position.z = -0.5 * velocity.z * particles.lifetime
