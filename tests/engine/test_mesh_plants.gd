## MeshPlantFunction: plants of the user's meshes.
extends "res://tests/engine/plant_harness.gd"

const Maker := preload("res://tests/engine/model_maker.gd")
const Files := preload("res://tests/engine/model_files.gd")

const STEP := 1.0 / 60.0
const MIN_FILES := 20
const SAMPLES := 3000
## Linear blend skinning shortens blades. Plants of fields keep their length within 1 %, as tests of
## the core show.
const SKINNING_ERROR := 0.05


func test_all_files_of_other_tools_become_plants_without_a_setting() -> void:
	var files := Files.all()
	check(files.size() >= MIN_FILES, "%d files" % files.size())
	for name: String in files:
		var species := MeshPlantFunction.of(files[name])
		check_equal(species.find_problem(0.0, 12), "", name)
		var found := species.find_model(0)
		check(found.height > 0.2 and found.height < 3.0, "%s is %.2f m high" % [name, found.height])
		check(found.roots > 0, "%s meets the ground" % name)


func test_all_files_sway_with_a_still_base() -> void:
	var files := Files.all()
	for name: String in files:
		var plant := _plant_in_wind(MeshPlantFunction.of(files[name]))
		var before := _posed(plant)
		var farthest := 0.0
		for i in 120:
			plant.advance(STEP)
			farthest = maxf(
				farthest, plant.get_tip_position().distance_to(Vector3(0, _height(plant), 0))
			)
		var after := _posed(plant)
		check(farthest > 0.02 * _height(plant), "%s sways by %.4f m" % [name, farthest])
		check(
			_base_moved(before, after) < 1e-3,
			"%s: the base moves %.5f m" % [name, _base_moved(before, after)]
		)
		var kept := _length(after) / _length(before)
		check_near(kept, 1.0, SKINNING_ERROR, "%s: share of its length" % name)
		plant.free()


func test_leaves_of_all_files_that_have_loose_parts_lag_and_come_to_rest() -> void:
	var files := Files.all()
	var with_leaves := 0
	for name: String in files:
		var species := MeshPlantFunction.of(files[name])
		var found := species.find_model(0)
		if found.leaves + found.heads == 0:
			continue
		with_leaves += 1
		var plant := _plant_in_wind(species)
		var skeleton := plant.get_skeleton()
		var most := 0.0
		for i in 30:
			plant.advance(STEP)
			most = maxf(most, _part_turn(skeleton))
		check(most > 0.02, "%s: its parts turn by %.4f rad" % [name, most])
		plant.wind = null
		for i in 900:
			plant.advance(STEP)
		check(_part_turn(skeleton) < 0.01, "%s: parts rest" % name)
		plant.free()
	check(with_leaves >= 15, "%d files have loose parts" % with_leaves)


func test_the_frame_of_a_file_is_found() -> void:
	var files := Files.all()
	check_equal(_found(files.blender_z_up).up_axis, MeshPlantFunction.AXIS_PLUS_Z)
	check_equal(_found(files.blender_z_up_off_origin).up_axis, MeshPlantFunction.AXIS_PLUS_Z)
	check_near(_found(files.blender_z_up_off_origin).root, Vector3(4, 1, 3), 0.02)
	check_near(_found(files.quixel_centimetres).scale, 0.01, 1e-6)
	check_near(_found(files.millimetres).scale, 0.001, 1e-6)
	check_near(_found(files.origin_in_the_middle).root, Vector3(0, -1, 0), 0.02)
	check_near(_found(files.buried).root, Vector3.ZERO, 1e-6)


func test_parts_are_found() -> void:
	var files := Files.all()
	var flower := _found(files.blender_flower)
	check_equal(
		[flower.roots, flower.leaves, flower.heads], [1, 5, 1], "stem, leaves and head of a flower"
	)
	check_equal(_found(files.speedtree_two_materials).leaves, 80)
	check_equal(_found(files.speedtree_twigs).twigs, 8)
	check_equal(_found(files.kenney_several_nodes).leaves, 3)


