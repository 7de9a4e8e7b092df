## The code in README, guide and class help runs. Each block has its described effect in a small
## scene, without an error or a warning.
extends "res://tests/engine/harness.gd"

const ShownCode := preload("res://tests/engine/shown_code.gd")
## Relative to the tests' project in build/test, or to a project in the root folder.
const TEXTS: PackedStringArray = ["README.md", "addons/undergrowth/README.md"]
const GUIDE := "docs/guide"
const HELP := "extension/doc_classes"
## Duration of a block, and its maximum duration.
const SHOWN_FRAMES := 8
const PATIENCE := 20000
const SHAPED: PackedStringArray = ["PlantFunction", "PlantPart"]
## C# identifiers of classes and of their members.
const SHARP_CLASS := 'ClassDB\\.\\w+\\("(\\w+)"'
const SHARP_MEMBER := (
	"(?:\\.(Set|Get|Call|Connect|HasMethod)\\(|(ToSignal)\\(\\w+, "
	+ '|(ClassCallStatic|ClassGetIntegerConstant)\\("\\w+", )"(\\w+)"'
)
const SHARP_WAYS: Dictionary[String, String] = {
	"Set": "property",
	"Get": "property",
	"Call": "method",
	"HasMethod": "method",
	"Connect": "signal",
	"ToSignal": "signal",
	"ClassCallStatic": "method",
	"ClassGetIntegerConstant": "constant",
}
## File for a species that is shown as a file.
const SHOWN_FILE := "user://shown_species.tres"


func test_code_of_readme_runs() -> void:
	for name in TEXTS:
		await _try_all(ShownCode.in_markdown(_find(name), name))
	check(ShownCode.in_markdown(_find("README.md"), "").size() >= 4, "README shows code")


func test_code_of_the_guide_runs() -> void:
	var count := 0
	for file in DirAccess.get_files_at(_find(GUIDE)):
		if file.ends_with(".md"):
			var blocks := ShownCode.in_markdown(_find(GUIDE).path_join(file), file)
			await _try_all(blocks)
			count += blocks.size()
	check(count >= 20, "the guide shows %d blocks" % count)


func test_code_of_the_class_help_runs() -> void:
	var count := 0
	for file in DirAccess.get_files_at(_find(HELP)):
		var blocks := ShownCode.in_help(_find(HELP).path_join(file), file)
		await _try_all(blocks)
		count += blocks.size()
	check(count >= 15, "the class help shows %d blocks" % count)


func test_what_is_wrong_in_a_block_is_found() -> void:
	var block := ShownCode.Block.new()
	block.place = "here"
	block.language = "csharp"
	block.code = 'field.Call("remove_in_spheer"); field.Set("density", 4);'
	check_equal(_find_wrong_names(block), PackedStringArray(["remove_in_spheer"]), "wrong names")
	block.code = (
		'ClassDB.ClassGetIntegerConstant("PlantWind", "KIND_AER");'
		+ 'await ToSignal(field, "fild");'
		+ 'ClassDB.ClassCallStatic("PlantFeild3D", "of_species", list);'
	)
	var wrong := PackedStringArray(["PlantFeild3D", "KIND_AER", "fild", "of_species"])
	check_equal(_find_wrong_names(block), wrong, "other wrong names")
	block.language = "ini"
	block.code = '[gd_resource type="PlantFunction" format=3]\n\n[resource]\nmas = 2.0\n'
	check_equal(_find_unset(block), PackedStringArray(["mas"]), "what a file does not set")
	block.language = "gdscript"
	block.code = "add_child(PlantFeild3D.new())\n"
	check(ShownCode.make_script(block).reload() != OK, "a misspelt class does not compile")
	check_error("PlantFeild3D")


