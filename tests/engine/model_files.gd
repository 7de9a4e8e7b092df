## Plant models in the layouts of other tools, as users export them.
extends RefCounted

const Maker := preload("res://tests/engine/model_maker.gd")
const BARK := Color(0.35, 0.26, 0.18)
const GREEN := Color(0.3, 0.5, 0.2)
const FOLDER := "user://models"


## Returns all files by name. Most were written as glTF files and read again.
static func all() -> Dictionary:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var files := {}
	for made: Dictionary in [_of_blender(), _of_speedtree(), _of_quixel(), _of_kenney(), _odd()]:
		files.merge(made)
	return files


static func tuft(count: int, material: Material, rows := 4) -> Maker:
	var maker := Maker.new()
	maker.surface(material)
	for i in count:
		var turn := 2.4 * i
		var side := Vector3(cos(turn), 0, sin(turn))
		var spine: PackedVector3Array = []
		var widths: PackedFloat32Array = []
		for row in rows + 1:
			var share := float(row) / rows
			spine.append(
				side * (0.01 + 0.004 * (i % 5) + 0.12 * share * share) + Maker.UP * 0.4 * share
			)
			widths.append(0.01 * (1.0 - 0.9 * share))
		maker.sheet(spine, widths, side.cross(Maker.UP))
	return maker


static func flower(material: Material) -> Maker:
	var maker := Maker.new()
	maker.surface(material)
	maker.stem(0.6, 0.006)
	maker.leaves(5, 0.05, 0.3, 0.18, 0.04, 3)
	for i in 8:
		var turn := TAU * i / 8
		var side := Vector3(cos(turn), 0.2, sin(turn))
		maker.leaf(Vector3(0, 0.6, 0) + 0.004 * side, 0.06 * side, 0.03)
	return maker


static func tree(leaf_count: int, twigs := 0) -> Maker:
	var maker := Maker.new()
	maker.surface(Maker.plain(BARK))
	maker.stem(2.0, 0.05, Vector3.ZERO, 10, 8)
	for i in twigs:
		var turn := 2.4 * i
		var side := Vector3(cos(turn), 0.4, sin(turn)).normalized()
		maker.leaf(Vector3(0, 0.8 + 0.1 * i, 0) + 0.03 * side, 0.8 * side, 0.02, 4)
	maker.surface(Maker.cutout())
	for i in leaf_count:
		var turn := 2.4 * i
		var side := Vector3(cos(turn), 0.3, sin(turn)).normalized()
		var base := Vector3(0, lerpf(0.7, 1.9, float(i) / leaf_count), 0) + 0.04 * side
		if twigs > 0:
			var twig := i % twigs
			var along := 2.4 * twig
			side = Vector3(cos(along), 0.4, sin(along)).normalized()
			base = (
				Vector3(0, 0.8 + 0.1 * twig, 0)
				+ side * (0.2 + 0.6 * (i / twigs) * twigs / leaf_count)
			)
			side = side.rotated(Maker.UP, 1.2 if i % 2 == 0 else -1.2)
		maker.leaf(base, 0.25 * side, 0.15, 2)
	return maker


static func turned(mesh: ArrayMesh, by: Transform3D) -> ArrayMesh:
	var made := ArrayMesh.new()
	for i in mesh.get_surface_count():
		var tool := SurfaceTool.new()
		tool.append_from(mesh, i, by)
		made = tool.commit(made)
		made.surface_set_material(i, mesh.surface_get_material(i))
	return made


static func _gltf(name: String, mesh: ArrayMesh, place := Transform3D()) -> PackedScene:
	return Maker.through_gltf(Maker.scene_of(mesh, place), "%s/%s.glb" % [FOLDER, name])


static func _of_blender() -> Dictionary:
	var bare := Maker.new()
	bare.without_uvs()
	bare.surface(Maker.plain(GREEN))
	bare.stem(0.5, 0.01)
	bare.leaves(6, 0.1, 0.5, 0.2, 0.05, 2)
	var fused := Maker.new()
	fused.surface(Maker.plain(GREEN))
	fused.stem(0.7, 0.2, Vector3.ZERO, 12, 10)
	var z_up := Transform3D(Basis(Vector3.RIGHT, 0.5 * PI), Vector3.ZERO)
	return {
		"blender_tuft": _gltf("blender_tuft", tuft(40, Maker.plain(GREEN)).mesh()),
		"blender_flower": _gltf("blender_flower", flower(Maker.plain(GREEN)).mesh()),
		"blender_fused_shrub": _gltf("blender_fused", fused.mesh()),
		"blender_without_uvs": _gltf("blender_bare", bare.mesh()),
		"blender_z_up": turned(flower(Maker.plain(GREEN)).mesh(), z_up),
		"blender_z_up_off_origin":
		turned(tree(60).mesh(), Transform3D(z_up.basis, Vector3(4, 1, 3))),
		"blender_skinned": _skinned(),
	}


static func _of_speedtree() -> Dictionary:
	return {
		"speedtree_two_materials": _gltf("speedtree_two", tree(80).mesh()),
		"speedtree_twigs": _gltf("speedtree_twigs", tree(120, 8).mesh()),
		"speedtree_3000_cards": _gltf("speedtree_cards", tree(3000, 10).mesh()),
	}