func test_levels_are_those_of_the_file_or_of_the_import() -> void:
	var files := Files.all()
	check_equal(_found(files.quixel_lod_nodes).triangles, PackedInt32Array([72, 2]))
	var sphere: PackedInt32Array = _found(SphereMesh.new()).triangles
	check(sphere.size() == 5 and sphere[-1] < sphere[0] / 16, "levels %s" % sphere)
	var cards: PackedInt32Array = _found(files.speedtree_3000_cards).triangles
	check(cards.size() == 5 and cards[-1] < cards[0] / 8, "levels of leaf cards %s" % cards)
	var tuft: PackedInt32Array = _found(files.triangles_100k).triangles
	check(tuft.size() == 5 and tuft[-1] < tuft[0] / 8, "levels of blades %s" % tuft)


func test_levels_of_a_mesh_are_those_of_its_surfaces() -> void:
	for side: int in [20, 260]:  # The renderer has indices of 16 bits, then of 32.
		var plane := PlaneMesh.new()
		plane.subdivide_width = side
		plane.subdivide_depth = side
		var arrays := plane.get_mesh_arrays()
		var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
		var last := indices.slice(indices.size() - 30)
		var mesh := ArrayMesh.new()
		mesh.add_surface_from_arrays(
			Mesh.PRIMITIVE_TRIANGLES, arrays, [], {0.01: indices.slice(0, 120), 0.5: last}
		)
		var triangles: PackedInt32Array = _found(mesh).triangles
		check_equal(triangles, PackedInt32Array([indices.size() / 3, 40, 10]))
		var baked := MeshPlantFunction.of(mesh).generate_mesh(0.0, 1)
		check_equal(baked.get_aabb().size.x > 0.0, true, "the last level has its vertices")


func test_coarse_levels_have_no_vertices_that_are_not_drawn() -> void:
	var species := MeshPlantFunction.of(Files.tree(200).mesh())
	var fine := species.generate_mesh(0.0, 12)
	var coarse := species.generate_mesh(0.0, 3)
	for mesh: ArrayMesh in [fine, coarse]:
		for surface in mesh.get_surface_count():
			var arrays := mesh.surface_get_arrays(surface)
			var used := {}
			for index: int in arrays[Mesh.ARRAY_INDEX]:
				used[index] = true
			check_equal(used.size(), mesh.surface_get_array_len(surface), "vertices in use")
	check(
		coarse.surface_get_array_len(1) < fine.surface_get_array_len(1) / 5,
		"coarse leaves are fewer"
	)
	check_near(coarse.get_aabb().end.y, fine.get_aabb().end.y, 0.15, "height")


func test_a_mirrored_node_keeps_its_outsides_outside() -> void:
	var mirrored := MeshPlantFunction.of(Files.all().mirrored_node).generate_mesh(0.0, 12)
	var own := Files.tree(30).mesh()
	check(
		_outward(own) > 0.0 and _outward(mirrored) > 0.0,
		"normals are on the side of the front faces"
	)


func test_coarse_levels_of_a_mirrored_node_have_their_outsides_outside() -> void:
	var place := Transform3D(Basis.from_scale(Vector3(-1, 1, 1)))
	var species := MeshPlantFunction.of(Maker.scene_of(SphereMesh.new(), place))
	check(species.find_model(0).triangles.size() > 1, "it has levels")
	for segments: int in [12, 8, 3]:
		check(_outward(species.generate_mesh(0.0, segments)) > 0.0, "%d segments" % segments)


