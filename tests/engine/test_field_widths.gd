## How wide plants of a field are drawn where levels of detail change and where plants are left
## away, in pictures.
extends "res://tests/engine/picture_harness.gd"

const MEADOW_GRASS := "res://addons/undergrowth/species/meadow_grass.tres"
const MARGIN := 1.0

var _field: PlantField3D


func before_each() -> void:
	make_stage()
	_field = PlantField3D.new()
	_field.density = 0.0  # Only what is added.
	_field.simulation_enabled = false
	_field.fade_margin = MARGIN
	stage.add_child(_field)


func after_each() -> void:
	stage.free()


func test_a_lathe_covers_as_much_while_its_level_changes() -> void:
	_field.add_plants([Transform3D.IDENTITY], TulipFunction.new())
	await _check_transition(0.03, 0.002)


func test_a_plant_of_parts_covers_as_much_while_its_level_changes() -> void:
	var scaled := Basis.from_scale(Vector3.ONE * 4.0)
	_field.add_plants([Transform3D(scaled)], load(MEADOW_GRASS))
	await _check_transition(0.15, 0.06)


## Goes through the band between two levels. What is covered stays between what either level covers,
## but for [param tolerance] of it; and no more than [param dots] of it are dots.
func _check_transition(tolerance: float, dots: float) -> void:
	var away := stage.get_camera_3d().position.length()
	var covered: Array[int] = []
	for step in 9:
		var way := (step - 1) / 7.0 * 1.2 - 0.1
		_field.levels = [PlantFieldLevel.of(6, away + MARGIN * (1.0 - way)), PlantFieldLevel.of(3)]
		await frames(2)
		var image := await picture()
		covered.append(_count_covered(image))
		var found := _count_dots(image)
		print(way, " ", covered.back(), " dots ", found)
		check(found <= dots * covered.back(), "%d dots of %d pixels" % [found, covered.back()])
	var least := mini(covered[0], covered[-1]) * (1.0 - tolerance)
	var most := maxi(covered[0], covered[-1]) * (1.0 + tolerance)
	check(least > LEAST_PLANT, "a plant is drawn")
	for count in covered:
		check(count >= least and count <= most, "%s pixels" % [covered])


func _count_covered(image: Image) -> int:
	return count_different(image, empty_picture())


## Pixels that are covered among eight that are not, or the other way round.
func _count_dots(image: Image) -> int:
	var count := 0
	for y in range(1, PICTURE_SIZE.y - 1):
		for x in range(1, PICTURE_SIZE.x - 1):
			var here := _is_covered(image, x, y)
			var same := 0
			for i in 9:
				same += 1 if _is_covered(image, x - 1 + i % 3, y - 1 + i / 3) == here else 0
			count += 1 if same == 1 else 0
	return count


func _is_covered(image: Image, x: int, y: int) -> bool:
	var color := image.get_pixel(x, y)
	return maxf(color.r, maxf(color.g, color.b)) > TOLERANCE