func _try_all(blocks: Array[ShownCode.Block]) -> void:
	for block in blocks:
		match block.language:
			"gdscript":
				await _try(block)
			"csharp":
				check_equal(
					_find_wrong_names(block), PackedStringArray(), "names of " + block.place
				)
			"ini":
				_load_species(block)
			"text", "gdshader":
				_check_includes(block)
		for message in _listener.take():
			check(false, "%s: %s" % [block.place, message])


func _try(block: ShownCode.Block) -> void:
	var script := ShownCode.make_script(block)
	var is_good := script.reload() == OK and script.can_instantiate()
	check(is_good, block.place + " does not compile")
	if not is_good or block.is_only_compiled:
		return
	var base := script.get_instance_base_type()
	if ClassDB.is_parent_class(base, &"Node"):
		await _show(block, script)
	elif base in SHAPED:
		_grow(block, script)


func _grow(block: ShownCode.Block, script: GDScript) -> void:
	var grown := script.new() as PlantFunction
	if not grown:
		return
	for name: String in ["leaf", "ray"]:
		if name in grown and not grown.get(name):
			grown.set(name, PlantAxis.new())
	grown.has_stem = grown.has_stem and not grown.has_method(&"_grow")
	check_equal(grown.find_problem(0.0, 12, 1), "", "problem of " + block.place)
	check(grown.generate_mesh(0.0, 12, 1) != null, block.place + " grows nothing")


## Runs a script as a node, with all objects that blocks may use.
func _show(block: ShownCode.Block, script: GDScript) -> void:
	var shown := ClassDB.instantiate(script.get_instance_base_type()) as Node
	var field := _make_field()
	_furnish(shown, field)
	shown.set_script(script)
	_lend(shown, field)
	root.add_child(shown)
	await field.build_finished
	await process_frame
	if shown.has_method(&"show_it"):
		shown.call(&"show_it")
		var waited := 0
		while not shown.get(&"is_over") and waited < PATIENCE:
			waited += 1
			OS.delay_msec(1)  # Headless frames are short, and worker threads need the processors.
			await process_frame
		check(shown.get(&"is_over") == true, block.place + " does not come to its end")
	await frames(SHOWN_FRAMES)
	while shown.find_children("*", "PlantField3D", true, false).any(_is_filling):
		await process_frame
	shown.free()
	await process_frame


func _is_filling(field: PlantField3D) -> bool:
	return field.is_building()


func _make_field() -> PlantField3D:
	var field := PlantField3D.from_species([GrassFunction.new(), TulipFunction.new()])
	field.name = "PlantField3D"
	field.size = Vector2(4, 4)
	field.density = 10.0
	field.wind = PlantWind.new()
	field.species[1].layer = "Poppy"
	return field


## Adds the children that blocks reference by `$`.
func _furnish(shown: Node, field: PlantField3D) -> void:
	shown.add_child(field)
	var plant := Plant3D.new()
	plant.name = "Plant3D"
	plant.species = TulipFunction.new()
	shown.add_child(plant)
	for name: String in ["Meadow", "Mower", "Grenade", "Smoke"]:
		var node := Node3D.new()
		node.name = name
		shown.add_child(node)
	shown.get_node("Meadow").add_child(Plant3D.new())
	(shown.get_node("Meadow").get_child(0) as Plant3D).species = GrassFunction.new()
	for name: String in ["Pond", "Road"]:
		var path := Path3D.new()
		path.name = name
		path.curve = Curve3D.new()
		for point: Vector3 in [Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 0, 1)]:
			path.curve.add_point(point)
		shown.add_child(path)
	shown.add_child(_make_player())
	var hedge := _make_field()
	hedge.name = "Hedge"
	shown.add_child(hedge)
	var ground := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = WorldBoundaryShape3D.new()
	ground.add_child(shape)
	shown.add_child(ground)
	for node: Node in [Label.new(), Camera3D.new(), AudioStreamPlayer3D.new()]:
		node.name = node.get_class()
		shown.add_child(node)


