@tool
extends SubViewport
## Takes pictures of plants for lists, one per frame.

## Emitted with the texture for [param key], or null if the plant cannot be built.
signal taken(key: String, picture: Texture2D)

const PlantGroup := preload("plant_group.gd")
## In pixels. A picture is larger than its display, so that thin leaves stay visible.
const SIZE := 128
const MARGIN := 4

var _queue: Array[Dictionary] = []
var _wish := {}
# Key of the picture in the next drawn frame. Empty: no picture is being taken.
var _key := ""
# The subject of the picture.
var _sitting: Node3D

@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	RenderingServer.frame_post_draw.connect(_on_frame_drawn)


# The editor moves docks by removing and adding them. Requests stay valid.
func _enter_tree() -> void:
	_begin_next.call_deferred()


func _exit_tree() -> void:
	if not _key.is_empty():
		_queue.push_front(_wish)
		_key = ""


## Requests a picture. [param make] is called in its turn and returns a PlantFunction, a
## PlantField3D that is freed afterwards, or null.
func request(key: String, make: Callable) -> void:
	_queue.append({"key": key, "make": make})
	_begin_next.call_deferred()


## Cancels all pending requests.
func clear() -> void:
	_queue.clear()


func _begin_next() -> void:
	if not _key.is_empty() or _queue.is_empty() or not is_inside_tree():
		return
	_wish = _queue.pop_front()
	_sitting = _seat(_wish["make"])
	if not _sitting:
		taken.emit(_wish["key"], null)
		_begin_next.call_deferred()
		return
	_key = _wish["key"]
	add_child(_sitting)
	_frame(PlantGroup.measure(_sitting))
	render_target_update_mode = SubViewport.UPDATE_ONCE


func _seat(make: Callable) -> Node3D:
	if _sitting:
		_sitting.free()
	var sitter: Object = make.call()
	var group := PlantGroup.make(sitter)
	if sitter is Node:
		(sitter as Node).free()
	return group


# The smallest picture of the subject's box, as the camera sees it.
func _frame(box: AABB) -> void:
	var seen := Rect2()
	for i in 8:
		var corner := _camera.basis.inverse() * box.get_endpoint(i)
		var at := Vector2(corner.x, corner.y)
		seen = Rect2(at, Vector2.ZERO) if i == 0 else seen.expand(at)
	var reach := box.size.length()
	var middle := seen.get_center()
	_camera.size = maxf(seen.size.x, seen.size.y)
	_camera.far = reach * 8.0
	var behind := (_camera.basis.inverse() * box.get_center()).z + reach * 4.0
	_camera.position = _camera.basis * Vector3(middle.x, middle.y, behind)


func _on_frame_drawn() -> void:
	if _key.is_empty() or _is_to_be_drawn():
		return
	var picture := ImageTexture.create_from_image(_cut(get_texture().get_image()))
	var key := _key
	_key = ""
	taken.emit(key, picture)
	_begin_next.call_deferred()


# A square around the visible pixels. The box around leaves and petals is larger than they are.
func _cut(image: Image) -> Image:
	var used := image.get_used_rect()
	var side := maxi(used.size.x, used.size.y) + 2 * MARGIN
	var square := Image.create_empty(side, side, false, image.get_format())
	square.blit_rect(image, used, (Vector2i.ONE * side - used.size) / 2)
	square.fix_alpha_edges()  # Without it the transparent pixels would darken the edges.
	square.resize(SIZE, SIZE, Image.INTERPOLATE_TRILINEAR)
	return square


# A frame can be drawn without this viewport, which then still shows the previous plant.
func _is_to_be_drawn() -> bool:
	var mode := RenderingServer.viewport_get_update_mode(get_viewport_rid())
	return mode == RenderingServer.VIEWPORT_UPDATE_ONCE
