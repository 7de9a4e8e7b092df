@tool
extends SubViewport
## Takes pictures of plants for lists, one a frame.

## Texture for [param key], or null where the plant cannot be built.
signal taken(key: String, picture: Texture2D)

const SEGMENTS := 16
const PLANT_SEED := 1
const MARGIN := 1.02
## A stalk is drawn thicker than it is, up to this breadth in shares of its height: a picture is
## small.
const LEAST_BREADTH := 0.2
const MOST_WIDENING := 3.5

var _queue: Array[Dictionary] = []
var _wish := {}
# The picture that the next drawn frame holds; nothing: none is being taken.
var _key := ""

@onready var _camera: Camera3D = $Camera
@onready var _plant: MeshInstance3D = $Plant


func _ready() -> void:
	RenderingServer.frame_post_draw.connect(_on_frame_drawn)


# The editor takes docks out and puts them in elsewhere: what was asked for is still wanted.
func _enter_tree() -> void:
	_begin_next.call_deferred()


func _exit_tree() -> void:
	if not _key.is_empty():
		_queue.push_front(_wish)
		_key = ""


## Asks for a picture; [param make] is called when its turn comes and returns a PlantFunction.
func request(key: String, make: Callable) -> void:
	_queue.append({"key": key, "make": make})
	_begin_next.call_deferred()


## Forgets all pictures that were not taken yet.
func clear() -> void:
	_queue.clear()


func _begin_next() -> void:
	if not _key.is_empty() or _queue.is_empty() or not is_inside_tree():
		return
	_wish = _queue.pop_front()
	var mesh := _build(_wish["make"])
	if not mesh:
		taken.emit(_wish["key"], null)
		_begin_next.call_deferred()
		return
	_key = _wish["key"]
	_plant.mesh = mesh
	var box := mesh.get_aabb()
	var breadth := maxf(box.size.x, box.size.z)
	var wider := clampf(LEAST_BREADTH * box.size.y / maxf(breadth, 1e-6), 1.0, MOST_WIDENING)
	_plant.scale = Vector3(wider, 1.0, wider)
	_frame(_plant.transform * box)
	render_target_update_mode = SubViewport.UPDATE_ONCE


func _build(make: Callable) -> Mesh:
	var function: PlantFunction = make.call()
	if not function or not function.find_problem(0.0, SEGMENTS, PLANT_SEED).is_empty():
		return null
	return function.generate_mesh(0.0, SEGMENTS, PLANT_SEED)


func _frame(box: AABB) -> void:
	var center := box.get_center()
	var radius := maxf(box.size.y * 0.5, Vector2(box.size.x, box.size.z).length() * 0.5) * MARGIN
	_camera.size = radius * 2.0
	_camera.far = radius * 8.0
	_camera.position = center + _camera.basis.z * radius * 4.0


func _on_frame_drawn() -> void:
	if _key.is_empty() or _is_to_be_drawn():
		return
	var picture := ImageTexture.create_from_image(get_texture().get_image())
	var key := _key
	_key = ""
	taken.emit(key, picture)
	_begin_next.call_deferred()


# A frame may be drawn without this viewport: it still shows the plant before.
func _is_to_be_drawn() -> bool:
	var mode := RenderingServer.viewport_get_update_mode(get_viewport_rid())
	return mode == RenderingServer.VIEWPORT_UPDATE_ONCE