static func _of_quixel() -> Dictionary:
	var cards := Maker.new()
	cards.surface(Maker.cutout())
	for i in 3:
		cards.leaf(Vector3.ZERO, Vector3(0, 0.3, 0).rotated(Vector3.RIGHT, 0.15 * i), 0.3, 2)
	var spread := Maker.new()
	spread.surface(Maker.cutout())
	for i in 12:
		var side := Vector3(cos(2.4 * i), 0, sin(2.4 * i))
		spread.leaf(0.12 * side, Vector3(0, 0.35, 0) + 0.1 * side, 0.2, 3)
	var far := Maker.new()
	far.surface(Maker.cutout())
	far.leaf(Vector3.ZERO, Vector3(0, 0.35, 0), 0.3)
	var levels := Maker.scene_of_nodes({"Grass_LOD0": spread.mesh(), "Grass_LOD1": far.mesh()})
	var centimetres := Transform3D(Basis().scaled(100.0 * Vector3.ONE), Vector3.ZERO)
	return {
		"quixel_crossed_cards": _gltf("quixel_cards", cards.mesh()),
		"quixel_spread_cards": _gltf("quixel_spread", spread.mesh()),
		"quixel_lod_nodes": Maker.through_gltf(levels, FOLDER + "/quixel_levels.glb"),
		"quixel_centimetres": _gltf("quixel_cm", turned(spread.mesh(), centimetres)),
	}


static func _of_kenney() -> Dictionary:
	var low := Maker.new()
	low.without_uvs()
	low.surface(Maker.plain(BARK))
	low.stem(0.6, 0.06, Vector3.ZERO, 1, 5)
	low.surface(Maker.plain(GREEN))
	low.stem(0.8, 0.4, Vector3(0, 0.45, 0), 1, 6)
	var stalk := Maker.new()
	stalk.surface(Maker.plain(BARK))
	stalk.stem(0.5, 0.01)
	var leaf := Maker.new()
	leaf.surface(Maker.plain(GREEN))
	leaf.leaf(Vector3.ZERO, Vector3(0.2, 0.1, 0), 0.06, 2)
	var nodes := Maker.scene_of_nodes(
		{"Stalk": stalk.mesh(), "LeafA": leaf.mesh(), "LeafB": leaf.mesh(), "LeafC": leaf.mesh()}
	)
	return {
		"kenney_low_poly": _gltf("kenney_low", low.mesh()),
		"kenney_several_nodes": _spread(nodes),
		"kenney_scaled_node":
		_gltf(
			"kenney_scaled",
			turned(
				flower(Maker.plain(GREEN)).mesh(), Transform3D(Basis().scaled(100.0 * Vector3.ONE))
			),
			Transform3D(Basis().scaled(0.01 * Vector3.ONE), Vector3.ZERO)
		),
	}


static func _odd() -> Dictionary:
	var blended := Maker.cutout()
	blended.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	blended.emission_enabled = true
	var buried := Transform3D(Basis(), Vector3(0, -0.08, 0))
	var cylinder := CylinderMesh.new()
	cylinder.height = 1.0
	cylinder.top_radius = 0.02
	cylinder.bottom_radius = 0.03
	return {
		"origin_in_the_middle":
		_gltf("middle", turned(tree(40).mesh(), Transform3D(Basis(), Vector3(0, -1, 0)))),
		"origin_beside":
		_gltf("beside", turned(tuft(20, null).mesh(), Transform3D(Basis(), Vector3(2, 0.5, -3)))),
		"buried": _gltf("buried", turned(flower(blended).mesh(), buried)),
		"triangles_100k": _gltf("large", tuft(1500, Maker.plain(GREEN), 34).mesh()),
		"millimetres":
		turned(tree(30).mesh(), Transform3D(Basis().scaled(1100.0 * Vector3.ONE), Vector3.ZERO)),
		"mirrored_node":
		Maker.scene_of(
			tree(30).mesh(), Transform3D(Basis().scaled(Vector3(-1, 1, 1)), Vector3.ZERO)
		),
		"primitive_mesh": cylinder,
	}


static func _spread(scene: PackedScene) -> PackedScene:
	var root := scene.instantiate()
	for i in range(1, root.get_child_count()):
		var node: Node3D = root.get_child(i)
		node.transform = Transform3D(Basis(Maker.UP, 2.0 * i), Vector3(0, 0.12 * i, 0))
	var packed := PackedScene.new()
	packed.pack(root)
	root.free()
	return packed


static func _skinned() -> PackedScene:
	var root := Node3D.new()
	var skeleton := Skeleton3D.new()
	skeleton.name = "Armature"
	for i in 3:
		skeleton.add_bone("Bone%d" % i)
		skeleton.set_bone_rest(i, Transform3D(Basis(), Vector3(0, 0.2 if i > 0 else 0.0, 0)))
		if i > 0:
			skeleton.set_bone_parent(i, i - 1)
	root.add_child(skeleton)
	skeleton.owner = root
	var node := MeshInstance3D.new()
	node.mesh = flower(Maker.plain(GREEN)).mesh()
	skeleton.add_child(node)
	node.owner = root
	node.skin = skeleton.create_skin_from_rest_transforms()
	var packed := PackedScene.new()
	packed.pack(root)
	root.free()
	return packed
