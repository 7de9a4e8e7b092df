## Random values: for a property by its hint, for an argument by its type. Some are absurd.
extends RefCounted

const ODD_NUMBERS: Array[float] = [0.0, -1.0, 1e-30, 1e30, -1e9, NAN, INF, -INF, 0.5, 1.0]
const ODD_INTEGERS: Array[int] = [0, -1, 1, 2, 63, 64, 65, 2147483647, -9223372036854775808]
## Upper limits of values that determine the cost of one plant, one field or one mesh. Larger values
## would take minutes.
const MAX_VALUES: Dictionary[String, float] = {
	"density": 60.0,
	"density_factor": 3.0,
	"variants": 6.0,
	"segments": 14.0,
	"lobes": 12.0,
	"lod": 64.0,
	"delta": 0.3,
	"seconds": 100.0,
}
const WIDEST_FIELD := 14.0
## Share of values that ignore the hint.
const ODD_SHARE := 0.12
const MAX_LIST := 8
## Saved bytes start with four letters, a version and their length, and end with a checksum.
const HEADER_BYTES := 10
const LENGTH_AT := 6
const CHECKSUM_BYTES := 4
const ODD_WORDS: Array[int] = [0, 1, 0x7F, 0x80, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF, 0x7F800000]

const FIELD_LETTERS := "UGSC"
const MAP_LETTERS := "UGDM"

## Saved bytes of fields and maps.
var saved_bytes: Array[PackedByteArray] = [PackedByteArray()]

var rng := RandomNumberGenerator.new()


func chance(share: float) -> bool:
	return rng.randf() < share


func pick(from: Array) -> Variant:
	return null if from.is_empty() else from[rng.randi_range(0, from.size() - 1)]


## Returns a value for [param info], an entry of a property list, or null if its type is unknown.
func value(info: Dictionary) -> Variant:
	var made: Variant = null
	match int(info["type"]):
		TYPE_BOOL:
			made = chance(0.5)
		TYPE_INT:
			# A field with this seed takes another from its position.
			made = -1 if info["name"] == "seed" and chance(0.2) else _capped(info, _integer(info))
		TYPE_FLOAT:
			made = _capped(info, _number(info))
		TYPE_VECTOR2:
			if info["name"] == "size":
				made = Vector2(rng.randf(), rng.randf()) * WIDEST_FIELD
			else:
				made = Vector2(_number(info), _number(info))
		TYPE_VECTOR3:
			made = point()
		TYPE_COLOR:
			made = Color(rng.randf(), rng.randf(), rng.randf())
		TYPE_AABB:
			made = AABB(place(), place())
		TYPE_TRANSFORM3D:
			made = transform()
		TYPE_STRING_NAME:
			made = pick([&"walkers", &"", &"nobody"])
		TYPE_STRING:
			made = pick(["", "Grass", "Poppy", "x".repeat(300), "Mädesüß"])
		TYPE_RECT2:
			var corner := place()
			made = Rect2(corner.x, corner.z, rng.randf() * 6.0, rng.randf() * 6.0)
		TYPE_VECTOR2I:
			made = Vector2i(rng.randi_range(0, 4), rng.randi_range(0, 4))
		TYPE_PACKED_BYTE_ARRAY:
			made = damaged_save(MAP_LETTERS if info["name"] == "data" else FIELD_LETTERS)
		TYPE_PACKED_FLOAT32_ARRAY:
			made = _numbers(info)
		TYPE_PACKED_VECTOR3_ARRAY:
			made = PackedVector3Array(_points())
		TYPE_PACKED_VECTOR2_ARRAY:
			made = PackedVector2Array(
				_points().map(func(at: Vector3) -> Vector2: return Vector2(at.x, at.z))
			)
	return made


## Returns a position near the field.
func place() -> Vector3:
	return Vector3(
		rng.randf_range(-8.0, 8.0), rng.randf_range(-0.5, 2.0), rng.randf_range(-8.0, 8.0)
	)


## The same, sometimes far away or not finite.
func point() -> Vector3:
	if chance(0.03):
		return Vector3(pick(ODD_NUMBERS), pick(ODD_NUMBERS), pick(ODD_NUMBERS))
	return place()