## Returns a body that pushes plants, on request.
func _make_player() -> CharacterBody3D:
	var player := CharacterBody3D.new()
	player.name = "Player"
	player.position.y = 0.9  # It is on the ground.
	var shape := CollisionShape3D.new()
	var capsule := CapsuleShape3D.new()
	capsule.height = 1.8
	shape.shape = capsule
	player.add_child(shape)
	return player


## Returns the objects that blocks use without declaring them.
func _lend(shown: Node, field: PlantField3D) -> void:
	var things := {
		"field": field,
		"hedge": shown.get_node("Hedge"),
		"plant": shown.get_node("Plant3D"),
		"map": field.map,
		"wind": field.wind,
		"species": CurvePlantFunction.new(),
		"player": shown.get_node("Player"),
		"mower": shown.get_node("Mower"),
		"grenade": shown.get_node("Grenade"),
		"smoke": shown.get_node("Smoke"),
		"camera": shown.get_node("Camera3D"),
		"rustle": shown.get_node("AudioStreamPlayer3D"),
		"leaf": PlantBlade.new(),
		"stem": PlantAxis.new(),
		"ray": PlantBlade.new(),
	}
	for name: String in things:
		if name in shown and not shown.get(name):
			shown.set(name, things[name])


## Checks a species that is shown as a file: it loads with all values in the file.
func _load_species(block: ShownCode.Block) -> void:
	check_equal(_find_unset(block), PackedStringArray(), "what is not set, " + block.place)
	var species := load(SHOWN_FILE) as PlantFunction
	check_equal(species.find_problem(0.0, 12, 1), "", "problem of " + block.place)


## Returns properties in a species' file that stay at their defaults. Godot reports nothing.
func _find_unset(block: ShownCode.Block) -> PackedStringArray:
	var file := FileAccess.open(SHOWN_FILE, FileAccess.WRITE)
	file.store_string(block.code)
	file.close()
	var species := ResourceLoader.load(SHOWN_FILE, "", ResourceLoader.CACHE_MODE_REPLACE)
	ResourceSaver.save(species, SHOWN_FILE)
	var saved := FileAccess.get_file_as_string(SHOWN_FILE)
	var unset: PackedStringArray = []
	for line in block.code.split("\n"):
		var name := line.get_slice(" = ", 0)
		if name != line and not saved.contains("\n%s = " % name):
			unset.append(name)
	return unset


## Returns identifiers of C# that no class of the add-on or of the engine has.
func _find_wrong_names(block: ShownCode.Block) -> PackedStringArray:
	var wrong: PackedStringArray = []
	for found in RegEx.create_from_string(SHARP_CLASS).search_all(block.code):
		if not ClassDB.class_exists(found.get_string(1)):
			wrong.append(found.get_string(1))
	for found in RegEx.create_from_string(SHARP_MEMBER).search_all(block.code):
		var way := found.get_string(1) + found.get_string(2) + found.get_string(3)
		if not _is_known(found.get_string(4), SHARP_WAYS[way]):
			wrong.append(found.get_string(4))
	return wrong


func _is_known(name: String, way: String) -> bool:
	for type in ClassDB.get_class_list():
		if not type.begins_with("Plant"):
			continue
		var is_there: bool = {
			"property": name in ClassDB.class_get_property_list(type).map(_name_of),
			"method": ClassDB.class_has_method(type, name),
			"signal": ClassDB.class_has_signal(type, name),
			"constant": ClassDB.class_has_integer_constant(type, name),
		}[way]
		if is_there:
			return true
	return false


func _name_of(property: Dictionary) -> String:
	return property["name"]


func _check_includes(block: ShownCode.Block) -> void:
	for found in RegEx.create_from_string('#include "([^"]+)"').search_all(block.code):
		check(
			ResourceLoader.exists(found.get_string(1)),
			"%s: %s" % [block.place, found.get_string(1)]
		)


func _find(name: String) -> String:
	var path := ShownCode.find_file(name)
	check(path != "", name + " is not there")
	return path
