extends Node3D
## A bed of plants, sown around its own place, in clumps, on the ground.
##
## The same seed sows the same bed.

const TRIES_PER_PLANT := 60

## What grows here: each plant takes one of these at random.
@export var species: Array[PlantFunction] = []
## The wind that moves the bed.
@export var wind: PlantWind
## How many plants grow here.
@export_range(0, 5000) var count := 100
## Segments of each plant along its height.
@export_range(1, 64) var segments := 8
## Plants are sown with a normal distribution of this width around the bed.
@export var spread := Vector2(3.0, 3.0)
## Least and largest scale of a plant.
@export var sizes := Vector2(0.85, 1.15)
## Least distance between two plants of the bed.
@export_range(0.0, 1.0, 0.01, "suffix:m") var spacing := 0.05
## 0 sows evenly, 1 leaves bare ground between clumps.
@export_range(0.0, 1.0, 0.01) var clumping := 0.5
## Across one clump and the gap to the next.
@export_range(0.2, 10.0, 0.1, "suffix:m") var clump_size := 1.5
## Lowest and highest ground above the water level where plants of this bed grow.
@export var above_water := Vector2(0.06, 3.0)
## Another seed sows another bed.
@export var bed_seed := 1
## The ground: a node with a `height_at(x, z)` method.
@export var ground: Node3D

var _rng := RandomNumberGenerator.new()
var _clumps := FastNoiseLite.new()
var _taken: Dictionary[Vector2i, Array] = {}


func _ready() -> void:
	_rng.seed = bed_seed
	_clumps.seed = bed_seed
	_clumps.frequency = 1.0 / clump_size
	for _index in count:
		_sow()


func _sow() -> void:
	for _try in TRIES_PER_PLANT:
		var place := Vector2(
			global_position.x + _rng.randfn() * spread.x,
			global_position.z + _rng.randfn() * spread.y
		)
		if _is_good(place):
			_plant(place)
			return


func _is_good(place: Vector2) -> bool:
	var height := _height_at(place)
	if height < above_water.x or height > above_water.y:
		return false
	var density := clampf(0.5 + 1.6 * _clumps.get_noise_2dv(place), 0.0, 1.0)
	return _rng.randf() < lerpf(1.0, density * density, clumping) and _has_room(place)


func _has_room(place: Vector2) -> bool:
	if spacing <= 0.0:
		return true
	var cell := Vector2i((place / spacing).floor())
	for x in range(-1, 2):
		for y in range(-1, 2):
			for other: Vector2 in _taken.get(cell + Vector2i(x, y), []):
				if other.distance_squared_to(place) < spacing * spacing:
					return false
	_taken.get_or_add(cell, []).append(place)
	return true


func _plant(place: Vector2) -> void:
	var plant := Plant3D.new()
	plant.species = species[_rng.randi_range(0, species.size() - 1)]
	plant.wind = wind
	plant.segments = segments
	plant.seed = _rng.randi()
	var turn := Basis(Vector3.UP, _rng.randf() * TAU)
	var size := _rng.randf_range(sizes.x, sizes.y)
	add_child(plant)
	plant.global_transform = Transform3D(
		turn.scaled(Vector3.ONE * size), Vector3(place.x, _height_at(place) - 0.01, place.y)
	)


func _height_at(place: Vector2) -> float:
	return float(ground.call(&"height_at", place.x, place.y)) if ground else 0.0