func test_normals_follow_a_node_with_an_uneven_scale() -> void:
	var place := Transform3D(Basis.from_scale(Vector3(1, 3, 1)))
	var species := MeshPlantFunction.of(Maker.scene_of(SphereMesh.new(), place))
	var arrays := species.generate_mesh(0.0, 12).surface_get_arrays(0)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
	var middle := 0.5 * species.find_model(0).height as float
	for i in vertices.size():
		var way := vertices[i] - Vector3(0, middle, 0)
		var expected := Vector3(way.x, way.y / 9.0, way.z).normalized()
		check(normals[i].dot(expected) > 0.99, "normal %s at %s" % [normals[i], way])


func test_leaves_that_stand_for_others_widen_about_their_midrib() -> void:
	var species := MeshPlantFunction.of(Files.tree(200).mesh())
	var fine := _midribs(species.generate_mesh(0.0, 12))
	var coarse := _midribs(species.generate_mesh(0.0, 8))
	check(coarse.size() < fine.size(), "%d of %d places" % [coarse.size(), fine.size()])
	for place: Vector3 in coarse:
		check(fine.has(place), "a leaf at %s" % place)


func test_a_material_override_of_a_node_is_that_of_its_plants() -> void:
	var red := Maker.plain(Color.RED)
	var node := MeshInstance3D.new()
	node.mesh = Files.flower(null).mesh()
	node.material_override = red
	var scene := PackedScene.new()
	scene.pack(node)
	node.free()
	var mesh := MeshPlantFunction.of(scene).generate_mesh(0.0, 12)
	check_equal(mesh.surface_get_material(0), red, "material")


func test_leaves_of_a_stretched_plant_swing_about_their_stretched_base() -> void:
	var species := MeshPlantFunction.of(Files.tree(30).mesh())
	var height: float = species.find_model(0).height
	var own := species.generate_mesh(height, 12).surface_get_arrays(1)
	var tall := species.generate_mesh(2.0 * height, 12).surface_get_arrays(1)
	var pivots: PackedFloat32Array = own[Mesh.ARRAY_CUSTOM1]
	var stretched: PackedFloat32Array = tall[Mesh.ARRAY_CUSTOM1]
	check(pivots[1] > 0.0, "a leaf above the ground")
	for i in range(0, pivots.size(), 4):
		check_near(stretched[i], pivots[i], 1e-6, "x of the pivot")
		check_near(stretched[i + 1], 2.0 * pivots[i + 1], 1e-5, "height of the pivot")


func test_the_height_and_the_axis_can_be_set() -> void:
	var species := MeshPlantFunction.of(Files.flower(null).mesh())
	species.height = 1.5
	check_near(species.find_model(0).height, 1.5, 1e-5)
	check_near(species.generate_mesh(0.0, 12).get_aabb().end.y, 1.5, 1e-3)
	species.up_axis = MeshPlantFunction.AXIS_MINUS_Y
	check_equal(species.find_model(0).up_axis, MeshPlantFunction.AXIS_MINUS_Y)


func test_the_root_and_the_leaves_can_be_set() -> void:
	var species := MeshPlantFunction.of(Files.flower(null).mesh())
	species.has_own_root = true
	species.root = Vector3(0.1, 0.2, 0)
	check_near(species.find_model(0).height, 0.4, 0.03)
	check_near(species.generate_mesh(0.0, 12).get_aabb().position.y, -0.2, 1e-3)
	var bark := Maker.new()
	bark.surface(Maker.plain(Color.BROWN))
	bark.stem(1.0, 0.02)
	bark.surface(Maker.plain(Color.GREEN))
	bark.stem(0.5, 0.15, Vector3(0.0, 0.03, 0.0))
	species = MeshPlantFunction.of(bark.mesh())
	check_equal(species.find_model(0).roots, 2, "roots of two plain materials")
	species.leaf_surfaces = PackedInt32Array([1])
	check_equal(species.find_model(0).roots, 1, "roots beside foliage")