## With a rotation and the same scale along all axes.
func transform() -> Transform3D:
	var axis := Vector3(rng.randfn(), rng.randfn() + 2.0, rng.randfn()).normalized()
	var scale := Vector3.ONE * rng.randf_range(0.3, 1.5)
	return Transform3D(Basis(axis, rng.randf_range(-3.0, 3.0)).scaled(scale), place())


## The same, sometimes flat, mirrored, stretched or not finite.
func odd_transform() -> Transform3D:
	var odd := transform()
	if chance(0.1):
		odd.basis = (
			odd.basis
			* Basis.from_scale(pick([Vector3.ZERO, Vector3(1, -1, 1), Vector3(1, 4, 0.1)]))
		)
	odd.origin = point()
	return odd


## Returns saved bytes that start with [param letters], mutated, or sometimes other bytes.
func damaged_save(letters: String) -> PackedByteArray:
	var begin := letters.to_ascii_buffer()
	var fitting := saved_bytes.filter(
		func(bytes: PackedByteArray) -> bool: return bytes.slice(0, begin.size()) == begin
	)
	return mutated(pick(saved_bytes if fitting.is_empty() or chance(0.05) else fitting))


## Returns [param bytes] with random damage, mostly with a correct length and checksum.
func mutated(bytes: PackedByteArray) -> PackedByteArray:
	var made := bytes.duplicate()
	if chance(0.2) or made.size() <= HEADER_BYTES + CHECKSUM_BYTES:
		return made
	for i in rng.randi_range(1, 4):
		_mutate_once(made)
	if chance(0.9):
		_seal(made)
	return made


func _mutate_once(bytes: PackedByteArray) -> void:
	var end := bytes.size() - CHECKSUM_BYTES
	if end <= HEADER_BYTES:
		return
	var at := rng.randi_range(HEADER_BYTES, end - 1)
	match rng.randi_range(0, 4):
		0:
			bytes[at] = rng.randi_range(0, 255)
		1:
			bytes[at] ^= 1 << rng.randi_range(0, 7)
		2:
			bytes.remove_at(at)
		3:
			bytes.insert(at, bytes[rng.randi_range(HEADER_BYTES, end - 1)])
		_:
			if at + 4 <= end:
				bytes.encode_u32(at, pick(ODD_WORDS))


## Corrects length and checksum: FNV-1a of all bytes before it.
func _seal(bytes: PackedByteArray) -> void:
	bytes.encode_u32(LENGTH_AT, bytes.size())
	var checksum := 0x811C9DC5
	for i in bytes.size() - CHECKSUM_BYTES:
		checksum = ((checksum ^ bytes[i]) * 0x01000193) & 0xFFFFFFFF
	bytes.encode_u32(bytes.size() - CHECKSUM_BYTES, checksum)


func _numbers(info: Dictionary) -> PackedFloat32Array:
	var made := PackedFloat32Array()
	for i in rng.randi_range(0, MAX_LIST):
		made.append(_number(info))
	return made


func _points() -> Array[Vector3]:
	var made: Array[Vector3] = []
	for i in rng.randi_range(0, MAX_LIST):
		made.append(point())
	return made


func _number(info: Dictionary) -> float:
	if chance(ODD_SHARE):
		return pick(ODD_NUMBERS)
	var range := _range_of(info)
	return lerpf(range.x, range.y, pow(rng.randf(), 2.0))


func _integer(info: Dictionary) -> int:
	if chance(ODD_SHARE):
		return pick(ODD_INTEGERS)
	var range := _range_of(info)
	return int(lerpf(range.x, range.y + 1.0, pow(rng.randf(), 2.0)))


func _range_of(info: Dictionary) -> Vector2:
	var hint: String = info.get("hint_string", "")
	match int(info.get("hint", PROPERTY_HINT_NONE)):
		PROPERTY_HINT_RANGE:
			var words := hint.split(",")
			return Vector2(float(words[0]), float(words[1]))
		PROPERTY_HINT_ENUM:
			return Vector2(0.0, hint.count(","))
	return Vector2(0.0, 10.0)


func _capped(info: Dictionary, number: Variant) -> Variant:
	var maximum: float = MAX_VALUES.get(info["name"], INF)
	return number if not number > maximum else type_convert(maximum, typeof(number))
