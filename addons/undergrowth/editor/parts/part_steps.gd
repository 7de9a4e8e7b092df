@tool
extends RefCounted
## Changes of the parts of a species. Each is one step of Godot's undo.
##
## A carrier is the species itself, or an arrangement that carries others.

const Translations := preload("../translations/translations.gd")
const MAX_COUNT := 4096
## Properties of a new leaf as factors of its carrier's length.
const LEAF_LENGTH := 0.3
const LEAF_WIDTH := 0.2
## Metres. Length of a new leaf on the ground, if the species has no other parts there.
const GROUND_LENGTH := 0.3
const LEAF_COUNT := Vector2i(5, 7)

var _undo: EditorUndoRedoManager
var _function: PlantFunction


func _init(undo: EditorUndoRedoManager, function: PlantFunction) -> void:
	_undo = undo
	_function = function


## Returns the arrangements on [param carrier].
static func children_of(carrier: Resource) -> Array[PlantArrangement]:
	var found: Array[PlantArrangement] = []
	found.assign(carrier.get(_property_of(carrier)) as Array)
	return found


## Returns the title of [param arrangement]: its name, that of its part, or the part's kind.
static func title_of(arrangement: PlantArrangement) -> String:
	if arrangement.resource_name:
		return arrangement.resource_name
	if not arrangement.part:
		return Translations.text("No Part")
	if arrangement.part.resource_name:
		return arrangement.part.resource_name
	return arrangement.part.get_class().trim_prefix("Plant")


## Returns the count as text: "9", or "7–9".
static func describe_count(count: Vector2i) -> String:
	return str(count.x) if count.x == count.y else "%d–%d" % [count.x, count.y]


## Returns the count in [param text], or [param fallback] if it contains no count.
static func parse_count(text: String, fallback: Vector2i) -> Vector2i:
	var numbers := RegEx.create_from_string("\\d+").search_all(text)
	if numbers.is_empty() or numbers.size() > 2:
		return fallback
	var first := numbers[0].get_string().to_int()
	var last := numbers[-1].get_string().to_int()
	if mini(first, last) > MAX_COUNT or maxi(first, last) < 1:
		return fallback
	return Vector2i(mini(first, last), mini(maxi(first, last), MAX_COUNT))


## Sets one property of [param resource].
func set_value(resource: Resource, property: StringName, value: Variant, title: String) -> void:
	if resource.get(property) == value:
		return
	_begin(title, UndoRedo.MERGE_ENDS)
	_undo.add_do_property(resource, property, value)
	_undo.add_undo_property(resource, property, resource.get(property))
	_undo.commit_action()


## Adds leaves on [param carrier] and returns them.
func add_leaf(carrier: Resource) -> PlantArrangement:
	var leaves := _make_leaves(carrier)
	_begin(Translations.text("Add Part"))
	_change_children(carrier, children_of(carrier) + ([leaves] as Array[PlantArrangement]))
	_undo.commit_action()
	return leaves


## Adds a copy of [param arrangement] below it on [param carrier], and returns the copy.
func duplicate(carrier: Resource, arrangement: PlantArrangement) -> PlantArrangement:
	var copy := arrangement.duplicate(true) as PlantArrangement
	var children := children_of(carrier)
	children.insert(children.find(arrangement) + 1, copy)
	_begin(Translations.text("Duplicate Part"))
	_change_children(carrier, children)
	_undo.commit_action()
	return copy


func remove(carrier: Resource, arrangement: PlantArrangement) -> void:
	var children := children_of(carrier)
	children.erase(arrangement)
	_begin(Translations.text("Remove Part"))
	_change_children(carrier, children)
	_undo.commit_action()


## Moves [param arrangement] from the carrier [param from] to [param index] on [param to]. The index
## counts its present place too. A move to the same place is no step.
func move(arrangement: PlantArrangement, from: Resource, to: Resource, index: int) -> void:
	var before := children_of(from)
	var place := before.find(arrangement)
	before.erase(arrangement)
	var after := before if to == from else children_of(to)
	after.insert(index - 1 if to == from and place < index else index, arrangement)
	if to == from and after == children_of(from):
		return
	_begin(Translations.text("Move Part"))
	if to != from:
		_change_children(from, before)
	_change_children(to, after)
	_undo.commit_action()


## Moves the colours of [param part] by [param shift].
func shift_colors(part: PlantPart, shift: Color) -> void:
	_begin(Translations.text("Change Color"), UndoRedo.MERGE_ENDS)
	for property: StringName in [&"base_color", &"tip_color"]:
		_undo.add_do_property(part, property, _shift(part.get(property), shift))
		_undo.add_undo_property(part, property, part.get(property))
	if part.gradient:
		var gradient := part.gradient.duplicate() as Gradient
		for i in gradient.get_point_count():
			gradient.set_color(i, _shift(gradient.get_color(i), shift))
		_undo.add_do_property(part, &"gradient", gradient)
		_undo.add_undo_property(part, &"gradient", part.gradient)
	_undo.commit_action()


## Returns the mean colour of [param part].
static func color_of(part: PlantPart) -> Color:
	if part.gradient:
		return part.gradient.sample(0.5)
	return part.base_color.lerp(part.tip_color, 0.5)


## Returns true if [param other] is [param arrangement] or on it.
static func contains(arrangement: PlantArrangement, other: Resource) -> bool:
	if arrangement == other:
		return true
	return arrangement.carries.any(
		func(below: PlantArrangement) -> bool: return below and contains(below, other)
	)


static func _property_of(carrier: Resource) -> StringName:
	return &"arrangements" if carrier is PlantFunction else &"carries"


static func _shift(color: Color, shift: Color) -> Color:
	var moved := Color(color.r + shift.r, color.g + shift.g, color.b + shift.b, color.a)
	return moved.clamp()


# Parts without a path of their own would otherwise belong to the history of the edited scene.
func _begin(title: String, merge_mode := UndoRedo.MERGE_DISABLE) -> void:
	_undo.create_action(title, merge_mode, _function)
	_undo.force_fixed_history()


func _change_children(carrier: Resource, children: Array[PlantArrangement]) -> void:
	var property := _property_of(carrier)
	_undo.add_do_property(carrier, property, children)
	_undo.add_undo_property(carrier, property, children_of(carrier))


# Visible at once: as long and as many as suits the carrier.
func _make_leaves(carrier: Resource) -> PlantArrangement:
	var leaves := PlantArrangement.new()
	leaves.resource_name = Translations.text("Leaves")
	leaves.count = LEAF_COUNT
	var length := GROUND_LENGTH
	var stands := carrier is PlantFunction and not _function.has_stem
	if stands:
		leaves.layout = PlantArrangement.LAYOUT_GROUND
		leaves.tilt = Vector2(0.2, 0.8)
		leaves.radius = 0.02
		for other in children_of(carrier):
			length = other.part.length.y * 0.6 if other.part else length
	else:
		leaves.from = 0.2
		leaves.to = 0.9
		leaves.angle = Vector2(0.9, 0.7)
		leaves.turn = 2.4
		var on := carrier as PlantArrangement
		length = on.part.length.y * LEAF_LENGTH if on and on.part else GROUND_LENGTH
	leaves.part = _make_leaf(length)
	return leaves


func _make_leaf(length: float) -> PlantBlade:
	var leaf := PlantBlade.new()
	leaf.resource_name = Translations.text("Leaf")
	leaf.length = Vector2(length * 0.8, length)
	leaf.width = length * LEAF_WIDTH
	leaf.bend = 0.4
	return leaf