func test_vertex_colours_can_stiffen_a_plant() -> void:
	var maker := Maker.new()
	maker.surface(Maker.plain(Color.GREEN))
	maker.paint(Color(0.0, 1.0, 0.0))
	maker.stem(0.8, 0.02)
	var species := MeshPlantFunction.of(maker.mesh())
	check(_greatest_offset(species) > 0.99, "it bends to its tip")
	species.vertex_colors = MeshPlantFunction.VERTEX_COLORS_BEND_FLUTTER_PHASE
	check_near(_greatest_offset(species), 0.0, 1e-6, "stiff by red")
	species.vertex_colors = MeshPlantFunction.VERTEX_COLORS_ALPHA_BEND
	check(_greatest_offset(species) > 0.99, "alpha is 1")


func test_weights_select_among_models() -> void:
	var species := MeshPlantFunction.of([Files.flower(null).mesh(), Files.tree(30).mesh()])
	var tall := 0
	for seed in 100:
		tall += 1 if species.generate_mesh(0.0, 12, seed).get_aabb().end.y > 1.0 else 0
	check(tall > 25 and tall < 75, "%d of 100 are trees" % tall)
	species.weights = PackedFloat32Array([1.0, 0.0])
	for seed in 20:
		check(species.generate_mesh(0.0, 12, seed).get_aabb().end.y < 1.0, "no tree has a weight")


func test_files_that_cannot_work_say_why() -> void:
	var species := MeshPlantFunction.new()
	check(species.find_problem(0.0, 12).contains("no model"), species.find_problem(0.0, 12))
	species.models = [null]
	check(species.find_problem(0.0, 12).contains("models[0] is empty"), "an empty entry")
	species.models = [Maker.scene_of_nodes({})]
	check(species.find_problem(0.0, 12).contains("contains no mesh"), "a scene without a mesh")
	species.models = [ArrayMesh.new()]
	check(species.find_problem(0.0, 12).contains("contains no mesh"), "an empty mesh")
	species.models = [_broken_mesh()]
	check(species.find_problem(0.0, 12).contains("not finite"), species.find_problem(0.0, 12))
	species.models = [Files.flower(null).mesh()]
	species.weights = PackedFloat32Array([0.0])
	check(species.find_problem(0.0, 12).contains("weights"), "no model has a weight")


func test_wrong_values_are_refused() -> void:
	var species := MeshPlantFunction.of(Files.flower(null).mesh())
	species.models = [Gradient.new()]
	check_error("is no model")
	species.weights = PackedFloat32Array([-1.0])
	check_error("weights[0]")
	species.height = NAN
	check_error("height")
	check_equal(species.models.size(), 1)
	check_equal(species.find_problem(0.0, 12), "")


func test_a_plant_shows_the_materials_of_its_file_or_its_own() -> void:
	var species := MeshPlantFunction.of(Files.tree(30).mesh())
	var mesh := species.generate_mesh(0.0, 12)
	check_equal(mesh.get_surface_count(), 2)
	var leaves: StandardMaterial3D = mesh.surface_get_material(1)
	check_equal(leaves.transparency, BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR)
	species.material = Maker.plain(Color.RED)
	mesh = species.generate_mesh(0.0, 12)
	check_equal(mesh.surface_get_material(0), species.material)
	check_equal(mesh.surface_get_material(1), species.material)


func test_a_change_of_a_mesh_is_a_change_of_the_species() -> void:
	var mesh := CylinderMesh.new()
	var species := MeshPlantFunction.of(mesh)
	check_near(species.find_model(0).height, 2.0, 1e-5)
	mesh.height = 1.0
	check_near(species.find_model(0).height, 1.0, 1e-5)


func _found(file: Resource) -> Dictionary:
	return MeshPlantFunction.of(file).find_model(0)


func _plant_in_wind(species: PlantFunction) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = species
	plant.simulation_enabled = false
	plant.wind = PlantWind.new()
	plant.wind.kind = PlantWind.KIND_AIR
	plant.wind.speed = 9.0
	root.add_child(plant)
	plant.get_mesh()
	return plant


