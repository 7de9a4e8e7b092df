## The blocks of code in README, guide and class help, as scripts that run in a small scene of their
## own.
extends RefCounted


## One block of code.
class Block:
	## Position in the text, for messages.
	var place := ""
	## The shown text, with tabs.
	var code := ""
	## gdscript, csharp or another language.
	var language := ""
	## True if it cannot run by itself. The text above it says so.
	var is_only_compiled := false

	## True if it is a whole script with an extends line.
	func is_script() -> bool:
		return RegEx.create_from_string("(?m)^extends ").search(code) != null

	## Methods and members of a script, without its head.
	func is_body() -> bool:
		return RegEx.create_from_string("(?m)^func ").search(code) != null


const HEADS := "(?m)^(class_name .*|extends \\w+ *)$"
const FENCE := "```"
## Marker above a block that needs objects of a game.
const ONLY_COMPILED := "<!-- only compiled"
const CODE_BLOCK := "(?s)\\[codeblock([^\\]]*)\\](.*?)\\[/codeblock\\]"
const INDENT := "    "
## Objects that blocks may use, by name. A block can declare its own instead.
const MEMBERS: Dictionary[String, String] = {
	"field": "PlantField3D",
	"hedge": "PlantField3D",
	"plant": "Plant3D",
	"map": "PlantMap",
	"habitat": "PlantHabitat",
	"wind": "PlantWind",
	"species": "PlantFunction",
	"leaf": "PlantPart",
	"stem": "PlantPart",
	"ray": "PlantPart",
	"player": "Node3D",
	"mower": "Node3D",
	"grenade": "Node3D",
	"smoke": "Node3D",
	"camera": "Camera3D",
	"rustle": "AudioStreamPlayer3D",
}
const METHODS: Dictionary[String, String] = {
	"throw_clippings": "func throw_clippings(_at: Vector3) -> void:\n\tpass\n",
	"draw_link": "func draw_link(_from: Vector3, _to: Vector3) -> void:\n\tpass\n",
}


## Returns the path of a file or folder of the checkout, or "". The tests' project is in build/test,
## or in the root folder.
static func find_file(name: String) -> String:
	for folder: String in ["../../..", "."]:
		var path := ProjectSettings.globalize_path("res://").path_join(folder).path_join(name)
		if FileAccess.file_exists(path) or DirAccess.dir_exists_absolute(path):
			return path
	return ""


## Returns all fenced blocks of a Markdown file.
static func in_markdown(path: String, name: String) -> Array[Block]:
	var found: Array[Block] = []
	var lines := FileAccess.get_file_as_string(path).split("\n")
	var block: Block = null
	for i in lines.size():
		if not lines[i].strip_edges().begins_with(FENCE):
			if block:
				block.code += lines[i] + "\n"
		elif block:
			found.append(block)
			block = null
		else:
			block = Block.new()
			block.place = "%s:%d" % [name, i + 1]
			block.language = lines[i].strip_edges().trim_prefix(FENCE)
			block.is_only_compiled = i > 0 and lines[i - 1].begins_with(ONLY_COMPILED)
	return found


## Returns all code blocks of a class's help.
static func in_help(path: String, name: String) -> Array[Block]:
	var found: Array[Block] = []
	var text := FileAccess.get_file_as_string(path)
	for part in RegEx.create_from_string(CODE_BLOCK).search_all(text):
		var block := Block.new()
		block.place = "%s:%d" % [name, text.left(part.get_start()).count("\n") + 1]
		block.language = "text" if part.get_string(1).contains("lang") else "gdscript"
		block.code = _with_tabs(part.get_string(2).dedent().xml_unescape()).strip_edges() + "\n"
		found.append(block)
	return found


## Returns a script that runs [param block] and sets `is_over` at the end of its statements.
static func make_script(block: Block) -> GDScript:
	var script := GDScript.new()
	script.source_code = _source_of(block)
	return script


static func _source_of(block: Block) -> String:
	if block.is_script():
		return RegEx.create_from_string("(?m)^class_name .*$").sub(block.code, "", true)
	var base := "PlantFunction" if block.code.contains("func _grow(") else "Node3D"
	var source := "extends %s\n\nvar is_over := false\n" % base
	for name in MEMBERS:
		var is_own := ClassDB.class_has_method(base, "get_" + name)
		if _uses(block.code, name) and not is_own and not _declares(block.code, name):
			source += "var %s: %s\n" % [name, MEMBERS[name]]
	for name in METHODS:
		if _uses(block.code, name):
			source += "\n\n" + METHODS[name]
	if block.is_body():
		return source + "\n\n" + block.code
	return source + "\n\nfunc show_it() -> void:\n" + block.code.indent("\t") + "\tis_over = true\n"


static func _uses(code: String, name: String) -> bool:
	return RegEx.create_from_string('(?<![.\\w"])%s\\b' % name).search(code) != null


static func _declares(code: String, name: String) -> bool:
	return RegEx.create_from_string("(?m)^(@\\S+ )?var %s\\b" % name).search(code) != null


static func _with_tabs(code: String) -> String:
	var lines := code.split("\n")
	for i in lines.size():
		var inner := lines[i].lstrip(" ")
		lines[i] = "\t".repeat((lines[i].length() - inner.length()) / INDENT.length()) + inner
	return "\n".join(lines)
