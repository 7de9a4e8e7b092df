extends "sheet.gd"
## Where species grow by habitats: wet valleys, sunny slopes, banks of a brook.

const FROM := Vector3(0.0, 7.5, 11.0)
const GROUND := preload("res://addons/undergrowth/grounds/meadow.tres")
const SIDE := 24.0
## The hills go on beyond the field.
const HILLS_SIDE := 64.0
## Degrees: from the south, as the light of habitats.
const SUN := Vector3(-48.0, -35.0, 0.0)
const WATER := Color(0.16, 0.27, 0.33)
const BROOK_WIDTH := 1.6
## Metres between the points of the hills.
const STEP := 0.5


func _fill(row: HBoxContainer) -> void:
	_fill_moisture(_add_world(row, "moisture"))
	_fill_light(_add_world(row, "light and slope"))
	_fill_distance(_add_world(row, "distance and competition"))


func _add_world(row: HBoxContainer, title: String) -> Node3D:
	var world := add_cell(row, title, FROM, Vector3(0.0, -0.6, -1.0), 44.0)
	(world.get_node("Sun") as Node3D).rotation_degrees = SUN
	return world


func _fill_moisture(world: Node3D) -> void:
	var files: Dictionary[String, float] = {"meadow_grass": 1.0, "cattail": 1.2, "oxeye_daisy": 0.6}
	var field := _make_field_on_hills(world, files, _valley)
	field.species[0].habitat = PlantHabitat.new()
	field.species[0].habitat.moisture_curve = PlantHabitat.make_curve(
		[Vector2(0.0, 1.0), Vector2(0.5, 1.0), Vector2(0.65, 0.2)]
	)
	field.species[1].habitat = PlantHabitat.new()
	field.species[1].habitat.moisture_curve = PlantHabitat.make_curve(
		[Vector2(0.55, 0.0), Vector2(0.65, 1.0)]
	)
	field.species[2].habitat = PlantHabitat.new()
	field.species[2].habitat.moisture_curve = PlantHabitat.make_curve(
		[Vector2(0.3, 1.0), Vector2(0.42, 0.0)]
	)


func _fill_light(world: Node3D) -> void:
	var files: Dictionary[String, float] = {"meadow_grass": 1.0, "poppy": 0.7, "male_fern": 0.12}
	var field := _make_field_on_hills(world, files, _ridge)
	field.species[0].habitat = PlantHabitat.new()
	field.species[0].habitat.slope_curve = PlantHabitat.make_curve(
		[Vector2(22.0, 1.0), Vector2(34.0, 0.15)]
	)
	field.species[1].habitat = PlantHabitat.new()
	field.species[1].habitat.light_curve = PlantHabitat.make_curve(
		[Vector2(0.52, 0.0), Vector2(0.58, 1.0)]
	)
	field.species[2].habitat = PlantHabitat.new()
	field.species[2].habitat.light_curve = PlantHabitat.make_curve(
		[Vector2(0.4, 1.0), Vector2(0.47, 0.0)]
	)


func _fill_distance(world: Node3D) -> void:
	var brook := Path3D.new()
	brook.curve = Curve3D.new()
	for i in 9:
		brook.curve.add_point(Vector3(3.0 * i - 12.0, 0.0, 1.6 * sin(0.9 * i)))
	brook.add_to_group(&"water")
	world.add_child(brook)
	world.add_child(_make_water(brook.curve))
	var files: Dictionary[String, float] = {
		"meadow_grass": 1.0, "common_reed": 1.0, "field_horsetail": 0.6
	}
	var field := _make_field_on_hills(world, files, func(_x: float, _z: float) -> float: return 0.0)
	field.exclusions = [NodePath("../" + brook.name)] as Array[NodePath]
	field.exclusion_widths = [BROOK_WIDTH]
	field.competition = 1.0
	field.species[1].vigor = 4.0
	field.species[1].shade_radius = 0.5
	field.species[1].shade_tolerance = 1.0
	for i: int in [1, 2]:
		var habitat := PlantHabitat.new()
		habitat.distance_group = &"water"
		var width := 0.8 + 1.2 * i
		habitat.distance_curve = PlantHabitat.make_curve(
			[Vector2(0.6 * width, 1.0), Vector2(width, 0.0)]
		)
		field.species[i].habitat = habitat


# A band along the curve, a centimetre above the ground.
func _make_water(curve: Curve3D) -> MeshInstance3D:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLE_STRIP)
	tool.set_normal(Vector3.UP)
	for i in curve.point_count:
		var ahead := curve.get_point_position(mini(i + 1, curve.point_count - 1))
		var behind := curve.get_point_position(maxi(i - 1, 0))
		var across := (ahead - behind).cross(Vector3.UP).normalized() * 0.5 * BROOK_WIDTH
		for side: float in [1.0, -1.0]:
			tool.add_vertex(curve.get_point_position(i) + side * across + Vector3.UP * 0.01)
	var water := MeshInstance3D.new()
	water.mesh = tool.commit()
	var material := StandardMaterial3D.new()
	material.albedo_color = WATER
	material.roughness = 0.1
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	water.material_override = material
	return water


func _make_field_on_hills(
	world: Node3D, files: Dictionary[String, float], height: Callable
) -> PlantField3D:
	var hills := MeshInstance3D.new()
	hills.name = "Hills"
	hills.mesh = _make_hills(height)
	hills.material_override = GROUND
	(world.get_node("Ground") as MeshInstance3D).hide()
	world.add_child(hills)
	var field := make_field(files, 32.0, Vector2.ONE * SIDE)
	field.ground_mode = PlantField3D.GROUND_MESH
	field.ground_mesh = ^"../Hills"
	field.edge_falloff = 0.5
	world.add_child(field)
	return field


func _make_hills(height: Callable) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	var count := int(HILLS_SIDE / STEP)
	for row in count:
		for column in count:
			for corner: Vector2 in [
				Vector2(0, 0),
				Vector2(1, 0),
				Vector2(0, 1),
				Vector2(1, 0),
				Vector2(1, 1),
				Vector2(0, 1)
			]:
				var x := (column + corner.x) * STEP - 0.5 * HILLS_SIDE
				var z := (row + corner.y) * STEP - 0.5 * HILLS_SIDE
				tool.add_vertex(Vector3(x, height.call(x, z), z))
	tool.generate_normals()
	return tool.commit()


# A valley that winds towards the camera.
func _valley(x: float, z: float) -> float:
	var side := x - 1.5 * sin(0.4 * z)
	return 2.6 * (1.0 - exp(-0.06 * side * side)) - 0.03 * z


# A ridge across the view, with the sun before it.
func _ridge(x: float, z: float) -> float:
	var side := z - 0.4 * x + 1.0
	return 2.6 * exp(-0.06 * side * side)