func _height(plant: Plant3D) -> float:
	return plant.get_plant_height()


# Returns rest (even) and posed (odd) places of some vertices of all surfaces, in whole triangles.
func _posed(plant: Plant3D) -> PackedVector3Array:
	var skeleton := plant.get_skeleton()
	var poses: Array[Transform3D] = []
	for bone in skeleton.get_bone_count():
		var rest := skeleton.get_bone_global_rest(bone)
		poses.append(skeleton.get_bone_global_pose(bone) * rest.affine_inverse())
	var places: PackedVector3Array = []
	var mesh := plant.get_mesh()
	for surface in mesh.get_surface_count():
		var arrays := mesh.surface_get_arrays(surface)
		var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
		var weights: PackedFloat32Array = arrays[Mesh.ARRAY_WEIGHTS]
		var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
		var stride := maxi(indices.size() / 3 / SAMPLES, 1)
		for triangle in range(0, indices.size() / 3, stride):
			for corner in 3:
				var vertex := indices[3 * triangle + corner]
				var place := Vector3.ZERO
				for k in 4:
					var weight := weights[4 * vertex + k]
					if weight > 0.0:
						place += weight * (poses[bones[4 * vertex + k]] * vertices[vertex])
				places.append(vertices[vertex])
				places.append(place)
	return places


func _base_moved(before: PackedVector3Array, after: PackedVector3Array) -> float:
	var most := 0.0
	for i in range(0, before.size(), 2):
		if before[i].y <= 1e-4:
			most = maxf(most, after[i + 1].distance_to(before[i + 1]))
	return most


# The sum of all edges: a bend makes those on one side longer and those on the other side shorter.
func _length(places: PackedVector3Array) -> float:
	var sum := 0.0
	for i in range(0, places.size(), 6):
		sum += places[i + 1].distance_to(places[i + 3]) + places[i + 3].distance_to(places[i + 5])
		sum += places[i + 5].distance_to(places[i + 1])
	return sum


# The largest turn of a part against the stem.
func _part_turn(skeleton: Skeleton3D) -> float:
	var most := 0.0
	for bone in skeleton.get_bone_count():
		var name := skeleton.get_bone_name(bone)
		if name.begins_with("leaf") or name.begins_with("head"):
			most = maxf(most, skeleton.get_bone_pose_rotation(bone).get_angle())
	return most


# Sum over the triangles of the cosine between front side and normal.
func _outward(mesh: ArrayMesh) -> float:
	var arrays := mesh.surface_get_arrays(0)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var normals: PackedVector3Array = arrays[Mesh.ARRAY_NORMAL]
	var indices: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
	var sum := 0.0
	for i in range(0, indices.size(), 3):
		var a := vertices[indices[i]]
		var front := (vertices[indices[i + 2]] - a).cross(vertices[indices[i + 1]] - a).normalized()
		sum += front.dot(normals[indices[i]])
	return sum


# Places on midribs of the vertices of leaves, in millimetres.
func _midribs(mesh: ArrayMesh) -> Dictionary:
	var arrays := mesh.surface_get_arrays(1)
	var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var asides: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM2]
	var places := {}
	for i in vertices.size():
		var aside := Vector3(asides[4 * i], asides[4 * i + 1], asides[4 * i + 2])
		places[(1000.0 * (vertices[i] - aside)).round()] = true
	return places


# Of the positions on the stem that move vertices.
func _greatest_offset(species: PlantFunction) -> float:
	var arrays := species.generate_mesh(0.0, 12).surface_get_arrays(0)
	var customs: PackedFloat32Array = arrays[Mesh.ARRAY_CUSTOM0]
	var greatest := 0.0
	for i in range(0, customs.size(), 4):
		greatest = maxf(greatest, customs[i])
	return greatest


func _broken_mesh() -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = PackedVector3Array([Vector3.ZERO, Vector3(NAN, 0, 0), Vector3.ONE])
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh
