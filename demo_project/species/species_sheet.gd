extends Control
## All ready species of the add-on side by side, each as large as its picture: what a field can grow
## without a line of code.

const FOLDER := "res://addons/undergrowth/species/"
## The botanical name of each, the seed of the plant that is shown, and the view from near:
## below which share of its height, and how many metres of it.
const SPECIES := {
	"meadow_grass": ["Poa pratensis", 4, 1.0, 0.09],
	"lawn_grass": ["Lolium perenne", 1, 1.0, 0.03],
	"barley": ["Hordeum vulgare", 3, 0.92, 0.13],
	"wheat": ["Triticum aestivum", 3, 1.0, 0.11],
	"common_reed": ["Phragmites australis", 2, 1.0, 0.4],
	"cattail": ["Typha latifolia", 3, 1.0, 0.34],
	"oxeye_daisy": ["Leucanthemum vulgare", 5, 0.93, 0.05],
	"poppy": ["Papaver rhoeas", 2, 1.0, 0.1],
	"cornflower": ["Centaurea cyanus", 3, 1.0, 0.05],
	"bellflower": ["Campanula persicifolia", 2, 0.93, 0.1],
	"buttercup": ["Ranunculus acris", 6, 1.0, 0.036],
	"dandelion": ["Taraxacum officinale", 4, 0.6, 0.05],
	"red_clover": ["Trifolium pratense", 5, 1.0, 0.04],
	"yarrow": ["Achillea millefolium", 3, 1.0, 0.09],
	"lavender": ["Lavandula angustifolia", 4, 1.0, 0.07],
	"garden_tulip": ["Tulipa gesneriana", 6, 1.0, 0.1],
	"male_fern": ["Dryopteris filix-mas", 1, 0.8, 0.3],
	"field_horsetail": ["Equisetum arvense", 5, 0.7, 0.14],
	"white_clover": ["Trifolium repens", 3, 1.0, 0.05],
	"moss_cushion": ["Leucobryum glaucum", 2, 1.0, 0.04],
	"plantain": ["Plantago major", 3, 0.6, 0.1],
	"ivy_carpet": ["Hedera helix", 2, 1.0, 0.12],
	"wild_strawberry": ["Fragaria vesca", 4, 1.0, 0.06],
	"seedlings": ["Fagus sylvatica", 3, 1.0, 0.05],
	"heather": ["Calluna vulgaris", 3, 1.0, 0.08],
	"bramble": ["Rubus fruticosus", 2, 0.9, 0.3],
	"hazel": ["Corylus avellana", 2, 0.9, 0.4],
	"bamboo": ["Phyllostachys aurea", 3, 0.9, 0.4],
	"dog_rose": ["Rosa canina", 2, 0.75, 0.25],
}
const SEGMENTS := 64
const COLUMNS := 6
## Metres between two plants of a world in which each is 1 m high or wide.
const APART := 30.0
const VIEW_DEGREES := 20.0
## How much of its picture a plant fills.
const FILLED := 0.78
## Wide plants are drawn smaller, by how much wider than high they are.
const WIDEST := 1.7
## How far plants are moved aside, in shares of their height: the view from near is beside them.
const ASIDE := 0.16
## Pixels of the view from near.
const INSET := Vector2(120, 120)
const INSET_PLACE := Vector2(4, 4)

@onready var _cells: GridContainer = %Cells
@onready var _world: Node3D = %World


func _ready() -> void:
	_cells.columns = COLUMNS
	for file: String in SPECIES:
		var plant := _add_plant(file)
		_add_cell(plant, file)


func _add_plant(file: String) -> Plant3D:
	var plant := Plant3D.new()
	plant.species = load(FOLDER + file + ".tres")
	plant.segments = SEGMENTS
	plant.seed = SPECIES[file][1]
	plant.position.x = APART * _world.get_child_count()
	_world.add_child(plant)
	var size_there := plant.get_mesh().get_aabb().size
	var across := maxf(size_there.x, size_there.z)
	plant.scale = Vector3.ONE / maxf(size_there.y, WIDEST * across)
	return plant


func _add_cell(plant: Plant3D, file: String) -> void:
	var whole := _make_view(_camera_of_all(plant))
	whole.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	whole.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_cells.add_child(whole)
	var near := _make_view(_camera_of_head(plant, SPECIES[file][2], SPECIES[file][3]))
	near.size = INSET
	near.position = INSET_PLACE
	whole.add_child(near)
	whole.add_child(_make_label(plant, file))


func _make_view(camera: Camera3D) -> SubViewportContainer:
	var container := SubViewportContainer.new()
	container.stretch = true
	var view := SubViewport.new()
	view.msaa_3d = Viewport.MSAA_4X
	container.add_child(view)
	view.add_child(camera)
	return container


func _camera_of_all(plant: Plant3D) -> Camera3D:
	var box := plant.get_mesh().get_aabb()
	# The name is below the plant, the near view beside its upper half.
	var aside := Vector3(ASIDE, 0.05, 0.0) / plant.scale
	var center := Vector3(box.get_center().x, 0.5 / plant.scale.y, 0.0) - aside
	return _add_camera(plant, center, 1.0 / FILLED, Vector3(0.0, 0.16, 1.0))


## Shows `metres` of what is highest below a share of the plant's height.
func _camera_of_head(plant: Plant3D, share: float, metres: float) -> Camera3D:
	var points: PackedVector3Array = plant.get_mesh().surface_get_arrays(0)[Mesh.ARRAY_VERTEX]
	var limit := share * plant.get_mesh().get_aabb().end.y
	var top := Vector3.ZERO
	for point in points:
		top = point if point.y > top.y and point.y <= limit else top
	var sum := Vector3.ZERO
	var count := 0
	for point in points:
		if point.distance_to(top) < 0.6 * metres:
			sum += point
			count += 1
	return _add_camera(plant, sum / count, metres * plant.scale.y, Vector3(0.25, 0.55, 1.0))


## A camera that sees `extent` metres of a plant's world around a point of the plant.
func _add_camera(plant: Plant3D, at: Vector3, extent: float, from: Vector3) -> Camera3D:
	var camera := Camera3D.new()
	camera.fov = VIEW_DEGREES
	camera.near = 0.01
	var distance := 0.5 * extent / tan(deg_to_rad(0.5 * VIEW_DEGREES))
	var target := plant.position + at * plant.scale
	camera.look_at_from_position(target + from.normalized() * distance, target)
	return camera


func _make_label(plant: Plant3D, file: String) -> Label:
	var label := Label.new()
	var height := plant.get_mesh().get_aabb().end.y
	var metres := "%.0f cm" % (100.0 * height) if height < 1.0 else "%.1f m" % height
	label.text = (
		"%s, %s\n%s"
		% [
			file.substr(0, 1).to_upper() + file.substr(1).replace("_", " "),
			metres,
			SPECIES[file][0]
		]
	)
	label.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	label.vertical_alignment = VERTICAL_ALIGNMENT_BOTTOM
	label.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	label.add_theme_font_size_override(&"font_size", 15)
	label.add_theme_constant_override(&"line_spacing", 0)
	label.add_theme_color_override(&"font_color", Color(0.95, 0.95, 0.9))
	label.add_theme_color_override(&"font_outline_color", Color(0.12, 0.14, 0.12, 0.8))
	label.add_theme_constant_override(&"outline_size", 4)
	return label
